// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "settings/case.hpp"

namespace berm::picture {

/// A stage in words: "push 0.1 m/s to w = 2 mm", "drag 0.1 m/s, V held, 20 mm". Lengths are of the model; where several limits are given, all
/// stand there with "or" between them.
std::string stage_words(const settings::StageSettings& stage, int dimension);

/// What a support holds: "x, y fixed in rest, drained".
std::string held_words(const settings::Case& c, const boundary::SupportSettings& support);

/// Of a support that moves: ", moves along x in quake", or ", waves come in along x in quake"; "" of others.
std::string motion_words(const boundary::SupportSettings& support);

/// What drives it and how fast: "0.1 m/s down", "4 kN/m along x, V held".
std::string drive_words(const settings::StageSettings& stage, int dimension);

/// Until when it lasts: "w = 2 mm or V = 4 kN/m"; lengths times `scale` and forces per metre times it, as the prototype has them. Times are not scaled.
std::string until_words(const settings::StageSettings& stage, int dimension, Real scale = 1);

}  // namespace berm::picture
