// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "macro_element/macro_element.h"

namespace berm::macro_element {

/// A number among the parameters.
struct Member {
  const char* name;
  double berm_macro_element_parameters::*member;
  const char* unit;
};
/// All but the points of V0.
#define BERM_MEMBER(name, unit)                                                                                                            \
  {                                                                                                                                        \
#name, &berm_macro_element_parameters::name, unit                                                                                      \
  }
constexpr Member members[] = {
    BERM_MEMBER(diameter, "m"),
    BERM_MEMBER(vertical_stiffness, "N/m^2"),
    BERM_MEMBER(horizontal_stiffness, "N/m^2"),
    BERM_MEMBER(backbone_factor, "N/m"),
    BERM_MEMBER(backbone_power, "1"),
    BERM_MEMBER(peak_ratio, "1"),
    BERM_MEMBER(surface_beta, "1"),
    BERM_MEMBER(surface_b1, "1"),
    BERM_MEMBER(surface_b2, "1"),
    BERM_MEMBER(uplift_ratio, "1"),
    BERM_MEMBER(flow_slope, "1"),
    BERM_MEMBER(flow_zero, "1"),
    BERM_MEMBER(flow_climb, "1"),
    BERM_MEMBER(first_yield, "1"),
    BERM_MEMBER(mobilisation_length, "m"),
    BERM_MEMBER(residual_ratio, "1"),
    BERM_MEMBER(softening_length, "m"),
    BERM_MEMBER(berm_rate, "N/m^3"),
    BERM_MEMBER(berm_length, "m"),
    BERM_MEMBER(berm_reach, "m"),
};
#undef BERM_MEMBER

}  // namespace berm::macro_element
