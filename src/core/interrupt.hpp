// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace berm {

/// From now on SIGINT and SIGTERM only ask a run to stop; a second one ends the program at once.
void catch_interrupts();

/// True once the user has asked to stop.
bool interrupted();

}  // namespace berm
