// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "settings/case.hpp"

#include <string>
#include <vector>

namespace berm::driven {

/// The names of all key results that a run of a case may have by its stages (quantities_of), and of its details, with # for the number in V_at_w_0.1D, of which
/// nobody knows how many there will be. Empty where the body has no width.
std::vector<std::string> known_names(const settings::Case& c);

/// V_at_w_#D for V_at_w_0.1D, where V is taken at that multiple of D; any other name as it is.
std::string without_number(const std::string& name);

}  // namespace berm::driven
