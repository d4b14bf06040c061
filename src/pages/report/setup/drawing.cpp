// SPDX-License-Identifier: BSD-3-Clause
#include "report/setup/drawing.hpp"

#include "report/setup/sketch.hpp"
#include "report/setup/stage_words.hpp"
#include "text/quantity_words.hpp"
#include "text/svg.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace berm::report {
namespace {

// Units of a drawing, which are pixels where it is shown in its size.
constexpr Real whole_width = 460, whole_height = 330;    // most that the bed takes
constexpr Real detail_width = 400, detail_height = 280;  // most that the surroundings of the path take
constexpr Real line_height = 18, letter = 6.6;           // of words
constexpr Real min_width = 340;                          // that the words below take
constexpr Real small_part = 1. / 5;                      // of the whole: a driven body below this is drawn once more, enlarged
constexpr Real beyond = 0.4;                             // of the mesh's height: so much of rigid bodies above and below it is drawn

/// From metres to the units of a drawing.
class View {
public:
  View(const Extent& extent, Real width, Real height, const Vec<2>& upper_left)
      : extent_(extent),
        scale_(std::min(width / extent.size()[0], height / extent.size()[1])),
        upper_left_(upper_left)
  {
  }

  Vec<2> operator()(const Vec<2>& x) const { return upper_left_ + scale_ * Vec<2>(x[0] - extent_.lower[0], extent_.upper[1] - x[1]); }
  Real length(Real metres) const { return scale_ * metres; }
  Vec<2> size() const { return scale_ * extent_.size(); }
  Vec<2> upper_left() const { return upper_left_; }
  Vec<2> lower_right() const { return upper_left_ + size(); }
  const Extent& extent() const { return extent_; }

private:
  Extent extent_;
  Real scale_;
  Vec<2> upper_left_;
};

/// The largest of 1, 2, 5, 10, ... that is not above a quarter of a width, m.
Real bar_length(Real width)
{
  const Real max = width / 4, power = std::pow(10., std::floor(std::log10(max)));
  for (const Real step : {5., 2.})
    if (step * power <= max) return step * power;
  return power;
}

std::vector<std::string> wrapped(const std::string& words, std::size_t max)
{
  std::vector<std::string> lines(1);
  std::size_t begin = 0;
  while (begin < words.size()) {
    const std::size_t end = std::min(words.find(' ', begin), words.size());
    const std::string word = words.substr(begin, end - begin);
    if (!lines.back().empty() && lines.back().size() + 1 + word.size() > max) lines.emplace_back();
    lines.back() += (lines.back().empty() ? "" : " ") + word;
    begin = end + 1;
  }
  for (std::string& line : lines) {
    if (line.size() <= max) continue;
    std::size_t end = max - 3;
    while (end > 0 && (static_cast<unsigned char>(line[end]) & 0xC0) == 0x80) --end;  // not inside a UTF-8 character
    line = line.substr(0, end) + "...";
  }
  return lines;
}

/// Draws a sketch as a view shows it.
class Drawer {
public:
  Drawer(const problem::Case& c, const Sketch& sketch, const View& view) : case_(c), sketch_(sketch), view_(view) {}

