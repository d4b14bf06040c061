// SPDX-License-Identifier: BSD-3-Clause
#include "structures/lateral/shaft.hpp"

#include "formulas/axial.hpp"
#include "formulas/footing.hpp"
#include "structures/base/general_measures.hpp"
#include "structures/penetration/penetration_run.hpp"
#include "text/quantity_words.hpp"

#include <fmt/format.h>

namespace berm::lateral {
namespace {

using penetration::PenetrationRun;

constexpr base::Limit skirt_cells = base::too_large(
    {32, 10, base::Effect::contact_width, "soil beside the wall moves with it up to a cell beyond it (examples/cone_in_clay)", true});
constexpr base::Limit skirt_wall_cells =
    base::too_large({4, 2, base::Effect::contact_width,
                     "the soil within a cell of a wall moves with it: a tip of thickness t carries as one of t + 2 h at most", true});

/// Where the means over the end of the push are: halfway of that travel, m.
Real middle_of_end(const PenetrationRun& run)
{
  return run.z_end() - run.last().travel / 2;
}

/// The shear strength of the interface, Pa, on average over this depth; NaN where it has friction.
Real strength_of_interface(const PenetrationRun& run, Real depth)
{
  constexpr int points = 50;
  Real mean = 0;
  for (int k = 0; k < points; ++k) {
    const penetration::SoilAt soil = run.soil.at((k + 0.5) / points * depth);
    mean += soil.interface_ratio * soil.strength / points;
  }
  return mean;
}

std::vector<penetration::Comparison> published_of_skirt(const PenetrationRun& run)
{
  if (run.measure() != penetration::Measure::strength || !(run.body.bore > 0)) return {};
  const Real depth = middle_of_end(run), ratio = run.soil.at(depth).interface_ratio;
  std::vector<penetration::Comparison> list;
  if (ratio >= 0)
    list.push_back({"N<sub>c</sub>", run.last().factor, formulas::n_c_strip(0, ratio > 0 ? formulas::Base::rough : formulas::Base::smooth),
                    "a strip as thick as the wall, at the surface: at depth it is larger, up to twice that", true});
  if (run.knows_shaft()) {
    formulas::Formula friction = formulas::skirt_friction(run.body.width, 2 * run.body.bore, depth, strength_of_interface(run, depth));
    friction.value /= 1e3;
    list.push_back({"friction of both faces, kN", run.last().friction * run.shaft_area(depth) / 1e3, friction,
                    fmt::format("z = {}", text::length_words(depth))});
  }
  return list;
}

/// How tip and faces share the load.
std::string share_words(const record::RunRecord& run, const base::DisplayUnits&)
{
  const PenetrationRun pushed(run, skirt());
  if (pushed.z().empty() || !(pushed.body.bore > 0) || !std::isfinite(pushed.last().friction)) return "";
  const auto force = [](Real newtons) { return text::force_words(newtons, 3); };
  return fmt::format("Over that travel the tip carries {} and friction {}, {} on average over both faces{}.",
                     force(pushed.last().q * pushed.area()), force(pushed.last().friction * pushed.shaft_area(middle_of_end(pushed))),
                     text::stress_words(pushed.last().friction),
                     std::isinf(pushed.body.lid) ? "" : fmt::format("; the lid is {} above the tip", text::length_words(pushed.body.lid)));
}

base::TrustMeasures wall_measures(const settings::Case&)
{
  using Run = const record::RunRecord&;
  const auto across_wall = [](Run run) {
    const std::optional<base::BodyProfile> body = base::body_profile(run.settings.rigid[main_rigid(run.settings)].second.shape);
    return body && body->bore > 0 ? body->wall() / base::near_cells(run).first : nan;
  };
  const base::TrustMeasure wall{"cells in the thickness of the wall",
                                &skirt_wall_cells,
                                base::always,
                                across_wall,
                                base::as_number,
                                "the wall is {} cells thick: make mesh.near_size smaller",
                                base::bare_limit};
  return {wall};
}

}  // namespace

/// A body that is open below: the skirt of a footing, a caisson, a pipe pile. q_b = V over the area of its tip, the ring, without the friction of both faces; factors as of a pile.
const penetration::Penetrometer& skirt()
{
  static const penetration::Penetrometer skirt{.word = "skirt",
                                               .level = "tip of the skirt",
                                               .resistance = {"q_b", "q<sub>b</sub>"},
                                               .in_clay = {"N_c", "N<sub>c</sub>"},
                                               .in_sand = {"N_q", "N<sub>q</sub>"},
                                               .sand_measure = penetration::SandMeasure::overburden,
                                               .flows_around = false,
                                               .averaging = 0.02,
                                               .last_travel = 0.2,
                                               .depths = {0.05, 0.1, 0.15, 0.2, 0.25, 0.3, 0.4, 0.5, 0.75, 1, 1.5, 2, 3, 4, 5, 6, 8, 10},
                                               .keeps_push = false,
                                               .cells = &skirt_cells,
                                               .published = published_of_skirt,
                                               .remark = "",
                                               .also = {.words = share_words, .measures = wall_measures}};
  return skirt;
}

}  // namespace berm::lateral
