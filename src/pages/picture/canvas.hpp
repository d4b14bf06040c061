// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "plot/gnuplot.hpp"
#include "report/setup/convex.hpp"

#include <optional>
#include <string>

namespace berm::picture {

using report::Points;

/// A rectangle of the canvas, pixels.
struct Window {
  Vec<2> upper_left, lower_right;

  bool holds(const Vec<2>& x) const { return (x.array() >= upper_left.array()).all() && (x.array() <= lower_right.array()).all(); }
  Vec<2> size() const { return lower_right - upper_left; }
};

/// The part of a convex polygon inside a window; without points where there is none.
Points part_inside(const Points& convex, const Window& window);
/// The part of a straight line inside a window.
std::optional<std::pair<Vec<2>, Vec<2>>> part_inside(const Vec<2>& from, const Vec<2>& to, const Window& window);

struct LineStyle {
  std::string color;
  Real width = 1;
  int dash = 1;  ///< of gnuplot: 1 is solid
  bool operator==(const LineStyle&) const = default;
};

enum class Anchor { left, center, right };

struct TextStyle {
  Real size = 11;
  Anchor anchor = Anchor::left;
  std::string color = "#222222";
  bool bold = false, upright = false;  ///< upright: turned by 90 degrees, from below
};

/// A drawing in pixels from its upper left corner, y down. What is drawn later lies above; words lie above all. Within a window shapes are cut at its sides, and
/// words whose place is outside are left out.
class Canvas {
public:
  void open(const Window& window) { window_ = window; }
  void close() { window_.reset(); }

  void polygon(const Points& convex, const std::string& color);
  void line(const Points& points, const LineStyle& style);
  void outline(Points points, const LineStyle& style);
  void disk(const Vec<2>& center, Real radius, const std::string& color) { polygon(circle(center, radius), color); }
  /// With a head at `to`.
  void arrow(const Vec<2>& from, const Vec<2>& to, const LineStyle& style);
  /// A line between two points with a head at both ends and words beside it: above, or left of it where it stands.
  void dimension(const Vec<2>& from, const Vec<2>& to, const std::string& words);
  void text(const Vec<2>& at, const std::string& words, const TextStyle& style = {});

  static Points circle(const Vec<2>& center, Real radius);
  /// How wide words are, pixels, by the mean width of a letter.
  static Real width_of(const std::string& words, Real size);

  /// FOLDER/NAME.png or .svg; see plot::draw.
  bool draw(const std::filesystem::path& folder, const std::string& name, int width, int height, plot::PlotFormat format) const;

private:
  /// Shapes of one look that were drawn one after the other: a block of the data file.
  struct Layer {
    std::string look;  ///< as gnuplot's `with` takes it
    std::string data;
  };
  void add(const std::string& look, const Points& points);

  std::optional<Window> window_;
  std::vector<Layer> layers_;
  std::string labels_;
};

}  // namespace berm::picture
