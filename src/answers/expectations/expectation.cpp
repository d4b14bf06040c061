// SPDX-License-Identifier: BSD-3-Clause
#include "expectations/expectation.hpp"

#include "expectations/quotation.hpp"
#include "input/reader.hpp"
#include "os/error.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::expectations {
namespace {

bool is_ratio(const Expectation& e)
{
  return !e.over.empty() || e.over_number;
}

std::vector<std::string> names_of(const std::vector<std::pair<std::string, VerificationRun>>& runs)
{
  std::vector<std::string> names;
  for (const auto& entry : runs) names.push_back(entry.first);
  return names;
}

void check_runs(Describe& d, const std::string& path, const Expectation& e, const std::vector<std::string>& known)
{
  const auto is_known = [&](const std::string& name) { return std::find(known.begin(), known.end(), name) != known.end(); };
  d.check(e.run.empty() != e.runs.empty(), path, "needs either a run or, for an order of convergence, runs");
  d.check(e.run.empty() || is_known(e.run), path + ".run", "there is no such [run.NAME]", known);
  d.check(e.over.empty() || is_known(e.over), path + ".over", "there is no such [run.NAME]", known);
  d.check(e.over.empty() || (!e.run.empty() && e.over != e.run), path + ".over", "needs a run, and another one");
  d.check(!e.over_number || !e.run.empty(), path + ".over_number", "needs a run");
  d.check(std::all_of(e.runs.begin(), e.runs.end(), is_known), path + ".runs", "there is no such [run.NAME]", known);
  d.check(e.runs.empty() || e.runs.size() > 1, path + ".runs", "an order of convergence needs two runs at least");
  std::vector<std::string> sorted = e.runs;
  std::sort(sorted.begin(), sorted.end());
  d.check(std::adjacent_find(sorted.begin(), sorted.end()) == sorted.end(), path + ".runs", "names a run twice");
  d.check(e.limit.has_value() != e.runs.empty(), path + (e.limit ? ".limit" : ""), "runs and a limit go together");
}

/// The value that a page quotes is the one to expect, within one unit of its last digit.
void take_quotation(Describe& d, const std::string& path, Expectation& e)
{
  d.check(e.quoted_unit.empty() || !e.quoted.empty(), path + ".quoted_unit", "needs quoted");
  if (e.quoted.empty()) return;
  d.check(!is_judged(e) && !e.tolerance && !e.absolute_tolerance && e.held == Held::not_asked, path + ".quoted",
          "is the value to expect, to its last digit: leave out exact, least, most, held and the tolerances");
  try {
    const Quotation quotation = quotation_of(e);
    e.exact = quotation.value;
    e.absolute_tolerance = quotation.last_digit;
    if (!is_pure(e)) e.unit = quotation.si_unit;
  } catch (const InputError& error) {
    d.check(false, path + ".quoted", error.what());
  }
  if (e.source.empty()) e.source = e.page;
  if (e.why.empty()) e.why = "one unit of the last digit that the page gives";
  if (e.requirement.empty()) e.requirement = "Pages quote numbers of their runs.";
  if (e.derived.empty()) e.derived = e.page;
}

/// What must fit together in one expectation.
void check(Describe& d, const std::string& path, const Expectation& e)
{
  check(d, path, e.observable);
  if (e.over_number) check(d, path + ".over_number", *e.over_number);
  const bool bounded = e.min || e.max;
  d.check(!e.exact || !bounded, path, "needs either exact, or least and most or one of them");
  d.check(!e.min || !e.max || *e.min <= *e.max, path + ".most", "must not be less than least");
  const int tolerances = e.tolerance.has_value() + e.absolute_tolerance.has_value();
  d.check(tolerances == (e.exact && e.held == Held::not_asked ? 1 : 0), path,
          "exact needs a tolerance, an absolute_tolerance or held, and one of them; bounds need none, or held");
  d.check(e.held == Held::not_asked || (!e.observable.quantity.empty() && !is_pure(e)), path + ".held",
          "only a quantity of one run has a band");
  d.check(!e.tolerance || e.exact != 0., path + ".tolerance", "zero needs an absolute_tolerance");
}

/// A band is there where the run was asked for it.
void check_band(Describe& d, const std::string& path, const Expectation& e, const Expectations& all)
{
  const bool asked =
      std::any_of(all.run.begin(), all.run.end(), [&](const auto& run) { return run.first == e.run && run.second.uncertainty; });
  d.check(e.held == Held::not_asked || asked, path + ".held", "the run needs uncertainty = true");
}

/// Element tests have key results, and no history over time.
void check_element(Describe& d, const std::string& path, const Expectation& e, const Expectations& all)
{
  const bool of_tests =
      std::any_of(all.run.begin(), all.run.end(), [&](const auto& run) { return run.first == e.run && !run.second.is_run(); });
  d.check(!of_tests || e.observable.column.empty(), path + ".column",
          "a run with element, fit, cyclic, sea or route = true has quantities only");
}

/// A number of which nobody says what it is for, and where it is from, proves nothing.
void take_promise(Describe& d, const std::string& path, Expectation& e, const Expectations& all)
{
  d.check(is_judged(e), path, "needs either exact, or least and most or one of them");
  d.check(!e.source.empty(), path, "needs source, source of the expected value");
  d.check(!e.why.empty(), path, "needs why, a reason for the tolerance or the bounds");
  d.check(!e.partly, path + ".partly", "only a claim can hold partly");
  if (e.requirement.empty()) e.requirement = all.requirement;
  if (e.derived.empty()) e.derived = all.derived;
  d.check(!e.requirement.empty(), path, "needs a requirement, what the user may rely on, here or at the top of the file");
  d.check(!e.derived.empty(), path, "needs derived, where its requirement is derived, here or at the top of the file");
}

/// A number of a claim for each of its runs.
std::vector<Expectation> for_each_run(const Claim& claim)
{
  std::vector<Expectation> all;
  for (const Expectation& e : claim.expect) {
    if (!e.run.empty()) all.push_back(e);
    for (const std::string& run : e.run.empty() ? claim.runs : std::vector<std::string>()) all.emplace_back(e).run = run;
  }
  return all;
}

void check_claim(Describe& d, const std::string& path, const Claim& claim, const std::vector<std::string>& names)
{
  for (std::size_t k = 0; k < claim.expect.size(); ++k) {
    const Expectation& e = claim.expect[k];
    const std::string own = fmt::format("{}.expect[{}]", path, k);
    d.check(!e.run.empty() || !claim.runs.empty(), own, "needs a run, here or as one of the claim's runs");
    d.check(e.runs.empty(), own + ".runs", "a claim has no orders of convergence");
    d.check(e.quoted.empty(), own + ".quoted", "a claim is not quoted: its numbers are those of others");
    d.check(!e.label.empty(), own, "needs a label, which says what the number is");
    d.check(!e.partly || is_judged(e), own + ".partly", "needs exact or bounds");
  }
  for (const Expectation& e : for_each_run(claim)) {
    check_runs(d, path, e, names);
    check(d, path, e);
  }
}

Expectations read_document(input::Document document)
{
  Expectations all;
  read(document, all);
  return all;
}

}  // namespace

