// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/report/expectations/claims_section_test.cpp
#include "report/expectations/expectations_section.hpp"
#include "report/expectations/expected_runs.hpp"
#include "structures/base/soil_words.hpp"
#include "text/quantity_words.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::report {
namespace {

using expectations::Claim;
using expectations::Expectation;
using expectations::ExpectationResult;
using expectations::Published;
using expectations::Verdict;
using text::Standing;

/// What one run says of a claim.
struct Evidence {
  std::string run, words;
  Standing standing;
};

/// The settings that tests often leave open, and what the mesh is.
std::string setting_of(const record::RunRecord& run)
{
  const settings::Case& c = run.settings;
  const base::BodyScale scale = base::body_scale(c);
  std::string words = fmt::format("γ′ = {:.3g} kN/m³", scale.unit_weight / 1000);
  if (const auto soil = base::touched_material(c))
    if (const auto sand = strength_at_rest(*soil)) words += fmt::format(", ψ = {:.3g}°", sand->dilation_angle * 180 / pi);
  for (const auto& [name, body] : c.body)
    if (body.has_k0()) words += ", K0 = " + base::k0_in_words(body.at_rest(), body.sin_friction);
  if (const auto* seabed = std::get_if<mesh::SeabedMesh>(&c.mesh)) {
    const Real size = c.method == settings::Method::fem && c.fem.contact_size ? *c.fem.contact_size : seabed->near_size;
    words += fmt::format(", {} of D/{:.3g}", c.method == settings::Method::fem ? "elements" : "cells", scale.width / size);
  }
  if (c.method == settings::Method::mpm) words += c.mpm.volumetric_projection ? ", no locking" : ", plain triangles, which lock";
  return words;
}

std::string words_of(const Expectation& e, const ExpectationResult& found, const record::RunRecord& run)
{
  if (std::isnan(found.number)) return fmt::format("{}: none", e.label);
  std::string words = fmt::format("{}: {}", e.label, shown(e, found.number, found.unit, 3));
  const base::BodyScale scale = base::body_scale(run);
  if (found.unit == "N/m" && !is_pure(e) && has_prototype(scale))
    words += fmt::format(" ({} in the prototype)", text::force_words(found.number * scale.gravity_level, scale.dimension));
  if (e.exact) words += fmt::format(", {:.2g} times the {} that is published", found.number / *e.exact, found.exact);
  return words;
}

/// How far a number is from what it should be, relative.
Real distance_of(const Expectation& e, Real number)
{
  const Real error = std::abs(error_of(e, number));
  return e.exact ? (e.tolerance ? error : error / std::abs(*e.exact))
                 : error / std::abs(number < e.min.value_or(-infinity) ? *e.min : *e.max);
}

Standing standing_of(const Expectation& e, const ExpectationResult& found)
{
  if (found.verdict == Verdict::met) return Standing::good;
  return e.partly && distance_of(e, found.number) <= *e.partly ? Standing::fair : Standing::bad;
}

/// The worst of all; where there are several and none is good, bad.
Standing standing_of_all(const std::vector<Standing>& judged)
{
  const bool any_good = std::find(judged.begin(), judged.end(), Standing::good) != judged.end();
  if (judged.size() > 1 && !any_good) return Standing::bad;
  return judged.empty() ? Standing::good : *std::max_element(judged.begin(), judged.end());
}

/// Empty where the run lacks a number that the claim is judged by; without a verdict, and with the reason, where one cannot be read.
std::optional<Evidence> evidence_of(const Claim& claim, const ExpectedRun& run, const ExpectedRuns& all)
{
  std::string words;
  std::vector<Standing> judged;
  for (const Expectation& e : claim.expect) {
    if (e.run != run.name) continue;
    const ExpectationResult found = all.have(e) ? all.compare(e, run) : without_numbers(e, Verdict::not_run, "");
    if (is_judged(e)) {
      if (found.verdict == Verdict::failed) return Evidence{run.record->name, found.reason, Standing::unknown};
      if (std::isnan(found.number)) return {};
      judged.push_back(standing_of(e, found));
    }
    if (all.have(e)) words += (words.empty() ? "" : "; ") + words_of(e, found, *run.record);
  }
  if (words.empty()) return {};
  return Evidence{run.record->name, words, standing_of_all(judged)};
}

/// Of all runs together: what all of them say, else partly.
Standing verdict_of(std::vector<Evidence> evidence)
{
  std::erase_if(evidence, [](const Evidence& e) { return e.standing == Standing::unknown; });
  if (evidence.empty()) return Standing::unknown;
  const Standing first = evidence.front().standing;
  return std::all_of(evidence.begin(), evidence.end(), [&](const Evidence& e) { return e.standing == first; }) ? first : Standing::fair;
}

std::string badge_of(Standing standing)
{
  constexpr const char* words[] = {"reproduced", "partly", "not reproduced", "not examined"};
  return html_badge(standing, words[static_cast<std::size_t>(standing)]);
}

std::string cell_of(const std::vector<Evidence>& evidence)
{
  std::string html;
  for (const Evidence& e : evidence)
    html += fmt::format("<div><strong>{}</strong>: {} {}</div>", text::html_text(e.run), text::html_text(e.words),
                        evidence.size() > 1 ? badge_of(e.standing) : "");
  return html.empty() ? "not shown by a run on this page" : html;
}

std::string section_of(const ExpectedRuns& runs, const Published& published, const std::string& id)
{
  std::string settings;
  for (const ExpectedRun& run : runs.runs())
    settings +=
        fmt::format("<li><strong>{}</strong>: {}</li>\n", text::html_text(run.record->name), text::html_text(setting_of(*run.record)));
  text::HtmlTable table(id + "-table", published.title);
  table.columns({{"claim"}, {"verdict"}, {"what berm finds"}, {"why"}});
  for (const Claim& claim : published.claims) {
    std::vector<Evidence> evidence;
    for (const ExpectedRun& run : runs.runs())
      if (const auto found = evidence_of(claim, run, runs)) evidence.push_back(*found);
    table.row({{fmt::format("{} <span class=\"quiet\">({})</span>", text::html_text(claim.statement), text::html_text(claim.where))},
               {badge_of(verdict_of(evidence))},
               {cell_of(evidence)},
               {text::html_text(claim.why)}});
  }
  const std::string intro = text::html_paragraph(published.source + ". Each row uses the numbers of the runs on this page.");
  return text::html_section(id, published.title, intro + "<ul>\n" + settings + "</ul>\n" + table.html());
}

}  // namespace

std::string claims_section(const std::vector<record::RunRecord>& runs, const ExpectationSheets& sheets)
{
  std::string html;
  int count = 0;
  for (const expectations::Expectations& sheet : sheets) {
    const ExpectedRuns expected(runs, sheet);
    if (!sheet.published || sheet.published->claims.empty() || expected.runs().empty()) continue;
    html += section_of(expected, *sheet.published, ++count == 1 ? "claims" : fmt::format("claims-{}", count));
  }
  return html;
}

}  // namespace berm::report
