// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/report/claims/claims_test.cpp
#include "report/claims/claim_evidence.hpp"

#include "core/error.hpp"
#include "text/quantity_words.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::report {
namespace {

using text::Standing;

constexpr Real alike_depth = 0.01;  // of D

bool is_selected(const TestRun& run, const RunSelection& selection)
{
  if (run.record.settings.method != selection.method) return false;
  const std::optional<Real> begin = run.observed->begin_of_drag();
  if (selection.drag_from && !(begin && std::abs(*begin - *selection.drag_from) < alike_depth)) return false;
  if (selection.drag_to && !run.observed->drag_reaches(*selection.drag_to)) return false;
  return meets(run.record.settings, selection.conditions);
}

/// The first run that one is to be compared with, or null.
const TestRun* beside_of(const TestRun& run, const ClaimFinding& finding, const TestRuns& runs)
{
  const auto is_alike = [&](const TestRun& other, const std::string& path) {
    return values_of(run.record.settings, path) == values_of(other.record.settings, path);
  };
  for (const TestRun& other : runs)
    if (&other != &run && is_selected(other, *finding.beside) &&
        std::all_of(finding.alike.begin(), finding.alike.end(), [&](const std::string& path) { return is_alike(other, path); }))
      return &other;
  return nullptr;
}

const ClaimNumber& number_named(const std::vector<ClaimNumber>& numbers, const std::string& name)
{
  return *std::find_if(numbers.begin(), numbers.end(), [&](const ClaimNumber& n) { return n.name == name; });
}

/// Forces over the unit weight of the soil that they are in.
Real comparable(const ClaimNumber& number)
{
  return number.unit == base::ObservableUnit::force ? number.value / number.run->scale.unit_weight : number.value;
}

ClaimNumber number_of(const ClaimValue& v, const TestRun& run, ClaimScale scale, const std::vector<ClaimNumber>& before)
{
  const base::Observable& observable = claim_observables()[v.observable];
  ClaimNumber number{v.name, evaluate(observable, v.at, v.quantity, run), observable.unit, &run, {}};
  if (v.published && number.unit == base::ObservableUnit::force && scale == ClaimScale::prototype) number.value *= run.scale.gravity_level;
  if (v.per) number.value /= *v.per;
  if (!v.over.empty()) number.value = comparable(number) / comparable(number_named(before, v.over));
  if (v.per || !v.over.empty()) number.unit = base::ObservableUnit::number;
  return number;
}

std::optional<Standing> standing_of(const ClaimValue& v, Real number, const ClaimSheet& sheet, const std::vector<ClaimNumber>& before)
{
  if (std::isnan(number) && v.counts_as) number = *v.counts_as;
  if (std::isnan(number)) return {};
  if (v.published) {
    const Real off = std::abs(number / *v.published - 1);
    return off <= sheet.near ? Standing::good : off <= sheet.off ? Standing::fair : Standing::bad;
  }
  if (!v.min && !v.max && v.more_than.empty()) return {};
  const bool more = v.more_than.empty() || number > number_named(before, v.more_than).value;
  const bool holds = more && (!v.min || number >= *v.min) && (!v.max || number <= *v.max);
  return holds ? Standing::good : v.partly ? Standing::fair : Standing::bad;
}

/// The worst of all; where there are several and none is good, bad.
Standing standing_of_all(const std::vector<ClaimNumber>& numbers)
{
  Standing worst = Standing::good;
  int judged = 0, good = 0;
  for (const ClaimNumber& number : numbers) {
    if (!number.standing) continue;
    ++judged;
    good += *number.standing == Standing::good ? 1 : 0;
    worst = std::max(worst, *number.standing);
  }
  return judged > 1 && good == 0 ? Standing::bad : worst;
}

std::string percent_of(Real part)
{
  return part < 0.1 ? fmt::format("{:.2g} %", 100 * part) : fmt::format("{:.0f} %", 100 * part);
}

std::string words_of(const ClaimValue& v, const ClaimNumber& number)
{
  if (std::isnan(number.value)) return v.without;
  const std::string shown = v.percent ? percent_of(number.value) : report::words_of(number.unit, number.value);
  const std::optional<Placeholder> place = v.words.empty() ? std::nullopt : first_placeholder(v.words);
  return place ? place->before + shown + place->after : v.words.empty() ? shown : v.words;
}

/// A text with every placeholder filled by `fill(name)`.
template <class Fill>
std::string filled(std::string text, const Fill& fill)
{
  std::string all;
  for (auto found = first_placeholder(text); found; found = first_placeholder(text)) {
    all += found->before + fill(found->name);
    text = found->after;
  }
  return all + text;
}

std::optional<ClaimEvidence> tell(const ClaimFinding& finding, ClaimScale scale, const ClaimSheet& sheet, const TestRun& run,
                                  const TestRun* beside)
{
  ClaimEvidence evidence{run.record.name, "", Standing::unknown, {}};
  std::map<std::string, std::string> words;
  if (beside != nullptr) words["beside"] = beside->record.name;
  for (const ClaimValue& v : finding.values) {
    ClaimNumber number = number_of(v, v.of_beside ? *beside : run, scale, evidence.numbers);
    if (std::isnan(number.value) && v.without.empty()) return {};
    number.standing = standing_of(v, number.value, sheet, evidence.numbers);
    words[v.name] = words_of(v, number);
    evidence.numbers.push_back(number);
  }
  evidence.standing = standing_of_all(evidence.numbers);
  evidence.words = filled(finding.words, [&](const std::string& name) { return words[name]; });
  return evidence;
}

/// "NAME least", "NAME most" or "NAME ratio" over the runs; empty where there is none.
std::string range_of(const std::string& placeholder, const std::vector<ClaimEvidence>& evidence)
{
  const std::size_t space = placeholder.find_last_of(' ');
  const std::string name = placeholder.substr(0, space), what = placeholder.substr(space + 1);
  Real min = infinity, max = -infinity;
  base::ObservableUnit unit = base::ObservableUnit::number;
  int count = 0;
  for (const ClaimEvidence& e : evidence)
    for (const ClaimNumber& number : e.numbers)
      if (number.name == name && !std::isnan(number.value)) {
        min = std::min(min, number.value), max = std::max(max, number.value), unit = number.unit;
        ++count;
      }
  if (count == 0 || (what == "ratio" && count != 2)) return "";
  const Real value = what == "least" ? min : what == "most" ? max : max / min;
  return unit == base::ObservableUnit::force && what != "ratio" ? text::force_words(value, 2) : fmt::format("{:.2g}", value);
}

/// A sentence with ranges of numbers in it; "" where one of them is not there.
std::string sentence(const std::string& text, const std::vector<ClaimEvidence>& evidence)
{
  bool whole = true;
  const std::string all = filled(text, [&](const std::string& name) {
    const std::string range = range_of(name, evidence);
    whole = whole && !range.empty();
    return range;
  });
  return whole ? all : "";
}

/// Whether the runs that have a number of this name are all as they should be; empty where none has.
std::optional<bool> all_meet(const std::string& name, const std::vector<ClaimEvidence>& evidence)
{
  std::optional<bool> all;
  for (const ClaimEvidence& e : evidence)
    for (const ClaimNumber& number : e.numbers)
      if (number.name == name && number.standing) all = all.value_or(true) && *number.standing == Standing::good;
  return all;
}

}  // namespace