void describe(Describe& d, VerificationRun& run)
{
  d.value("title", run.title, {.meaning = "what the run is, in one line"});
  d.value("case", run.case_file, {.meaning = "case file in the example's folder"});
  d.value("set", run.set, {.meaning = "parameters changed for this run, each KEY=VALUE as for --set"});
  d.value("element", run.element, {.meaning = "whether the case is an input of element tests (berm element)"});
  d.value("fit", run.fit, {.meaning = "whether the case is an input of berm fit"});
  d.value("cyclic", run.cyclic, {.meaning = "whether the case is an input of berm cyclic"});
  d.value("sea", run.sea, {.meaning = "whether the case is an input of berm sea"});
  d.value("route", run.route, {.meaning = "whether the case is an input of berm route"});
  d.value("uncertainty", run.uncertainty, {.meaning = "whether the bands of its results are found, too (berm run --uncertainty)"});
  d.value("fast", run.fast, {.meaning = "whether the run takes a few seconds and belongs to the tests"});
  d.value("long", run.is_long, {.meaning = "whether the run takes ten minutes or more and is left out of the whole book"});
}

void describe(Describe& d, Expectation& e)
{
  d.value("run", e.run, {.meaning = "name of the run that is to give the number"});
  d.value("over", e.over, {.meaning = "name of a run by whose number it is divided: the number to expect is the ratio"});
  d.optional_table("over_number", e.over_number,
                   {.meaning = "number that it is divided by, of the run `over` or of the same run; absent: the same number"});
  d.value("runs", e.runs,
          {.meaning = "instead of run: names of runs with cells half as large each time, whose order of convergence is meant"});
  describe(d, e.observable);
  std::string* const unit = is_pure(e) ? nullptr : &e.unit;
  d.value("limit", e.limit, {.meaning = "value that the runs converge to", .any_unit = &e.unit});
  d.value("exact", e.exact, {.meaning = "value to expect", .any_unit = unit});
  d.value("tolerance", e.tolerance, {.meaning = "largest |value / exact - 1|", .range = positive});
  d.value("absolute_tolerance", e.absolute_tolerance, {.meaning = "largest |value - exact|", .range = positive, .any_unit = unit});
  d.choice("held", e.held, held_words,
           {.meaning = "instead of a tolerance, of a quantity of a run with uncertainty: whether its band contains exact, or satisfies "
                       "least and most"});
  d.value("least", e.min, {.meaning = "least value to expect, instead of exact", .any_unit = unit});
  d.value("most", e.max, {.meaning = "largest value to expect, instead of exact", .any_unit = unit});
  d.value("quoted", e.quoted, {.meaning = "instead of exact: text of a page that quotes the number, which stands in braces with its unit"});
  d.value("quoted_unit", e.quoted_unit, {.meaning = "unit of that number, where it is not in the text"});
  d.value("page", e.page, {.meaning = "file of the example that has that text"});
  d.value(
      "partly", e.partly,
      {.meaning = "of a claim: largest |value / exact - 1|, or distance from a bound divided by that bound, up to which it holds partly",
       .range = positive,
       .words = {{"always", infinity}}});
  d.value("label", e.label, {.meaning = "of a claim: what the number is"});
  d.value("source", e.source, {.meaning = "source of the expected value"});
  d.value("why", e.why, {.meaning = "reason for the tolerance or the bounds"});
  d.value("requirement", e.requirement, {.meaning = "what the user may rely on, in a sentence; absent: that at the top of the file"});
  d.value("derived", e.derived, {.meaning = "where that is derived; absent: as at the top of the file"});
}

