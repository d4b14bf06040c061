// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "picture/panel.hpp"

namespace berm::picture {

/// What the colours and signs of a picture mean: soils, rigid bodies, contacts, supports, loads and mesh. Drawn from an upper left corner downwards within a width;
/// gives the level where it ends, pixels.
Real draw_legend(Canvas& canvas, const Model& model, const Vec<2>& at, Real width);

/// The names of soils and rigid bodies alone, which runs that differ in numbers share; the same.
Real draw_names(Canvas& canvas, const Model& model, const Vec<2>& at, Real width);

/// The stages in words, each with its number; the same.
Real draw_stages(Canvas& canvas, const Model& model, const Vec<2>& at, Real width);

/// "plane strain, material point method, 7664 cells, gravity 1 g".
std::string method_words(const Model& model);

/// The ways of the driven bodies as arrows with the numbers of their stages, and the bodies where they arrive, dashed. Ways that are gone again have one arrow.
void path_marks(Canvas& canvas, const Model& model, const Scale& scale);

/// The colour of a stage's arrow and number.
std::string stage_color(settings::StageKind kind);

/// A number in a disk.
void number_mark(Canvas& canvas, const Vec<2>& center, const std::string& number, const std::string& color);

}  // namespace berm::picture
