// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/start/cpt_test.cpp
#pragma once

#include "site/strength.hpp"
#include "start/kinds.hpp"

namespace berm::start {

/// How a sounding is read as strength.
struct CptChoice {
  Real N_kt = 14;                                                    ///< of clay
  site::Correlation correlation = site::Correlation::kulhawy_mayne;  ///< of sand
};

/// A case with the strength of a sounding in its clay or its sand, down to the base of its mesh: a profile of the undrained strength, or layers of sand, each with its
/// angle of friction. The unit weight is that of the case. Throws InputError where the kind has neither, or layers of its own.
std::string with_cpt(const Kind& kind, const std::string& text, const site::Sounding& sounding, const CptChoice& choice);

}  // namespace berm::start
