// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/report/claims/claims_test.cpp
#include "formulas/design_code.hpp"
#include "report/claims/claim.hpp"
#include "report/claims/paper.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::report {
namespace {

using MaybeFinding = std::optional<ClaimEvidence>;

constexpr Real still = 0.02;  // of D: a pipe that sinks by no more stays where it is

/// The least and the most of what was found.
struct Span {
  Real min = infinity, max = -infinity;
  void take(Real value) { min = std::min(min, value), max = std::max(max, value); }
};

bool comes_beyond(const TestRun& run, Real u)
{
  return run.has_drag() && run.end_of_drag() >= u;
}

Claim force_of_the_push(const TestRuns& mpm)
{
  Claim claim{
      fmt::format("A push to w = {:g} D takes V = {:g} kN, in agreement with the test", paper_w_push, paper_V_push / 1000), "3.4", {}, ""};
  Span parts;
  add_findings(claim, mpm, [&](const TestRun& run) -> MaybeFinding {
    const Real V = run.V_of_push(paper_w_push * run.D);
    if (std::isnan(V)) return {};
    parts.take(V / paper_V_push);
    const auto w = run.w_where_V_is(paper_V_push);
    return ClaimEvidence{run.record.name, standing_of(V, paper_V_push),
                         fmt::format("V = {} at {:g} D; {}", text::force_words(V, 2), paper_w_push,
                                     w ? fmt::format("{:g} kN/m at {}", paper_V_push / 1000, diameters(run, *w))
                                       : fmt::format("{:g} kN/m is not reached", paper_V_push / 1000))};
  });
  claim.why =
      fmt::format("Read per metre run of the model, the runs give {:.2g} to {:.2g} times the paper's force. It leaves weight, dilation, K0 "
                  "and mesh open, and the scale of its kN.",
                  parts.min, parts.max);
  return claim;
}

Claim heave_of_the_push(const TestRuns& mpm)
{
  Claim claim{"Soil heaves at both sides of the pipe as it is pushed in", "3.4", {}, ""};
  claim.why =
      "Heave is the largest rise of the surface beside the pipe (less than 0: it sinks). It counts where it is at least half of what the "
      "displaced soil would make, spread evenly over 1.5 D to both sides of the axis.";
  add_findings(claim, mpm, [](const TestRun& run) -> MaybeFinding {
    const auto frame = run.frames.last(problem::StageKind::push);
    if (!frame || !run.has_drag()) return {};
    const pipe::PipePlace& pipe = run.frames.place(*frame);
    const pipe::Heave heave = heave_of(run.frames.soil(0), run.frames.soil(*frame), run.record.settings.surface, pipe, run.D);
    const Real even = formulas::f114_penetrated_area(run.D, pipe.w) / (3 * run.D);
    return ClaimEvidence{run.record.name, standing_if(std::min(heave.behind, heave.ahead) >= even / 2),
                         fmt::format("{} and {} at w = {}; spread evenly {}", diameters(run, heave.behind), diameters(run, heave.ahead),
                                     diameters(run, pipe.w), diameters(run, even))};
  });
  return claim;
}

Claim growing_resistance(const TestRuns& mpm)
{
  Claim claim{"H grows with the horizontal displacement while V is held", "3.1, figure 2", {}, ""};
  claim.why = "H is compared at a third, two thirds and the end of the drag.";
  add_findings(claim, mpm, [](const TestRun& run) -> MaybeFinding {
    if (!comes_beyond(run, 0.1 * run.D)) return {};
    const Real u = run.end_of_drag(), first = run.H(u / 3), second = run.H(2 * u / 3), last = run.H(u);
    if (std::isnan(first + second + last)) return {};
    return ClaimEvidence{run.record.name, standing_if(first < second && second < last),
                         fmt::format("{}, {}, {} at u = {}, {}, {}", text::force_words(first, 2), text::force_words(second, 2),
                                     text::force_words(last, 2), diameters(run, u / 3), diameters(run, 2 * u / 3), diameters(run, u))};
  });
  return claim;
}

Claim sinking(const TestRuns& mpm)
{
  Claim claim{fmt::format("The pipe sinks while it is dragged, to w = {:g} D at u = {:g} D", paper_w_drag, paper_u_drag), "3.4", {}, ""};
  Span sinks_by;
  add_findings(claim, mpm, [&](const TestRun& run) -> MaybeFinding {
    const Real w = run.has_drag() ? run.w(paper_u_drag * run.D) : std::numeric_limits<Real>::quiet_NaN();
    if (std::isnan(w)) return {};
    sinks_by.take((w - run.w_begin()) / run.D);
    return ClaimEvidence{run.record.name, standing_of(w, paper_w_drag * run.D),
                         fmt::format("w = {} at u = {:g} D, from {}", diameters(run, w), paper_u_drag, diameters(run, run.w_begin()))};
  });
  claim.why =
      fmt::format("The drag itself makes the pipe sink by {:.2g} to {:.2g} D, in the paper by {:.2g} D; where the push ends deeper, so "
                  "does the drag.",
                  sinks_by.min, sinks_by.max, paper_w_drag - paper_w_push);
  return claim;
}

Claim end_of_sinking(const TestRuns& mpm)
{
  Claim claim{fmt::format("At u = {:g} D the embedment has reached its maximum", paper_u_drag), "3.4", {}, ""};
  claim.why = fmt::format("A growth of w by more than {:g} D after u = {:g} D counts as sinking on.", still, paper_u_drag);
  add_findings(claim, mpm, [](const TestRun& run) -> MaybeFinding {
    if (!comes_beyond(run, (paper_u_drag + 0.1) * run.D)) return {};
    const Real growth = run.w(run.end_of_drag()) - run.w(paper_u_drag * run.D);
    return ClaimEvidence{run.record.name, standing_if(growth <= still * run.D),
                         fmt::format("w grows by {} from there to u = {}", diameters(run, growth), diameters(run, run.end_of_drag()))};
  });
  return claim;
}

Claim berm_of_soil(const TestRuns& mpm)
{
  Claim claim{fmt::format("After u = {:g} D the berm that the pipe heaps up makes H grow", paper_u_drag), "3.4, 4", {}, ""};
  bool sinks = false;
  add_findings(claim, mpm, [&](const TestRun& run) -> MaybeFinding {
    const auto from = run.frames.nearest(problem::StageKind::drag, &pipe::PipePlace::u, paper_u_drag * run.D),
               to = run.frames.last(problem::StageKind::drag);
    if (!from || !to || *from == *to || !comes_beyond(run, (paper_u_drag + 0.1) * run.D)) return {};
    const auto berm = [&](std::size_t frame) {
      return heave_of(run.frames.soil(0), run.frames.soil(frame), run.record.settings.surface, run.frames.place(frame), run.D).berm /
             (run.D * run.D);
    };
    const Real first = berm(*from), last = berm(*to), H_first = run.H(paper_u_drag * run.D), H_last = run.H(run.end_of_drag());
    const bool grows = last > first && H_last > H_first;
    const bool sinks_on = run.w(run.end_of_drag()) - run.w(paper_u_drag * run.D) > still * run.D;
    sinks = sinks || sinks_on;
    const text::Standing standing = !grows ? text::Standing::bad : sinks_on ? text::Standing::fair : text::Standing::good;
    return ClaimEvidence{
        run.record.name, standing,
        fmt::format("berm {:.3g} to {:.3g} D², H {} to {}", first, last, text::force_words(H_first, 2), text::force_words(H_last, 2))};
  });
  claim.why = sinks ? "Berm and H grow together, but the pipe sinks on as well, so that these runs cannot tell the two apart."
                    : "The pipe sinks no more: what grows with H is the berm.";
  return claim;
}

const contact::ContactSettings& contact_of(const TestRun& run)
{
  return *pipe::contact_of_pipe(run.record.settings);
}

Claim no_penetration(const TestRuns& mpm)
{
  constexpr Real deepest = 0.002;  // of D
  Claim claim{"With the two corrections no soil enters the pipe", "2.1, 4", {}, ""};
  claim.why = fmt::format(
      "Up to {:g} D counts as none. That it takes two corrections is not told by this: for that a run with scheme \"once\" is needed.",
      deepest);
  claim.missing = "No run here that came to its drag corrects twice.";
  add_findings(claim, mpm, [](const TestRun& run) -> MaybeFinding {
    const run_folder::Quantity* overlap = run.record.quantity("overlap_max_over_D");
    if (overlap == nullptr || std::isnan(overlap->value) || contact_of(run).scheme != contact::Scheme::twice || !run.has_drag()) return {};
    return ClaimEvidence{run.record.name, standing_if(overlap->value <= deepest),
                         fmt::format("deepest particle {:.2g} D inside", overlap->value)};
  });
  return claim;
}

/// A run with one correction and one with two that detect contact alike.
Claim fewer_oscillations(const TestRuns& mpm)
{
  Claim claim{"Correcting twice lessens the oscillations", "2.1, 4", {}, ""};
  claim.why = "The noise of V in the push about its moving mean is compared; a tenth less counts.";
  claim.missing = "No two runs here differ in it; berm study examples/contact_schemes compares the schemes.";
  for (const TestRun& once : mpm)
    add_findings(claim, mpm, [&](const TestRun& twice) -> MaybeFinding {
      const contact::ContactSettings &a = contact_of(once), &b = contact_of(twice);
      const run_folder::Quantity *noise_a = once.record.quantity("V_noise"), *noise_b = twice.record.quantity("V_noise");
      const bool pair = a.scheme == contact::Scheme::once && b.scheme == contact::Scheme::twice && a.detection == b.detection;
      if (!pair || noise_a == nullptr || noise_b == nullptr) return {};
      return ClaimEvidence{
          twice.record.name, standing_if(noise_b->value < 0.9 * noise_a->value),
          fmt::format("noise of V {:.2g} % with two, {:.2g} % with one correction", 100 * noise_b->value, 100 * noise_a->value)};
    });
  return claim;
}

}  // namespace

std::vector<Claim> claims_of_the_drag(const TestRuns& mpm)
{
  return {force_of_the_push(mpm), heave_of_the_push(mpm), growing_resistance(mpm), sinking(mpm), end_of_sinking(mpm), berm_of_soil(mpm)};
}

std::vector<Claim> claims_of_contact(const TestRuns& mpm)
{
  return {no_penetration(mpm), fewer_oscillations(mpm)};
}

}  // namespace berm::report
