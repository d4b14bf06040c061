// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/structures/penetration/penetration_test.cpp
#include "structures/penetration/penetrometers.hpp"

#include "formulas/penetrometer.hpp"
#include "structures/penetration/penetration_run.hpp"

#include <fmt/format.h>

namespace berm::penetration {
namespace {

constexpr base::Limit ball_cells = base::too_large(
    {40, 10, base::Effect::contact_width,
     "a body acts as if up to a cell larger on each side: (1 + 2 h/D)^2 - 1 of its area (examples/circular_footing)", true});

std::vector<Comparison> published_of_ball(const PenetrationRun& run)
{
  if (run.measure() != Measure::strength) return {};
  const SoilAt soil = run.soil.at(run.z_end());
  std::vector<Comparison> list = {{"N<sub>ball</sub>", run.last().factor, formulas::ball_factor(soil.interface_ratio), "deep", true}};
  if (soil.interface_ratio > 0 || run.soil.varies()) return list;
  for (const Real w : {0.05, 0.1, 0.3, 0.5}) {
    const Real z = w * run.body.width - run.body.shoulder, factor = run.factor_at(z);
    if (std::isfinite(factor))
      list.push_back({fmt::format("V/(D² s<sub>u</sub>) at w = {:g} D", w), factor * pi / 4, formulas::smooth_sphere(w),
                      "wished in place: heave increases it"});
  }
  return list;
}

}  // namespace

/// A ball that is pushed in: q over its largest section, N_ball = q/s_u less the weight of the soil that it displaces, over the depth of its centre.
const Penetrometer& ball()
{
  static const Penetrometer ball{.word = "ball",
                                 .level = "centre of the ball",
                                 .resistance = {"q_ball", "q<sub>ball</sub>"},
                                 .in_clay = {"N_ball", "N<sub>ball</sub>"},
                                 .in_sand = {"Q_ball", "Q<sub>ball</sub>"},
                                 .sand_measure = SandMeasure::overburden,
                                 .flows_around = true,
                                 .averaging = 0.05,
                                 .last_travel = 1,
                                 .depths = {-0.4, -0.2, 0, 0.25, 0.5, 1, 1.5, 2, 3, 4, 5, 6, 8, 10, 15, 20},
                                 .keeps_push = false,
                                 .cells = &ball_cells,
                                 .published = published_of_ball,
                                 .remark = "Factors of a deep ball are not shown: their sources have not been checked (docs/formulas.md)."};
  return ball;
}

}  // namespace berm::penetration
