// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/structures/penetration/depth_log_test.cpp
#include "plot/panels.hpp"

#include "text/html.hpp"
#include "text/quantity_words.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace berm::plot {
namespace {

constexpr Real left_room = 74, top_room = 62, key_line = 19, round_off = 1e-9;  // pixels, but round_off
constexpr std::size_t max_points = 600;

/// A text as SVG, with what follows a _ below the line: "N_kt".
std::string with_subscripts(const std::string& plain)
{
  std::string svg;
  for (std::size_t k = 0; k < plain.size(); ++k) {
    if (plain[k] != '_') {
      svg += text::html_text(plain.substr(k, 1));
      continue;
    }
    std::size_t end = k + 1;
    while (end < plain.size() && (std::isalnum(static_cast<unsigned char>(plain[end])) != 0)) ++end;
    svg += fmt::format("<tspan dy=\"4\" font-size=\"80%\">{}</tspan><tspan dy=\"-4\">&#8203;</tspan>", plain.substr(k + 1, end - k - 1));
    k = end - 1;
  }
  return svg;
}

std::string words(Real x, Real y, const char* anchor, const std::string& svg, const std::string& more = "")
{
  return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\"{}>{}</text>\n", x, y, anchor, more, svg);
}

std::string line(Real x1, Real y1, Real x2, Real y2, const std::string& style)
{
  return fmt::format("<line x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\" style=\"{}\"/>\n", x1, y1, x2, y2, style);
}

constexpr const char *grid = "stroke:var(--grid);stroke-width:1", *axis = "stroke:var(--quiet);stroke-width:1";

/// The round numbers of an axis.
std::vector<Real> tics(Real from, Real to)
{
  const Real step = tic_step(to - from);
  std::vector<Real> at;
  for (Real k = std::ceil(from / step - round_off); k * step <= to + round_off * step; ++k) at.push_back(k * step + 0.);  // no -0
  return at;
}

/// Places in a panel whose left end is at x0.
struct Places {
  const Panels& all;
  const Panel& panel;
  Real x0;

  Real x(Real value) const { return x0 + (value - panel.left) / (panel.right - panel.left) * all.width; }
  Real y(Real value) const
  {
    const Real part = (value - panel.low) / (panel.high - panel.low);
    return top_room + (all.downwards ? part : 1 - part) * all.height;
  }
  bool has(Real value_x, Real value_y) const
  {
    const Real slack_x = round_off * (panel.right - panel.left), slack_y = round_off * (panel.high - panel.low);
    return value_x >= panel.left - slack_x && value_x <= panel.right + slack_x && value_y >= panel.low - slack_y &&
           value_y <= panel.high + slack_y;
  }
};

std::string drawn(const PanelCurve& curve, const Places& at)
{
  std::string points, all;
  const auto end = [&] {
    if (!points.empty()) all += fmt::format("<polyline points=\"{}\" style=\"fill:none;{}\"/>\n", points, curve.style.css);
    points.clear();
  };
  for (std::size_t k = 0, stride = curve.x.size() / max_points + 1; k < curve.x.size(); k += stride)
    if (at.has(curve.x[k], curve.y[k]))
      points += fmt::format("{:.1f},{:.1f} ", at.x(curve.x[k]), at.y(curve.y[k]));
    else
      end();
  end();
  return all;
}

std::string drawn(const Places& at, bool with_y)
{
  const auto& [all, panel, x0] = at;
  const Real bottom = top_room + all.height, right = x0 + all.width;
  std::string svg;
  for (const Real tic : tics(panel.left, panel.right))
    svg += line(at.x(tic), top_room, at.x(tic), bottom, grid) +
           words(at.x(tic), all.downwards ? top_room - 8 : bottom + 18, "middle", text::short_number(tic));
  for (const Real tic : tics(panel.low, panel.high))
    svg += line(x0, at.y(tic), right, at.y(tic), grid) + (with_y ? words(x0 - 7, at.y(tic) + 4, "end", text::short_number(tic)) : "");
  const Real zero_y = panel.low <= 0 && panel.high >= 0 ? at.y(0) : all.downwards ? top_room : bottom;
  svg +=
      line(x0, zero_y, right, zero_y, axis) + (panel.left <= 0 && panel.right >= 0 ? line(at.x(0), top_room, at.x(0), bottom, axis) : "");
  svg += words(x0 + all.width / 2, top_room - (all.downwards ? 30 : 12), "middle", with_subscripts(panel.title), " font-weight=\"600\"");
  if (!all.x_label.empty()) svg += words(x0 + all.width / 2, bottom + 38, "middle", text::html_text(all.x_label));
  for (const PanelCurve& curve : panel.curves) svg += drawn(curve, at);
  return svg;
}

}  // namespace

CurveStyle thin_style(std::size_t color)
{
  const char* name = curve_color(color);
  return {fmt::format("stroke:{};stroke-width:.9;stroke-opacity:.5", name),
          fmt::format("lines lw 0.5 lc rgb '#66{}'", name + 1)};  // before the colour: how transparent
}

CurveStyle thick_style(std::size_t color)
{
  return {fmt::format("stroke:{};stroke-width:2", curve_color(color)), fmt::format("lines lw 2.5 lc rgb '{}'", curve_color(color))};
}

CurveStyle published_style()
{
  return {"stroke:var(--published);stroke-width:1.4;stroke-dasharray:5 4", "lines lw 1.5 dt 2 lc rgb '#7a1f5c'"};
}

std::string svg_of(const Panels& all)
{
  if (all.panels.empty()) return "";
  const Real step = all.width + (all.downwards ? 46 : left_room + 14), bottom = top_room + all.height,
             last = left_room + static_cast<Real>(all.panels.size() - 1) * step;
  std::string svg, key;
  for (std::size_t p = 0; p < all.panels.size(); ++p)
    svg += drawn(Places{all, all.panels[p], left_room + static_cast<Real>(p) * step}, p == 0 || !all.downwards);
  if (!all.y_label.empty())
    svg += words(0, 0, "middle", text::html_text(all.y_label),
                 fmt::format(" transform=\"translate(18 {:.0f}) rotate(-90)\"", top_room + all.height / 2));
  if (const Real end = last + all.width; all.second > 0) {
    const Panel& panel = all.panels.back();
    svg += line(end, top_room, end, bottom, axis) + words(end + 8, top_room - 8, "start", all.second_label);
    for (const Real tic : tics(panel.low / all.second, panel.high / all.second)) {
      const Real y = Places{all, panel, last}.y(tic * all.second);
      svg += line(end, y, end + 4, y, axis) + words(end + 8, y + 4, "start", text::short_number(tic));
    }
  }
  Real level = bottom + (all.x_label.empty() ? 26 : 60);
  for (const Panel& panel : all.panels)
    for (const PanelCurve& curve : panel.curves)
      if (!curve.name.empty()) {
        key += line(left_room, level - 4, left_room + 30, level - 4, curve.style.css) +
               words(left_room + 38, level, "start", curve.is_symbol ? with_subscripts(curve.name) : text::html_text(curve.name));
        level += key_line;
      }
  return fmt::format("<figure class=\"{0}\"><svg viewBox=\"0 0 {1:.0f} {2:.0f}\" width=\"{1:.0f}\" "
                     "style=\"max-width:100%;height:auto;font:13px sans-serif;fill:var(--text)\" role=\"img\">\n<title>{3}</title>\n{4}{5}"
                     "</svg></figure>\n",
                     all.css_class, last + all.width + (all.second > 0 ? 60 : 20), level - 10, text::html_text(all.title), svg, key);
}

}  // namespace berm::plot
