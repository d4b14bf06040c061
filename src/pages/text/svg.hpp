// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/types.hpp"

#include <string>
#include <vector>

namespace berm::text {

/// Style of a line or an area of a drawing, by its meaning; the page's style has a class of this name. Colours are those of
/// the page where it has them (--text, --quiet, --link, --ground), so that drawings suit light and dark mode.
enum class Pen {
  domain,     ///< the edge of the mesh
  soil,       ///< an area
  material,   ///< a deformable body that is not a bed: an area with an edge
  surface,    ///< the bed's surface
  fine,       ///< the edge of the zone of fine cells
  rigid,      ///< a rigid body: an area with an edge
  later,      ///< a later position of a rigid body
  path,       ///< an arrow of motion
  nominal,    ///< an arrow of motion whose length is not known
  held,       ///< supports
  dimension,  ///< dimension lines
  key         ///< the ground of a number in the drawing
};

enum class Anchor { start, middle, end };

/// An SVG, element by element. Points are in its own units, y downwards; a unit is a pixel where it is shown in its size.
class Svg {
public:
  void line(const Vec<2>& from, const Vec<2>& to, Pen pen);
  void polygon(const std::vector<Vec<2>>& corners, Pen pen);
  void rectangle(const Vec<2>& upper_left, const Vec<2>& size, Pen pen);
  /// A rectangle with a rectangular hole.
  void frame(const Vec<2>& upper_left, const Vec<2>& size, const Vec<2>& hole_upper_left, const Vec<2>& hole_size, Pen pen);
  void circle(const Vec<2>& center, Real radius, Pen pen);
  /// A line with a head at its end.
  void arrow(const Vec<2>& from, const Vec<2>& to, Pen pen);
  /// A text (plain) whose baseline begins, is centred or ends at a point; `upright` ones are rotated to read upwards.
  void text(const Vec<2>& at, const std::string& words, Anchor anchor = Anchor::start, bool upright = false);
  /// A number in a small disk.
  void number(const Vec<2>& center, int number);
  /// Hatching beside a line that is fixed in all directions, on the side that `outward` (a unit vector) points to; or
  /// rollers.
  void hatching(const Vec<2>& from, const Vec<2>& to, const Vec<2>& outward);
  void rollers(const Vec<2>& from, const Vec<2>& to, const Vec<2>& outward);
  /// A dimension line with strokes at its ends and its words at its middle: below a horizontal one, left of an upright one (right with `right`).
  void dimension(const Vec<2>& from, const Vec<2>& to, const std::string& words, bool right = false);

  /// What is drawn until end_window() is clipped to the window.
  void begin_window(const Vec<2>& upper_left, const Vec<2>& size);
  void end_window();

  /// The complete drawing: its size in units, and title and description for readers who cannot see it (plain text).
  std::string whole(const Vec<2>& size, const std::string& title, const std::string& description) const;

private:
  std::string elements_;
};

}  // namespace berm::text