std::vector<ClaimEvidence> evidence_of(const Claim& claim, const ClaimSheet& sheet, const TestRuns& runs)
{
  std::vector<ClaimEvidence> all;
  for (const ClaimFinding& finding : claim.findings)
    for (const TestRun& run : runs) try {
        if (!is_selected(run, finding.runs)) continue;
        const TestRun* beside = finding.beside ? beside_of(run, finding, runs) : nullptr;
        if (finding.beside && beside == nullptr) continue;
        if (const auto evidence = tell(finding, claim.scale, sheet, run, beside)) all.push_back(*evidence);
      } catch (const RunError&) {
        continue;  // the film of the run says which frame
      }
  return all;
}

std::string reasons_of(const Claim& claim, const std::vector<ClaimEvidence>& evidence)
{
  std::vector<std::string> sentences = {sentence(claim.why, evidence)};
  for (const ClaimFinding& finding : claim.findings)
    for (const ClaimValue& v : finding.values)
      if (const std::optional<bool> met = all_meet(v.name, evidence)) sentences.push_back(*met ? v.met : v.missed);
  if (evidence.size() > 1) sentences.push_back(sentence(claim.why_of_several, evidence));
  std::string text;
  for (const std::string& words : sentences)
    if (!words.empty()) text += (text.empty() ? "" : " ") + words;
  return text;
}

}  // namespace berm::report
