// SPDX-License-Identifier: BSD-3-Clause
#include "report/claims/claims.hpp"
#include "report/claims/claim_evidence.hpp"
#include "text/html.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::report {
namespace {

/// The settings that tests often leave open, and what the mesh is.
std::string setting_of(const record::RunRecord& run)
{
  const problem::Case& c = run.settings;
  const base::BodyScale scale = base::body_scale(c);
  std::string words = fmt::format("γ′ = {:.3g} kN/m³", scale.unit_weight / 1000);
  if (const auto sand = strength_at_rest(*base::touched_material(c)))
    words += fmt::format(", ψ = {:.3g}°", sand->dilation_angle * 180 / pi);
  for (const auto& [name, body] : c.body)
    if (body.k0) words += fmt::format(", K0 = {:.3g}", *body.k0);
  if (const auto* seabed = std::get_if<mesh::SeabedMesh>(&c.mesh)) {
    const Real size = c.method == problem::Method::fem && c.fem.contact_size ? *c.fem.contact_size : seabed->near_size;
    words += fmt::format(", {} of D/{:.3g}", c.method == problem::Method::fem ? "elements" : "cells", scale.width / size);
  }
  if (c.method == problem::Method::mpm) words += c.mpm.volumetric_projection ? ", no locking" : ", plain triangles, which lock";
  return words;
}

/// Of all findings together: what all of them say, else partly.
text::Standing verdict_of(const std::vector<ClaimEvidence>& findings)
{
  if (findings.empty()) return text::Standing::unknown;
  const text::Standing first = findings.front().standing;
  return std::all_of(findings.begin(), findings.end(), [&](const ClaimEvidence& f) { return f.standing == first; }) ? first
                                                                                                                    : text::Standing::fair;
}

std::string word_of(text::Standing standing)
{
  switch (standing) {
  case text::Standing::good:
    return "reproduced";
  case text::Standing::fair:
    return "partly";
  case text::Standing::bad:
    return "not reproduced";
  case text::Standing::unknown:
    break;
  }
  return "not examined";
}

/// The scale at which a claim of forces is judged, below its verdict.
std::string scale_of(const Claim& claim)
{
  if (!judges_a_force(claim)) return "";
  return fmt::format("<div class=\"quiet\">per metre of the {}</div>", claim.scale == ClaimScale::model ? "model" : "prototype");
}

std::string cell_of(const std::vector<ClaimEvidence>& findings)
{
  std::string html;
  for (const ClaimEvidence& f : findings)
    html += fmt::format("<div><strong>{}</strong>: {} {}</div>", text::html_text(f.run), text::html_text(f.words),
                        findings.size() > 1 ? html_badge(f.standing, word_of(f.standing)) : "");
  return html.empty() ? "no run shows it" : html;
}

std::string section_of(const std::vector<record::RunRecord>& runs, const ClaimSheet& sheet, const std::string& id)
{
  TestRuns of_test;
  std::string settings;
  for (const record::RunRecord& run : runs) {
    if (!is_of_test(run, sheet) || run.history.rows() == 0) continue;
    of_test.emplace_back(run);
    settings += fmt::format("<li><strong>{}</strong>: {}</li>\n", text::html_text(run.name), text::html_text(setting_of(run)));
  }
  if (of_test.empty()) return "";
  text::HtmlTable table(id + "-table", sheet.title);
  table.columns({{"claim"}, {"verdict"}, {"what berm finds"}, {"why"}});
  for (const Claim& claim : sheet.claims) {
    const std::vector<ClaimEvidence> evidence = evidence_of(claim, sheet, of_test);
    const text::Standing verdict = verdict_of(evidence);
    table.row({{fmt::format("{} <span class=\"quiet\">({})</span>", text::html_text(claim.statement), text::html_text(claim.where))},
               {html_badge(verdict, word_of(verdict)) + scale_of(claim)},
               {cell_of(evidence)},
               {text::html_text(evidence.empty() ? claim.missing : reasons_of(claim, evidence))}});
  }
  const std::string intro =
      text::html_paragraph(fmt::format("{}. Each row is made from the numbers of the runs on this page: within {:.0f} % of the published "
                                       "number is reproduced, within {:.0f} % partly.",
                                       sheet.source, 100 * sheet.near, 100 * sheet.off));
  return text::html_section(id, sheet.title, intro + "<ul>\n" + settings + "</ul>\n" + table.html());
}

}  // namespace

bool is_of_test(const record::RunRecord& run, const ClaimSheet& sheet)
{
  return !structures::structure_of(run.settings).observables().empty() && meets(run.settings, sheet.test);
}

bool is_of_a_test(const record::RunRecord& run, const ClaimSheets& sheets)
{
  return std::any_of(sheets.begin(), sheets.end(), [&](const ClaimSheet& sheet) { return is_of_test(run, sheet); });
}

base::PublishedPoints published_points(const std::vector<record::RunRecord>& runs, const ClaimSheets& sheets)
{
  base::PublishedPoints points;
  for (const ClaimSheet& sheet : sheets)
    if (std::any_of(runs.begin(), runs.end(), [&](const record::RunRecord& run) { return is_of_test(run, sheet); }))
      points.insert(points.end(), sheet.points.begin(), sheet.points.end());
  return points;
}

std::string claims_section(const std::vector<record::RunRecord>& runs, const ClaimSheets& sheets)
{
  std::string html;
  int number = 0;
  for (const ClaimSheet& sheet : sheets) {
    const std::string section = section_of(runs, sheet, number == 0 ? "claims" : fmt::format("claims-{}", number + 1));
    number += section.empty() ? 0 : 1;
    html += section;
  }
  return html;
}

}  // namespace berm::report
