// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "material/law_list.hpp"
#include "material/linear_elastic.hpp"
#include "material/mohr_coulomb.hpp"
#include "material/rate_dependent_tresca.hpp"

namespace berm::material {

/// The closed list of laws. Each law L has its word and parameters (`describe`), elasticity(L), prepare(L), and
///
///   update(prepared, stress, increment, state)
///
/// for T = Real, T = Lanes and, in plane strain, T = Dual; and it answers those questions of law_answers.hpp whose ready answer is not its own. Choose once
/// per body with std::visit, outside the loop over particles.
using Laws = LawList<LinearElastic, MohrCoulomb, RateDependentTresca>;

using Material = Laws::Material;
using PreparedMaterial = Laws::Prepared;

void describe(Describe& d, Material& material);

/// What no range of a single key can say, for the table at `path` ("material.sand"): what the law says, and that density is not larger than inertia_density.
void check(Describe& d, const std::string& path, const Material& material);

/// The law with its constants worked out.
PreparedMaterial prepare(const Material& material);

/// Of the weight, kg/m3.
Real density(const Material& material);

/// Of the mass that resists acceleration, kg/m3.
Real inertia_density(const Material& material);

/// Of the law's elastic part.
Elasticity elasticity(const Material& material);
YoungPoisson young_poisson(const Material& material);

/// The modulus that gives the speed of pressure waves sqrt(M / inertia density), Pa.
Real p_wave_modulus(const Material& material);

/// How many numbers of its own a particle of this material keeps.
int state_size(const Material& material);

// The questions of law_answers.hpp.
std::string law_name(const Material& material);
std::vector<FieldInfo> state_fields(const Material& material);
bool yields(const Material& material);
std::optional<Strength> strength_at_rest(const Material& material);
std::optional<Real> shear_strength(const Material& material, Real middle, const Real* state);
bool dilates(const Material& material);
Material without_dilation(const Material& material);
std::string depth_key(const Material& material);
Material at_depth(const Material& material, Real depth);
bool non_associated(const Material& material);
Material associated(const Material& material, const SymTensor<2>& stress);

}  // namespace berm::material
