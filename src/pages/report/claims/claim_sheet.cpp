// SPDX-License-Identifier: BSD-3-Clause
#include "report/claims/claim_sheet.hpp"

#include "input/message_text.hpp"
#include "input/reader.hpp"

#include <algorithm>
#include <array>
#include <fmt/format.h>

namespace berm::report {
namespace {

const std::vector<const char*> method_words = {"mpm", "fem"};
const std::vector<const char*> otherwise_words = {"not reproduced", "partly"};
const std::vector<std::string> selection_keys = {"method", "drag_from", "drag_to"};

/// The names of the values that stand before the k-th.
std::vector<std::string> names_before(const std::vector<ClaimValue>& values, std::size_t k)
{
  std::vector<std::string> names;
  for (std::size_t before = 0; before < k; ++before) names.push_back(values[before].name);
  return names;
}

bool contains(const std::vector<std::string>& list, const std::string& word)
{
  return std::find(list.begin(), list.end(), word) != list.end();
}

void check_value(Describe& d, const std::string& path, const ClaimValue& v, const ClaimFinding& finding,
                 const std::vector<std::string>& before)
{
  const base::Observable& kind = claim_observables()[v.observable];
  d.check(!contains(before, v.name), path + ".name", "is the name of a value before it");
  d.check(!kind.needs_at || v.at, path, fmt::format("{} needs at, where it is taken", kind.word));
  d.check(kind.at != base::ObservableUnit::none || !v.at, path + ".at", fmt::format("{} is taken at no such place", kind.word));
  const bool of_quantity = is_quantity(kind);
  d.check(of_quantity != v.quantity.empty(), path + (of_quantity ? "" : ".quantity"),
          "observable = \"quantity\" and a quantity of summary.json go together");
  d.check(!v.of_beside || finding.beside, path + ".of_beside", "there is no run beside");
  d.check(v.over.empty() || contains(before, v.over), path + ".over", "is no value before it", before);
  d.check(v.more_than.empty() || contains(before, v.more_than), path + ".more_than", "is no value before it", before);
  d.check(v.over.empty() || !v.per, path + ".per", "is one divisor too many, beside over");
  const bool bounded = v.min || v.max || !v.more_than.empty();
  d.check(!v.published || !bounded, path + ".published", "is judged by near and off; least, most and more_than are for bounds");
  d.check(!v.published || *v.published != 0, path + ".published", "must not be zero, of which nothing is near; give least and most");
  d.check(!v.min || !v.max || *v.min <= *v.max, path + ".most", "must not be less than least");
  d.check(bounded || (v.met.empty() && v.missed.empty() && !v.partly), path, "met, missed and otherwise need least, most or more_than");
}

void check_words(Describe& d, const std::string& path, const std::string& words, const std::vector<std::string>& names)
{
  for (auto found = first_placeholder(words); found; found = first_placeholder(found->after))
    d.check(contains(names, found->name), path, fmt::format("{} stands for nothing", input::in_quotes("{" + found->name + "}")), names);
}

void check_finding(Describe& d, const std::string& path, const ClaimFinding& finding)
{
  for (std::size_t k = 0; k < finding.values.size(); ++k)
    check_value(d, fmt::format("{}.value[{}]", path, k), finding.values[k], finding, names_before(finding.values, k));
  d.check(finding.alike.empty() || finding.beside, path + ".alike", "there is no run beside");
  std::vector<std::string> names = names_before(finding.values, finding.values.size());
  if (finding.beside) names.emplace_back("beside");
  check_words(d, path + ".words", finding.words, names);
}

void check_claim(Describe& d, const std::string& path, const Claim& claim)
{
  std::vector<std::string> ranges;
  for (std::size_t k = 0; k < claim.findings.size(); ++k) {
    check_finding(d, fmt::format("{}.finding[{}]", path, k), claim.findings[k]);
    for (const ClaimValue& value : claim.findings[k].values)
      for (const char* what : {" least", " most", " ratio"}) ranges.push_back(value.name + what);
  }
  check_words(d, path + ".why", claim.why, ranges);
  check_words(d, path + ".why_of_several", claim.why_of_several, ranges);
}

ClaimSheet sheet_of(input::Document document)
{
  ClaimSheet sheet;
  std::vector<std::vector<std::array<std::vector<TestCondition>, 2>>> selections;
  const auto take_from = [&](input::Node& table, const char* key, const std::string& path, const std::vector<std::string>& kept) {
    input::Node* inner = member(table, key);
    const bool there = inner != nullptr && inner->kind == input::Node::Kind::table;
    return there ? take_conditions(document, *inner, path + key, kept) : std::vector<TestCondition>{};
  };
  const auto items_of = [](input::Node* array) {
    std::vector<input::Node*> items;
    if (array != nullptr && array->kind == input::Node::Kind::array)
      for (input::Node& item : array->items) items.push_back(&item);
    return items;
  };
  sheet.test.all = take_from(document.root, "test", "", {"tolerance"});
  for (input::Node* claim : items_of(member(document.root, "claim"))) {
    auto& of_claim = selections.emplace_back();
    for (input::Node* finding : items_of(member(*claim, "finding"))) {
      const std::string path = fmt::format("claim[{}].finding[{}].", selections.size() - 1, of_claim.size());
      of_claim.push_back({take_from(*finding, "runs", path, selection_keys), take_from(*finding, "beside", path, selection_keys)});
    }
  }
  read(document, sheet);
  for (std::size_t k = 0; k < sheet.claims.size(); ++k)
    for (std::size_t f = 0; f < sheet.claims[k].findings.size(); ++f) {
      ClaimFinding& finding = sheet.claims[k].findings[f];
      finding.runs.conditions.all = selections[k][f][0];
      if (finding.beside) finding.beside->conditions.all = selections[k][f][1];
      const input::Node& node = member(document.root, "claim")->items[k].items.front();
      for (const std::string& parameter : finding.alike)
        refuse_unknown_parameter(document, node, fmt::format("claim[{}].finding[{}].alike", k, f), parameter);
    }
  if (sheet.test.all.empty()) refuse(document, document.root, "test", "names no parameter: every run would be of this test");
  return sheet;
}

}  // namespace

void describe(Describe& d, TestConditions& conditions)
{
  d.value("tolerance", conditions.tolerance, {.meaning = "largest |value / number - 1| of a parameter", .range = not_negative});
}

void describe(Describe& d, RunSelection& runs)
{
  d.choice("method", runs.method, method_words, {.meaning = "method of the runs"});
  d.value("drag_from", runs.drag_from, {.meaning = "embedment with which the drag begins, in D; within 0.01", .range = not_negative});
  d.value("drag_to", runs.drag_to, {.meaning = "displacement that the drag comes to at least, in D", .range = not_negative});
}

void describe(Describe& d, ClaimValue& value)
{
  d.value("name", value.name, {.meaning = "name of the value, for {NAME} in words", .required = true});
  int observable = static_cast<int>(value.observable);
  d.choice("observable", observable, observable_words(), {.meaning = "what is taken of a run", .required = true});
  value.observable = static_cast<std::size_t>(observable);
  const base::Observable& kind = claim_observables()[value.observable];
  d.value("at", value.at, {.meaning = "where it is taken; w and u in D", .unit = unit_of(kind.at)});
  d.value("quantity", value.quantity, {.meaning = "quantity of summary.json, for observable = \"quantity\""});
  d.value("of_beside", value.of_beside, {.meaning = "whether it is that of the run beside"});
  d.value("per", value.per, {.meaning = "what it is divided by", .unit = unit_of(kind.unit), .range = positive});
  d.value("over", value.over, {.meaning = "value that it is divided by; forces each over the unit weight of their soil"});
  const char* unit = value.per || !value.over.empty() ? "" : unit_of(kind.unit);
  d.value("percent", value.percent, {.meaning = "whether it is shown in per cent"});
  d.value("words", value.words, {.meaning = "how it is said, with {} for the number; absent: the number"});
  d.value("without", value.without, {.meaning = "what is said of a run without it; absent: nothing is said of that run"});
  d.value("counts_as", value.counts_as, {.meaning = "number that is judged where a run has none", .unit = unit});
  d.value("published", value.published, {.meaning = "number that is published", .unit = unit});
  d.value("least", value.min, {.meaning = "least number with which the claim holds", .unit = unit});
  d.value("most", value.max, {.meaning = "largest number with which the claim holds", .unit = unit});
  d.value("more_than", value.more_than, {.meaning = "name of a value that it exceeds where the claim holds"});
  int otherwise = value.partly ? 1 : 0;
  d.choice("otherwise", otherwise, otherwise_words, {.meaning = "verdict where it is out of these bounds"});
  value.partly = otherwise == 1;
  d.value("met", value.met, {.meaning = "said as a reason where all runs are within these bounds"});
  d.value("missed", value.missed, {.meaning = "said as a reason where a run is out of them"});
}

void describe(Describe& d, ClaimFinding& finding)
{
  d.table("runs", finding.runs, {.meaning = "runs that it is found in; further keys are parameters that they have"});
  d.optional_table("beside", finding.beside, {.meaning = "run that each is compared with, the first such"});
  d.value("alike", finding.alike, {.meaning = "parameters in which the run beside is alike"});
  d.value("words", finding.words, {.meaning = "what is found, with {NAME} for values and {beside} for the run beside", .required = true});
  d.array("value", finding.values, {.meaning = "numbers, and what they should be", .required = true});
}

void describe(Describe& d, Claim& claim)
{
  d.value("statement", claim.statement, {.meaning = "what is claimed", .required = true});
  d.value("where", claim.where, {.meaning = "section or figure where it is", .required = true});
  d.choice("scale", claim.scale, {"model", "prototype"},
           {.meaning = "what published forces are read as: per metre run of the model or of the prototype; runs are judged alike"});
  d.array("finding", claim.findings, {.meaning = "what runs say of it", .required = true});
  d.value("why", claim.why,
          {.meaning = "how it is judged, with {NAME least} and {NAME most} for the range over the runs", .required = true});
  d.value("why_of_several", claim.why_of_several,
          {.meaning = "said after it where two runs tell of it or more; {NAME ratio} where two do"});
  d.value("missing", claim.missing, {.meaning = "said where no run tells of it"});
}

void describe(Describe& d, ClaimSheet& sheet)
{
  d.value("title", sheet.title, {.meaning = "heading of the section"});
  d.value("source", sheet.source, {.meaning = "where the claims are published", .required = true});
  d.value("near", sheet.near, {.meaning = "largest |number / published - 1| of what is reproduced", .range = positive});
  d.value("off", sheet.off, {.meaning = "largest |number / published - 1| of what is partly reproduced", .range = positive});
  d.table("test", sheet.test, {.meaning = "parameters of the runs that are of this test", .required = true});
  d.array("claim", sheet.claims, {.meaning = "what is claimed", .required = true});
  d.array("point", sheet.points, {.meaning = "published numbers in the charts"});
  d.check(sheet.near <= sheet.off, "off", "must not be less than near");
  for (std::size_t k = 0; k < sheet.claims.size(); ++k) check_claim(d, fmt::format("claim[{}]", k), sheet.claims[k]);
}

bool judges_a_force(const Claim& claim)
{
  return std::any_of(claim.findings.begin(), claim.findings.end(), [](const ClaimFinding& finding) {
    return std::any_of(finding.values.begin(), finding.values.end(), [](const ClaimValue& v) {
      return v.published && claim_observables()[v.observable].unit == base::ObservableUnit::force && !v.per && v.over.empty();
    });
  });
}

ClaimSheet read_claims(const std::filesystem::path& file)
{
  return sheet_of(input::parse_file(file));
}

ClaimSheet read_claims_text(const std::string& file, const std::string& text)
{
  return sheet_of(input::parse_text(file, text));
}

std::optional<Placeholder> first_placeholder(const std::string& text)
{
  const std::size_t begin = text.find('{'), end = text.find('}', begin == std::string::npos ? 0 : begin);
  if (begin == std::string::npos || end == std::string::npos) return {};
  return Placeholder{text.substr(0, begin), text.substr(begin + 1, end - begin - 1), text.substr(end + 1)};
}

}  // namespace berm::report
