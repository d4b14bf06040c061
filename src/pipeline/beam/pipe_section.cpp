// SPDX-License-Identifier: BSD-3-Clause
#include "beam/pipe_section.hpp"

namespace berm::beam {

Section section_of(const Pipe& pipe)
{
  const Real outer = pipe.outer_area(), inner = pipe.inner_area(), wall = pipe.wall_area();
  Section section;
  section.bending_stiffness = pipe.young_modulus * (outer * outer - inner * inner) / (4 * pi);
  section.axial_stiffness = pipe.young_modulus * wall;
  section.axial_mass = pipe.density * wall + pipe.content_density * inner;
  section.mass = section.axial_mass + pipe.added_mass * pipe.water_density * outer;
  section.submerged_weight = standard_gravity * (section.axial_mass - pipe.water_density * outer);
  section.radius = pipe.outer_diameter / 2;
  return section;
}

Real constrained_force(const Pipe& pipe, Real temperature_rise, Real pressure_rise, Real lay_tension)
{
  return pipe.young_modulus * pipe.wall_area() * pipe.expansion * temperature_rise +
         (1 - 2 * pipe.poisson_ratio) * pipe.inner_area() * pressure_rise - lay_tension;
}

}  // namespace berm::beam
