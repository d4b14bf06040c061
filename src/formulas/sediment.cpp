// SPDX-License-Identifier: BSD-3-Clause
#include "formulas/sediment.hpp"

#include <cmath>

namespace berm::formulas {
namespace {

constexpr Real density_ratio = 2.65, viscosity = 1.36e-6;  // m2/s
constexpr const char* sizes = "d_50 of 0.06 to 2 mm";

bool is_sand(Real grain)
{
  return within(grain, 0.06e-3, 2e-3);
}

}  // namespace

Formula critical_shields(Real grain)
{
  constexpr Source source{Label::fit, "Soulsby and Whitehouse 1997", sizes};
  const Real size = grain * std::cbrt((density_ratio - 1) * standard_gravity / (viscosity * viscosity));
  return formula(0.3 / (1 + 1.2 * size) + 0.055 * (1 - std::exp(-0.02 * size)), source, is_sand(grain));
}

Formula shields_parameter(const BedFlow& flow, Real grain)
{
  constexpr Source source{Label::fit, "Soulsby 1997", sizes};
  const Real way = flow.velocity * flow.period / (2 * pi);
  const Real waves = flow.velocity > 0 ? 0.237 * std::pow(way / (2.5 * grain), -0.52) * flow.velocity * flow.velocity / 2 : 0;  // over rho
  const Real current = std::pow(0.4 * flow.current / std::log1p(flow.height / flow.roughness), 2);
  const Real mean = current > 0 ? current * (1 + 1.2 * std::pow(waves / (current + waves), 3.2)) : 0;
  const Real largest = std::hypot(mean + waves * std::cos(flow.angle), waves * std::sin(flow.angle));
  return formula(largest / ((density_ratio - 1) * standard_gravity * grain), source, is_sand(grain));
}

}  // namespace berm::formulas