void describe(Describe& d, Claim& claim)
{
  d.value("statement", claim.statement, {.meaning = "what is claimed", .required = true});
  d.value("where", claim.where, {.meaning = "section or figure where it is", .required = true});
  d.value("why", claim.why, {.meaning = "criterion", .required = true});
  d.value("runs", claim.runs, {.meaning = "runs of each number that names none"});
  d.array("expect", claim.expect,
          {.meaning = "numbers that would prove it; without exact or bounds: shown for information", .required = true});
}

void describe(Describe& d, Published& published)
{
  d.value("title", published.title, {.meaning = "heading of the claims"});
  d.value("source", published.source, {.meaning = "where they are published", .required = true});
  d.array("point", published.points, {.meaning = "published numbers in the charts of a report"});
  d.array("claim", published.claims, {.meaning = "what is claimed"});
}

void describe(Describe& d, Expectations& all)
{
  d.choice("chapter", all.chapter, chapter_words, {.meaning = "chapter of the verification book"});
  d.value("requirement", all.requirement, {.meaning = "what the user may rely on, in a sentence, where an [[expect]] does not say it"});
  d.value("derived", all.derived, {.meaning = "where that is derived, where an [[expect]] does not say it"});
  d.named_tables("run", all.run, {.meaning = "problems, each one run of berm", .required = true});
  d.array("expect", all.expect, {.meaning = "numbers to expect", .required = true});
  d.optional_table("published", all.published, {.meaning = "what others published of the test, for its report"});
  const std::vector<std::string> names = names_of(all.run);
  for (const auto& [name, run] : all.run) d.check(!run.fast || !run.is_long, "run." + name + ".long", "the run is fast");
  for (const auto& [name, run] : all.run)
    d.check(run.is_run() || !run.uncertainty, "run." + name + ".uncertainty",
            "element tests, fits, storms, sea states and routes have no bands");
  for (const auto& [name, run] : all.run)
    d.check(run.element + run.fit + run.cyclic + run.sea + run.route <= 1, "run." + name,
            "has two of element, fit, cyclic, sea and route = true: it is one of them");
  std::vector<std::string> needed;
  for (std::size_t k = 0; k < all.expect.size(); ++k) {
    const std::string path = fmt::format("expect[{}]", k);
    check_runs(d, path, all.expect[k], names);
    take_quotation(d, path, all.expect[k]);
    check(d, path, all.expect[k]);
    check_band(d, path, all.expect[k], all);
    check_element(d, path, all.expect[k], all);
    take_promise(d, path, all.expect[k], all);
    for (const std::string& run : runs_of(all.expect[k])) needed.push_back(run);
  }
  for (std::size_t k = 0; all.published && k < all.published->claims.size(); ++k) {
    Claim& claim = all.published->claims[k];
    check_claim(d, fmt::format("published.claim[{}]", k), claim, names);
    claim.expect = for_each_run(claim);
  }
  for (const std::string& name : names)
    d.check(std::find(needed.begin(), needed.end(), name) != needed.end(), "run." + name, "no [[expect]] is about this run");
}

