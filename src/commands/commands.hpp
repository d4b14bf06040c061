// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace berm::commands {

/// The program: reads the command line, does what it says and gives the exit status: 0 done, 1 the run failed, 2 the input is wrong.
int run_commands(int argc, char** argv);

}  // namespace berm::commands
