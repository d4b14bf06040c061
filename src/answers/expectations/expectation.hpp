// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "expectations/chapter.hpp"
#include "expectations/observable.hpp"
#include "input/catalogue.hpp"
#include "structures/base/published_point.hpp"

namespace berm::expectations {

/// One problem of the verification book: one run of berm.
struct VerificationRun {
  std::string title;
  std::string case_file = "case.toml";  ///< in the example's folder
  std::vector<std::string> set;         ///< overrides KEY=VALUE
  bool fast = false;                    ///< a few seconds: part of the tests
  bool is_long = false;                 ///< ten minutes or more: only where it is asked for
  bool element = false;                 ///< element tests (berm element) instead of a run
  bool fit = false;                     ///< a soil fitted to tests (berm fit) instead of a run
  bool cyclic = false;                  ///< a storm on contours (berm cyclic) instead of a run
  bool sea = false;                     ///< a sea state on a pipe (berm sea) instead of a run
  bool route = false;                   ///< a line along a route (berm route) instead of a run
  bool uncertainty = false;             ///< run with the bands of its results

  /// The command of berm that does it.
  std::string command() const { return element ? "element" : fit ? "fit" : cyclic ? "cyclic" : sea ? "sea" : route ? "route" : "run"; }
  bool is_run() const { return command() == "run"; }
};

/// Instead of a tolerance: whether the band of a quantity holds exact, or meets the bounds.
enum class Held { not_asked, yes, no };
inline const std::vector<const char*> held_words = {"not asked", "yes", "no"};

/// One number that a run is expected to give; or the order of convergence of runs whose cells are half as large each time.
struct Expectation {
  std::string run;                        ///< which run; or
  std::string over;                       ///< run by whose number that of `run` is divided; "": none
  std::optional<Observable> over_number;  ///< what it is divided by, of that run or of the same; empty: the same observable
  std::vector<std::string> runs;          ///< from the coarsest to the finest, with
  std::optional<Real> limit;              ///< SI units: what the number tends to
  Observable observable;
  std::optional<Real> exact, min, max;                ///< of the number in SI units, or of the order; either exact or bounds
  std::optional<Real> tolerance, absolute_tolerance;  ///< of exact: relative, or in its unit
  Held held = Held::not_asked;
  std::string quoted, quoted_unit;  ///< text of a page that quotes the number, in braces: the value to expect, to its last digit
  std::string page = "README.md";   ///< in the example's folder
  std::string unit;                 ///< SI, of these and of limit as they are written; "" where they have none
  std::string source, why;
  std::string requirement, derived;  ///< what the user may rely on, and where that is derived
  std::string label;                 ///< of a claim: what the number is, in words
  std::optional<Real> partly;        ///< of a claim: how far off, relative, it still holds in part
};

/// What is claimed of a test: numbers of runs that would prove it. Nothing is expected of a run that has no bounds; such a number is told beside the others.
struct Claim {
  std::string statement, where, why;
  std::vector<std::string> runs;  ///< of each number that names none
  std::vector<Expectation> expect;
};

/// What others published of the test: to compare with, whether or not berm gives the same.
struct Published {
  std::string title = "Published claims", source;
  base::PublishedPoints points;
  std::vector<Claim> claims;
};

/// expected.toml: what an example should give.
struct Expectations {
  Chapter chapter = Chapter::other;
  std::string requirement, derived;  ///< of every number that has none of its own
  std::vector<std::pair<std::string, VerificationRun>> run;
  std::vector<Expectation> expect;
  std::optional<Published> published;
};

/// The file, in the folder of an example and in that of each of its runs.
constexpr const char* expected_file = "expected.toml";

/// The keys of expected.toml, for its schema.
input::Listed expected_catalogue();

/// Read it, or its text. Throw InputError with file, line and key.
Expectations read_expectations(const std::filesystem::path& file);
Expectations read_expectations_text(const std::string& file, const std::string& text);

/// The name that a run has there: that of the same case file with the same changes; "" where there is none, or where the run did not come to its end.
std::string name_of(const record::RunRecord& run, const Expectations& all);

/// exact, least, most and absolute_tolerance may have any unit, which must be of the dimension of what the run gives (compare_with_expectation).
void describe(Describe& d, VerificationRun& run);
void describe(Describe& d, Expectation& e);
void describe(Describe& d, Claim& claim);
void describe(Describe& d, Published& published);
void describe(Describe& d, Expectations& all);

/// The runs that an expectation needs, and what is read of the k-th of them.
std::vector<std::string> runs_of(const Expectation& e);
const Observable& observable_of(const Expectation& e, std::size_t k);

/// Whether a number has something to meet.
bool is_judged(const Expectation& e);

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

}  // namespace berm::expectations