  void inside()
  {
    svg_.begin_window(view_.upper_left(), view_.size());
    for (const FilledPart& part : sketch_.filled) {
      const auto place = [&](const Extent& e) { return view_(Vec<2>(e.lower[0], e.upper[1])); };
      const auto size = [&](const Extent& e) { return Vec<2>(view_.length(e.size()[0]), view_.length(e.size()[1])); };
      if (part.hole)
        svg_.frame(place(part.part), size(part.part), place(*part.hole), size(*part.hole), text::Pen::soil);
      else
        svg_.rectangle(place(part.part), size(part.part), text::Pen::soil);
    }
    if (sketch_.uneven.empty()) {
      if (sketch_.domain_known) box(sketch_.domain, text::Pen::domain);
      if (sketch_.fine) box(*sketch_.fine, text::Pen::fine);
    } else {
      constexpr text::Pen pens[] = {text::Pen::soil, text::Pen::domain, text::Pen::fine};
      for (std::size_t k = 0; k < sketch_.uneven.size(); ++k) polygon(sketch_.uneven[k], pens[k]);
    }
    for (const NamedOutline& body : sketch_.bodies) outline(body.outline, Vec<2>::Zero(), text::Pen::material);
    const Real left = std::max(sketch_.domain.lower[0], view_.extent().lower[0]);
    const Real right = std::min(sketch_.domain.upper[0], view_.extent().upper[0]);
    if (sketch_.surface) svg_.line(view_(Vec<2>(left, *sketch_.surface)), view_(Vec<2>(right, *sketch_.surface)), text::Pen::surface);
    const std::vector<Vec<2>>& ground = sketch_.ground.line.corners;
    for (std::size_t k = 1; k < ground.size(); ++k) svg_.line(view_(ground[k - 1]), view_(ground[k]), text::Pen::surface);
    for (const NamedOutline& rigid : sketch_.rigid_bodies) outline(rigid.outline, Vec<2>::Zero(), text::Pen::rigid);
  }

  /// Ends what is cut off at the edges of the view.
  void end_inside() { svg_.end_window(); }

  /// Where the driven body will be, and how it goes there.
  void path()
  {
    std::vector<std::pair<Vec<2>, Vec<2>>> drawn;
    for (const PathStep& step : sketch_.path) {
      const Outline& outline_there = sketch_.rigid_bodies[step.rigid].outline;
      const Extent extent = extent_of(outline_there);
      if (step.known) outline(outline_there, step.to - 0.5 * (extent.lower + extent.upper), text::Pen::later);
    }
    for (const PathStep& step : sketch_.path) {
      // A way that was gone already is drawn beside itself.
      const auto same = std::count_if(drawn.begin(), drawn.end(), [&](const auto& other) {
        return std::min((other.first - step.from).norm() + (other.second - step.to).norm(),
                        (other.first - step.to).norm() + (other.second - step.from).norm()) < 1e-9;
      });
      drawn.emplace_back(step.from, step.to);
      const Vec<2> rim(26, 40), way = view_(step.to) - view_(step.from), along = way.normalized();
      const Vec<2> from = view_(step.from).cwiseMax(view_.upper_left() + rim).cwiseMin(view_.lower_right() - rim), to = from + way;
      const Vec<2> beside = Vec<2>(along[1], -along[0]) * (along[0] < 0 ? -1 : 1) * 14 * static_cast<Real>(same);
      svg_.arrow(from + beside, to + beside, step.known ? text::Pen::path : text::Pen::nominal);
      const bool level = std::abs(along[0]) > std::abs(along[1]);
      svg_.number(0.5 * (from + to) + beside + (level ? Vec<2>(0, -14) : Vec<2>(-15, 0)), step.stage + 1);
    }
  }

  void body_names()
  {
    for (const NamedOutline& body : sketch_.bodies) {
      const Extent extent = extent_of(body.outline);
      svg_.text(view_(0.5 * (extent.lower + extent.upper)) + Vec<2>(0, 4), body.name, text::Anchor::middle);
    }
    for (const NamedOutline& rigid : sketch_.rigid_bodies)
      if (const auto* plane = std::get_if<PlaneOutline>(&rigid.outline)) {
        const std::vector<Vec<2>> corners = part_inside(*plane, view_.extent());
        Vec<2> middle = Vec<2>::Zero();
        for (const Vec<2>& corner : corners) middle += view_(corner) / static_cast<Real>(corners.size());
        if (!corners.empty()) svg_.text(middle + Vec<2>(0, 4), rigid.name, text::Anchor::middle);
      }
    if (!sketch_.filled_by.empty() && !sketch_.uneven.empty())
      svg_.text(view_(sketch_.uneven[0].back()) + Vec<2>(10, -14), sketch_.filled_by);
    if (!sketch_.filled_by.empty() && !sketch_.filled.empty()) {
      const Extent& part = sketch_.filled.front().part;
      if (view_.length(part.size()[0]) > letter * static_cast<Real>(sketch_.filled_by.size()) + 20)
        svg_.text(view_(part.lower) + Vec<2>(10, -8), sketch_.filled_by);
      else
        svg_.text(view_(0.5 * (part.lower + part.upper)) + Vec<2>(4, 0), sketch_.filled_by, text::Anchor::middle, true);
    }
  }

