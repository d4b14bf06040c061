// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/describe.hpp"
#include "output/history.hpp"

#include <filesystem>

namespace berm {

/// The one number that is taken from a column of a history over a window of time.
enum class Measure {
  end,           ///< in the last row
  mean,          ///< over the rows
  largest,       ///< of the rows
  least,         ///< of the rows
  change,        ///< last row less first row
  slope,         ///< of the least-squares line over time
  acceleration,  ///< slope of a velocity; of a displacement twice the square term of the least-squares parabola
  period         ///< mean distance of the crossings of the mean that go the same way, interpolated between rows
};

/// The word for each measure.
inline const std::vector<const char*> measure_words = {"end", "mean", "largest", "least", "change", "slope", "acceleration", "period"};

/// One number that a run is expected to give.
struct Expectation {
  std::string case_file = "case.toml";  ///< in the example's folder
  std::vector<std::string> set;         ///< overrides KEY=VALUE for this run
  std::string quantity;                 ///< of summary.json; or
  std::string column;                   ///< of history.csv, with
  Measure measure = Measure::end;
  std::optional<Real> from, to;                       ///< s, ends of the window
  std::optional<Real> exact, least, most;             ///< SI units; either exact or bounds
  std::optional<Real> tolerance, absolute_tolerance;  ///< of exact: relative, or in the unit of the quantity
  std::string source, why;
};

/// expected.toml: what an example should give.
struct Expectations {
  std::vector<Expectation> expect;
};

/// The units of exact, least, most and absolute_tolerance are those of the quantity, as its name tells.
void describe(Describe& d, Expectation& e);
void describe(Describe& d, Expectations& all);

/// The SI unit of a quantity or column, told by its name: V_at_w_0.1D is in N/m, tip_uy_m in m; "" where it is a bare number.
std::string unit_of(const std::string& name);

/// The unit of what is expected: unit_of the quantity, or of the column and what the measure makes of it.
std::string unit_of(const Expectation& e);

/// The measure of the column over its window. NaN where the window has too few rows or crossings. Throws InputError where there is no such column.
Real evaluate(const Expectation& e, const History& history);

/// The quantity of a summary.json; NaN for one that was not finite. Throws InputError where there is no such quantity.
Real evaluate(const Expectation& e, const std::filesystem::path& summary);

/// How far a value is from what is expected: relative or absolute as the tolerance is; for bounds how far it is outside, 0 within.
Real error_of(const Expectation& e, Real value);

/// Whether a value is as expected; NaN never is.
bool is_met(const Expectation& e, Real value);

}  // namespace berm
