// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "macro_element/parameters.hpp"

namespace berm::macro_element {

/// A pipe of 0.5 m in clay of some kPa, in round numbers.
inline Parameters sample_parameters()
{
  Parameters p{};
  p.version = BERM_MACRO_ELEMENT_VERSION;
  p.diameter = 0.5;
  p.vertical_stiffness = 1e6;
  p.horizontal_stiffness = 8e5;
  p.backbone_factor = 1.2e4;
  p.backbone_power = 0.5;
  p.peak_ratio = 0.35;
  p.surface_beta = 0.05;
  p.surface_b1 = 0.5;
  p.surface_b2 = 0.6;
  p.uplift_ratio = 0.03;
  p.flow_slope = 1.5;
  p.flow_zero = 0.35;
  p.flow_climb = 0;
  p.first_yield = 0.6;
  p.mobilisation_length = 0.01;
  p.residual_ratio = 0.6;
  p.softening_length = 0.2;
  p.berm_rate = 2e4;
  p.berm_length = 0.5;
  p.berm_reach = 0.1;
  p.axial_friction = 0.5;
  p.axial_mobilisation = 0.004;
  return p;
}

}  // namespace berm::macro_element
