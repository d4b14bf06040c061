// SPDX-License-Identifier: BSD-3-Clause
#include "problem/interface.hpp"

#include "contact/detect.hpp"
#include "core/names.hpp"
#include "material/linear_elastic.hpp"
#include "settings/body_soil.hpp"
#include "settings/case.hpp"
#include "settings/interface.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::problem {
namespace {

/// Half widths of a particle, from the surface: in triangles the centres of the first row lie 0.94 from it and those of the second 1.89. Were that bonded too, the cells at the
/// surface could not strain.
constexpr Real first_row = 1.5;

}  // namespace

Real AdhesionLaw::part_left(Real slip) const
{
  return softens() ? 1 / sensitivity + (1 - 1 / sensitivity) * std::exp(-3 * slip / ductility) : 1;
}

Real AdhesionLaw::at(const material::Material& soil, const Real* state, Real slip, Index number) const
{
  const Real share = factor_beside(number);
  if (!(share > 0)) return adhesion_beside(number, slip);
  const Real at_rest = settings::undrained_strength(soil).value_or(0);
  const Real now =
      shear_strength(soil, 0, state).value_or(at_rest);  // of a law whose strength depends on the direction: that in simple shear
  return share * (softens() ? std::min(now, part_left(slip) * at_rest) : now);
}

AdhesionLaw adhesion_law(const contact::ContactSettings& contact, const settings::BodySoil& soil)
{
  AdhesionLaw law{contact.adhesion, contact.adhesion_factor, contact.adhesion_sensitivity, contact.adhesion_ductility};
  if (!contact.soil.empty()) {
    law.by_soil.assign(soil.materials.size(), {std::tan(contact.friction_angle), contact.adhesion, contact.adhesion_factor});
    for (const contact::SoilInterfaceSettings& beside : contact.soil)
      for (std::size_t k = 0; k < soil.names.size(); ++k)
        if (soil.names[k] == beside.material) law.by_soil[k] = {std::tan(beside.friction_angle), beside.adhesion, beside.adhesion_factor};
  }
  const bool some = std::any_of(law.by_soil.begin(), law.by_soil.end(), [](const SoilInterface& beside) { return beside.factor > 0; });
  if (law.factor > 0 || some)
    for (const material::Material& material : soil.materials) law.soils.push_back(at_depth(material, 0));
  return law;
}

template <int dim>
void bond_at_start(mesh::Metric metric, bodies::Particles<dim>& particles, const bodies::RigidShape<dim>& shape, int bond)
{
  particles.visit([&](Index, Index b, int l) {
    const bodies::Particle<dim> p = particles.read(b, l);
    if (surface_at<dim>(shape, p.x).distance < first_row * contact::half_width<dim>(section_of(metric, p.volume, p.x)))
      particles.extra(b)[bond][l] = static_cast<Real>(Bond::bonded);
  });
}

template void bond_at_start(mesh::Metric, bodies::Particles<2>&, const bodies::RigidShape<2>&, int);
template void bond_at_start(mesh::Metric, bodies::Particles<3>&, const bodies::RigidShape<3>&, int);

}  // namespace berm::problem