input::Listed expected_catalogue()
{
  return input::catalogue_of<Expectations>();
}

Expectations read_expectations(const std::filesystem::path& file)
{
  return read_document(input::parse_file(file));
}

Expectations read_expectations_text(const std::string& file, const std::string& text)
{
  return read_document(input::parse_text(file, text));
}

std::string name_of(const record::RunRecord& run, const Expectations& all)
{
  if (!run.origin || run.end != record::RunEnd::finished) return "";
  const auto found = std::find_if(all.run.begin(), all.run.end(), [&](const auto& entry) {
    return entry.second.case_file == run.origin->case_file && entry.second.set == run.origin->set;
  });
  return found == all.run.end() ? "" : found->first;
}

std::vector<std::string> runs_of(const Expectation& e)
{
  if (!e.runs.empty()) return e.runs;
  if (!is_ratio(e)) return {e.run};
  return {e.run, e.over.empty() ? e.run : e.over};
}

const Observable& observable_of(const Expectation& e, std::size_t k)
{
  return k == 1 && e.over_number ? *e.over_number : e.observable;
}

bool is_judged(const Expectation& e)
{
  return e.exact || e.min || e.max;
}

std::string words_of(const Expectation& e)
{
  if (!e.label.empty()) return e.label;
  const std::string words = (e.runs.empty() ? "" : "order of ") + words_of(e.observable);
  if (!is_ratio(e)) return words;
  const std::string divisor = e.over_number ? words_of(*e.over_number) : "that";
  return fmt::format("{} divided by {}{}", words, divisor, e.over.empty() ? "" : " of " + e.over);
}

bool is_pure(const Expectation& e)
{
  return !e.runs.empty() || is_ratio(e);
}

Real number_of(const Expectation& e, const std::vector<Real>& values)
{
  if (is_ratio(e)) return values.at(0) / values.at(1);
  if (e.runs.empty()) return values.at(0);
  const Real middle = (static_cast<Real>(values.size()) - 1) / 2;
  Real product = 0, squares = 0;
  for (std::size_t k = 0; k < values.size(); ++k) {
    const Real off = std::abs(values[k] - *e.limit), x = static_cast<Real>(k) - middle;
    if (!(off > 0)) return nan;
    product -= x * std::log2(off);
    squares += x * x;
  }
  return product / squares;
}

Real error_of(const Expectation& e, Real number)
{
  if (e.exact) return e.tolerance ? (number - *e.exact) / std::abs(*e.exact) : number - *e.exact;
  if (e.min && number < *e.min) return number - *e.min;
  if (e.max && number > *e.max) return number - *e.max;
  return std::isnan(number) ? number : 0;
}

bool is_met(const Expectation& e, Real number)
{
  return std::abs(error_of(e, number)) <= (e.exact ? e.tolerance ? *e.tolerance : *e.absolute_tolerance : 0);
}

}  // namespace berm::expectations