  /// The velocity of what flies at the start, as an arrow that begins beside the body's name.
  void flights()
  {
    for (const Flight& flight : sketch_.flights) {
      const Vec<2> along = Vec<2>(flight.velocity[0], -flight.velocity[1]).normalized(), middle = view_(flight.at);
      const Vec<2> from = middle + (12 + 0.5 * letter * static_cast<Real>(flight.name.size()) * std::abs(along[0])) * along;
      svg_.arrow(from, from + 30 * along, text::Pen::path);
      svg_.text(middle + Vec<2>(0, along[1] > 0 ? -14 : 22), text::speed_words(flight.velocity.norm()), text::Anchor::middle);
    }
  }

  void surface_name()
  {
    const bool uneven = !sketch_.ground.line.level();
    if (!sketch_.surface && !uneven) return;
    const auto covered = [&](Real x) {
      return std::any_of(sketch_.rigid_bodies.begin(), sketch_.rigid_bodies.end(), [&](const NamedOutline& rigid) {
        const Extent extent = extent_of(rigid.outline);
        return view_.length(std::abs(x - std::clamp(x, extent.lower[0], extent.upper[0]))) < 70;
      });
    };
    const Real left = std::max(sketch_.domain.lower[0], view_.extent().lower[0]);
    const Real right = std::min(sketch_.domain.upper[0], view_.extent().upper[0]);
    const bool at_left = covered(right);
    const Vec<2> aside(at_left ? 14 : -14, 0);
    const Real x = (at_left ? left : right) + aside[0] / view_.length(1);
    const Vec<2> mark = view_(Vec<2>(x, uneven ? sketch_.ground.line.height(x) : *sketch_.surface));
    svg_.polygon({mark, mark + Vec<2>(-5, -8), mark + Vec<2>(5, -8)}, text::Pen::dimension);
    svg_.text(mark + Vec<2>(at_left ? 10 : -10, -4), "surface", at_left ? text::Anchor::start : text::Anchor::end);
  }

  void fine_name()
  {
    if (!sketch_.fine) return;
    const std::string words = "fine zone";
    const Vec<2> below = view_(Vec<2>(0.5 * (sketch_.fine->lower[0] + sketch_.fine->upper[0]), sketch_.fine->lower[1]));
    const Real half = 0.5 * letter * static_cast<Real>(words.size());
    const Real x = std::clamp(below[0], view_.upper_left()[0] + half + 4, view_.lower_right()[0] - half - 4);
    if (below[1] + 16 < view_.lower_right()[1]) svg_.text(Vec<2>(x, below[1] + 13), words, text::Anchor::middle);
  }

  void supports()
  {
    for (const HeldEdge& edge : sketch_.held) {
      const Vec<2> from = view_(edge.from), to = view_(edge.to), outward(edge.outward[0], -edge.outward[1]);
      edge.wholly ? svg_.hatching(from, to, outward) : svg_.rollers(from, to, outward);
      const Vec<2> middle = 0.5 * (from + to);
      if (outward[0] != 0)
        svg_.text(middle + Vec<2>(outward[0] > 0 ? 21 : -12, 0), edge.words, text::Anchor::middle, true);
      else
        svg_.text(middle + Vec<2>(0, outward[1] > 0 ? 21 : -13), edge.words, text::Anchor::middle);
    }
  }

