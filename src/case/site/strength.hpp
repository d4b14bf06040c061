// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/site/strength_test.cpp
#pragma once

#include "site/sounding.hpp"

namespace berm::site {

/// A mean over a layer of the sounding: from 0.1 m thick at the seabed to a tenth of the depth.
struct Layer {
  Real top, middle, q_t;  ///< m, mean depth of its readings, Pa
};
std::vector<Layer> layers_of(const Sounding& sounding);

/// Strength of a layer: an undrained strength in Pa, or an angle of friction in rad.
struct Strength {
  Real top, middle, value;
};

/// Strengths of the layers of a sounding, and its layers that have none.
struct StrengthProfile {
  std::vector<Strength> strength;
  std::vector<Layer> without;
};

/// s_u = (q_t - sigma_v0) / N_kt, with sigma_v0 = (gamma' + 9.81 kN/m3) z from the seabed, where the cone reads zero in the water that is there.
/// N_kt lies between 8 and 25 (Mayne and Peuchen 2018). Layers whose strength would not be positive are left out. Throws InputError where these are more than a quarter.
StrengthProfile undrained_strength(const Sounding& sounding, Real submerged_unit_weight, Real N_kt);

/// What gives an angle of friction from the cone resistance, with sigma'_v0 = gamma' z and p_a = 100 kPa.
enum class Correlation {
  kulhawy_mayne,        ///< phi = 17.6 deg + 11 deg log10((q_t / p_a) / sqrt(sigma'_v0 / p_a)): Kulhawy and Mayne (1990)
  robertson_campanella  ///< tan phi = (log10(q_t / sigma'_v0) + 0.29) / 2.68: Robertson and Campanella (1983)
};

/// The angle of one resistance, without a limit.
Real friction_of(Real q_t, Real effective_stress, Correlation correlation);

/// Angles of friction, of layers put together while they differ by no more than 2 degrees; 45 degrees where the correlation says more. Layers of less than 25 degrees, which are no
/// sand, are left out. Throws InputError where these are more than a quarter.
StrengthProfile friction_angle(const Sounding& sounding, Real submerged_unit_weight, Correlation correlation);

/// The largest angle that is taken from a correlation.
constexpr Real most_friction_angle = 45 * degree;

}  // namespace berm::site
