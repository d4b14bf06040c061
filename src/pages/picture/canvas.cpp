// SPDX-License-Identifier: BSD-3-Clause
#include "picture/canvas.hpp"

#include "io/atomic_file.hpp"

#include <fmt/format.h>

namespace berm::picture {
namespace {

constexpr Real head_length = 11, head_half = 4.2;  // of an arrow, pixels

}  // namespace

Points part_inside(const Points& convex, const Window& window)
{
  Points part = convex;
  for (int d = 0; d < 2; ++d) {
    part = report::cut(part, [&](const Vec<2>& x) { return x[d] - window.upper_left[d]; });
    part = report::cut(part, [&](const Vec<2>& x) { return window.lower_right[d] - x[d]; });
  }
  return part.size() < 3 ? Points{} : part;
}

std::optional<std::pair<Vec<2>, Vec<2>>> part_inside(const Vec<2>& from, const Vec<2>& to, const Window& window)
{
  Real begin = 0, end = 1;
  const Vec<2> way = to - from;
  for (int d = 0; d < 2; ++d)
    for (const auto& [way_out, room] :
         {std::pair{-way[d], from[d] - window.upper_left[d]}, std::pair{way[d], window.lower_right[d] - from[d]}}) {
      if (way_out == 0 && room < 0) return {};
      if (way_out > 0) end = std::min(end, room / way_out);
      if (way_out < 0) begin = std::max(begin, room / way_out);
    }
  if (begin >= end) return {};
  return std::pair{Vec<2>(from + begin * way), Vec<2>(from + end * way)};
}

void Canvas::add(const std::string& look, const Points& points)
{
  if (layers_.empty() || layers_.back().look != look) layers_.push_back({look, ""});
  for (const Vec<2>& x : points) fmt::format_to(std::back_inserter(layers_.back().data), "{:.2f} {:.2f}\n", x[0], x[1]);
  layers_.back().data += '\n';
}

void Canvas::polygon(const Points& convex, const std::string& color)
{
  const Points part = window_ ? part_inside(convex, *window_) : convex;
  if (part.size() >= 3) add(fmt::format("filledcurves closed lc rgb '{}' fs solid 1", color), part);
}

void Canvas::line(const Points& points, const LineStyle& style)
{
  const std::string look = fmt::format("lines lc rgb '{}' lw {:g} dt {}", style.color, style.width, style.dash);
  if (!window_) return add(look, points);
  Points part;
  const auto finish = [&] {
    if (part.size() > 1) add(look, part);
    part.clear();
  };
  for (std::size_t k = 0; k + 1 < points.size(); ++k) {
    const auto inside = part_inside(points[k], points[k + 1], *window_);
    if (!inside) continue;
    if (part.empty() || part.back() != inside->first) finish(), part.push_back(inside->first);
    part.push_back(inside->second);
  }
  finish();
}

void Canvas::outline(Points points, const LineStyle& style)
{
  if (points.empty()) return;
  points.push_back(points.front());
  line(points, style);
}

void Canvas::arrow(const Vec<2>& from, const Vec<2>& to, const LineStyle& style)
{
  const Real length = (to - from).norm();
  if (!(length > 0)) return;
  const Vec<2> along = (to - from) / length, across(-along[1], along[0]);
  const Real head = std::min(head_length, 0.7 * length), half = head_half * head / head_length;
  line({from, Vec<2>(to - 0.8 * head * along)}, style);
  polygon({to, Vec<2>(to - head * along + half * across), Vec<2>(to - head * along - half * across)}, style.color);
}

void Canvas::dimension(const Vec<2>& from, const Vec<2>& to, const std::string& words)
{
  const LineStyle style{"#555555", 1};
  const Vec<2> middle = 0.5 * (from + to);
  arrow(middle, from, style);
  arrow(middle, to, style);
  const bool upright = std::abs(to[1] - from[1]) > std::abs(to[0] - from[0]);
  if (upright && (to - from).norm() < width_of(words, TextStyle{}.size) + 6)  // words that are longer than the line lie
    text(middle + Vec<2>(-10, 0), words, {.anchor = Anchor::right});
  else
    text(middle + (upright ? Vec<2>(-11, 0) : Vec<2>(0, -9)), words, {.anchor = Anchor::center, .upright = upright});
}

void Canvas::text(const Vec<2>& at, const std::string& words, const TextStyle& style)
{
  if (words.empty() || (window_ && !window_->holds(at))) return;
  constexpr const char* anchors[] = {"left", "center", "right"};
  fmt::format_to(std::back_inserter(labels_), "set label {} at {:.1f},{:.1f} {}{} font 'DejaVu Sans{},{:g}' tc rgb '{}' front\n",
                 plot::gnuplot_text(words), at[0], at[1], anchors[static_cast<int>(style.anchor)], style.upright ? " rotate by 90" : "",
                 style.bold ? ":Bold" : "", style.size, style.color);
}

Points Canvas::circle(const Vec<2>& center, Real radius)
{
  constexpr int sides = 72;
  Points points;
  for (int k = 0; k < sides; ++k) {
    const Real angle = 2 * pi * k / sides;
    points.emplace_back(center + radius * Vec<2>(std::cos(angle), std::sin(angle)));
  }
  return points;
}

Real Canvas::width_of(const std::string& words, Real size)
{
  std::size_t letters = 0;
  for (const char c : words) letters += (static_cast<unsigned char>(c) & 0xC0) != 0x80 ? 1 : 0;
  return 0.8 * size * static_cast<Real>(letters);
}

bool Canvas::draw(const std::filesystem::path& folder, const std::string& name, int width, int height, plot::PlotFormat format) const
{
  io::make_folder(folder / "plots");
  std::string data, plot;
  for (std::size_t k = 0; k < layers_.size(); ++k) {
    data += layers_[k].data + "\n\n";
    plot += fmt::format("{} index {} using 1:2 with {} notitle",
                        k == 0 ? "plot " + plot::gnuplot_text("./" + name + ".dat") : ", \\\n     ''", k, layers_[k].look);
  }
  io::write_atomically(folder / "plots" / (name + ".dat"), data);
  const std::string script =
      fmt::format("set lmargin at screen 0\nset rmargin at screen 1\nset bmargin at screen 0\nset tmargin at screen 1\n"
                  "set xrange [0:{}]\nset yrange [{}:0]\nunset border\nunset tics\nunset key\n{}{}\n",
                  width, height, labels_, plot);
  return plot::draw(folder, name, width, height, script, format);
}

}  // namespace berm::picture
