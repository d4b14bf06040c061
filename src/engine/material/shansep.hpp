// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/describe.hpp"

namespace berm::material {

/// Undrained strength by the stress that the clay rests under and has rested under, s_u = ratio sigma'_v0 OCR^exponent, at least min_strength, with the vertical
/// effective stress sigma'_v0 at the start, Pa. OCR: `ocr`, that of the profile over depth, or (sigma'_v0 + pop) / sigma'_v0. [Ladd and Foott 1974]
struct Shansep {
  Real ratio = 0;           ///< s_u / sigma'_v0 of normally consolidated clay
  Real exponent = 0.8;      ///< m
  std::optional<Real> ocr;  ///< empty: by pop or the profile, else 1
  std::optional<Real> pop;  ///< Pa, largest vertical effective stress of the past less that at the start
  Real surcharge = 0;       ///< Pa, vertical effective stress on the bed's surface, which sigma'_v0 has too
  Real min_strength = 0;    ///< Pa

  bool operator==(const Shansep&) const = default;
};

void describe(Describe& d, Shansep& shansep);

/// s_u under the weight of the soil above, Pa; ocr: that of the profile there, or none.
Real strength_by(const Shansep& shansep, Real weight_above, const std::optional<Real>& ocr);

/// For display: "0.25 σ'v0 OCR^0.8, POP = 40 kPa, 1 kPa at least".
std::string formula_words(const Shansep& shansep);

/// Refuses what gives the overconsolidation twice, and a strength that grows without end towards the surface. ocr_in_profile: whether the profile gives it.
void check_shansep(Describe& d, const std::string& path, const Shansep& shansep, bool ocr_in_profile);

}  // namespace berm::material
