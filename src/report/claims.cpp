// SPDX-License-Identifier: BSD-3-Clause
#include "output/tex_math.hpp"
#include "output/travel_curve.hpp"
#include "report/html.hpp"
#include "report/mechanism.hpp"
#include "report/paper.hpp"
#include "report/sections.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm {
namespace {

/// What one run says of a claim.
struct Finding {
  std::string run;
  Standing standing;
  std::string words;
};

/// A claim of the paper and what the runs say of it.
struct Claim {
  std::string statement, where;
  std::vector<Finding> findings;
  std::string why;
};

// How near is near: the paper gives its numbers with one or two digits, and berm's own depend on the mesh by some 10 %.
constexpr Real near_enough = 0.15, not_far = 0.4;

Standing standing_of(Real value, Real published)
{
  const Real off = std::abs(value / published - 1);
  return off <= near_enough ? Standing::good : off <= not_far ? Standing::fair : Standing::bad;
}

Standing standing_if(bool holds)
{
  return holds ? Standing::good : Standing::bad;
}

/// Of all findings together: what all of them say, else partly.
Standing verdict_of(const std::vector<Finding>& findings)
{
  if (findings.empty()) return Standing::unknown;
  const Standing first = findings.front().standing;
  return std::all_of(findings.begin(), findings.end(), [&](const Finding& f) { return f.standing == first; }) ? first : Standing::fair;
}

/// A run of the paper's test with its curves and frames.
class TestRun {
public:
  explicit TestRun(const RunRecord& run)
      : record(run),
        D(run.scale.diameter),
        half_(averaging_half(run.scale)),
        path_(pipe_path(run.history, run.stages)),
        V_(path_.w, path_.V),
        H_(path_.drag_u, path_.drag_H),
        V_drag_(path_.drag_u, path_.drag_V),
        w_(path_.drag_u, path_.drag_w),
        frames(run)
  {
  }

  const RunRecord& record;
  const Real D;

  Real V_of_push(Real w) const { return V_.at(w, half_); }
  Real H(Real u) const { return H_.at(u, half_); }
  Real V(Real u) const { return V_drag_.at(u, half_); }
  Real w(Real u) const { return w_.at(u, half_); }
  bool has_push() const { return !V_.empty(); }
  bool has_drag() const { return !H_.empty() && !w_.empty() && H_.end() > 0; }
  Real end_of_drag() const { return H_.end(); }
  /// The embedment with which the drag begins.
  Real w_begin() const { return path_.drag_w.front(); }

  /// Where in the push V first reaches a force, or in the drag w an embedment; empty where it does not.
  std::optional<Real> w_where_V_is(Real force) const { return first_travel(V_, force); }
  std::optional<Real> u_where_w_is(Real embedment) const { return first_travel(w_, embedment); }

private:
  std::optional<Real> first_travel(const TravelCurve& curve, Real value) const
  {
    for (const Real travel : curve.travel())
      if (curve.at(travel, half_) >= value) return travel;
    return std::nullopt;
  }

