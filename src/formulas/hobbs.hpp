// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "formulas/formula.hpp"

// Lateral buckles of a long straight hot line on a plane, whose friction is rigid and acts against the displacement.

namespace berm::formulas {

/// A line, and what resists it.
struct HotLine {
  Real bending_stiffness, axial_stiffness;  ///< EI, N m2; EA, N
  Real lateral, axial;                      ///< h, f, N/m, resistance sideways and along the line
};

/// By the shape: one lobe, two that are images by half a turn, three, four.
enum class HobbsMode { one, two, three, four };

/// A buckle of such a line; NaN where there is none.
struct HobbsBuckle {
  Real lobe = nan, half_length = nan;  ///< m, L: length of the largest lobe; from the middle of the buckle to its end
  Real amplitude = nan, moment = nan;  ///< m, N m, the largest
  Real compression = nan;              ///< P, N, in the buckle
  Real constrained_force = nan;        ///< P_0, N, where the line does not move
  Real slip_length = nan;              ///< m, from the middle to where that is so
};

Source hobbs_source();

/// The buckle that has the compression P, with constants k_1 ... k_5 of the mode:
///
///   P = k_1 EI/L^2,  P_0 = P + k_3 f L (sqrt(1 + k_2 EA h^2 L^5/(f EI^2)) - 1),  y = k_4 h L^4/EI,  M = k_5 h L^2.
///
/// NaN where EI, EA, h, f or P is not positive. [exact: for such friction; Hobbs 1984]
HobbsBuckle hobbs_buckle(HobbsMode mode, const HotLine& line, Real P);

/// The smallest constrained force P_0 that has a buckle of the mode, N; NaN where EI, EA, h or f is not positive.
Real hobbs_smallest_force(HobbsMode mode, const HotLine& line);

/// The buckle at the constrained force P_0 that is stable: the longer of two. NaN below the smallest force that has one.
HobbsBuckle hobbs_buckle_at(HobbsMode mode, const HotLine& line, Real P0);

}  // namespace berm::formulas
