// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/expectations/expectation_test.cpp
#include "expectations/expectation_result.hpp"

#include "input/units.hpp"
#include "os/error.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <new>

namespace berm::expectations {
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

/// By the size of what is expected, at least this.
ShownUnit shown_unit(const Expectation& e, const std::string& of_values, Real size = 0)
{
  const std::string unit = is_pure(e) ? "" : of_values;
  if (e.exact == 0. && e.absolute_tolerance) size = *e.absolute_tolerance;
  for (const auto& value : {e.exact, e.min, e.max}) size = std::max(size, std::abs(value.value_or(0)));
  if (unit == "m" && size < 1e-5) return {1e6, "um"};
  if (unit == "m" && size < 0.1) return {1e3, "mm"};
  if ((unit == "N/m" || unit == "Pa" || unit == "J/m") && size >= 1e3 && size < 1e6) return {1e-3, "k" + unit};
  if ((unit == "N/m" || unit == "Pa" || unit == "J/m") && size >= 1e6) return {1e-6, "M" + unit};
  return {1, unit};
}

std::string exact_of(const Expectation& e, const ShownUnit& unit)
{
  if (!is_judged(e)) return "";
  if (e.exact) return unit.value(*e.exact);
  if (e.min && e.max) return unit.number(*e.min) + " .. " + unit.value(*e.max);
  return e.min ? ">= " + unit.value(*e.min) : "<= " + unit.value(*e.max);
}

/// Takes the values of the runs; false, and the reason says why, where one has none.
bool take_values(ExpectationResult& result, const Expectation& e, const NumbersOfRuns& numbers)
{
  const std::vector<std::string> runs = runs_of(e);
  for (std::size_t k = 0; k < runs.size(); ++k) try {
      Reading reading = numbers.reading(runs[k], observable_of(e, k));
      if (e.held != Held::not_asked) {
        result.band = numbers.band(runs[k], e.observable.quantity);
        reading.value = result.band->converged;
      }
      result.values.push_back(reading.value);
      if (k == 0) result.unit = reading.unit, result.label = reading.label;
      if (!e.unit.empty() && !input::same_dimension(e.unit, reading.unit))
        throw InputError(
            fmt::format("{} is expected in {}, and is in {}", words_of(e.observable), e.unit, reading.unit.empty() ? "1" : reading.unit));
    } catch (const std::bad_alloc&) {
      throw;
    } catch (const std::exception& error) {
      result.reason = error.what();
      return false;
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

/// What is expected, in the unit of the values.
void take_words(ExpectationResult& result, const Expectation& e)
{
  const ShownUnit unit = shown_unit(e, result.unit);
  result.what = words_of(e);
  result.exact = exact_of(e, unit);
  result.tolerance = e.tolerance ? percent(*e.tolerance) : e.absolute_tolerance ? unit.value(*e.absolute_tolerance) : "";
}

}  // namespace

const char* word_of(Verdict verdict)
{
  constexpr const char* words[] = {"met", "MISSED", "FAILED", "not run"};
  return words[static_cast<int>(verdict)];
}

ExpectationResult without_numbers(const Expectation& e, Verdict verdict, const std::string& reason)
{
  ExpectationResult result;
  result.unit = e.unit == "1" ? "" : e.unit;
  result.verdict = verdict;
  result.reason = reason;
  take_words(result, e);
  return result;
}

ExpectationResult compare_with_numbers(const Expectation& e, const NumbersOfRuns& numbers)
{
  ExpectationResult result;
  if (!take_values(result, e, numbers)) return without_numbers(e, Verdict::failed, result.reason);
  take_words(result, e);
  result.number = number_of(e, result.values);
  const ShownUnit unit = shown_unit(e, result.unit);
  if (result.band) return compare_with_band(result, e, unit);
  result.berm = unit.value(result.number);
  const Real error = error_of(e, result.number);
  const bool within_bounds = !e.exact && error == 0;
  result.error = within_bounds ? "" : e.tolerance ? percent(error) : unit.value(error, 3);
  result.verdict = is_met(e, result.number) ? Verdict::met : Verdict::missed;
  return result;
}

std::string shown(const Expectation& e, Real value, const std::string& unit, int digits)
{
  return shown_unit(e, unit, is_judged(e) ? 0 : std::abs(value)).value(value, digits);
}

run_folder::Band band_of(const std::string& quantity, const std::optional<run_folder::RunSummary>& summary)
{
  if (!summary || !summary->uncertainty) throw InputError("the run has no bands");
  if (const run_folder::Band* band = summary->uncertainty->find(quantity)) return *band;
  throw InputError(fmt::format("{} has no band", quantity));
}

}  // namespace berm::expectations
