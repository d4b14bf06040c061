// SPDX-License-Identifier: BSD-3-Clause
#include "report/claim.hpp"
#include "report/paper.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm {
namespace {

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
  constexpr Real a_tenth = 0.1, half = 0.5;
  std::vector<Real> reaches;  // of D
  Claim claim{fmt::format("At {:g} D finite elements show two wedges, the material point method drags all heaped soil along", paper_w_drag),
              "3.4, figures 5 and 6",
              {},
              ""};
  const auto mechanism = [](const TestRun& run, std::size_t frame) {
    return mechanism_of(run.frames.soil(frame - 1), run.frames.soil(frame), run.record.settings.surface, run.frames.place(frame - 1),
                        run.frames.place(frame), run.D);
  };
  const auto words = [](const TestRun& run, const Mechanism& m) {
    return fmt::format(
        "{:.0f} % of the shearing behind the centre, nine tenths of the rest within {} ahead; {:.0f} % of the heaped soil moves along",
        100 * m.behind, diameters(run, m.reach), std::isnan(m.dragged) ? 0 : 100 * m.dragged);
  };
  if (const TestRun* run = wished_at(fem, paper_w_drag))
    if (const auto frame = run->frames.last(StageKind::drag); frame && *frame > 0) {
      const Mechanism m = mechanism(*run, *frame);
      claim.findings.push_back({run->record.name, standing_if(m.behind >= a_tenth), words(*run, m)});
      reaches.push_back(m.reach / run->D);
    }
  for (const TestRun& run : mpm)
    if (const auto frame = run.frames.nearest(StageKind::drag, &PipePlace::w, paper_w_drag * run.D); frame && *frame > 0) {
      const Mechanism m = mechanism(run, *frame);
      claim.findings.push_back({run.record.name, standing_if(m.dragged >= half),
                                fmt::format("at w = {}: {}", diameters(run, run.frames.place(*frame).w), words(run, m))});
      reaches.push_back(m.reach / run.D);
    }
  claim.why = "Two wedges: a tenth of the shearing or more behind the pipe's centre. Dragging: half of the soil that is heaped up ahead, "
              "or more, moves by a tenth "
              "of the pipe's way";
  claim.why += reaches.size() < 2
                   ? "."
                   : fmt::format("; what sets the runs apart is how far ahead the soil fails, {:.2g} to {:.2g} D.",
                                 *std::min_element(reaches.begin(), reaches.end()), *std::max_element(reaches.begin(), reaches.end()));
  return claim;
}

}  // namespace

std::vector<Claim> claims_of_finite_elements(const TestRuns& mpm, const TestRuns& fem)
{
  return {force_of_finite_elements(fem), finite_elements_fall_short(mpm, fem, paper_H_fem[0].first),
          finite_elements_fall_short(mpm, fem, paper_H_fem[1].first), mechanisms_differ(mpm, fem)};
}

}  // namespace berm
