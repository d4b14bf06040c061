// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace berm::sandbox {

/// From now on, and for good, this process and what it starts may not open sockets, mount, change namespaces or type into a terminal, and the kernel asks before a call that
/// starts a program or changes files. Gives the descriptor that it asks through. Throws std::system_error.
int install_filter();

}  // namespace berm::sandbox
