// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace berm::base {

/// A range of src/structures/formulas, "0 <= w/D <= 0.5", with the signs of print, HTML.
std::string printed_range(const char* range);

}  // namespace berm::base
