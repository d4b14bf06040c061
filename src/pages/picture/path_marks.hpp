// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "picture/panel.hpp"

namespace berm::picture {

/// The ways of the driven bodies as arrows with the numbers of their stages, and the bodies where they arrive, dashed. Ways that are gone again have one arrow.
void path_marks(Canvas& canvas, const Model& model, const Scale& scale);

/// The colour of a stage's arrow and number.
std::string stage_color(problem::StageKind kind);

/// A number in a disk.
void number_mark(Canvas& canvas, const Vec<2>& center, const std::string& number, const std::string& color);

}  // namespace berm::picture
