// SPDX-License-Identifier: BSD-3-Clause
#include "kernels/step_speed.hpp"

#include "samples/temporary_folder.hpp"

#include <fstream>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <set>

namespace berm::bench::this_file {
namespace {

TEST(Bench, sets_the_loops_of_the_kernel_beside_those_of_the_step_and_names_the_others)
{
  const TemporaryFolder folder;
  const std::string file = (folder / "bench.json").string();
  simulation::Context context(1);
  measure_steps({"probe_D10"}, file, context, 0);
  const auto problem = nlohmann::json::parse(std::ifstream(file)).at("problems").at(0);

  std::set<std::string> shared, beside;
  Real step = 0, bare = 0, replaced = 0;  // ns
  for (const auto& row : problem.at("loops")) {
    const Real time = row.at("ns_per_particle_step");
    step += time;
    (row.contains("kernel_ns_per_particle_step") ? shared : beside).insert(row.at("label").get<std::string>());
    const Real of_kernel = row.value("kernel_ns_per_particle_step", 0.);
    bare += of_kernel;
    replaced += of_kernel > 0 ? of_kernel - time : 0;
  }
  EXPECT_EQ(shared, (std::set<std::string>{"momentum balance of nodes", "momentum after the forces", "gather new velocities",
                                           "move and strain particles"}));
  for (const char* label : {"smooth velocities", "volume change of cells", "internal forces of cells", "contact: step 4"})
    EXPECT_TRUE(beside.count(label)) << label;

  const Real speed = problem.at("particle_steps_per_s"), ceiling = problem.at("ceiling_particle_steps_per_s");
  EXPECT_LE(step, 1e9 / speed) << "loops are parts of the step";
  EXPECT_LE(bare, 1e9 / problem.at("kernel_particle_steps_per_s").get<Real>());
  EXPECT_NEAR(1e9 / ceiling, 1e9 / speed + replaced, 1e-9 * step);
  EXPECT_NEAR(problem.at("share_of_ceiling"), speed / ceiling, 1e-12);
  // Near the pipe nine particles in three blocks, elsewhere four in one.
  EXPECT_GT(problem.at("lanes_per_particle"), 1);
  EXPECT_LT(problem.at("lanes_per_particle"), 12. / 9);
}

}  // namespace
}  // namespace berm::bench::this_file
