// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/physics/interface.cpp
#include "mpm/interface.hpp"

#include "contact/footprint.hpp"
#include "contact/strips.hpp"
#include "mpm/contact_velocity.hpp"

namespace berm::mpm {
namespace {

using problem::Bond;

constexpr Real number_of(Bond bond)
{
  return static_cast<Real>(bond);
}

/// The number of the material that a particle is in its body.
template <int dim>
Index material_number(const problem::Body<dim>& body, const bodies::Particle<dim>& p)
{
  const int index = settings::material_index_offset(body.soil);
  return index == none ? 0 : static_cast<Index>(p.extra[index]);
}

/// The adhesion of the soil that a particle is.
template <int dim>
Real adhesion_beside(const problem::Body<dim>& body, const problem::Contact& contact, const bodies::Particle<dim>& p)
{
  const problem::AdhesionLaw& law = contact.adhesion_law;
  const Real slip = contact.memory.slip == none ? 0 : p.extra[contact.memory.slip];
  const Index number = material_number(body, p);
  if (!(law.factor_beside(number) > 0)) return law.adhesion_beside(number, slip);
  const material::Material& soil = law.soils[static_cast<std::size_t>(number)];
  if (!settings::varies(body.soil)) return law.at(soil, p.extra, slip, number);
  return law.at(with_local_values(soil, p.extra + state_size(soil)), p.extra, slip, number);
}

/// The total normal stress on a surface with this normal, Pa, compression positive.
template <int dim>
Real pressure_on(const SymTensor<dim>& stress, const Vec<dim>& n)
{
  Real pressure = 0;
  for (int a = 0; a < dim; ++a)
    for (int b = 0; b < dim; ++b) pressure -= n[a] * stress[tensor_index(std::min(a, b), std::max(a, b))] * n[b];
  return pressure;
}

}  // namespace

template <int dim>
void recall(const problem::Model<dim>& model, problem::State<dim>& state, const problem::Contact& contact,
            contact::ContactPoints<dim>& points)
{
  if (contact.memory.bond == none && !contact.adhesion_law.differs() && contact.pore_pressure == none) return;
  bodies::Particles<dim>& particles = state.particles[contact.body];
  contact::for_each_point(points, [&](contact::ContactPoint<dim>& point) {
    if (point.block == none) return;  // of another rank
    if (contact.memory.bond != none) {
      Real& bond = particles.extra(point.block)[contact.memory.bond][point.lane];
      const bool bonded = bond == number_of(Bond::bonded);
      if (bonded && !point.touching && contact.tension < infinity) bond = number_of(Bond::parted);
      point.bonded = bonded && point.touching;
    }
    if (contact.adhesion_law.differs()) {
      const bodies::Particle<dim> p = particles.read(point.block, point.lane);
      const problem::Body<dim>& body = model.bodies[contact.body];
      point.adhesion = adhesion_beside(body, contact, p);
      if (const auto& by_soil = contact.adhesion_law.by_soil; !by_soil.empty())
        point.friction = by_soil[static_cast<std::size_t>(material_number(body, p))].friction;
    }
    if (contact.pore_pressure != none) {
      const bodies::Particle<dim> p = particles.read(point.block, point.lane);
      point.pore_pressure = p.extra[contact.pore_pressure];
      point.soil_pressure = pressure_on(p.stress, point.normal);
    }
  });
  struct Recalled {
    Real adhesion, friction, pore_pressure, soil_pressure;
    bool bonded;
  };
  contact::share_points<Recalled>(
      points,
      [](const contact::ContactPoint<dim>& point, Recalled& recalled) {
        recalled = {point.adhesion, point.friction, point.pore_pressure, point.soil_pressure, point.bonded};
      },
      [](const Recalled& recalled, contact::ContactPoint<dim>& point) {
        point.adhesion = recalled.adhesion;
        point.friction = recalled.friction;
        point.pore_pressure = recalled.pore_pressure;
        point.soil_pressure = recalled.soil_pressure;
        point.bonded = recalled.bonded;
      });
  if (contact.pore_pressure != none) find_water_fractions(points, model.mesh);
}

template <int dim>
void remember(const problem::Model<dim>& model, problem::State<dim>& state, const Workspace<dim>& workspace)
{
  for (std::size_t k = 0; k < model.contacts.size(); ++k) {
    const problem::Contact& contact = model.contacts[k];
    const Index bond = contact.memory.bond, slip = contact.memory.slip;
    if (bond == none && slip == none) continue;
    bodies::Particles<dim>& particles = state.particles[contact.body];
    contact::for_each_point(workspace.contact_points[k], [&](const contact::ContactPoint<dim>& point) {
      if (point.block == none) return;
      Lanes* extra = particles.extra(point.block);
      if (bond != none && point.impulse.dot(point.normal) > 0 && extra[bond][point.lane] == number_of(Bond::never))
        extra[bond][point.lane] = number_of(Bond::bonded);
      if (slip == none || !point.touching || point.status == contact::ContactStatus::sticking) return;
      const Vec<dim> relative = relative_velocity(workspace, contact, point, Moved<dim>{});
      extra[slip][point.lane] += state.dt * (relative - relative.dot(point.normal) * point.normal).norm();
    });
  }
}

template <int dim>
SurfaceInContact surface_in_contact(const problem::Contact& contact, const contact::ContactPoints<dim>& points)
{
  SurfaceInContact sum;
  Real shear = 0;
  for (const contact::ContactPoint<dim>& point : points.list) {
    sum.area += point.area;
    sum.in_tension += point.impulse.dot(point.normal) < 0 ? point.area : 0;
    shear += point.area * (contact.adhesion_law.differs() ? point.adhesion : contact.adhesion);
  }
  if (sum.area > 0) sum.in_tension /= sum.area, sum.adhesion = shear / sum.area;
  return sum;
}

#define BERM_INSTANTIATE(dim)                                                                                                              \
  template void recall(const problem::Model<dim>&, problem::State<dim>&, const problem::Contact&, contact::ContactPoints<dim>&);           \
  template void remember(const problem::Model<dim>&, problem::State<dim>&, const Workspace<dim>&);                                         \
  template SurfaceInContact surface_in_contact(const problem::Contact&, const contact::ContactPoints<dim>&);
BERM_INSTANTIATE(2)
BERM_INSTANTIATE(3)
#undef BERM_INSTANTIATE

}  // namespace berm::mpm
