// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "problem/case.hpp"

namespace berm::base {

/// How far water flows in a stage, by the soil that touches the main rigid body: "v D/c_v = 20: partly drained" where a stage moves it, "T = c_v t/D^2 = 0.3"
/// where it rests for a given time. Empty where no water flows, or neither is known. Drained below 0.01, undrained above 100
/// (examples/pipe_consolidation: 2 % of the resistance).
std::string drainage_in_words(const problem::Case& c, const problem::StageSettings& stage);

/// What `berm check` says of the water, line by line: c_v of each soil in which it flows, then each stage; empty where none flows.
std::vector<std::string> drainage_words(const problem::Case& c);

}  // namespace berm::base
