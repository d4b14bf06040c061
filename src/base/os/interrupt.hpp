// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <stdexcept>

namespace berm {

/// A signal asked to stop (interrupted()) where nothing can be kept. The same command begins anew.
struct Interrupted : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// From now on SIGINT, SIGTERM, SIGUSR1 and SIGHUP only ask a run to stop. A second one ends the program at once, but for SIGHUP, which a terminal that
/// is closed sends more than once; that is ignored where it was when the program began.
void catch_interrupts();

/// From now on a write beyond the limit of a file's size, or to a pipe that nobody reads, fails like any other instead of ending the program.
void survive_failed_writes();

/// True once a signal has asked to stop; false in a program that does not catch them.
bool interrupted();

/// Throws Interrupted then. `what`: "triangles were compared".
void stop_if_asked(const char* what);

}  // namespace berm
