// SPDX-License-Identifier: BSD-3-Clause
#include "commands/commands.hpp"
#include "core/interrupt.hpp"
#include "core/threads.hpp"

int main(int argc, char** argv)
{
  berm::reexec_with_openmp_environment(argv);
  berm::survive_failed_writes();
  return berm::commands::run_commands(argc, argv);
}
