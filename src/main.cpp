// SPDX-License-Identifier: BSD-3-Clause
#include "core/threads.hpp"
#include "commands/commands.hpp"

int main(int argc, char** argv)
{
  berm::restart_with_settings(argv);
  return berm::run_commands(argc, argv);
}
