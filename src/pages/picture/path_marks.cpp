// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/picture/model_picture_test.cpp
#include "picture/legend.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::picture {
namespace {

/// A way and the stages that go it.
struct Way {
  PathStep step;
  std::string numbers;
  int count = 0;
};

std::vector<Way> ways_of(const Sketch& sketch)
{
  constexpr int max_numbers = 3;
  std::vector<Way> ways;
  for (const PathStep& step : sketch.path) {
    auto same = std::find_if(ways.begin(), ways.end(), [&](const Way& way) {
      return way.step.rigid == step.rigid && (way.step.from - step.from).norm() + (way.step.to - step.to).norm() < 1e-9;
    });
    if (same == ways.end()) same = ways.insert(ways.end(), {step, "", 0});
    if (same->count < max_numbers) same->numbers += fmt::format("{}{}", same->count > 0 ? ", " : "", step.stage + 1);
    if (same->count++ == max_numbers) same->numbers += ", ...";
  }
  return ways;
}

}  // namespace

std::string stage_color(settings::StageKind kind)
{
  switch (kind) {
  case settings::StageKind::push:
    return push_color;
  case settings::StageKind::drag:
  case settings::StageKind::sweep:
    return drag_color;
  case settings::StageKind::drive:
  case settings::StageKind::pipeline:
    return "#2e7d32";
  case settings::StageKind::geostatic:
  case settings::StageKind::free:
    break;
  }
  return "#5f6b76";
}

void number_mark(Canvas& canvas, const Vec<2>& center, const std::string& number, const std::string& color)
{
  const Real half = std::max<Real>(10, 0.5 * Canvas::width_of(number, 10) + 5);
  const Vec<2> side(half - 10, 0);
  canvas.disk(center - side, 10, color);
  canvas.disk(center + side, 10, color);
  canvas.polygon({Vec<2>(center - side - Vec<2>(0, 10)), Vec<2>(center + side - Vec<2>(0, 10)), Vec<2>(center + side + Vec<2>(0, 10)),
                  Vec<2>(center - side + Vec<2>(0, 10))},
                 color);
  canvas.text(center, number, {.size = 10, .anchor = Anchor::center, .color = ground_color, .bold = true, .halo = false});
}

void path_marks(Canvas& canvas, const Model& model, const Scale& scale)
{
  const std::vector<Way> ways = ways_of(model.sketch);
  for (const Way& way : ways)
    if (way.step.known) {
      const Outline& outline = model.sketch.rigid_bodies[way.step.rigid].outline;
      const Extent extent = extent_of(outline);
      canvas.outline(outline_points(outline, scale, way.step.to - 0.5 * (extent.lower + extent.upper)), {rim_color, 1.3, dashed});
    }
  for (std::size_t k = 0; k < ways.size(); ++k) {
    const PathStep& step = ways[k].step;
    const std::string color = stage_color(model.settings.stage[step.stage].kind);
    // The middle of a half-plane may lie at the rim, or anywhere: the arrow is moved to where it is seen.
    const Vec<2> rim(30, 30), way = scale(step.to) - scale(step.from), along = way.normalized();
    const Vec<2> from = scale(step.from).cwiseMax(scale.window().upper_left + rim).cwiseMin(scale.window().lower_right - rim),
                 to = from + way;
    // The way back lies beside the way out.
    const auto back = std::any_of(ways.begin(), ways.begin() + static_cast<std::ptrdiff_t>(k), [&](const Way& other) {
      return (other.step.from - step.to).norm() + (other.step.to - step.from).norm() < 1e-9;
    });
    const Vec<2> beside = back ? Vec<2>(18 * Vec<2>(-along[1], along[0])) : Vec<2>(Vec<2>::Zero());
    canvas.arrow(from + beside, to + beside, {color, 2.6, step.known ? "" : dashed});
    const Vec<2> middle = 0.5 * (from + to) + beside;
    const bool upright = std::abs(along[1]) > std::abs(along[0]);
    const bool room = (to - from).norm() > 50;
    number_mark(canvas, room ? middle : Vec<2>(middle + (upright ? Vec<2>(18, 0) : Vec<2>(0, -18))), ways[k].numbers, color);
  }
}

}  // namespace berm::picture
