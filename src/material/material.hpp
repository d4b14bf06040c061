// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "material/linear_elastic.hpp"
#include "material/mohr_coulomb.hpp"

#include <string>
#include <variant>

namespace berm::material {

/// The closed list of laws. Each law L has prepare(L), and update_stress(prepared, stress, strain_increment, state) for T = Real, T = Lanes and, in
/// plane strain, T = Dual; choose once per body with std::visit, outside the loop over particles.
using Material = std::variant<LinearElastic, MohrCoulomb>;

void describe(Describe& d, Material& material);

/// What no range of a single key can say, for the table at `path` ("material.sand"): the dilation angle is not larger than the friction angle, nor density than inertia_density.
void check(Describe& d, const std::string& path, const Material& material);

/// Of the weight, kg/m3.
Real density(const Material& material);

/// Of the mass that resists acceleration, kg/m3.
Real inertia_density(const Material& material);

/// Of the law's elastic part.
Elasticity elasticity(const Material& material);

/// The modulus that gives the speed of pressure waves sqrt(M / inertia density), Pa.
Real p_wave_modulus(const Material& material);

/// Whether its strength has a limit, as that of soil has.
bool yields(const Material& material);

/// Whether shearing the material at yield makes its volume grow.
bool dilates(const Material& material);

/// The same material with a dilation angle of zero: what becomes of it once it cannot grow any further.
Material without_dilation(Material material);

/// How many numbers of its own a particle of this material keeps.
int state_size(const Material& material);

}  // namespace berm::material
