// SPDX-License-Identifier: BSD-3-Clause
#include "settings/water_loads.hpp"

#include "core/usual.hpp"

#include <algorithm>

namespace berm::settings {

WaterReductions water_reductions(Real embedment, Real trench_depth, Real trench_angle, bool permeable)
{
  const Real angle = trench_angle / degree - 5;
  const bool trench = trench_depth > 0;
  const Real in_trench_y = trench ? 1 - 0.18 * std::pow(angle, 0.25) * std::pow(trench_depth, 0.42) : 1;
  const Real in_trench_z = trench ? 1 - 0.14 * std::pow(angle, 0.43) * std::pow(trench_depth, 0.46) : 1;
  const Real embedded_z = embedment < 0.1 ? 1 : std::max(1 - 1.3 * (embedment - 0.1), Real(0));
  return {std::max(1 - 1.4 * embedment, 0.3) * std::max(in_trench_y, Real(0)),
          embedded_z * std::max(in_trench_z, Real(0)) * (permeable ? 0.7 : 1)};
}

WaterForce water_force(const WaterSettings& water, const WaterMotion& motion, Real diameter, Real velocity, Real embedment)
{
  const Real D = diameter, relative = motion.velocity - velocity;
  const WaterReductions left =
      water_reductions(std::max(embedment / D, Real(0)), water.trench_depth / D, water.trench_angle, water.permeable);
  const Real pressure = water.density * D / 2, displaced = water.density * pi * D * D / 4;
  return {left.horizontal * (pressure * water.drag * std::abs(relative) * relative + displaced * water.inertia * motion.acceleration),
          water.weight - left.vertical * pressure * water.lift * relative * relative};
}

Real mass_in_water(const WaterSettings& water, Real diameter)
{
  return water.weight / standard_gravity + water.inertia * water.density * pi * diameter * diameter / 4;
}

void describe(Describe& d, WaterSettings& water)
{
  d.value("density", water.density, {.meaning = "density of the water", .unit = "kg/m^3", .range = positive});
  d.value("drag", water.drag, {.meaning = "drag coefficient C_D of Morison's equation", .range = not_negative, .required = true});
  d.value("inertia", water.inertia, {.meaning = "inertia coefficient C_M", .range = not_negative, .required = true});
  d.value("lift", water.lift, {.meaning = "lift coefficient C_L", .range = not_negative, .required = true});
  d.value("weight", water.weight, {.meaning = "submerged weight of the pipe", .unit = "N/m", .range = positive, .required = true});
  d.value("permeable", water.permeable, {.meaning = "water flows through the seabed below the pipe: 0.7 of the lift is left"});
  d.value("trench_depth", water.trench_depth,
          {.meaning = "depth of a trench in which the pipe is sheltered", .unit = "m", .range = not_negative});
  d.value("trench_angle", water.trench_angle,
          {.meaning = "slope of its walls, where there is one: 5 deg or more", .unit = "rad", .range = {0, 45 * degree}});
  declare_usual(d, {{"density", {990, 1040}}, {"drag", {0.3, 3}}, {"inertia", {1, 5}}, {"lift", {0.3, 3}}, {"weight", {10, 5e4}}});
}

}  // namespace berm::settings
