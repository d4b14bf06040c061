// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/structures/penetration/depth_log_test.cpp
#include "structures/penetration/depth_log.hpp"

#include "plot/figure.hpp"
#include "text/html.hpp"
#include "text/quantity_words.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::penetration {
namespace {

constexpr Real panel_width = 270, panel_gap = 46, panel_left = 74, room_right = 60, panel_top = 62, panel_height = 440, key_line = 19;
constexpr std::size_t max_points = 400;
constexpr Real round_off = 1e-9;

struct Key {
  std::string name, style;
  bool is_run;  ///< a name of the user's: as it is
};

std::string svg_style(const LogCurve& curve)
{
  const std::string color = plot::curve_color(curve.run);
  switch (curve.line) {
  case LogCurve::Line::rows:
    return fmt::format("stroke:{};stroke-width:.9;stroke-opacity:.5", color);
  case LogCurve::Line::mean:
    return fmt::format("stroke:{};stroke-width:2", color);
  case LogCurve::Line::level:
    return "stroke:var(--published);stroke-width:1.4;stroke-dasharray:5 4";
  }
  return "";
}

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

std::string words(Real x, Real y, const char* anchor, const std::string& text, const char* more = "", bool plain = true)
{
  return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\"{}>{}</text>\n", x, y, anchor, more,
                     plain ? text::html_text(text) : with_subscripts(text));
}

std::string line(Real x1, Real y1, Real x2, Real y2, const char* color)
{
  return fmt::format("<line x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\" style=\"stroke:var(--{});stroke-width:1\"/>\n", x1, y1,
                     x2, y2, color);
}

/// A depth from the upper (0) to the lower end (1) of the panels.
Real place_of(Real depth, const DepthLog& log)
{
  return (depth - log.shallowest) / (log.deepest - log.shallowest);
}

/// The round depths of an axis, in its unit.
std::vector<Real> round_depths(Real from, Real to)
{
  const Real step = plot::tic_step(to - from);
  std::vector<Real> depths;
  for (Real k = std::ceil(from / step - round_off); k * step <= to + round_off * step; ++k) depths.push_back(k * step + 0.);  // no -0
  return depths;
}

/// A curve as polylines, broken where it leaves the panel.
std::string drawn(const LogCurve& curve, const LogPanel& panel, const DepthLog& log, Real x0)
{
  std::string points, all;
  const auto end = [&] {
    if (!points.empty()) all += fmt::format("<polyline points=\"{}\" style=\"fill:none;{}\"/>\n", points, svg_style(curve));
    points.clear();
  };
  const std::size_t stride = std::max<std::size_t>(1, curve.value.size() / max_points);
  for (std::size_t k = 0; k < curve.value.size(); k += stride) {
    const Real x = curve.value[k] / panel.max, y = place_of(curve.depth[k], log);
    if (!(x >= 0 && x <= 1 && y >= -round_off && y <= 1 + round_off)) {
      end();
      continue;
    }
    points += fmt::format("{:.1f},{:.1f} ", x0 + x * panel_width, panel_top + y * panel_height);
  }
  end();
  return all;
}

std::string panel_of(const LogPanel& panel, const DepthLog& log, Real x0)
{
  std::string svg;
  const Real x_step = plot::tic_step(panel.max);
  for (int k = 0; k * x_step <= panel.max * (1 + 1e-9); ++k) {
    const Real x = x0 + k * x_step / panel.max * panel_width;
    svg += line(x, panel_top, x, panel_top + panel_height, "grid") + words(x, panel_top - 8, "middle", text::short_number(k * x_step));
  }
  for (const Real depth : round_depths(log.shallowest, log.deepest)) {
    const Real y = panel_top + place_of(depth, log) * panel_height;
    svg += line(x0, y, x0 + panel_width, y, "grid");
  }
  svg += line(x0, panel_top, x0 + panel_width, panel_top, "quiet") + line(x0, panel_top, x0, panel_top + panel_height, "quiet");
  svg += words(x0 + panel_width / 2, panel_top - 30, "middle", panel.label, " font-weight=\"600\"", false);
  for (const LogCurve& curve : panel.curves) svg += drawn(curve, panel, log, x0);
  return svg;
}

}  // namespace

std::string svg_of(const DepthLog& log)
{
  if (log.panels.empty()) return "";
  const Real count = static_cast<Real>(log.panels.size()), width = panel_left + count * panel_width + (count - 1) * panel_gap + room_right;
  std::vector<Key> keys;
  for (const LogPanel& panel : log.panels)
    for (const LogCurve& curve : panel.curves)
      if (!curve.name.empty()) keys.push_back({curve.name, svg_style(curve), curve.line != LogCurve::Line::level});
  const Real whole = panel_top + panel_height + 14 + key_line * static_cast<Real>(keys.size());
  std::string svg = fmt::format(
      "<figure class=\"depth_log\"><svg viewBox=\"0 0 {:.0f} {:.0f}\" width=\"{:.0f}\" style=\"max-width:100%;height:auto;font:13px "
      "sans-serif;fill:var(--text)\" role=\"img\">\n<title>{}</title>\n",
      width, whole, width, text::html_text(log.title));
  for (std::size_t p = 0; p < log.panels.size(); ++p)
    svg += panel_of(log.panels[p], log, panel_left + static_cast<Real>(p) * (panel_width + panel_gap));
  const Real end = width - room_right;
  for (const Real depth : round_depths(log.shallowest, log.deepest))
    svg += words(panel_left - 7, panel_top + place_of(depth, log) * panel_height + 4, "end", text::short_number(depth));
  svg += words(0, 0, "middle", log.depth_label,
               fmt::format(" transform=\"translate(18 {:.0f}) rotate(-90)\"", panel_top + panel_height / 2).c_str());
  if (log.per_width > 0) {
    svg += line(end, panel_top, end, panel_top + panel_height, "quiet");
    for (const Real widths : round_depths(log.shallowest / log.per_width, log.deepest / log.per_width)) {
      const Real y = panel_top + place_of(widths * log.per_width, log) * panel_height;
      svg += line(end, y, end + 4, y, "quiet") + words(end + 8, y + 4, "start", text::short_number(widths));
    }
    svg += words(end + 8, panel_top - 8, "start", "z/D");
  }
  Real y = panel_top + panel_height + 26;
  for (const Key& key : keys) {
    svg += fmt::format("<line x1=\"{:.0f}\" y1=\"{:.1f}\" x2=\"{:.0f}\" y2=\"{:.1f}\" style=\"{}\"/>\n", panel_left, y - 4, panel_left + 30,
                       y - 4, key.style);
    svg += words(panel_left + 38, y, "start", key.name, "", key.is_run);
    y += key_line;
  }
  return svg + "</svg></figure>\n";
}

}  // namespace berm::penetration
