// SPDX-License-Identifier: BSD-3-Clause
#include "slices/line_of_case.hpp"

#include "core/error.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace berm::slices {
namespace {

Real diameter_of(const problem::Case& c)
{
  return bodies::width_of<2>(bodies::make_shape<2>(c.rigid.front().second.shape));
}

beam::Pipe pipe_of(const problem::PipelineSettings& p, Real diameter)
{
  beam::Pipe pipe;
  pipe.outer_diameter = diameter;
  pipe.wall = p.wall.value_or(0);
  pipe.young_modulus = p.young_modulus.value_or(0);
  pipe.poisson_ratio = p.poisson_ratio;
  pipe.expansion = p.expansion;
  return pipe;
}

Real mass_of(const problem::Case& c)
{
  return c.pipeline->mass.value_or(c.rigid.front().second.mass);
}

/// Stiffnesses of the case, or of a wall as thick as it is; weight and masses are the case's.
beam::Section section_of_case(const problem::Case& c)
{
  const problem::PipelineSettings& p = *c.pipeline;
  beam::Section section;
  if (p.wall) section = beam::section_of(pipe_of(p, diameter_of(c)));
  if (p.bending_stiffness) section.bending_stiffness = *p.bending_stiffness;
  if (p.axial_stiffness) section.axial_stiffness = *p.axial_stiffness;
  section.mass = mass_of(c);
  section.axial_mass = p.axial_mass.value_or(section.mass);
  section.submerged_weight = p.submerged_weight;
  section.radius = diameter_of(c) / 2;
  return section;
}

Real compression(const problem::PipelineSettings& p, const beam::Section& section, Real diameter, const LineLoads& loads)
{
  if (p.wall) return beam::constrained_force(pipe_of(p, diameter), loads.temperature, loads.pressure, p.lay_tension);
  return section.axial_stiffness * p.expansion * loads.temperature - p.lay_tension;
}

/// The largest compression that the stages can bring, N.
Real largest_compression(const problem::Case& c, const beam::Section& section)
{
  LineLoads now{0, 0, c.pipeline->submerged_weight, 0};
  Real largest = 0;
  for (const problem::StageSettings& stage : c.stage) {
    now = target_of(stage.pipeline, now);
    largest = std::max(largest, compression(*c.pipeline, section, diameter_of(c), now));
  }
  return largest;
}

std::vector<Real> places_of(const problem::SliceSettings& slices)
{
  std::vector<Real> places;
  const int count = static_cast<int>(std::lround(slices.to / slices.spacing));
  for (int k = 0; k <= count; ++k) places.push_back(slices.to * k / count);
  return places;
}

/// Elements as long as slices are apart, or parts of that where a buckle needs them shorter; beyond the slices they grow.
std::vector<Real> nodes_of(const problem::Case& c, const std::vector<Real>& places)
{
  const beam::Section section = section_of_case(c);
  const problem::PipelineSettings& p = *c.pipeline;
  const Real P = largest_compression(c, section);
  // A quarter of the half wave of a column under this compression, which short waves of a buckle come near to.
  const Real longest = P > 0 ? pi * std::sqrt(section.bending_stiffness / P) / 4 : p.length;
  const Real spacing = places[1], size = spacing / std::ceil(spacing / longest);
  constexpr Real growth = 1.1, max_nodes = 20000;
  if (!(p.slices.to / size + p.length / longest < max_nodes))
    throw KeyError(fmt::format("pipeline.length: elements of {:.3g} m, which the largest compression of {:.3g} N asks for, would be more "
                               "than {}: shorten the line, or look at its stiffness and loads",
                               size, P, max_nodes));
  std::vector<Real> nodes = beam::graded_nodes(size, p.slices.to, growth, std::max(size, longest), p.length);
  const auto within = static_cast<std::size_t>(std::lround(p.slices.to / size));
  for (std::size_t k = 0; k <= within && k < nodes.size(); ++k) nodes[k] = p.slices.to * static_cast<Real>(k) / static_cast<Real>(within);
  return nodes;
}

void give_shape(beam::Line& line, const problem::PipelineSettings& p)
{
  const Real a = p.imperfection.amplitude, k = 2 * pi / p.imperfection.length, half = p.imperfection.length / 2;
  const Real b = a * 4 / (3 * std::sqrt(3.0));  // (1 + cos) sin has its largest, 3 sqrt(3)/4, at 60 degrees
  if (p.half == problem::LineHalf::symmetric)
    beam::set_shape(
        line, beam::Plane::lateral, [&](Real x) { return x < half ? a * (1 + std::cos(k * x)) / 2 : 0; },
        [&](Real x) { return x < half ? -a * k * std::sin(k * x) / 2 : 0; });
  else
    beam::set_shape(
        line, beam::Plane::lateral, [&](Real x) { return x < half ? b * std::sin(k * x) * (1 + std::cos(k * x)) : 0; },
        [&](Real x) { return x < half ? b * k * (std::cos(k * x) + std::cos(2 * k * x)) : 0; });
}

beam::Line line_of(const problem::Case& c, const std::vector<Real>& places)
{
  const problem::PipelineSettings& p = *c.pipeline;
  beam::Line line = beam::straight_line(nodes_of(c, places), section_of_case(c), {beam::Plane::lateral, beam::Plane::vertical});
  give_shape(line, p);
  beam::hold(line, 0, p.half == problem::LineHalf::symmetric ? beam::EndCondition::symmetric : beam::EndCondition::antisymmetric);
  if (p.end == problem::LineEnd::anchored) beam::hold(line, line.nodes() - 1, beam::EndCondition::clamped);
  const Real settled = diameter_of(c) / 100;
  const std::vector<Real> beyond = beam::lengths_of_nodes(line, p.slices.to), all = beam::lengths_of_nodes(line);
  const auto sliding = [&](Real friction, Real mobilisation) { return beam::friction(friction * p.submerged_weight, mobilisation); };
  if (p.far_soil.friction > 0)
    beam::add_springs(line, beam::Direction::lateral,
                      sliding(p.far_soil.friction, p.far_soil.mobilisation > 0 ? p.far_soil.mobilisation : settled), beyond);
  if (p.far_soil.axial_friction > 0)
    beam::add_springs(line, beam::Direction::axial, sliding(p.far_soil.axial_friction, p.far_soil.axial_mobilisation), all);
  beam::add_springs(line, beam::Direction::vertical, beam::LinearSpring{p.far_soil.stiffness.value_or(p.submerged_weight / settled)},
                    beyond);
  line.axial_where_sideways = false;
  line.damping[1] = p.vertical_damping;
  return line;
}

}  // namespace

LineOfCase::LineOfCase(const problem::Case& c)
    : line(line_of(c, places_of(c.pipeline->slices))),
      places(places_of(c.pipeline->slices)),
      stations(line, places),
      diameter(diameter_of(c)),
      mass(mass_of(c)),
      length_on_springs(beam::lengths_of_nodes(line, c.pipeline->slices.to)),
      settings(*c.pipeline)
{
}

Real LineOfCase::constrained_force(const LineLoads& loads) const
{
  return compression(settings, line.section.front(), diameter, loads);
}

LineLoads target_of(const problem::PipelineLoads& stage, const LineLoads& before)
{
  return {stage.temperature.value_or(before.temperature), stage.pressure.value_or(before.pressure), stage.weight.value_or(before.weight),
          stage.lateral.value_or(before.lateral)};
}

LineLoads between(const LineLoads& from, const LineLoads& to, Real part)
{
  return {std::lerp(from.temperature, to.temperature, part), std::lerp(from.pressure, to.pressure, part),
          std::lerp(from.weight, to.weight, part), std::lerp(from.lateral, to.lateral, part)};
}

}  // namespace berm::slices