  /// Length and height of the mesh, or depth and headroom of the bed, left of it and below.
  void bed_dimensions()
  {
    if (!sketch_.domain_known) return;
    const Vec<2>&low = sketch_.domain.lower, &high = sketch_.domain.upper;
    const Vec<2> base = view_(low), right = view_(Vec<2>(high[0], low[1])), top = view_(Vec<2>(low[0], high[1]));
    svg_.dimension(base + Vec<2>(0, 34), right + Vec<2>(0, 34), text::length_words(high[0] - low[0]));
    const bool split = sketch_.surface && *sketch_.surface > low[1] && *sketch_.surface < high[1] &&
                       view_.length(high[1] - *sketch_.surface) > 14 && view_.length(*sketch_.surface - low[1]) > 14;
    const Vec<2> aside(-32, 0);
    if (!split) {
      svg_.dimension(base + aside, top + aside, text::length_words(high[1] - low[1]));
      return;
    }
    const Vec<2> surface = view_(Vec<2>(low[0], *sketch_.surface));
    svg_.dimension(base + aside, surface + aside, text::length_words(*sketch_.surface - low[1]));
    svg_.dimension(surface + aside, top + aside, text::length_words(high[1] - *sketch_.surface));
  }

  /// The width of the driven (else every) rigid body above it, and its embedment beside it where it begins below the surface.
  void body_dimensions()
  {
    for (const NamedOutline& rigid : sketch_.rigid_bodies) {
      const Extent extent = extent_of(rigid.outline);
      if (extent.size()[0] <= 0) continue;
      const Vec<2> left = view_(Vec<2>(extent.lower[0], extent.upper[1])), right = view_(extent.upper);
      const char* letter_of_width = std::holds_alternative<DiskOutline>(rigid.outline) ? "D" : "B";
      const std::string words = fmt::format("{} = {}", letter_of_width, text::length_words(extent.size()[0]));
      if (left[1] < view_.upper_left()[1] + 4 || left[0] < view_.upper_left()[0] || right[0] > view_.lower_right()[0]) {
        words_within(extent, words);
        continue;
      }
      const Vec<2> above(0, -9);
      svg_.dimension(left + above, right + above, "");
      svg_.text(0.5 * (left + right) + above + Vec<2>(0, -5), words, text::Anchor::middle);
      embedment(extent);
    }
  }

  void gravity(const Vec<2>& at)
  {
    const Real size = sketch_.gravity.norm();
    if (size == 0) return;
    const Vec<2> along = Vec<2>(sketch_.gravity[0], -sketch_.gravity[1]) / size;
    svg_.arrow(at - 20 * along, at + 20 * along, text::Pen::dimension);
    svg_.text(at + Vec<2>(0, 38), fmt::format("{:.3g} g", size / standard_gravity), text::Anchor::middle);
  }

  void scale_bar(const Vec<2>& at)
  {
    const Real metres = bar_length(view_.extent().size()[0]), length = view_.length(metres);
    svg_.line(at, at + Vec<2>(length, 0), text::Pen::surface);
    for (const Real end : {0., length}) svg_.line(at + Vec<2>(end, -4), at + Vec<2>(end, 4), text::Pen::surface);
    svg_.text(at + Vec<2>(length + 8, 4), text::length_words(metres));
  }

  /// The stages in words, each with the number that its arrow has; gives how high they are.
  Real stages(const Vec<2>& at, Real width)
  {
    Real y = at[1];
    for (std::size_t k = 0; k < case_.stage.size(); ++k) {
      svg_.number(Vec<2>(at[0] + 8, y), static_cast<int>(k) + 1);
      for (const std::string& line :
           wrapped(stage_words(case_.stage[k], case_.force_dimension()), static_cast<std::size_t>((width - 24) / letter))) {
        svg_.text(Vec<2>(at[0] + 24, y + 4), line);
        y += line_height;
      }
      y += 2;
    }
    return y - at[1];
  }

  text::Svg& svg() { return svg_; }

private:
  void polygon(const std::vector<Vec<2>>& corners, text::Pen pen)
  {
    std::vector<Vec<2>> there;
    for (const Vec<2>& corner : corners) there.push_back(view_(corner));
    svg_.polygon(there, pen);
  }

