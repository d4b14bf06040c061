// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/report/claims/claims_test.cpp
#include "report/claims/claim.hpp"
#include "report/claims/paper.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::report {
namespace {

using MaybeFinding = std::optional<ClaimEvidence>;

bool wished_at(const TestRun& run, Real w)
{
  return run.has_drag() && std::abs(run.w_begin() / run.D - w) < 0.01;
}

/// The first run that is wished in place at an embedment, or null.
const TestRun* first_wished_at(const TestRuns& fem, Real w)
{
  const auto found = std::find_if(fem.begin(), fem.end(), [&](const TestRun& run) { return wished_at(run, w); });
  return found == fem.end() ? nullptr : &*found;
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
  Real max = 0;  // over the paper's, per metre of the model
  for (const auto& [w, H] : paper_H_fem)
    add_findings(claim, fem, [&, w = w, H = H](const TestRun& run) -> MaybeFinding {
      if (!wished_at(run, w) || std::isnan(plateau(run))) return {};
      const Real prototype = plateau(run) * run.record.scale.gravity_level;
      forces.push_back(plateau(run));
      max = std::max(max, plateau(run) / H);
      return ClaimEvidence{run.record.name, standing_of(prototype, H),
                           fmt::format("{} at u = {}, {} in the prototype (paper {:g} kN)", text::force_words(plateau(run), 2),
                                       diameters(run, run.end_of_drag()), text::force_words(prototype, 2), H / 1000)};
    });
  claim.why = fmt::format("Judged per metre run of the prototype; read per metre run of the model, as V is above and in the curves, berm "
                          "gives at most {:.2g} of "
                          "the paper's forces.",
                          max);
  if (forces.size() == 2)
    claim.why += fmt::format(" The ratio of the two depends on no scale: {:.2g} here, {:.2g} in the paper.", forces[1] / forces[0],
                             paper_H_fem[1].second / paper_H_fem[0].second);
  return claim;
}

Claim finite_elements_fall_short(const TestRuns& mpm, const TestRuns& fem, Real w)
{
  constexpr Real alike = 1.5;  // ratio of vertical forces that are still called the same load
  const bool first = w == paper_H_fem[0].first;
  Claim claim{first ? fmt::format("Finite elements at the first embedment, {:g} D, fall short of H in the drag", w)
                    : fmt::format("Finite elements at the last embedment, {:g} D, still fall short of H: they lack the berm", w),
              "3.4, 4",
              {},
              ""};
  const TestRun* wished = first_wished_at(fem, w);
  if (wished == nullptr) return claim;
  const auto per_weight = [](const TestRun& run, Real force) { return force / run.record.scale.unit_weight; };
  const Real H_fem = per_weight(*wished, plateau(*wished)), V_fem = per_weight(*wished, wished->V(wished->end_of_drag()));
  bool same_load = true;
  add_findings(claim, mpm, [&](const TestRun& run) -> MaybeFinding {
    if (!run.has_drag()) return {};
    const auto u = first ? std::optional<Real>(paper_u_drag * run.D) : run.u_where_w_is(w * run.D);
    const Real H = u ? run.H(*u) : std::numeric_limits<Real>::quiet_NaN();
    if (std::isnan(H)) return {};
    const Real ratio = per_weight(run, H) / H_fem, ratio_V = per_weight(run, run.V(*u)) / V_fem;
    const bool same = ratio_V < alike && ratio_V > 1 / alike;
    same_load = same_load && same;
    const text::Standing standing = ratio <= 1 + near_enough ? text::Standing::bad : same ? text::Standing::good : text::Standing::fair;
    return ClaimEvidence{run.record.name, standing,
                         fmt::format("H = {} at u = {} (w = {}): {:.2g} times that of {}, under {:.2g} times its V",
                                     text::force_words(H, 2), diameters(run, *u), diameters(run, run.w(*u)), ratio, wished->record.name,
                                     ratio_V)};
  });
  claim.why = "H and V over γ′ D² are compared.";
  if (!same_load)
    claim.why += " The loads differ: where the finite elements keep w fixed V falls as the pipe is dragged. So the larger H is not the "
                 "berm's alone; "
                 "berm study examples/wip_study compares under the same V.";
  return claim;
}

Claim mechanisms_differ(const TestRuns& mpm, const TestRuns& fem)
{
  constexpr Real a_tenth = 0.1, half = 0.5;
  Claim claim{fmt::format("At {:g} D finite elements show two wedges, the material point method drags all heaped soil along", paper_w_drag),
              "3.4, figures 5 and 6",
              {},
              ""};
  std::vector<Real> reaches;  // of D
  const auto judge = [&](const TestRun& run, std::size_t frame, bool two_wedges) -> MaybeFinding {
    if (frame == 0) return {};
    const pipe::Mechanism m = mechanism_of(run.frames.soil(frame - 1), run.frames.soil(frame), run.record.settings.surface,
                                           run.frames.place(frame - 1), run.frames.place(frame), run.D);
    reaches.push_back(m.reach / run.D);
    const bool behind = m.behind >= a_tenth, drags = m.dragged >= half;  // NaN, no heaped soil: drags nothing
    const text::Standing standing = behind == two_wedges && drags != two_wedges   ? text::Standing::good
                                    : behind == two_wedges || drags != two_wedges ? text::Standing::fair
                                                                                  : text::Standing::bad;
    const std::string heap =
        std::isnan(m.dragged) ? "no soil is heaped up" : fmt::format("{:.0f} % of the heaped soil moves along", 100 * m.dragged);
    return ClaimEvidence{
        run.record.name, standing,
        fmt::format("at w = {} {:.0f} % of the shearing lies behind the centre, nine tenths of the rest within {} ahead; {}",
                    diameters(run, run.frames.place(frame).w), 100 * m.behind, diameters(run, m.reach), heap)};
  };
  add_findings(claim, fem, [&](const TestRun& run) -> MaybeFinding {
    const auto frame = wished_at(run, paper_w_drag) ? run.frames.last(problem::StageKind::drag) : std::nullopt;
    return frame ? judge(run, *frame, true) : MaybeFinding{};
  });
  add_findings(claim, mpm, [&](const TestRun& run) -> MaybeFinding {
    if (!run.has_drag() || !run.u_where_w_is(paper_w_drag * run.D)) return {};
    const auto frame = run.frames.nearest(problem::StageKind::drag, &pipe::PipePlace::w, paper_w_drag * run.D);
    return frame ? judge(run, *frame, false) : MaybeFinding{};
  });
  claim.why = "Two wedges: a tenth of the shearing or more behind the pipe's centre, and the heaped soil stays. Dragging: less than a "
              "tenth behind, and "
              "at least half of the heaped soil ahead moves by a tenth of the pipe's way or more.";
  if (reaches.size() > 1)
    claim.why += fmt::format(" The soil fails {:.2g} to {:.2g} D ahead.", *std::min_element(reaches.begin(), reaches.end()),
                             *std::max_element(reaches.begin(), reaches.end()));
  return claim;
}

}  // namespace

std::vector<Claim> claims_of_finite_elements(const TestRuns& mpm, const TestRuns& fem)
{
  return {force_of_finite_elements(fem), finite_elements_fall_short(mpm, fem, paper_H_fem[0].first),
          finite_elements_fall_short(mpm, fem, paper_H_fem[1].first), mechanisms_differ(mpm, fem)};
}

}  // namespace berm::report
