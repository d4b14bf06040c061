// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "os/numbers.hpp"

#include <string>

namespace berm::io {

/// "40 ms", "3.1 s", "12 min 05 s", "1 h 02 min"; "?" where it is not a duration.
std::string duration_text(Real seconds);

}  // namespace berm::io