  void box(const Extent& e, text::Pen pen)
  {
    svg_.rectangle(view_(Vec<2>(e.lower[0], e.upper[1])), Vec<2>(view_.length(e.size()[0]), view_.length(e.size()[1])), pen);
  }

  void outline(const Outline& shape, const Vec<2>& moved, text::Pen pen)
  {
    if (const auto* disk = std::get_if<DiskOutline>(&shape)) svg_.circle(view_(disk->center + moved), view_.length(disk->radius), pen);
    const auto* plane = std::get_if<PlaneOutline>(&shape);
    const std::vector<Vec<2>> corners = plane != nullptr ? part_inside({plane->point + moved, plane->normal}, view_.extent())
                                        : std::holds_alternative<CornersOutline>(shape) ? std::get<CornersOutline>(shape).corners
                                                                                        : std::vector<Vec<2>>{};
    std::vector<Vec<2>> points;
    for (const Vec<2>& corner : corners) points.push_back(view_(plane != nullptr ? corner : Vec<2>(corner + moved)));
    if (points.size() >= 3) svg_.polygon(points, pen);
  }

  /// At the top of the part of a body that the view shows.
  void words_within(const Extent& body, const std::string& words)
  {
    const Extent seen{body.lower.cwiseMax(view_.extent().lower), body.upper.cwiseMin(view_.extent().upper)};
    if (seen.size().minCoeff() > 0)
      svg_.text(view_(Vec<2>(0.5 * (seen.lower[0] + seen.upper[0]), seen.upper[1])) + Vec<2>(0, 20), words, text::Anchor::middle);
  }

  void embedment(const Extent& body)
  {
    if (!sketch_.surface && sketch_.ground.line.level()) return;
    const Real surface = sketch_.ground.level_at(0.5 * (body.lower[0] + body.upper[0]), sketch_.surface.value_or(case_.surface));
    const Real w = surface - body.lower[1];
    if (w <= 1e-3 * body.size()[1] || body.lower[1] < sketch_.domain.lower[1]) return;
    const Vec<2> level = view_(Vec<2>(body.upper[0], surface)) + Vec<2>(16, 0);
    const Vec<2> lowest = view_(Vec<2>(body.upper[0], body.lower[1])) + Vec<2>(16, 0);
    svg_.line(view_(Vec<2>(0.5 * (body.lower[0] + body.upper[0]), body.lower[1])), lowest, text::Pen::dimension);
    svg_.dimension(lowest, level, "");
    svg_.text(lowest + Vec<2>(8, 12), "w = " + text::length_words(w));
  }

