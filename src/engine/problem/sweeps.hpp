// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "problem/case.hpp"

namespace berm::problem {

constexpr std::size_t max_stage_name = 100;  ///< bytes

/// Puts drags in the place of the sweeps of a case. A sweep "s" of n drags becomes s_1 ... s_n, along its velocity and back in turn, each over its amplitude;
/// where it pauses, s_1_pause ... between them stand still with the vertical force held. Supports and tractions that name s name all of them. Gives for each
/// stage that there is now the number of the one that it came from. Throws InputError where another stage has one of these names.
std::vector<std::size_t> expand_sweeps(Case& c);

}  // namespace berm::problem
