// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "bodies/particles.hpp"
#include "bodies/rigid/rigid_body.hpp"
#include "contact/contact_settings.hpp"
#include "material/material.hpp"
#include "settings/body_soil.hpp"

namespace berm::problem {

/// Whether a particle is bonded to the surface of a rigid body, as the number that it keeps.
enum class Bond : std::uint8_t {
  never,   ///< it has not been pressed on the surface yet
  bonded,  ///< closed at the start, or pressed on since: it carries tension
  parted   ///< a gap has opened: it carries tension no more
};

/// What an interface is beside one of the materials of a body.
struct SoilInterface {
  Real friction;          ///< tan of the friction angle
  Real adhesion, factor;  ///< Pa, and alpha
};

/// How the adhesion of an interface (Pa) follows from the soil beside it and from its slip:
///
///   c_a = f adhesion,   or   c_a = alpha su, where f = 1, else alpha min(su, f su0),   f = 1/St + (1 - 1/St) exp(-3 slip / ductility),
///
/// with the undrained strength su that the soil has at the moment, and su0 that it has undisturbed at a negligible rate.
struct AdhesionLaw {
  Real adhesion = 0, factor = 0;            ///< Pa, and alpha
  Real sensitivity = 1, ductility = 0;      ///< St, and m
  std::vector<material::Material> soils{};  ///< of the body, without their profiles; empty where alpha is 0 everywhere
  std::vector<SoilInterface> by_soil{};     ///< by number of the material in the body; empty where it is the same beside all

  bool softens() const { return sensitivity > 1; }
  bool differs() const { return factor > 0 || softens() || !by_soil.empty(); }
  /// f after a slip, m.
  Real part_left(Real slip) const;
  /// alpha beside the material of this number.
  Real factor_beside(Index number) const { return by_soil.empty() ? factor : by_soil[static_cast<std::size_t>(number)].factor; }
  /// The adhesion where alpha is 0, Pa.
  Real adhesion_beside(Index number, Real slip) const
  {
    return (by_soil.empty() ? adhesion : by_soil[static_cast<std::size_t>(number)].adhesion) * part_left(slip);
  }
  /// The adhesion beside soil that has this law, Pa; `state`: its state variables, `number`: of the material.
  Real at(const material::Material& soil, const Real* state, Real slip, Index number) const;
};

AdhesionLaw adhesion_law(const contact::ContactSettings& contact, const settings::BodySoil& soil);

/// Bonds the particles of a body that lie at the surface of a rigid one at the start.
template <int dim>
void bond_at_start(mesh::Metric metric, bodies::Particles<dim>& particles, const bodies::RigidShape<dim>& shape, int bond);

}  // namespace berm::problem