  const problem::Case& case_;
  const Sketch& sketch_;
  const View& view_;
  text::Svg svg_;
};

/// The mesh, and what stands out of it above and below, as far as it is not much higher.
Extent whole_extent(const Sketch& sketch)
{
  Extent extent = sketch.domain;
  for (const NamedOutline& rigid : sketch.rigid_bodies) extent = around(extent, extent_of(rigid.outline));
  const Vec<2> max(0, beyond * sketch.domain.size()[1]);
  return {extent.lower.cwiseMax(sketch.domain.lower - max), extent.upper.cwiseMin(sketch.domain.upper + max)};
}

/// Around the way of the driven bodies, with a part of their size to spare; none where they are large in the whole anyway.
std::optional<Extent> detail_extent(const Sketch& sketch)
{
  std::optional<Extent> way;
  Real size = 0;
  for (const PathStep& step : sketch.path) {
    const Extent start = extent_of(sketch.rigid_bodies[step.rigid].outline);
    const Vec<2> half = 0.5 * start.size();
    size = std::max(size, start.size().maxCoeff());
    for (const Vec<2>& center : {Vec<2>(0.5 * (start.lower + start.upper)), step.from, step.to}) {
      const Extent there{center - half, center + half};
      way = way ? around(*way, there) : there;
    }
  }
  if (!way || size <= 0 || size > small_part * sketch.domain.size().maxCoeff()) return {};
  way->lower -= size * Vec<2>(0.6, 0.7);
  way->upper += size * Vec<2>(1.1, 0.35);  // right of the body stand its embedment and the name of the surface
  return way;
}

std::string description_of(const problem::Case& c, const Sketch& sketch)
{
  std::vector<std::string> parts;
  if (sketch.domain_known)
    parts.push_back(
        fmt::format("mesh of {} by {}", text::length_words(sketch.domain.size()[0]), text::length_words(sketch.domain.size()[1])));
  for (const NamedOutline& rigid : sketch.rigid_bodies) {
    const Extent extent = extent_of(rigid.outline);
    const Vec<2> middle = 0.5 * (extent.lower + extent.upper);
    parts.push_back(fmt::format("rigid body {} of {} at x = {}, y = {}", rigid.name, text::length_words(extent.size()[0]),
                                text::length_words(middle[0]), text::length_words(middle[1])));
  }
  for (const HeldEdge& edge : sketch.held) parts.push_back(edge.words);
  for (const problem::StageSettings& stage : c.stage) parts.push_back(stage_words(stage, c.force_dimension()));
  return fmt::format("{}", fmt::join(parts, "; "));
}

std::string draw_whole(const problem::Case& c, const Sketch& sketch, const std::string& title, bool with_path)
{
  const Real left = 104, top = 46, right = 84;
  const View view(whole_extent(sketch), whole_width, whole_height, Vec<2>(left, top));
  Drawer drawer(c, sketch, view);
  drawer.inside();
  if (with_path) drawer.path();
  drawer.end_inside();
  drawer.supports();
  drawer.bed_dimensions();
  drawer.fine_name();
  drawer.surface_name();
  drawer.body_names();
  drawer.flights();
  if (with_path) drawer.body_dimensions();
  const Vec<2> corner = view.lower_right();
  drawer.gravity(Vec<2>(corner[0] + 58, top + 24));
  drawer.svg().text(Vec<2>(left, 14), "whole model");
  drawer.scale_bar(Vec<2>(left, corner[1] + 66));
  Real height = corner[1] + 84;
  if (with_path) height += 6 + drawer.stages(Vec<2>(left, height + 6), std::max(view.size()[0], min_width));
  return drawer.svg().whole(Vec<2>(std::max(corner[0], left + min_width) + right, height), title, description_of(c, sketch));
}

std::string draw_detail(const problem::Case& c, const Sketch& sketch, const Extent& extent, const std::string& title)
{
  const Real left = 16, top = 26, right = 16;
  const View view(extent, detail_width, detail_height, Vec<2>(left, top));
  Drawer drawer(c, sketch, view);
  drawer.inside();
  drawer.path();
  drawer.end_inside();
  drawer.surface_name();
  drawer.body_dimensions();
  const Vec<2> corner = view.lower_right();
  drawer.svg().text(Vec<2>(left, 14), "enlarged");
  drawer.scale_bar(Vec<2>(left, corner[1] + 18));
  const Real from = corner[1] + 44, width = std::max(view.size()[0], min_width);
  const Real height = from + drawer.stages(Vec<2>(left, from), width);
  return drawer.svg().whole(Vec<2>(left + width + right, height), title + ", enlarged", description_of(c, sketch));
}

}  // namespace

Drawing draw_case(const problem::Case& settings, const std::string& title)
{
  return draw_case(settings, title, problem::ground_of(settings));
}

Drawing draw_case(const problem::Case& settings, const std::string& title, const problem::Ground& ground)
{
  const Sketch sketch = sketch_of(settings, ground);
  const std::optional<Extent> detail = detail_extent(sketch);
  Drawing drawing{draw_whole(settings, sketch, title, !detail), sketch.notes};
  if (detail) drawing.svgs += draw_detail(settings, sketch, *detail, title);
  return drawing;
}

}  // namespace berm::report
