// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "material/clay.hpp"
#include "material/hardening_soil.hpp"
#include "material/hypoplastic.hpp"
#include "material/law_list.hpp"
#include "material/linear_elastic.hpp"
#include "material/modified_cam_clay.hpp"
#include "material/mohr_coulomb.hpp"
#include "material/ngi_adp.hpp"
#include "material/norsand.hpp"
#include "material/user_law.hpp"

namespace berm::material {

/// The closed list of laws. Each law L has its word and parameters (`describe`), elasticity(L), prepare(L), and
///
///   update(prepared, stress, increment, state)
///
/// for T = Real, T = Lanes and, in plane strain, T = Dual, and with_local(prepared, own), the law of particles that keep
/// strength and stiffness for themselves; it overrides the queries of law_queries.hpp whose default does
/// not apply. Choose once per body, outside the loop over particles.
using Laws = LawList<LinearElastic, MohrCoulomb, Clay, ModifiedCamClay, NorSand, Hypoplastic, HardeningSoil, NgiAdp,
                     UserLaw<Interface::umat>, UserLaw<Interface::own>>;
static_assert(Laws::max_state <= max_state, "a law has more state variables than material.hpp says");

struct PreparedMaterial : Laws::Prepared {
  using Laws::Prepared::Prepared;
};

/// act(law) with the law of a material.
template <class Act>
decltype(auto) visit(const Act& act, const Material& material)
{
  return Laws::visit(act, material);
}
template <class Act>
decltype(auto) visit(const Act& act, Material& material)
{
  return Laws::visit(act, material);
}

}  // namespace berm::material
