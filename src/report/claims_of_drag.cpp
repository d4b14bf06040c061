// SPDX-License-Identifier: BSD-3-Clause
#include "formulas/design_code.hpp"
#include "report/claim.hpp"
#include "report/paper.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm {
namespace {

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
              "Heave is the largest rise of the surface beside the pipe. It counts where it is at least half of what the displaced soil "
              "would make, spread "
              "evenly over 1.5 D to both sides of the axis."};
  for (const TestRun& run : mpm) {
    const auto frame = run.frames.last(StageKind::push);
    if (!frame) continue;
    const PipePlace& pipe = run.frames.place(*frame);
    const Heave heave = heave_of(run.frames.soil(0), run.frames.soil(*frame), run.record.settings.surface, pipe, run.D);
    const Real even = f114_penetrated_area(run.D, pipe.w) / (3 * run.D);
    claim.findings.push_back({run.record.name, standing_if(std::min(heave.behind, heave.ahead) >= even / 2),
                              fmt::format("{} and {} high at w = {}; spread evenly {}", diameters(run, heave.behind),
                                          diameters(run, heave.ahead), diameters(run, pipe.w), diameters(run, even))});
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
  Claim claim{fmt::format("The pipe sinks while it is dragged, to w = {:g} D at u = {:g} D", paper_w_drag, paper_u_drag), "3.4", {}, ""};
  Real least = infinity, most = -infinity;
  for (const TestRun& run : mpm) {
    const Real w = run.has_drag() ? run.w(paper_u_drag * run.D) : std::numeric_limits<Real>::quiet_NaN();
    if (std::isnan(w)) continue;
    claim.findings.push_back(
        {run.record.name, standing_of(w, paper_w_drag * run.D),
         fmt::format("w = {} at u = {:g} D, from {}", diameters(run, w), paper_u_drag, diameters(run, run.w_begin()))});
    const Real sinks_by = (w - run.w_begin()) / run.D;
    least = std::min(least, sinks_by), most = std::max(most, sinks_by);
  }
  claim.why = fmt::format(
      "The drag itself makes the pipe sink by {:.2g} to {:.2g} D, in the paper by {:.2g} D; where the push ends deeper, so does the drag.",
      least, most, paper_w_drag - paper_w_push);
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
      return heave_of(run.frames.soil(0), run.frames.soil(frame), run.record.settings.surface, run.frames.place(frame), run.D).berm /
             (run.D * run.D);
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

}  // namespace

std::vector<Claim> claims_of_the_drag(const TestRuns& mpm)
{
  return {force_of_the_push(mpm), heave_of_the_push(mpm), growing_resistance(mpm), sinking(mpm), end_of_sinking(mpm), berm_of_soil(mpm)};
}

std::vector<Claim> claims_of_contact(const TestRuns& mpm)
{
  return {no_penetration(mpm), fewer_oscillations(mpm)};
}

}  // namespace berm