  Real half_;
  PipePath path_;
  TravelCurve V_, H_, V_drag_, w_;

public:
  const PipeFrames frames;
};

std::string newtons(Real force)
{
  return std::abs(force) < 1000 ? fmt::format("{:.3g} N/m", force) : fmt::format("{:.3g} kN/m", force / 1000);
}

std::string diameters(const TestRun& run, Real length)
{
  return fmt::format("{:.3g} D", length / run.D);
}

/// The settings that the paper leaves open, and what the mesh is.
std::string setting_of(const RunRecord& run)
{
  const Case& c = run.settings;
  std::string words = fmt::format("gamma' = {:.3g} kN/m3", run.scale.unit_weight / 1000);
  if (const auto* sand = std::get_if<MohrCoulomb>(touched_material(c)))
    words += fmt::format(", psi = {:.3g} deg", sand->dilation_angle * 180 / pi);
  for (const auto& [name, body] : c.body)
    if (body.k0) words += fmt::format(", K0 = {:.3g}", *body.k0);
  if (const auto* seabed = std::get_if<SeabedMesh>(&c.mesh)) {
    const Real size = c.method == Method::fem && c.fem.contact_size ? *c.fem.contact_size : seabed->near_size;
    words += fmt::format(", {} of D/{:.3g}", c.method == Method::fem ? "elements" : "cells", run.scale.diameter / size);
  }
  if (c.method == Method::mpm) words += c.mpm.volumetric_projection ? ", no locking" : ", plain triangles, which lock";
  return words;
}

using TestRuns = std::vector<TestRun>;

Claim force_of_the_push(const TestRuns& mpm)
{
  Claim claim{
      fmt::format("A push to w = {:g} D takes V = {:g} kN, in agreement with the test", paper_w_push, paper_V_push / 1000), "3.4", {}, ""};
  Real least = infinity, most = 0;
  for (const TestRun& run : mpm) {
    const Real V = run.has_push() ? run.V_of_push(paper_w_push * run.D) : std::numeric_limits<Real>::quiet_NaN();
    if (std::isnan(V)) continue;
    const auto w = run.w_where_V_is(paper_V_push);
    claim.findings.push_back({run.record.name, standing_of(V, paper_V_push),
                              fmt::format("V = {} at {:g} D; {}", newtons(V), paper_w_push,
                                          w ? fmt::format("{:g} kN/m at {}", paper_V_push / 1000, diameters(run, *w))
                                            : fmt::format("{:g} kN/m is not reached", paper_V_push / 1000))});
    least = std::min(least, V / paper_V_push), most = std::max(most, V / paper_V_push);
  }
  claim.why =
      fmt::format("The runs give {:.2g} to {:.2g} times the paper's force: weight, locking, K0 and dilation, which it leaves open, decide, "
                  "and it does not say at which scale its kN are.",
                  least, most);
  return claim;
}

Claim heave_of_the_push(const TestRuns& mpm)
{
  Claim claim{"Soil heaves at both sides of the pipe as it is pushed in",
              "3.4",
              {},
              "Heave is the height of the soil's columns beside the pipe above the first surface; above 0.01 D on both sides counts."};
  for (const TestRun& run : mpm) {
    const auto frame = run.frames.last(StageKind::push);
    if (!frame) continue;
    const Heave heave = heave_of(run.frames.soil(*frame), run.record.settings.surface, run.frames.place(*frame), run.D);
    claim.findings.push_back({run.record.name, standing_if(std::min(heave.behind, heave.ahead) > 0.01 * run.D),
                              fmt::format("{} and {} high at w = {}", diameters(run, heave.behind), diameters(run, heave.ahead),
                                          diameters(run, run.frames.place(*frame).w))});
  }
  return claim;
}

Claim growing_resistance(const TestRuns& mpm)
{
  Claim claim{"H grows with the horizontal displacement while V is held",
              "3.1, figure 2",
              {},
              "H is compared at a third, two thirds and the end of the drag."};
  for (const TestRun& run : mpm) {
    if (!run.has_drag()) continue;
    const Real u = run.end_of_drag(), first = run.H(u / 3), second = run.H(2 * u / 3), last = run.H(u);
    claim.findings.push_back({run.record.name, standing_if(first < second && second < last),
                              fmt::format("{}, {}, {} at u = {}, {}, {}", newtons(first), newtons(second), newtons(last),
                                          diameters(run, u / 3), diameters(run, 2 * u / 3), diameters(run, u))});
  }
  return claim;
}

Claim sinking(const TestRuns& mpm)
{
  Claim claim{fmt::format("The pipe sinks while it is dragged, to w = {:g} D at u = {:g} D", paper_w_drag, paper_u_drag),
              "3.4",
              {},
              "A pipe that is at yield when the drag begins sinks by geometry, whatever its V: w/D depends little on the setting."};
  for (const TestRun& run : mpm) {
    const Real w = run.has_drag() ? run.w(paper_u_drag * run.D) : std::numeric_limits<Real>::quiet_NaN();
    if (!std::isnan(w))
      claim.findings.push_back(
          {run.record.name, standing_of(w, paper_w_drag * run.D),
           fmt::format("w = {} at u = {:g} D, from {}", diameters(run, w), paper_u_drag, diameters(run, run.w_begin()))});
  }
  return claim;
}

Claim end_of_sinking(const TestRuns& mpm)
{
  constexpr Real still = 0.02;  // of D
  Claim claim{fmt::format("At u = {:g} D the embedment has reached its maximum", paper_u_drag),
              "3.4",
              {},
              fmt::format("A growth of w by more than {:g} D after u = {:g} D counts as sinking on.", still, paper_u_drag)};
  for (const TestRun& run : mpm) {
    if (!run.has_drag() || run.end_of_drag() < (paper_u_drag + 0.1) * run.D) continue;
    const Real growth = run.w(run.end_of_drag()) - run.w(paper_u_drag * run.D);
    claim.findings.push_back(
        {run.record.name, standing_if(growth <= still * run.D),
         fmt::format("w grows by {} from there to u = {}", diameters(run, growth), diameters(run, run.end_of_drag()))});
  }
  return claim;
}

Claim berm_of_soil(const TestRuns& mpm)
{
  constexpr Real still = 0.02;  // of D
  Claim claim{fmt::format("After u = {:g} D the berm that the pipe heaps up makes H grow", paper_u_drag), "3.4, 4", {}, ""};
  bool sinks = false;
  for (const TestRun& run : mpm) {
    const auto from = run.frames.nearest(StageKind::drag, &PipePlace::u, paper_u_drag * run.D), to = run.frames.last(StageKind::drag);
    if (!from || !to || *from == *to || !run.has_drag() || run.end_of_drag() < (paper_u_drag + 0.1) * run.D) continue;
    const auto berm = [&](std::size_t frame) {
      return heave_of(run.frames.soil(frame), run.record.settings.surface, run.frames.place(frame), run.D).berm / (run.D * run.D);
    };
    const Real first = berm(*from), last = berm(*to), H_first = run.H(paper_u_drag * run.D), H_last = run.H(run.end_of_drag());
    const bool grows = last > first && H_last > H_first;
    const bool sinks_on = run.w(run.end_of_drag()) - run.w(paper_u_drag * run.D) > still * run.D;
    sinks = sinks || sinks_on;
    claim.findings.push_back({run.record.name,
                              !grows     ? Standing::bad
                              : sinks_on ? Standing::fair
                                         : Standing::good,
                              fmt::format("berm {:.3g} to {:.3g} D2, H {} to {}", first, last, newtons(H_first), newtons(H_last))});
  }
  claim.why = sinks ? "Berm and H grow together, but the pipe sinks on as well, so that these runs cannot tell the two apart."
                    : "The pipe sinks no more: what grows with H is the berm.";
  return claim;
}

/// The run that is wished in place at an embedment, or null.
const TestRun* wished_at(const TestRuns& fem, Real w)
{
  for (const TestRun& run : fem)
    if (run.has_drag() && std::abs(run.w_begin() / run.D - w) < 0.01) return &run;
  return nullptr;
}

/// Where the paper reads its finite elements: where H no longer changes, the end of the drag.
Real plateau(const TestRun& fem)
{
  return fem.H(fem.end_of_drag());
}

Claim force_of_finite_elements(const TestRuns& fem)
{
  Claim claim{"Finite elements around a pipe wished in place give H of about 1 kN at 0.1 D and 2 kN at 0.25 D", "3.4", {}, ""};
  std::vector<Real> forces;
  for (const auto& [w, H] : paper_H_fem)
    if (const TestRun* run = wished_at(fem, w)) {
      const Real prototype = plateau(*run) * run->record.scale.gravity_level;
      forces.push_back(plateau(*run));
      claim.findings.push_back({run->record.name, standing_of(prototype, H),
                                fmt::format("{} at u = {}, {} in the prototype (paper {:g} kN)", newtons(plateau(*run)),
                                            diameters(*run, run->end_of_drag()), newtons(prototype), H / 1000)});
    }
  claim.why = "Compared per metre run of the prototype, the reading that is nearest";
  claim.why += forces.size() == 2
                   ? fmt::format("; the ratio of the two forces does not depend on any scale: {:.2g} here, {:.2g} in the paper.",
                                 forces[1] / forces[0], paper_H_fem[1].second / paper_H_fem[0].second)
                   : ".";
  return claim;
}

Claim finite_elements_fall_short(const TestRuns& mpm, const TestRuns& fem, Real w)
{
  const bool first = w == paper_H_fem[0].first;
  Claim claim{first ? fmt::format("Finite elements at the first embedment, {:g} D, fall short of H in the drag", w)
                    : fmt::format("Finite elements at the last embedment, {:g} D, still fall short of H: they lack the berm", w),
              "3.4, 4",
              {},
              ""};
  const TestRun* wished = wished_at(fem, w);
  if (wished == nullptr) return claim;
  const Real H_fem = plateau(*wished) / wished->record.scale.unit_weight;
  for (const TestRun& run : mpm) {
    if (!run.has_drag()) continue;
    const auto u = first ? std::optional<Real>(paper_u_drag * run.D) : run.u_where_w_is(w * run.D);
    const Real H = u ? run.H(*u) : std::numeric_limits<Real>::quiet_NaN();
    if (std::isnan(H)) continue;
    const Real ratio = H / run.record.scale.unit_weight / H_fem;
    claim.findings.push_back({run.record.name, standing_if(ratio > 1 + near_enough),
                              fmt::format("H = {} at u = {} (w = {}, V = {}): {:.2g} times that of {}", newtons(H), diameters(run, *u),
                                          diameters(run, run.w(*u)), newtons(run.V(*u)), ratio, wished->record.name)});
  }
  const Real V_fem = wished->V(wished->end_of_drag());
  claim.why =
      fmt::format("H over gamma' D2 is compared. With w fixed, V of {} is only {} at the end, so that the two are not under the same load.",
                  wished->record.name, newtons(V_fem));
  return claim;
}

Claim mechanisms_differ(const TestRuns& mpm, const TestRuns& fem)
{
  Claim claim{fmt::format("At {:g} D finite elements show two wedges, the material point method drags the heaped soil along", paper_w_drag),
              "3.4, figures 5 and 6",
              {},
              "Told by where the soil shears between two frames; dragging counts where a tenth of it or more lies above the first surface, "
              "two wedges "
              "where a tenth or more lies behind the pipe's centre."};
  constexpr Real a_tenth = 0.1;
  const auto words = [](const TestRun& run, const Shearing& s) {
    return fmt::format("{:.0f} % behind the centre, {:.0f} % above the surface, nine tenths of the rest within {} ahead", 100 * s.behind,
                       100 * s.above, diameters(run, s.reach));
  };
  const auto shearing = [](const TestRun& run, std::size_t frame) {
    return shearing_of(run.frames.soil(frame - 1), run.frames.soil(frame), run.record.settings.surface, run.frames.place(frame));
  };
  if (const TestRun* run = wished_at(fem, paper_w_drag))
    if (const auto frame = run->frames.last(StageKind::drag); frame && *frame > 0) {
      const Shearing s = shearing(*run, *frame);
      claim.findings.push_back({run->record.name, standing_if(s.behind >= a_tenth), words(*run, s)});
    }
  for (const TestRun& run : mpm)
    if (const auto frame = run.frames.nearest(StageKind::drag, &PipePlace::w, paper_w_drag * run.D); frame && *frame > 0) {
      const Shearing s = shearing(run, *frame);
      claim.findings.push_back({run.record.name, standing_if(s.above >= a_tenth),
                                fmt::format("at w = {}: {}", diameters(run, run.frames.place(*frame).w), words(run, s))});
    }
  return claim;
}

Claim no_penetration(const TestRuns& mpm)
{
  constexpr Real deepest = 0.002;  // of D
  Claim claim{"The two corrections enforce that no soil enters the pipe",
              "2.1, 4",
              {},
              fmt::format("Up to {:g} D counts as none. The second correction is not what does it: see the study of the contact schemes.",
                          deepest)};
  for (const TestRun& run : mpm)
    if (const Quantity* overlap = run.record.quantity("overlap_max_over_D"))
      claim.findings.push_back(
          {run.record.name, standing_if(overlap->value <= deepest), fmt::format("deepest particle {:.2g} D inside", overlap->value)});
  return claim;
}

const ContactSettings& contact_of(const RunRecord& run)
{
  return run.settings.contact.front().second;
}

/// A run with one correction and one with two that are else alike in the contact's detection.
Claim fewer_oscillations(const TestRuns& mpm)
{
  Claim claim{"Correcting twice lessens the oscillations", "2.1, 4", {}, ""};
  for (const TestRun& once : mpm)
    for (const TestRun& twice : mpm) {
      const ContactSettings &a = contact_of(once.record), &b = contact_of(twice.record);
      const bool pair = a.scheme == Scheme::once && b.scheme == Scheme::twice && a.detection == b.detection;
      const Quantity *noise_a = once.record.quantity("V_noise"), *noise_b = twice.record.quantity("V_noise");
      if (pair && noise_a != nullptr && noise_b != nullptr)
        claim.findings.push_back(
            {twice.record.name, standing_if(noise_b->value < 0.9 * noise_a->value),
             fmt::format("noise of V {:.2g} % with two, {:.2g} % with one correction", 100 * noise_b->value, 100 * noise_a->value)});
    }
  claim.why = claim.findings.empty() ? "No two runs here differ in it; berm study examples/contact_schemes compares the schemes."
                                     : "The noise of V in the push about its moving mean is compared; a tenth less counts.";
  return claim;
}

std::string word_of(Standing standing)
{
  switch (standing) {
  case Standing::good:
    return "reproduced";
  case Standing::fair:
    return "partly";
  case Standing::bad:
    return "not reproduced";
  case Standing::unknown:
    break;
  }
  return "not examined";
}

std::string cell_of(const std::vector<Finding>& findings)
{
  std::string html;
  for (const Finding& f : findings)
    html += fmt::format("<div><strong>{}</strong>: {} {}</div>", html_text(f.run), html_text(f.words),
                        findings.size() > 1 ? html_badge(f.standing, word_of(f.standing)) : "");
  return html.empty() ? "no run shows it" : html;
}

}  // namespace

