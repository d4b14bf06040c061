// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/types.hpp"

#include <string>

namespace berm::formulas {

/// Reliability of a formula.
enum class Label : std::uint8_t {
  exact,        ///< closed form, or computed to convergence
  lower_bound,  ///< closed form of stresses that meet equilibrium and strength: the load is as large or larger
  fit,          ///< published fit, as design codes and programs use it: a public source states it (docs/formulas.md says which)
  recalled      ///< quoted from memory: to be compared with its source before it is relied on, and not shown to clients
};

inline const char* word_of(Label label)
{
  switch (label) {
  case Label::exact:
    return "exact";
  case Label::lower_bound:
    return "lower bound";
  case Label::fit:
    return "fit";
  case Label::recalled:
    return "recalled";
  }
  return "";
}

/// Source of a formula.
struct Source {
  Label label;
  const char* work;         ///< who published it, and what: year or edition
  const char* range;        ///< arguments for which it holds
  const char* clause = "";  ///< of the work: section, equation, table or figure; "" where no public source states it
};

/// Work and clause as they are quoted.
inline std::string citation(const Source& source)
{
  return *source.clause == '\0' ? source.work : std::string(source.work) + ", " + source.clause;
}

/// Value of a formula in SI units, NaN where the formula has no meaning.
struct Formula {
  Real value;
  Source source;
  bool valid;  ///< the arguments are in the range and the value is a number
};

/// Low, best and high estimate of design codes: LE, BE and HE.
struct Estimates {
  Formula low, best, high;
};

inline Formula formula(Real value, const Source& source, bool in_range)
{
  return {value, source, in_range && std::isfinite(value)};
}

inline Estimates estimates(Real low, Real best, Real high, const Source& source, bool in_range)
{
  return {formula(low, source, in_range), formula(best, source, in_range), formula(high, source, in_range)};
}

/// Whether low <= x <= high, but for round-off (1e-9).
inline bool within(Real x, Real low, Real high)
{
  return x >= low - 1e-9 && x <= high + 1e-9;
}

}  // namespace berm::formulas
