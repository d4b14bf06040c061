// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/types.hpp"

namespace berm::formulas {

/// Reliability of a formula.
enum class Label : std::uint8_t {
  exact,    ///< closed form, or computed to convergence
  fit,      ///< published fit, as design codes and programs use it
  recalled  ///< quoted from memory: to be compared with its source before it is relied on
};

inline const char* word_of(Label label)
{
  return label == Label::exact ? "exact" : label == Label::fit ? "fit" : "recalled";
}

/// Source of a formula.
struct Source {
  Label label;
  const char* work;   ///< who published it, and what
  const char* range;  ///< arguments for which it holds
};

/// Value of a formula in SI units, NaN where the formula has no meaning.
struct Formula {
  Real value;
  Source source;
  bool valid;  ///< the arguments are in the range and the value is a number
};

inline Formula formula(Real value, const Source& source, bool in_range)
{
  return {value, source, in_range && std::isfinite(value)};
}

/// Whether low <= x <= high, but for round-off (1e-9).
inline bool within(Real x, Real low, Real high)
{
  return x >= low - 1e-9 && x <= high + 1e-9;
}

}  // namespace berm::formulas
