// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/report/quality/quality_section_test.cpp
#include "structures/driven/report.hpp"

#include "material/material.hpp"
#include "problem/cells_at_body.hpp"
#include "structures/base/cells_below.hpp"
#include "structures/base/driven_body.hpp"
#include "structures/base/general_measures.hpp"
#include "structures/base/kind.hpp"
#include "structures/driven/driven_run.hpp"
#include "text/quantity_words.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::driven {
namespace {

using namespace base;
using Run = const record::RunRecord&;

namespace limits {

inline constexpr Limit kinetic{
    0.05, 0.10, Effect::drive_speed,
    "the usual rule for explicit programs: a few per cent of the energy that went into the soil, or inertia is part of the result"};
inline constexpr Limit held{0.05, 0.10, Effect::balance, "the drag is to hold V within 5 % (examples/probe_test)"};
inline constexpr Limit shaking =
    too_small({0.07, 0.15, Effect::shaking, "vibrating sand loses strength, and V is too low (docs/decisions/0017)"});
inline constexpr Limit noise_of_V{0.02, 0.05, Effect::noise, "noise grows with the size of the cells (examples/mesh_study)"};
inline constexpr Limit noise_of_H{
    0.09, 0.18, Effect::noise,
    "sand without cohesion slides intermittently (stick-slip), whatever the contact scheme (examples/contact_schemes)"};
inline constexpr Limit gap = too_large(
    {0.02, 0.05, Effect::contact,
     "the gap makes the body act larger; contact at all nodes of cut cells makes the gap wider and V larger (examples/contact_schemes)"});
inline constexpr Limit overlap{0.002, 0.01, Effect::contact, "no particle should be deeper than 0.002 D in the body (examples/probe_test)"};
inline constexpr Limit second_impulse{0.01, 0.05, Effect::contact,
                                      "the second contact correction is not a force; it stays small with every contact scheme "
                                      "(examples/contact_schemes)"};
inline constexpr Limit push_in_cells{
    2, 0.5, Effect::cells, "a fraction of a cell is not resolved: the result of a push that ends there is set by the cells", true};
inline constexpr Limit cells =
    too_large({20, 10, Effect::cells, "V of a push falls with the size of the cells (examples/mesh_study)", true});
inline constexpr Limit dilating_cells{80, 40, Effect::cells,
                                      "sand with psi = phi: K_p of a wall is +27 % with 17 cells over its height and +10 % with 33, K_a "
                                      "-11 and -8 % (examples/embedded_wall)",
                                      true};
inline constexpr Limit particles{
    9, 4, Effect::cells, "use nine or more near the body: with four stresses scatter more (docs/theory/method.md, Checks of a run)", true};
inline constexpr Limit elements =
    too_large({40, 20, Effect::cells,
               "D/40 is what berm's own studies use (examples/wip_study); half the size should change little where psi = phi", true});

inline constexpr Limit remeshed_elements = too_large({9, 4.5, Effect::cells,
                                                      "for a pipe pushed 0.5 D into clay, V is 1 % higher with elements of D/5 and 0.3 % "
                                                      "higher with D/10 than by an independent program with D/40 (examples/remeshed_pipe)",
                                                      true});
inline constexpr Limit change_by_remeshing{
    0.03, 0.1, Effect::balance,
    "the contact force recovers in the next increment; smaller elements or a larger fem.remeshing_travel reduce the change"};
inline constexpr Limit energy_by_remeshing{
    0.01, 0.1, Effect::balance,
    "pipes, balls and footings pushed into clay lose 0.1 to 0.4 % on elements of D/10 (examples/remeshed_pipe, examples/remeshed_bodies)"};

}  // namespace limits

bool has_stage(Run run, settings::StageKind kind)
{
  return std::any_of(run.settings.stage.begin(), run.settings.stage.end(),
                     [&](const settings::StageSettings& stage) { return stage.kind == kind; });
}
bool pushes(Run run)
{
  return has_stage(run, settings::StageKind::push);
}
bool drags(Run run)
{
  return has_stage(run, settings::StageKind::drag);
}
/// Whether a drag of the run holds a vertical force.
bool holds(Run run)
{
  return std::any_of(run.settings.stage.begin(), run.settings.stage.end(), [](const settings::StageSettings& stage) {
    return stage.kind == settings::StageKind::drag && stage.vertical == settings::Vertical::hold && !stage.vertical_velocity;
  });
}

std::string cells_limit(Real value)
{
  return fmt::format("{:g} h", value);
}
std::string over_limit(Real value)
{
  return fmt::format("D/{:g}", value);
}
std::string diameter_limit(Real value)
{
  return fmt::format("{:g} D", value);
}

/// The largest kinetic energy over the largest work until then, in the part of each push or drag that gives the answer: beyond its first third. NaN where there are
/// no such rows. Work is what went into the soil or into it from outside: internal energy begins at nothing, and a body that moves away takes it out.
Real kinetic_over_work(const record::RunRecord& run, settings::StageKind kind)
{
  const run_folder::History& h = run.history;
  if (h.rows() == 0 || !h.has_label("kinetic") || !h.has_label("internal")) return nan;
  const std::vector<Real>&kinetic = h.by_label("kinetic"), &internal = h.by_label("internal");
  Real largest = nan;
  for (const Stage& stage : stages_of(run.settings)) {
    if (stage.kind != kind) continue;
    const std::string& name = stage.asked.name;
    const auto rows = std::count(h.stage.begin(), h.stage.end(), name);
    std::ptrdiff_t before = 0;
    Real work = 0;
    for (Index k = 0; k < h.rows(); ++k) {
      work = std::max(work, std::abs(internal[k]));
      if (h.has_label("external")) work = std::max(work, std::abs(h.by_label("external")[k]));
      if (h.stage[k] != name || 3 * before++ < rows) continue;
      const Real ratio = kinetic[k] / work;
      if (std::isfinite(ratio)) largest = std::isnan(largest) ? ratio : std::max(largest, ratio);
    }
  }
  return largest;
}

/// The largest of a measure over the drags of a run; NaN where none has it.
Real worst_of_drags(Run run, std::optional<Real> DragResults::*measure)
{
  Real worst = nan;
  for (const DragResults& drag : DrivenRun(run).results().drags)
    if (const std::optional<Real>& value = drag.*measure) worst = std::isnan(worst) ? *value : std::max(worst, *value);
  return worst;
}

/// How much larger the body acts than it is, at most, with soil held off by the mean gap: 2 gap / D.
Real acts_larger(Run run)
{
  return 2 * quantity_value(run, "gap_mean_over_D");
}

TrustMeasure kinetic(const char* stage, bool (*applies)(Run), settings::StageKind kind)
{
  return {fmt::format("kinetic energy over the work, {}", stage),
          &limits::kinetic,
          applies,
          [kind](Run run) { return kinetic_over_work(run, kind); },
          in_percent,
          fmt::format("kinetic energy is {{}} of the work in the {}: drive slower", stage),
          text::percent_words};
}

TrustMeasure noise(const char* force, const char* stage, const Limit& limit, bool (*applies)(Run), std::function<Real(Run)> value_of)
{
  return {fmt::format("noise of {} in the {}", force, stage),
          &limit,
          applies,
          std::move(value_of),
          in_percent,
          fmt::format("{} scatters by {{}} about its mean: use means, not single values", force),
          text::percent_words};
}

TrustMeasure held(const std::string& body)
{
  return {"error of the V that the drag holds (root mean square)",
          &limits::held,
          holds,
          [](Run run) { return worst_of_drags(run, &DragResults::V_rms_error); },
          in_percent,
          fmt::format("V is held to within {{}} only: give the drag a longer ramp, or the {} less mass", body),
          text::percent_words};
}

TrustMeasure shaking(const std::string& body)
{
  return {fmt::format("spurious stress oscillation at the {}, divided by p + c cot φ", body),
          &limits::shaking,
          has_soil,
          [](Run run) { return run.check("shaking_at_body"); },
          as_number,
          fmt::format("the soil at the {} vibrates with {{}} of the pressure p + c cot φ that gives it its strength: it has lost strength, "
                      "and resistance is too small",
                      body),
          bare_limit};
}

TrustMeasure contact_gap(const std::string& body)
{
  const auto words = [body](Run run, Real larger) {
    return fmt::format("{:.2g} h: the effective diameter of the {} is up to {} larger",
                       quantity_value(run, "gap_mean") / near_cells(run).first, body, text::percent_words(larger));
  };
  return {"contact gap on both sides",
          &limits::gap,
          always,
          acts_larger,
          words,
          [words](Run run, Real larger) { return "gap is " + words(run, larger) + " (2 gap/D)"; },
          text::percent_words};
}

TrustMeasure overlap(const std::string& body)
{
  return {fmt::format("deepest soil inside the {}, in D", body),
          &limits::overlap,
          always,
          [](Run run) { return quantity_value(run, "overlap_max_over_D"); },
          as_number,
          [body](Run run, Real value) {
            return fmt::format("soil is {} inside the {}, {} D", text::length_words(value * body_scale(run.settings).width), body,
                               text::number_words(value));
          },
          diameter_limit};
}

TrustMeasure second_impulse()
{
  return {"second contact correction, divided by V",
          &limits::second_impulse,
          pushes,
          [](Run run) { return quantity_value(run, "second_impulse_over_V"); },
          in_percent,
          "the second contact correction is {} of V: the two contact corrections oppose each other",
          text::percent_words};
}

/// Whether the cells at the body grew on its way.
bool grew(Run run)
{
  const base::NearCells cells = near_cells(run);
  return cells.largest > problem::coarser_cells * cells.first;
}

Real largest_met(Run run)
{
  const base::NearCells cells = near_cells(run);
  return grew(run) ? cells.largest : cells.first;
}

TrustMeasure size_of(const std::string& what, const Limit& limit)
{
  return {what,
          &limit,
          [](Run run) { return !covers_the_mesh(run.settings); },
          [](Run run) { return body_scale(run.settings).width / largest_met(run); },
          [](Run run, Real value) {
            const Real first = near_cells(run).first, over = body_scale(run.settings).width / first;
            if (grew(run)) return fmt::format("D/{:.3g} at the start, D/{:.3g} where they are largest", over, value);
            return fmt::format("D/{:.3g} ({})", value, text::length_words(first));
          },
          [what](Run run, Real value) {
            return fmt::format("{} are D/{:.3g}{}: resistance on a coarse mesh is too large", what, value,
                               grew(run) ? fmt::format(" over part of its travel, D/{:.3g} at the start",
                                                       body_scale(run.settings).width / near_cells(run).first)
                                         : "");
          },
          over_limit};
}

/// How deep a push went, in cells: of a pipe that begins above the soil.
TrustMeasure depth_of_push(const std::string& body)
{
  return {"embedment at the end of the push, in cells h at the " + body,
          &limits::push_in_cells,
          [](Run run) { return kind_of(run.settings) == "pipe" && has_soil(run) && quantity_value(run, "w_end_of_push") > 0; },
          [](Run run) { return quantity_value(run, "w_end_of_push") / near_cells(run).first; },
          as_number,
          fmt::format("the push ends {{}} cells deep: take cells of a fraction of the embedment at the {}, or take it as not known", body),
          cells_limit};
}

bool dilates_strongly(Run run)
{
  constexpr Real much = 10 * pi / 180;
  return std::any_of(run.settings.material.begin(), run.settings.material.end(), [](const auto& entry) {
    const std::optional<material::Strength> soil = strength_at_rest(entry.second);
    return soil && soil->dilation_angle > much;
  });
}

/// What dilating soil is worked over, m: the width of the body, or the depth in the soil of one that is no disk and is dragged alone, as a wall is.
Real worked_length(Run run)
{
  const Real width = body_scale(run.settings).width;
  const std::optional<base::BodyProfile> body = base::body_profile(run.settings.rigid[main_rigid(run.settings)].second.shape);
  const bool has_depth = run.history.rows() > 0 && run.history.has_label("w");
  if (!body || body->disk || is_pushed_down(run.settings) || !drags(run) || !has_depth) return width;
  const Real depth = std::ranges::max(run.history.by_label("w"));
  return depth > 0 ? std::min(width, depth) : width;
}

TrustMeasure cells_of_dilating_soil(const std::string& body)
{
  const auto words = [](Run run, Real value) {
    return worked_length(run) < body_scale(run.settings).width ? fmt::format("1/{:.3g} of its depth in the soil", value)
                                                               : fmt::format("D/{:.3g}", value);
  };
  return {"cells at the " + body + " in soil that dilates by more than 10 deg",
          &limits::dilating_cells,
          dilates_strongly,
          [](Run run) { return worked_length(run) / largest_met(run); },
          words,
          [body, words](Run run, Real value) {
            return fmt::format("with cells of {} at the {} soil that dilates so much is too strong: passive resistance is too large, and "
                               "active pressure too small. Take finer cells, or method = \"fem\" for a limit load",
                               words(run, value), body);
          },
          over_limit};
}

TrustMeasure particles_of_cells(const std::string& body)
{
  return {fmt::format("particles per cell at the {}", body),
          &limits::particles,
          always,
          [](Run run) { return near_particles(run.settings); },
          [](Run, Real value) { return text::count_words(value); },
          [body](Run, Real value) { return fmt::format("{:.0f} particles per cell at the {} are few: stresses scatter", value, body); },
          bare_limit};
}

TrustMeasures mpm_measures(const std::string& body, const Limit* of_cells)
{
  return joined(
      {{energy_balance(settings::Method::mpm)},
       energy_that_the_method_takes(),
       {kinetic("push", pushes, settings::StageKind::push), kinetic("drag", drags, settings::StageKind::drag),
        balance_after_geostatic("when the push began"), held(body),
        noise("V", "push", limits::noise_of_V, pushes, [](Run run) { return quantity_value(run, "V_noise"); }),
        noise("H", "drag", limits::noise_of_H, drags, [](Run run) { return worst_of_drags(run, &DragResults::H_noise); }), shaking(body)},
       soil_volumes(),
       {contact_gap(body), overlap(body), second_impulse(), momentum_balance(),
        size_of("cells at the " + body, of_cells == nullptr ? limits::cells : *of_cells), cells_below(body), depth_of_push(body),
        cells_of_dilating_soil(body), shear_bands(), friction_of_cells(), particles_of_cells(body), counted("particles", "particles"),
        counted("cells", "cells")}});
}

/// How much the reaction changes where the soil is meshed anew, on average.
TrustMeasures remeshing(const settings::Case& c)
{
  if (c.small_strain()) return {};
  return {{"mean change of the contact force at a remeshing", &limits::change_by_remeshing, base::always,
           [](Run run) { return run.check("mean_change_by_remeshing"); },
           [](Run run, Real value) {
             return fmt::format("{} at {} remeshings; the largest is {} of the largest contact force", text::percent_words(value),
                                text::count_words(run.check("remeshings")), text::percent_words(run.check("largest_change_by_remeshing")));
           },
           "remeshing changes the contact force on average by {}: use smaller elements (fem.contact_size)", text::percent_words},
          {"energy lost by remeshing, divided by the work", &limits::energy_by_remeshing, base::always,
           [](Run run) { return std::abs(run.check("energy_lost_by_remeshing")); },
           [](Run run, Real value) {
             return fmt::format("{} of the work; soil lost {:.2g} D2 (around an axis D3 per radian), {} folds closed",
                                text::percent_words(value), run.check("area_lost_by_remeshing"),
                                text::count_words(run.check("folds_closed_by_remeshing")));
           },
           "remeshing loses {} of the work: use smaller elements (fem.contact_size)", text::percent_words}};
}

TrustMeasures fem_measures(const settings::Case& c)
{
  const std::string body = body_word(c);
  return joined({convergence(),
                 remeshing(c),
                 {energy_balance(settings::Method::fem), held(body), overlap(body),
                  size_of("elements at the " + body, c.small_strain() ? limits::elements : limits::remeshed_elements), shear_bands(),
                  friction_of_cells(), counted("nodes", "nodes"), counted("elements", "cells")}});
}

}  // namespace

base::TrustMeasures driven_measures(const settings::Case& c, const base::Limit* of_cells)
{
  return c.method == settings::Method::mpm ? mpm_measures(body_word(c), of_cells) : fem_measures(c);
}

}  // namespace berm::driven
