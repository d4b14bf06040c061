// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "picture/canvas.hpp"
#include "picture/ground.hpp"

namespace berm::picture {

/// The colour of a kind of soil, by its number.
std::string soil_color(Index kind);

// Colours of what is drawn on the ground.
constexpr const char *mesh_color = "#5555557f", *rigid_color = "#9aa1ab", *rim_color = "var(--text,#2f343a)", *contact_color = "#8e44ad",
                     *support_color = "var(--quiet,#22313f)", *load_color = "#0b7a4b", *push_color = "var(--link,#1764ab)",
                     *drag_color = "#c8452f", *fine_color = "#d17a00", *watch_color = "#0b7a4b", *surface_color = "var(--text,#5d4a2f)";

/// All that a panel shows of a case.
struct Model {
  const settings::Case& settings;
  const Sketch& sketch;
  const Ground& ground;
};

/// From metres to pixels.
class Scale {
public:
  /// As large as fits into a box, from its upper left corner.
  Scale(const Extent& extent, const Window& box);

  Vec<2> operator()(const Vec<2>& x) const { return upper_left_ + scale_ * Vec<2>(x[0] - extent_.lower[0], extent_.upper[1] - x[1]); }
  Real length(Real metres) const { return scale_ * metres; }
  Window window() const { return {upper_left_, upper_left_ + scale_ * extent_.size()}; }
  const Extent& extent() const { return extent_; }

private:
  Extent extent_;
  Vec<2> upper_left_;
  Real scale_;
};

/// The corners of an outline in pixels, moved by so many metres; of a half-plane those of the part that the scale shows.
Points outline_points(const Outline& outline, const Scale& scale, const Vec<2>& moved);

/// A place on a held boundary: hatched where held in both directions (bits 0 and 1), a wheel where across it, a short line beside it where along it.
void support_sign(Canvas& canvas, const Vec<2>& at, const Vec<2>& outward, int directions);

/// Whether a side is held across it alone.
bool is_held_across(const Vec<2>& outward, int directions);

/// The whole mesh with its supports and main dimensions; what stands out of it above is drawn too.
void draw_whole(Canvas& canvas, const Model& model, const Scale& scale, bool with_path);
/// The surroundings of the driven body, with its dimensions and its way.
void draw_detail(Canvas& canvas, const Model& model, const Scale& scale);

/// What draw_whole shows.
Extent whole_extent(const Model& model);
/// What draw_detail shows: the driven bodies and their ways; none where they are large in the whole anyway.
std::optional<Extent> detail_extent(const Model& model);

}  // namespace berm::picture
