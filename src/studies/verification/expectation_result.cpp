// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/verification/expectation_test.cpp
#include "verification/expectation_result.hpp"

#include "core/error.hpp"
#include "input/units.hpp"
#include "run_folder/summary_file.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace berm::verification {
namespace {

std::string percent(Real part)
{
  return fmt::format("{:.3g} %", 100 * part);
}

/// The unit in which the numbers of an expectation are easiest to read.
struct ShownUnit {
  Real per_si;
  std::string name;

  std::string number(Real value, int digits = 5) const { return fmt::format("{:.{}g}", value * per_si, digits); }
  std::string value(Real value, int digits = 5) const { return number(value, digits) + (name.empty() ? "" : " " + name); }
};

ShownUnit shown_unit(const Expectation& e, const std::string& of_values)
{
  const std::string unit = is_pure(e) ? "" : of_values;
  Real size = e.exact == 0. && e.absolute_tolerance ? *e.absolute_tolerance : 0;
  for (const auto& value : {e.exact, e.min, e.max}) size = std::max(size, std::abs(value.value_or(0)));
  if (unit == "m" && size < 1e-5) return {1e6, "um"};
  if (unit == "m" && size < 0.1) return {1e3, "mm"};
  if ((unit == "N/m" || unit == "Pa" || unit == "J/m") && size >= 1e3 && size < 1e6) return {1e-3, "k" + unit};
  if ((unit == "N/m" || unit == "Pa" || unit == "J/m") && size >= 1e6) return {1e-6, "M" + unit};
  return {1, unit};
}

std::string exact_of(const Expectation& e, const ShownUnit& unit)
{
  if (e.exact) return unit.value(*e.exact);
  if (e.min && e.max) return unit.number(*e.min) + " .. " + unit.value(*e.max);
  return e.min ? ">= " + unit.value(*e.min) : "<= " + unit.value(*e.max);
}

const ProblemResult& result_of(const std::string& run, const Example& example, const std::vector<ProblemResult>& results)
{
  const auto named = [&](const auto& entry) { return entry.first == run; };
  return results.at(std::find_if(example.runs.begin(), example.runs.end(), named) - example.runs.begin());
}

/// The band of a quantity. Throws InputError where it has none.
run_folder::QuantityBand band_of(const Expectation& e, const std::filesystem::path& folder)
{
  const std::optional<run_folder::RunSummary> summary = run_folder::read_summary(folder);
  if (!summary || !summary->uncertainty) throw InputError("the run has no bands");
  for (const run_folder::QuantityBand& q : summary->uncertainty->quantities)
    if (q.name == e.observable.quantity) return q;
  throw InputError(fmt::format("{} has no band", e.observable.quantity));
}

/// Takes the values of the runs; false, and the verdict and reason say why, where one has none.
bool take_values(ExpectationResult& finding, const Example& example, const Expectation& e, const std::vector<ProblemResult>& results)
{
  for (const std::string& run : runs_of(e)) {
    const ProblemResult& result = result_of(run, example, results);
    if (outcome_of(result.end.kind) == jobs::Outcome::unfinished) return false;
    finding.verdict = Verdict::failed;
    finding.reason = e.runs.empty() && e.over.empty() ? result.end.reason : fmt::format("{}: {}", run, result.end.reason);
    if (result.end.kind == jobs::JobEnd::Kind::failed) return false;
    try {
      Reading reading = evaluate(e.observable, result.folder);
      if (e.held != Held::not_asked) {
        finding.band = band_of(e, result.folder).band;
        reading.value = finding.band->converged;
      }
      finding.values.push_back(reading.value);
      finding.unit = reading.unit;
      finding.label = reading.label;
      if (!e.unit.empty() && !input::same_dimension(e.unit, reading.unit))
        throw InputError(
            fmt::format("{} is expected in {}, and is in {}", words_of(e.observable), e.unit, reading.unit.empty() ? "1" : reading.unit));
    } catch (const std::exception& error) {
      finding.reason = error.what();
      return false;
    }
  }
  return true;
}

/// Whether the band of a quantity holds what is expected, as it is said to.
ExpectationResult compare_with_band(ExpectationResult finding, const Expectation& e, const ShownUnit& unit)
{
  finding.berm = fmt::format("{} (run {})", unit.value(finding.number), unit.number(finding.band->value));
  finding.tolerance = fmt::format("{}{}", e.held == Held::yes ? "" : "beyond ", unit.value(finding.band->half_width, 3));
  const Real error = error_of(e, finding.number);
  finding.error = unit.value(error, 3);
  finding.verdict = (std::abs(error) <= finding.band->half_width) == (e.held == Held::yes) ? Verdict::met : Verdict::missed;
  return finding;
}

}  // namespace

const char* word_of(Verdict verdict)
{
  constexpr const char* words[] = {"met", "MISSED", "FAILED", "not run"};
  return words[static_cast<int>(verdict)];
}

ExpectationResult compare_with_expectation(const Example& example, const Expectation& e, const std::vector<ProblemResult>& results)
{
  ExpectationResult finding;
  finding.problem = fmt::format("{}/{}", example.name, e.runs.empty() ? e.run : e.runs.front() + " .. " + e.runs.back());
  finding.what = words_of(e);
  finding.unit = e.unit == "1" ? "" : e.unit;
  const bool known = take_values(finding, example, e, results);
  const ShownUnit unit = shown_unit(e, finding.unit);
  finding.exact = exact_of(e, unit);
  finding.tolerance = e.tolerance ? percent(*e.tolerance) : e.absolute_tolerance ? unit.value(*e.absolute_tolerance) : "";
  if (!known) {
    finding.values.clear();
    return finding;
  }
  finding.number = number_of(e, finding.values);
  finding.reason.clear();
  if (finding.band) return compare_with_band(finding, e, unit);
  finding.berm = unit.value(finding.number);
  const Real error = error_of(e, finding.number);
  const bool within_bounds = !e.exact && error == 0;
  finding.error = within_bounds ? "" : e.tolerance ? percent(error) : unit.value(error, 3);
  finding.verdict = is_met(e, finding.number) ? Verdict::met : Verdict::missed;
  return finding;
}

}  // namespace berm::verification
