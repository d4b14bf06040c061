// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "formulas/formula.hpp"

#include <string>
#include <vector>

namespace berm::base {

/// A structure as it lies in the bed before the first stage.
struct EmbeddedBody {
  Real width = 0;      ///< D, m
  Real embedment = 0;  ///< m, depth of the lowest point below the bed's surface
};

/// The ends of the probes that found an envelope, N/m.
struct EnvelopeEnds {
  std::vector<Real> V, H;
  Real V_max;  ///< of the probe that goes straight down; NaN where there is none
};

/// A published curve or point, N/m.
struct PublishedCurve {
  std::string title;  ///< with its label, and its range where the structure is not in it
  std::vector<Real> V, H;
};

/// A published number, N/m.
struct PublishedNumber {
  std::string name;
  formulas::Formula formula;
};

/// What is published of the envelope of a structure in the soil of a case.
struct PublishedEnvelope {
  Real unit = 0;          ///< N/m that forces are divided by to be compared; 0: none
  std::string unit_name;  ///< as people write it
  std::vector<PublishedCurve> curves;
  std::vector<PublishedNumber> numbers;
  std::string remark;  ///< why there is nothing, or what is left out
};

}  // namespace berm::base
