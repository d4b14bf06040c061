// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "picture/convex.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace berm::picture {

/// A rectangle of the canvas, pixels.
struct Window {
  Vec<2> upper_left, lower_right;

  bool holds(const Vec<2>& x) const { return (x.array() >= upper_left.array()).all() && (x.array() <= lower_right.array()).all(); }
  Vec<2> size() const { return lower_right - upper_left; }
};

/// A colour is one of CSS. "var(--text,#222222)" is --text of the report's page, in light or dark, and #222222 in a file.
struct LineStyle {
  std::string color;
  Real width = 1;
  std::string dash = "";  ///< lengths of dashes and gaps, pixels
};
constexpr const char *dashed = "7 4", *dotted = "2 3";
constexpr const char *text_color = "var(--text,#222222)", *quiet_color = "var(--quiet,#555555)", *ground_color = "var(--ground,#ffffff)";

enum class Anchor { left, center, right };

struct TextStyle {
  Real size = 11;  ///< 1/72 inch, 4/3 of a pixel
  Anchor anchor = Anchor::left;
  std::string color = text_color;
  bool bold = false, upright = false;  ///< upright: turned by 90 degrees, from below
  bool halo = true;                    ///< of the colour of the ground, which separates words from lines below them
};

/// A drawing as SVG, in pixels from its upper left corner, y down. What is drawn later lies above; words lie above all, at the middle of their height. Within
/// a window shapes are cut at its sides, and words whose place is outside are left out.
class Canvas {
public:
  enum class Place { page, file };
  explicit Canvas(Place place) : place_(place) {}

  void open(const Window& window);
  void close();

  void polygon(const Points& points, const std::string& color);
  void line(const Points& points, const LineStyle& style);
  void outline(const Points& points, const LineStyle& style);
  void disk(const Vec<2>& center, Real radius, const std::string& color) { polygon(circle(center, radius), color); }
  /// With a head at `to`.
  void arrow(const Vec<2>& from, const Vec<2>& to, const LineStyle& style);
  /// A line between two points with a head at both ends and words beside it: above, or left of it where it stands.
  void dimension(const Vec<2>& from, const Vec<2>& to, const std::string& words);
  void text(const Vec<2>& at, const std::string& words, const TextStyle& style = {});

  static Points circle(const Vec<2>& center, Real radius);
  /// How wide words are, pixels, by the mean width of a letter.
  static Real width_of(const std::string& words, Real size);
  /// The lines that they take within a width, pixels.
  static std::vector<std::string> wrapped(const std::string& words, Real size, Real width);

  /// An SVG element, `scale` times as large as drawn; title and description (plain text) are for those who cannot see it.
  std::string svg(const Vec<2>& size, const std::string& title, const std::string& description, Real scale = 1) const;
  /// Writes a .svg, or a .png by the program rsvg-convert. Throws RunError where that fails.
  void write(const std::filesystem::path& file, const Vec<2>& size, const std::string& title, const std::string& description) const;

private:
  void add(const std::string& look, const Points& points, const char* end);
  void end_path();
  std::string look_of(const LineStyle& style) const;
  std::string shown(const std::string& color) const;

  Place place_;
  std::optional<Window> window_;
  std::string look_, shapes_, words_;  ///< look: of the path that is still open
};

}  // namespace berm::picture
