// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "material/hypoplastic.hpp"
#include "material/modified_cam_clay.hpp"
#include "material/norsand.hpp"

namespace berm {

/// The angle with which the critical state has the slope M in triaxial compression.
inline Real friction_angle_of_slope(Real slope)
{
  return std::asin(3 * slope / (6 + slope));
}

/// M = 1, lambda = 0.2, kappa = 0.04, v0 = 2.
inline material::ModifiedCamClay sample_cam_clay(Real slope = 1)
{
  material::ModifiedCamClay law;
  law.density = 1700;
  law.critical_friction_angle = friction_angle_of_slope(slope);
  law.compression_index = 0.2;
  law.swelling_index = 0.04;
  law.void_ratio = 1;
  law.poisson_ratio = 0.3;
  law.max_pressure = 1e7;
  return law;
}

/// M = 1.25, Gamma = 0.9, lambda_e = 0.03, N = 0.3, chi_tc = 3.5, H = 150, I_r = 300.
inline material::NorSand sample_norsand(Real state_parameter = -0.1)
{
  material::NorSand law;
  law.density = 1900;
  law.critical_friction_angle = friction_angle_of_slope(1.25);
  law.critical_void_ratio = 0.9;
  law.critical_line_slope = 0.03;
  law.volumetric_coupling = 0.3;
  law.dilatancy = 3.5;
  law.hardening_modulus = 150;
  law.state_parameter = state_parameter;
  law.rigidity = 300;
  law.poisson_ratio = 0.2;
  law.max_pressure = 1e8;
  return law;
}

/// Karlsruhe fine sand (Wichtmann and others 2019); small_strain = false: without intergranular strain.
inline material::Hypoplastic sample_hypoplastic(Real void_ratio = 0.8, bool small_strain = true)
{
  material::Hypoplastic law;
  law.density = 1500;
  law.critical_friction_angle = 0.5777;
  law.granular_hardness = 4e9;
  law.hardness_exponent = 0.27;
  law.min_void_ratio = 0.677;
  law.critical_void_ratio = 1.054;
  law.max_void_ratio = 1.212;
  law.dilatancy_exponent = 0.14;
  law.stiffness_exponent = 2.5;
  law.void_ratio = void_ratio;
  if (small_strain) {
    law.small_strain = 1e-4;
    law.reversal_stiffness = 4;
    law.turn_stiffness = 2;
    law.evolution_exponent = 0.3;
    law.decay_exponent = 3;
  }
  law.max_pressure = 1e6;
  return law;
}

}  // namespace berm
