// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "envelope/envelope_table.hpp"

#include <string_view>

namespace berm::envelope {

/// redwin.c, and the shared library that was compiled from it.
extern const std::string_view redwin_code, redwin_library;

/// The macro-element of a footing as redwin.c has it, N, N m and m (in plane strain per metre).
struct Foundation {
  Real k_v = 0, k_h = 0, k_hm = 0, k_m = 0;  ///< elastic: V over w, and the symmetric matrix of H and M over u and theta
  Real V_max = 0, H_max = 0, M_max = 0;      ///< of the yield surface
  Real cross = 0, tension = 0, b1 = 0.5, b2 = 0.5;
  Real hardening = 0;         ///< V0 over the plastic settlement
  int ends = 0;               ///< of probes that the surface is fitted to
  Real rms = 0, largest = 0;  ///< of their distance from it, sqrt(h^2 + m^2 - 2 cross h m) - y
  std::string farthest;       ///< the probe of the largest
};

/// Fits the surface to the ends of all probes, and the stiffness to their first motion: that of the moments to probes whose both edges go down at first, as a footing without a load parts from
/// the soil where one rises. Throws RunError, which says why, where a probe is not finished, or there is none that tells a number.
Foundation fit_foundation(const std::vector<EnvelopeRow>& rows, Real width);

/// The properties file of redwin.c.
std::string foundation_properties(const Foundation& foundation, int force_dimension);

}  // namespace berm::envelope
