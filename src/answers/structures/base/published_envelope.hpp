// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "formulas/formula.hpp"

#include <optional>
#include <string>
#include <vector>

namespace berm::base {

/// A structure as it lies in the bed before the first stage.
struct EmbeddedBody {
  Real width = 0;      ///< D, m
  Real embedment = 0;  ///< m, depth of the lowest point below the bed's surface
  /// m, of a body whose moments are looked for: the height of its centre above the middle of its flat base, about which they are, clockwise where H goes to the right.
  std::optional<Real> arm = std::nullopt;
};

/// The ends of the probes that found an envelope, N/m.
struct EnvelopeEnds {
  std::vector<Real> V, H;
  Real V_max;  ///< of the probe that goes straight down; NaN where there is none
};

/// V over V_max of the sections of an envelope in the plane of H and M.
inline constexpr Real section_levels[] = {0.5, 0.75};

/// A published curve or point in the plane of V and H, of V and M, or of H and M: N/m, N (in space N, N m). Of the third there is nothing.
struct PublishedCurve {
  std::string title;  ///< with its label, and its range where the structure is not in it
  std::vector<Real> V, H, M = {};
  bool of_code = false;  ///< drawn as a design code's
};

/// The title of a curve by a formula.
inline std::string titled(const std::string& title, const formulas::Formula& formula)
{
  const std::string out = formula.valid ? "" : std::string("; out of range: ") + formula.source.range;
  return title + " [" + word_of(formula.source.label) + out + "]";
}

/// A published number, N/m (in space N).
struct PublishedNumber {
  std::string name;
  formulas::Formula formula;
  bool moment = false;  ///< N (in space N m)
};

/// What is published of the envelope of a structure in the soil of a case.
struct PublishedEnvelope {
  Real unit = 0;          ///< N/m (in space N) that forces are divided by to be compared, and moments by it times the width; 0: none
  std::string unit_name;  ///< as people write it
  std::vector<PublishedCurve> curves;
  std::vector<PublishedNumber> numbers;
  std::string remark;  ///< why there is nothing, or what is left out
};

}  // namespace berm::base
