// SPDX-License-Identifier: BSD-3-Clause
#include "report/claims/claims.hpp"
#include "report/claims/claim.hpp"
#include "report/claims/paper.hpp"
#include "text/tex_math.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::report {
namespace {

/// The settings that the paper leaves open, and what the mesh is.
std::string setting_of(const pipe::RunRecord& run)
{
  const problem::Case& c = run.settings;
  std::string words = fmt::format("γ′ = {:.3g} kN/m³", run.scale.unit_weight / 1000);
  if (const auto* sand = std::get_if<material::MohrCoulomb>(pipe::touched_material(c)))
    words += fmt::format(", ψ = {:.3g}°", sand->dilation_angle * 180 / pi);
  for (const auto& [name, body] : c.body)
    if (body.k0) words += fmt::format(", K0 = {:.3g}", *body.k0);
  if (const auto* seabed = std::get_if<mesh::SeabedMesh>(&c.mesh)) {
    const Real size = c.method == problem::Method::fem && c.fem.contact_size ? *c.fem.contact_size : seabed->near_size;
    words += fmt::format(", {} of D/{:.3g}", c.method == problem::Method::fem ? "elements" : "cells", run.scale.diameter / size);
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

std::string cell_of(const std::vector<ClaimEvidence>& findings)
{
  std::string html;
  for (const ClaimEvidence& f : findings)
    html += fmt::format("<div><strong>{}</strong>: {} {}</div>", text::html_text(f.run), text::html_text(f.words),
                        findings.size() > 1 ? html_badge(f.standing, word_of(f.standing)) : "");
  return html.empty() ? "no run shows it" : html;
}

}  // namespace

text::Standing standing_of(Real value, Real published)
{
  const Real off = std::abs(value / published - 1);
  return off <= near_enough ? text::Standing::good : off <= not_far ? text::Standing::fair : text::Standing::bad;
}

text::Standing standing_if(bool holds)
{
  return holds ? text::Standing::good : text::Standing::bad;
}

std::string diameters(const TestRun& run, Real length)
{
  return fmt::format("{:.3g} D", length / run.D);
}

std::string claims_section(const std::vector<pipe::RunRecord>& runs)
{
  TestRuns mpm, fem;
  std::string settings;
  for (const pipe::RunRecord& run : runs) {
    if (!is_of_paper(run) || run.history.rows() == 0) continue;
    (run.settings.method == problem::Method::mpm ? mpm : fem).emplace_back(run);
    settings += fmt::format("<li><strong>{}</strong>: {}</li>\n", text::html_text(run.name), text::html_text(setting_of(run)));
  }
  if (mpm.empty() && fem.empty()) return "";

  std::vector<Claim> claims = claims_of_the_drag(mpm);
  for (const std::vector<Claim>& more : {claims_of_finite_elements(mpm, fem), claims_of_contact(mpm)})
    claims.insert(claims.end(), more.begin(), more.end());
  text::HtmlTable table("claims-table", "Claims of the paper");
  table.columns({{"claim"}, {"verdict"}, {"what berm finds"}, {"why"}});
  for (const Claim& claim : claims) {
    const text::Standing verdict = verdict_of(claim.findings);
    table.row({{fmt::format("{} <span class=\"quiet\">({})</span>", text::html_text(claim.statement), text::html_text(claim.where))},
               {html_badge(verdict, word_of(verdict))},
               {cell_of(claim.findings)},
               {text::html_text(claim.findings.empty() ? claim.missing : claim.why)}});
  }
  const std::string intro = text::html_paragraph(
      fmt::format("M. Maglia, N. M. Pinyol and C. Hoffman, Material Point Method modelling of offshore unburied cable/pipe interacting "
                  "with soil. Each row is made "
                  "from the numbers of the runs on this page: within {:.0f} % of the paper's number is reproduced, within {:.0f} % partly.",
                  100 * near_enough, 100 * not_far));
  return text::html_section("claims", "Claims of the paper", intro + "<ul>\n" + settings + "</ul>\n" + table.html());
}

}  // namespace berm::report
