// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "problem/case.hpp"

#include <string>
#include <vector>

namespace berm::driven {

/// The names of all key results that a run of a case may have (quantities_of), and of its details, with # for the number in V_at_w_0.1D.
std::vector<std::string> known_names(const problem::Case& c);

/// A name with # for its number.
std::string without_number(const std::string& name);

}  // namespace berm::driven
