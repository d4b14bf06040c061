// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace berm {

/// Uses `count` threads from now on (0: one for each processor that this process may use) and gives the number. More than one thread are bound to a
/// processor each, unless OMP_PROC_BIND says otherwise: threads that wander can be slower together than one alone.
int use_threads(int count);

}  // namespace berm