std::string claims_section(const std::vector<RunRecord>& runs)
{
  TestRuns mpm, fem;
  std::string settings;
  for (const RunRecord& run : runs) {
    if (!is_of_paper(run) || run.history.rows() == 0) continue;
    (run.settings.method == Method::mpm ? mpm : fem).emplace_back(run);
    settings += fmt::format("<li><strong>{}</strong>: {}</li>\n", html_text(run.name), html_text(setting_of(run)));
  }
  if (mpm.empty() && fem.empty()) return "";

  const std::vector<Claim> claims = {force_of_the_push(mpm),
                                     heave_of_the_push(mpm),
                                     growing_resistance(mpm),
                                     sinking(mpm),
                                     end_of_sinking(mpm),
                                     berm_of_soil(mpm),
                                     force_of_finite_elements(fem),
                                     finite_elements_fall_short(mpm, fem, paper_H_fem[0].first),
                                     finite_elements_fall_short(mpm, fem, paper_H_fem[1].first),
                                     mechanisms_differ(mpm, fem),
                                     no_penetration(mpm),
                                     fewer_oscillations(mpm)};
  HtmlTable table("claims-table", "Claims of the paper");
  table.columns({{"claim"}, {"verdict"}, {"what berm finds"}, {"why"}});
  for (const Claim& claim : claims) {
    const Standing verdict = verdict_of(claim.findings);
    table.row({{fmt::format("{} <span class=\"quiet\">({})</span>", html_text(claim.statement), html_text(claim.where))},
               {html_badge(verdict, word_of(verdict))},
               {cell_of(claim.findings)},
               {html_text(claim.why)}});
  }
  const std::string intro = html_paragraph(
      fmt::format("M. Maglia, N. M. Pinyol and C. Hoffman, Material Point Method modelling of offshore unburied cable/pipe interacting "
                  "with soil. Each row is made "
                  "from the numbers of the runs on this page: within {:.0f} % of the paper's number is reproduced, within {:.0f} % partly.",
                  100 * near_enough, 100 * not_far));
  return html_section("claims", "Claims of the paper", intro + "<ul>\n" + settings + "</ul>\n" + table.html());
}

}  // namespace berm
