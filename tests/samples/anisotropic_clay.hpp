// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "material/ngi_adp.hpp"

namespace berm {

/// A soft clay: s_A = 20 kPa, G / s_A = 400, s_D = 0.55 s_A, s_P = 0.35 s_A, so that the ellipse of plane strain is not a circle.
inline material::NgiAdp sample_ngi_adp(Real initial_mobilisation = 0.5)
{
  material::NgiAdp law;
  law.density = 1700;
  law.rigidity_index = 400;
  law.poisson_ratio = 0.49;
  law.undrained_strength = 2e4;
  law.dss_ratio = 0.55;
  law.passive_ratio = 0.35;
  law.active_failure_strain = 0.02;
  law.dss_failure_strain = 0.04;
  law.passive_failure_strain = 0.06;
  law.initial_mobilisation = initial_mobilisation;
  return law;
}

}  // namespace berm
