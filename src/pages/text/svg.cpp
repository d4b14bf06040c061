// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/report/setup/drawing_test.cpp
#include "text/svg.hpp"

#include "text/tex_math.hpp"

#include <algorithm>
#include <array>
#include <fmt/format.h>

namespace berm::text {
namespace {

struct Look {
  const char *name, *style;
};

constexpr std::array<Look, 12> looks = {{
    {"domain", "fill:none;stroke:var(--quiet,#5b6570);stroke-width:1"},
    {"soil", "fill:#b58b4a;fill-opacity:.24;stroke:#b58b4a;stroke-opacity:.5;stroke-width:.7"},
    {"material", "fill:#b58b4a;fill-opacity:.24;stroke:var(--text,#1d232a);stroke-width:1.2"},
    {"surface", "stroke:var(--text,#1d232a);stroke-width:1.6"},
    {"fine", "fill:none;stroke:var(--quiet,#5b6570);stroke-width:1;stroke-dasharray:5 3"},
    {"rigid", "fill:#7d8a99;fill-opacity:.45;stroke:var(--text,#1d232a);stroke-width:1.4"},
    {"later", "fill:none;stroke:var(--text,#1d232a);stroke-width:1;stroke-dasharray:2 3"},
    {"path", "fill:var(--link,#1764ab);stroke:var(--link,#1764ab);stroke-width:2"},
    {"nominal", "fill:var(--link,#1764ab);stroke:var(--link,#1764ab);stroke-width:2;stroke-dasharray:4 3"},
    {"held", "fill:none;stroke:var(--quiet,#5b6570);stroke-width:.9"},
    {"dimension", "fill:none;stroke:var(--quiet,#5b6570);stroke-width:.9"},
    {"key", "fill:var(--link,#1764ab);stroke:none"},
}};

std::string look_of(Pen pen)
{
  const Look& look = looks[static_cast<std::size_t>(pen)];
  return fmt::format("class=\"{}\" style=\"{}\"", look.name, look.style);
}

/// A hundredth of a unit is more than a screen shows.
std::string number_text(Real value)
{
  return fmt::format("{}", std::round(value * 100) / 100 + 0.);
}

std::string corners_text(const std::vector<Vec<2>>& corners)
{
  std::string text;
  for (const Vec<2>& corner : corners)
    text += fmt::format("{}{},{}", text.empty() ? "" : " ", number_text(corner[0]), number_text(corner[1]));
  return text;
}

std::string rectangle_path(const Vec<2>& upper_left, const Vec<2>& size)
{
  return fmt::format("M{} {}h{}v{}h{}z", number_text(upper_left[0]), number_text(upper_left[1]), number_text(size[0]), number_text(size[1]),
                     number_text(-size[0]));
}

constexpr Real held_depth = 8;  // units, of hatching and rollers

}  // namespace

void Svg::line(const Vec<2>& from, const Vec<2>& to, Pen pen)
{
  elements_ += fmt::format("<line {} x1=\"{}\" y1=\"{}\" x2=\"{}\" y2=\"{}\"/>\n", look_of(pen), number_text(from[0]), number_text(from[1]),
                           number_text(to[0]), number_text(to[1]));
}

void Svg::polygon(const std::vector<Vec<2>>& corners, Pen pen)
{
  elements_ += fmt::format("<polygon {} points=\"{}\"/>\n", look_of(pen), corners_text(corners));
}

void Svg::rectangle(const Vec<2>& upper_left, const Vec<2>& size, Pen pen)
{
  elements_ += fmt::format("<rect {} x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\"/>\n", look_of(pen), number_text(upper_left[0]),
                           number_text(upper_left[1]), number_text(size[0]), number_text(size[1]));
}

void Svg::frame(const Vec<2>& upper_left, const Vec<2>& size, const Vec<2>& hole_upper_left, const Vec<2>& hole_size, Pen pen)
{
  elements_ += fmt::format("<path {} fill-rule=\"evenodd\" d=\"{}{}\"/>\n", look_of(pen), rectangle_path(upper_left, size),
                           rectangle_path(hole_upper_left, hole_size));
}

void Svg::circle(const Vec<2>& center, Real radius, Pen pen)
{
  elements_ += fmt::format("<circle {} cx=\"{}\" cy=\"{}\" r=\"{}\"/>\n", look_of(pen), number_text(center[0]), number_text(center[1]),
                           number_text(radius));
}

void Svg::arrow(const Vec<2>& from, const Vec<2>& to, Pen pen)
{
  const Real length = (to - from).norm();
  if (length == 0) return;
  const Vec<2> along = (to - from) / length, across(-along[1], along[0]);
  const Real head = std::min(9., 0.7 * length);  // a short arrow keeps part of its shaft
  const Vec<2> neck = to - head * along;
  line(from, neck, pen);
  polygon({to, neck + 0.45 * head * across, neck - 0.45 * head * across}, pen == Pen::nominal ? Pen::path : pen);
}

void Svg::text(const Vec<2>& at, const std::string& words, Anchor anchor, bool upright)
{
  constexpr std::array anchors{"start", "middle", "end"};
  const std::string x = number_text(at[0]), y = number_text(at[1]);
  // The halo separates text from the lines below it.
  elements_ += fmt::format(
      "<text x=\"{0}\" y=\"{1}\" text-anchor=\"{2}\"{3} "
      "style=\"fill:var(--text,#1d232a);stroke:var(--ground,#fff);stroke-width:3;stroke-linejoin:round;paint-order:stroke\">{4}</text>\n",
      x, y, anchors[static_cast<std::size_t>(anchor)], upright ? fmt::format(" transform=\"rotate(-90 {} {})\"", x, y) : "",
      html_text(words));
}

void Svg::number(const Vec<2>& center, int number)
{
  circle(center, 8, Pen::key);
  elements_ += fmt::format(
      "<text x=\"{}\" y=\"{}\" text-anchor=\"middle\" style=\"fill:var(--ground,#fff);font-size:11px;font-weight:bold\">{}</text>\n",
      number_text(center[0]), number_text(center[1] + 4), number);
}

void Svg::hatching(const Vec<2>& from, const Vec<2>& to, const Vec<2>& outward)
{
  constexpr Real spacing = 7;
  const Real length = (to - from).norm();
  if (length == 0) return;
  const Vec<2> along = (to - from) / length;
  const int count = std::max(1, static_cast<int>(length / spacing));
  for (int k = 0; k < count; ++k) {
    const Vec<2> foot = from + (k + 0.75) * length / count * along;
    line(foot, foot + held_depth * outward - std::min(held_depth, length / 2) * 0.7 * along, Pen::held);
  }
}

void Svg::rollers(const Vec<2>& from, const Vec<2>& to, const Vec<2>& outward)
{
  constexpr Real spacing = 24, radius = 3;
  const Real length = (to - from).norm();
  if (length == 0) return;
  const Vec<2> along = (to - from) / length;
  const int count = std::max(1, static_cast<int>(length / spacing));
  for (int k = 0; k < count; ++k) circle(from + (k + 0.5) * length / count * along + (radius + 0.8) * outward, radius, Pen::held);
  line(from + held_depth * outward, to + held_depth * outward, Pen::held);
}

void Svg::dimension(const Vec<2>& from, const Vec<2>& to, const std::string& words, bool right)
{
  line(from, to, Pen::dimension);
  const Vec<2> stroke(3, -3), middle = 0.5 * (from + to);
  for (const Vec<2>& end : {from, to}) line(end - stroke, end + stroke, Pen::dimension);
  const bool level = std::abs(to[0] - from[0]) > std::abs(to[1] - from[1]);
  if (level)
    text(middle + Vec<2>(0, 14), words, Anchor::middle);
  else
    text(middle + Vec<2>(right ? 7 : -7, 4), words, right ? Anchor::start : Anchor::end);
}

void Svg::begin_window(const Vec<2>& upper_left, const Vec<2>& size)
{
  const std::string x = number_text(upper_left[0]), y = number_text(upper_left[1]), width = number_text(size[0]),
                    height = number_text(size[1]);
  elements_ += fmt::format("<svg x=\"{0}\" y=\"{1}\" width=\"{2}\" height=\"{3}\" viewBox=\"{0} {1} {2} {3}\">\n", x, y, width, height);
}

void Svg::end_window()
{
  elements_ += "</svg>\n";
}

std::string Svg::whole(const Vec<2>& size, const std::string& title, const std::string& description) const
{
  return fmt::format("<svg xmlns=\"http://www.w3.org/2000/svg\" role=\"img\" width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} {1}\" "
                     "style=\"max-width:100%;height:auto;font-size:12px\">\n<title>{2}</title>\n<desc>{3}</desc>\n{4}</svg>\n",
                     number_text(size[0]), number_text(size[1]), html_text(title), html_text(description), elements_);
}

}  // namespace berm::text
