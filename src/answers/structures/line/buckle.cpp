// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/structures/line/buckle_test.cpp
#include "structures/line/buckle.hpp"

#include <algorithm>

namespace berm::line {
namespace {

/// A part of the line on one side of its axis.
struct Lobe {
  Real from, to = nan;  ///< m; NaN where it does not end
  Real peak = 0;        ///< m, the largest |y|
};

std::vector<Lobe> lobes_of(const Shape& shape)
{
  std::vector<Lobe> lobes{{shape.x.front()}};
  for (std::size_t i = 0; i < shape.x.size(); ++i) {
    lobes.back().peak = std::max(lobes.back().peak, std::abs(shape.y[i]));
    if (i + 1 == shape.x.size() || shape.y[i] == 0 || shape.y[i] * shape.y[i + 1] > 0) continue;
    const Real crossing = std::lerp(shape.x[i], shape.x[i + 1], shape.y[i] / (shape.y[i] - shape.y[i + 1]));
    lobes.back().to = crossing;
    lobes.push_back({crossing});
  }
  return lobes;
}

/// The last place at which |values| pass a limit, in the straight line between nodes; 0 where none does, the end of the line where that does.
Real last_beyond(const std::vector<Real>& x, const std::vector<Real>& values, Real limit)
{
  for (std::size_t i = x.size(); i-- > 0;) {
    const Real here = std::abs(values[i]);
    if (!(here > limit)) continue;
    return i + 1 == x.size() ? x[i] : std::lerp(x[i], x[i + 1], (here - limit) / (here - std::abs(values[i + 1])));
  }
  return 0;
}

}  // namespace

Buckle buckle_of(const Shape& shape, const settings::PipelineSettings& line)
{
  constexpr Real counts = 0.01;  // of the largest lobe
  const std::vector<Lobe> lobes = lobes_of(shape);
  const Lobe& largest = *std::max_element(lobes.begin(), lobes.end(), [](const Lobe& a, const Lobe& b) { return a.peak < b.peak; });
  const bool mirrored = line.half == settings::LineHalf::symmetric;
  Buckle buckle;
  if (!(largest.peak > 0)) return buckle;
  for (const Lobe& lobe : lobes)
    if (lobe.peak > counts * largest.peak) {
      buckle.lobes += mirrored && &lobe == &lobes.front() ? 1 : 2;
      buckle.half_length = std::isnan(lobe.to) ? shape.x.back() : lobe.to;
    }
  buckle.lobe_length = mirrored && &largest == &lobes.front() ? 2 * largest.to : largest.to - largest.from;
  if (line.far_soil.axial_friction > 0) buckle.slip_length = last_beyond(shape.x, shape.u, line.far_soil.axial_mobilisation);
  for (std::size_t i = 0; i < shape.x.size(); ++i)
    buckle.bending = std::max(buckle.bending, (shape.strain_max[i] - shape.strain_min[i]) / 2);
  return buckle;
}

Real mean_axial(const Shape& shape)
{
  Real sum = 0;
  for (std::size_t i = 0; i + 1 < shape.x.size(); ++i) sum += (shape.x[i + 1] - shape.x[i]) * (shape.u[i] + shape.u[i + 1]) / 2;
  return sum / (shape.x.back() - shape.x.front());
}

}  // namespace berm::line
