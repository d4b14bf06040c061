// SPDX-License-Identifier: BSD-3-Clause
#include <berm/berm.hpp>

#include <cstdio>

int main(int, char** argv)
{
  berm::RunOptions options;
  options.folder = argv[2];
  berm::Run run(argv[1], options);
  while (run.step_to_row())
    for (const berm::RigidBodyNow& body : run.rigid_bodies())
      std::printf("%s: t = %g s, force of the soil %g, %g N/m\n", body.name.c_str(), run.time(), body.force[0], body.force[1]);
}
