// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace berm {

/// From now on SIGINT, SIGTERM and SIGUSR1 only ask a run to stop; a second one ends the program at once.
void catch_interrupts();

/// True once a signal has asked to stop; false in a program that does not catch them.
bool interrupted();

}  // namespace berm
