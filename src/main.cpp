// SPDX-License-Identifier: BSD-3-Clause
#include "run/commands.hpp"

int main(int argc, char** argv)
{
  return berm::run_commands(argc, argv);
}
