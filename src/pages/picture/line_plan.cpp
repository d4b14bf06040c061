// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/picture/line_plan_test.cpp
#include "picture/line_plan.hpp"

#include "picture/panel.hpp"
#include "slices/line_of_case.hpp"
#include "text/quantity_words.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace berm::picture {
namespace {

constexpr Real room_left = 74, room_above = 64, bump = 84, room_below = 118;  // pixels, around the axis of the line
constexpr Real room_of_end = 190;                                             // of the far end, behind a break

/// From metres along and beside the line to pixels.
struct PlanScale {
  Vec<2> origin;  ///< pixels, of x = 0 on the axis
  Real along, sideways;

  Vec<2> operator()(Real x, Real y) const { return origin + Vec<2>(along * x, -sideways * y); }
};

/// 1, 2 or 5 times a power of ten, not above a number.
Real round_down(Real number)
{
  const Real power = std::pow(10., std::floor(std::log10(number)));
  for (const Real step : {5., 2.})
    if (step * power <= number) return step * power;
  return power;
}

/// The shape of the line without stress up to a place, with points between its nodes.
Points shape_of_line(const beam::Line& line, Real reach)
{
  constexpr int parts = 8;
  Points points;
  for (Index i = 0; i < line.elements() && line.x[i] < reach; ++i) {
    const Index a = line.across(beam::Plane::lateral, i), b = line.across(beam::Plane::lateral, i + 1);
    const Real L = line.length(i);
    for (int k = points.empty() ? 0 : 1; k <= parts; ++k) {
      const Real s = static_cast<Real>(k) / parts, t = 1 - s;
      const Real y = t * t * (1 + 2 * s) * line.shape[a] + s * s * (1 + 2 * t) * line.shape[b] +
                     s * t * L * (t * line.shape[a + 1] - s * line.shape[b + 1]);
      if (line.x[i] + s * L <= reach) points.emplace_back(line.x[i] + s * L, y);
    }
  }
  return points;
}

/// A spring across the line, from it to what holds it.
void spring_sign(Canvas& canvas, const Vec<2>& at)
{
  Points zigzag{at};
  for (int k = 0; k < 6; ++k) zigzag.push_back(at + Vec<2>(k % 2 == 0 ? 5 : -5, 8 + 4 * k));
  zigzag.push_back(at + Vec<2>(0, 34));
  canvas.line(zigzag, {support_color, 1.2});
  canvas.line({Vec<2>(at + Vec<2>(-8, 34)), Vec<2>(at + Vec<2>(8, 34))}, {support_color, 1.6});
}

void slice_signs(Canvas& canvas, const slices::LineOfCase& line, const PlanScale& scale)
{
  Real apart = infinity;
  for (std::size_t k = 1; k < line.places.size(); ++k) apart = std::min(apart, line.places[k] - line.places[k - 1]);
  const Real half = std::clamp(0.35 * scale.along * apart, 1.5, 8.);
  for (const Real x : line.places) {
    const Vec<2> middle = scale(x, 0);
    const Points strip = corners_of({Vec<2>(middle - Vec<2>(half, bump / 2)), Vec<2>(middle + Vec<2>(half, bump / 2))});
    canvas.polygon(strip, soil_color(0));
    canvas.outline(strip, {surface_color, 1});
  }
}

/// What is at x = 0, where the other half begins.
void middle_sign(Canvas& canvas, const settings::PipelineSettings& p, const PlanScale& scale)
{
  const Vec<2> middle = scale(0, 0);
  canvas.line({Vec<2>(middle - Vec<2>(0, bump + 26)), Vec<2>(middle + Vec<2>(0, 60))}, {quiet_color, 1, "9 3 2 3"});
  canvas.text(middle - Vec<2>(18, bump / 2), p.half == settings::LineHalf::symmetric ? "mirror image" : "rotated by 180 degrees",
              {.size = 10, .anchor = Anchor::center, .upright = true});
}

/// The far end at a place of the axis, pixels.
void end_sign(Canvas& canvas, const settings::PipelineSettings& p, const Vec<2>& at)
{
  const bool held = p.end == settings::LineEnd::anchored;
  if (held) {
    canvas.line({Vec<2>(at - Vec<2>(0, 16)), Vec<2>(at + Vec<2>(0, 16))}, {support_color, 2});
    for (const Real beside : {-10., 10.}) support_sign(canvas, at + Vec<2>(0, beside), Vec<2>(1, 0), 3);
  }
  canvas.text(at - Vec<2>(0, 32), held ? "anchored" : "free", {.size = 10, .anchor = Anchor::center});
}

std::string friction_words(const settings::FarSoil& soil)
{
  return fmt::format("springs beyond the slices: {:.3g} W lateral, {:.3g} W axial", soil.friction, soil.axial_friction);
}

}  // namespace

Real draw_line_plan(Canvas& canvas, const settings::Case& c, const Vec<2>& at, Real width)
{
  const slices::LineOfCase line(c);
  const settings::PipelineSettings& p = line.settings;
  const Real last_slice = line.places.back(), wanted = 1.3 * std::max(last_slice, p.imperfection.length / 2);
  const bool broken = wanted < p.length;
  const Real reach = broken ? wanted : p.length, room = width - room_left - (broken ? room_of_end : 60);
  PlanScale scale{at + Vec<2>(room_left, room_above + bump), room / reach, 0};
  const Real size = std::abs(p.imperfection.amplitude), times = round_down(bump / (size * scale.along));
  scale.sideways = times * scale.along;
  canvas.text(at + Vec<2>(0, 10), fmt::format("Plan of the line, one half; lateral scale {:g} times larger", times),
              {.size = 13, .bold = true});

  slice_signs(canvas, line, scale);
  const Vec<2> axis_end = scale(reach, 0), far_end = broken ? Vec<2>(axis_end + Vec<2>(room_of_end - 80, 0)) : axis_end;
  canvas.line({scale(0, 0), far_end}, {quiet_color, 0.8, dashed});
  middle_sign(canvas, p, scale);
  Points drawn;
  for (const Vec<2>& point : shape_of_line(line.line, reach)) drawn.push_back(scale(point[0], point[1]));
  drawn.push_back(far_end);
  canvas.line(drawn, {rim_color, 3});
  const auto below = [&](Real x, Real level) -> Vec<2> { return scale(x, 0) + Vec<2>(0, level); };
  if (last_slice < reach) {
    for (const Real part : {0.25, 0.55, 0.85}) spring_sign(canvas, scale(std::lerp(last_slice, reach, part), 0));
    canvas.text(below(last_slice, 50) + Vec<2>(14, 0), friction_words(p.far_soil), {.size = 10});
  }
  if (broken) {
    const Vec<2> gap = axis_end + Vec<2>(26, 0);
    for (const Real shift : {-4., 4.})
      canvas.line({Vec<2>(gap + Vec<2>(shift - 5, 12)), Vec<2>(gap + Vec<2>(shift + 5, -12))}, {text_color, 1.4});
  }
  end_sign(canvas, p, far_end);

  canvas.dimension(below(0, 62), below(last_slice, 62), slices::words_of_places(line.places));
  const Real half_length = std::min(p.imperfection.length / 2, reach);
  canvas.dimension(scale(0, 0) - Vec<2>(0, bump + 16), scale(half_length, 0) - Vec<2>(0, bump + 16),
                   fmt::format("imperfection of {}, {} long", text::length_words(size), text::length_words(p.imperfection.length)));
  canvas.dimension(below(0, 96), far_end + Vec<2>(0, 96), text::length_words(p.length));
  return scale.origin[1] + room_below;
}

}  // namespace berm::picture
