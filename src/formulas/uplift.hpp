// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "formulas/formula.hpp"

#include <optional>
#include <vector>

// The largest resistance of the soil above a buried pipe that is pulled up, N/m, downwards on the pipe: its own weight comes on top. Nothing holds it from below.

namespace berm::formulas {

/// A pipe below a level surface, in soil of one kind.
struct BuriedPipe {
  Real diameter;                ///< D, m
  Real cover;                   ///< m, from the surface to the crown; H is that to the centre
  Real unit_weight;             ///< gamma', N/m3
  Real friction_angle = 0;      ///< phi, rad; 0 = clay
  Real dilation_angle = 0;      ///< psi, rad
  std::optional<Real> k0 = {};  ///< absent: 1 - sin phi
  Real strength = 0;            ///< s_u, Pa, of soil without friction: the mean over the cover
  Real roughness = 0;           ///< r: shear strength of the interface over s_u

  Real depth() const { return cover + diameter / 2; }  ///< H, m: of the centre
};

/// Block of sand between two planes that rise from the pipe's flanks, each at psi to the vertical, with the normal stress on them that the sand has at rest:
/// R = gamma' (H D - pi D^2/8) + gamma' H^2 (tan psi + (tan phi - tan psi) ((1 + K_0)/2 - (1 - K_0)/2 cos 2 psi)).
/// [exact: for these planes and that stress; White, Cheuk and Bolton 2008]
Formula uplift_inclined_slip(const BuriedPipe& pipe);

/// The same with vertical planes, psi = 0: R = gamma' (H D - pi D^2/8) + f gamma' H^2, f = K_0 tan phi. [exact: for these planes and that stress]
Formula uplift_vertical_slip(const BuriedPipe& pipe);

/// R = gamma' H D (1 + f H/D), f = K_0 tan phi. [fit: DNV-RP-F110]
Formula f110_uplift(const BuriedPipe& pipe);

/// How dense sand lies.
enum class Packing { loose, medium, dense };

/// R = gamma' C D + gamma' D^2 (1/2 - pi/8) + f gamma' H^2, C the cover, f = 0.29, 0.47 and 0.62 for loose, medium and dense sand. [fit: DNVGL-RP-F114]
Formula f114_uplift(const BuriedPipe& pipe, Packing packing);

/// Sand: R = N gamma' H D, N = min(phi H/(44 deg D), N_q), N_q that of a strip footing. [fit: American Lifelines Alliance 2001]
Formula ala_uplift_sand(const BuriedPipe& pipe);

/// Clay: R = N s_u D, N = min(2 H/D, 10); no weight. [fit: American Lifelines Alliance 2001]
Formula ala_uplift_clay(const BuriedPipe& pipe);

/// Clay: R = gamma' H D + 2 H s_u. [fit: OTC 6486]
Formula otc_uplift_clay(const BuriedPipe& pipe);

/// Upward displacement at that resistance, m: 0.01 to 0.02 H in sand, 0.1 D at most; 0.1 to 0.2 H in clay, 0.2 D at most; `best` is the mean.
/// [fit: American Lifelines Alliance 2001]
Estimates ala_uplift_displacement(const BuriedPipe& pipe);

/// A resistance with the name of its model.
struct UpliftModel {
  const char* name;
  Formula resistance;
};

/// All that apply to the soil: to sand where it has friction, to clay where it has a strength; none of soil that has neither.
std::vector<UpliftModel> uplift_models(const BuriedPipe& pipe);

}  // namespace berm::formulas
