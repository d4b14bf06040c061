// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "verification/observable.hpp"

namespace berm::verification {

/// One problem of the verification book: one run of berm.
struct VerificationRun {
  std::string title;
  std::string case_file = "case.toml";  ///< in the example's folder
  std::vector<std::string> set;         ///< overrides KEY=VALUE
  bool fast = false;                    ///< a few seconds: part of the tests
  bool element = false;                 ///< element tests (berm element) instead of a run
  bool uncertainty = false;             ///< run with the bands of its results
};

/// Instead of a tolerance: whether the band of a quantity holds exact, or meets the bounds.
enum class Held { not_asked, yes, no };
inline const std::vector<const char*> held_words = {"not asked", "yes", "no"};

/// One number that a run is expected to give; or the order of convergence of runs whose cells are half as large each time.
struct Expectation {
  std::string run;                ///< which run; or
  std::string over;               ///< run by whose number that of `run` is divided; "": none
  std::vector<std::string> runs;  ///< from the coarsest to the finest, with
  std::optional<Real> limit;      ///< SI units: what the number tends to
  Observable observable;
  std::optional<Real> exact, min, max;                ///< of the number in SI units, or of the order; either exact or bounds
  std::optional<Real> tolerance, absolute_tolerance;  ///< of exact: relative, or in its unit
  Held held = Held::not_asked;
  std::string unit;  ///< SI, of these and of limit as they are written; "" where they have none
  std::string source, why;
  std::string requirement, derived;  ///< what the user may rely on, and where that is derived
};

/// expected.toml: what an example should give.
struct Expectations {
  std::string requirement, derived;  ///< of every number that has none of its own
  std::vector<std::pair<std::string, VerificationRun>> run;
  std::vector<Expectation> expect;
};

/// exact, least, most and absolute_tolerance may have any unit, which must be of the dimension of what the run gives (compare_with_expectation).
void describe(Describe& d, VerificationRun& run);
void describe(Describe& d, Expectation& e);
void describe(Describe& d, Expectations& all);

/// The runs that an expectation needs.
std::vector<std::string> runs_of(const Expectation& e);

/// What is expected: words_of its reading, over that of another run, or "order of " it.
std::string words_of(const Expectation& e);

/// Whether it is a bare number, whatever it is made of: an order or a ratio.
bool is_pure(const Expectation& e);

/// Of one run its value; of several the order of convergence: the slope of the least-squares line through -log2 |value - limit| over the number of
/// times that the cells were halved. NaN where a value is NaN or the limit itself.
Real number_of(const Expectation& e, const std::vector<Real>& values);

/// How far a number is from what is expected: relative or absolute as the tolerance is; for bounds how far it is outside, 0 within.
Real error_of(const Expectation& e, Real number);

/// Whether a number is as expected; NaN never is.
bool is_met(const Expectation& e, Real number);

}  // namespace berm::verification
