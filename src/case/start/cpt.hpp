// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/start/cpt_test.cpp
#pragma once

#include "site/strength.hpp"
#include "start/kinds.hpp"

#include <optional>

namespace berm::start {

/// How a sounding is read as strength.
struct CptChoice {
  std::optional<Real> N_kt;                      ///< of clay
  std::optional<site::Correlation> correlation;  ///< of sand
};

/// What counts where nothing is chosen, and the cone factors that are taken.
constexpr Real usual_N_kt = 14, least_N_kt = 5, most_N_kt = 30;
constexpr site::Correlation usual_correlation = site::Correlation::kulhawy_mayne;

/// A case with the strength of a sounding, and what of the sounding is doubted.
struct CptCase {
  std::string text;
  std::vector<std::string> doubts;
};

/// Whether a case of this text can have its strength from a sounding: one clay or one sand, without layers.
bool takes_sounding(const std::string& text);

/// A case with the strength of a sounding in its clay or its sand, down to the base of its mesh: a profile of the undrained strength, or layers of sand, each with its
/// angle of friction, and of dilation by Bolton (1986). The unit weight is that of the case. Throws InputError where the kind has neither, or layers of its own, where the choice is
/// one of the other soil, and where the sounding has values that no such soil has.
CptCase with_cpt(const Kind& kind, const std::string& text, const site::Sounding& sounding, const CptChoice& choice);

}  // namespace berm::start
