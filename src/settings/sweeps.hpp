// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "settings/case.hpp"

namespace berm::settings {

constexpr std::size_t max_stage_name = 100;  ///< bytes

/// Puts drags in the place of the sweeps of a case. A sweep "s" of n drags becomes s_1 ... s_n, along its velocity and back in turn, each over its amplitude;
/// where it pauses, s_1_pause ... between them stand still with the vertical force held. Supports and tractions that name s name all of them. Gives for each
/// stage that there is now the number of the one that it came from. Throws InputError where another stage has one of these names.
std::vector<std::size_t> expand_sweeps(Case& c);

/// Writes stages that are repeated behind themselves: "heat" and "cool" with repeat = 3 are followed by heat_2, cool_2, heat_3 and cool_3. Supports and tractions that name a stage name its
/// repetitions, too. Before expand_sweeps; gives what that gives. Throws KeyError where what is repeated is not clear, or a name is taken.
std::vector<std::size_t> expand_repeats(Case& c);

}  // namespace berm::settings
