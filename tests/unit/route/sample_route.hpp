// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "route/route_report.hpp"

namespace berm::route {

/// The line of examples/route_buckling: clay, sand in a curve, a buried landfall.
inline RouteCase sample_route()
{
  RouteCase c;
  c.title = "A hot line";
  c.pipe.diameter = 0.3239, c.pipe.wall = 0.0159;
  c.pipe.laying = 700, c.pipe.flooded = 1250, c.pipe.operation = 900;
  c.pipe.lay_tension = 50e3, c.pipe.lay_factor = 2;
  c.operation = {{0, 12000}, {80, 32}, {15e6, 15e6}};
  Section clay;
  clay.name = "clay", clay.from = 0, clay.to = 4000;
  clay.strength = {1500, 2000, 3000}, clay.gradient = 1500, clay.unit_weight = 5000;
  clay.sensitivity = {3}, clay.adhesion_factor = {0.5}, clay.strength_ratio = {0.25, 0.35, 0.45};
  clay.exponent = 0.5, clay.consolidation = 0.9;
  Section sand;
  sand.name = "sand", sand.from = 4000, sand.to = 11500, sand.unit_weight = 9000, sand.curve_radius = 1500;
  sand.friction_angle = {30 * degree, 33 * degree, 36 * degree}, sand.interface_angle = {25 * degree, 28 * degree, 31 * degree};
  Section landfall;
  landfall.name = "landfall", landfall.from = 11500, landfall.to = 12000, landfall.unit_weight = 8500;
  landfall.friction_angle = {33 * degree}, landfall.interface_angle = {28 * degree};
  landfall.cover = 0.8, landfall.prop_height = 0.3;
  c.section = {clay, sand, landfall};
  return c;
}

inline Resistances no_run(const std::filesystem::path&, const Pipe&)
{
  return {};
}

}  // namespace berm::route
