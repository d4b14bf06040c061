// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/report/quality/quality_section_test.cpp
#include "report/quality/measures.hpp"

#include "material/shear_band.hpp"
#include "report/setup/setup_tables.hpp"
#include "text/quantity_words.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::report {
namespace {

using Run = const pipe::RunRecord&;

bool always(Run)
{
  return true;
}
bool has_pipe(Run run)
{
  return run.has_pipe();
}
bool pushes(Run run)
{
  return run.has_pipe() && !run.stages.push.empty();
}
bool drags(Run run)
{
  return run.has_pipe() && !run.stages.drag.empty();
}
bool holds(Run run)
{
  return drags(run) && holds_force(run.settings);
}
bool settles(Run run)
{
  const std::vector<problem::StageSettings>& stages = run.settings.stage;
  return std::any_of(stages.begin(), stages.end(),
                     [](const problem::StageSettings& stage) { return stage.kind == problem::StageKind::geostatic; });
}

bool has_soil(Run run)
{
  return std::any_of(run.settings.material.begin(), run.settings.material.end(), [](const auto& entry) { return yields(entry.second); });
}
bool shakes(Run run)
{
  return run.has_pipe() && has_soil(run);
}

std::string percent(Run, Real value)
{
  return text::percent_words(value);
}
std::string bare(Run, Real value)
{
  return fmt::format("{:.2g}", value);
}
std::string bare_limit(Real value)
{
  return fmt::format("{:.4g}", value);
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

std::string energy_words(Run run, Real value)
{
  const std::string where = energy_error(run).where;
  return text::percent_words(value) + (where.empty() ? "" : fmt::format(" ({})", where));
}

Real tightness(Run run)
{
  return run.scale.diameter / near_cell_size(run.settings);
}

TrustMeasure energy(const Limit& limit)
{
  return {"energy that does not balance, over the work",
          &limit,
          always,
          [](Run run) { return energy_error(run).over_work; },
          energy_words,
          [](Run run, Real value) {
            return fmt::format("{} of the work is not balanced by energy ({}): halve {}", text::percent_words(value),
                               energy_error(run).where, run.settings.method == problem::Method::mpm ? "mpm.courant" : "fem.largest_step");
          },
          text::percent_words};
}

TrustMeasure kinetic(const char* what, const char* stage, bool (*applies)(Run), std::vector<std::string> pipe::PipeStages::*stages)
{
  return {what,
          &limits::kinetic,
          applies,
          [stages](Run run) { return kinetic_over_internal(run, run.stages.*stages); },
          percent,
          [stage](Run, Real value) {
            return fmt::format("kinetic energy is {} of internal energy in the {}: drive slower", text::percent_words(value), stage);
          },
          text::percent_words};
}

TrustMeasure held()
{
  return {"error of the V that the drag holds (root mean square)",
          &limits::held,
          holds,
          [](Run run) { return quantity_value(run, "V_rms_error_in_drag"); },
          percent,
          [](Run, Real value) {
            return fmt::format("V is held within {} only: give the drag a longer ramp, or the pipe less mass", text::percent_words(value));
          },
          text::percent_words};
}

TrustMeasure overlap()
{
  return {"deepest soil inside the pipe, over D",
          &limits::overlap,
          has_pipe,
          [](Run run) { return quantity_value(run, "overlap_max_over_D"); },
          bare,
          [](Run run, Real value) {
            return fmt::format("soil is {} inside the pipe, {} D", text::length_words(value * run.scale.diameter),
                               text::number_words(value));
          },
          diameter_limit};
}

TrustMeasure size_at_pipe(const char* what, const Limit* limit)
{
  return {what,
          limit,
          has_pipe,
          tightness,
          [](Run run, Real value) { return fmt::format("D/{:.3g} ({})", value, text::length_words(near_cell_size(run.settings))); },
          [what](Run, Real value) { return fmt::format("{} are D/{:.3g}: resistance on a coarse mesh is too large", what, value); },
          over_limit};
}

/// The soil that loses most in shear bands; empty where none has a strength.
std::optional<material::Strength> weakest_in_shear_bands(Run run)
{
  std::optional<material::Strength> weakest;
  for (const auto& [name, material] : run.settings.material)
    if (const std::optional<material::Strength> soil = strength_at_rest(material))
      if (!weakest || friction_lost_in_shear_bands(*soil) > friction_lost_in_shear_bands(*weakest)) weakest = soil;
  return weakest;
}

Real lost_in_shear_bands(Run run)
{
  const std::optional<material::Strength> soil = weakest_in_shear_bands(run);
  return soil ? friction_lost_in_shear_bands(*soil) : 0;
}

TrustMeasure shear_bands()
{
  return {"friction that shear bands can lose, psi < phi",
          &limits::shear_bands,
          has_soil,
          lost_in_shear_bands,
          percent,
          [](Run run, Real value) {
            return fmt::format("the soil (psi below phi) can lose {} of its friction in shear bands, which are as wide as the cells make "
                               "them: resistance falls with finer "
                               "cells. Take cells of a third to a fifth of the soil's own bands, which are 10 to 20 d50 wide, and estimate "
                               "the lower end of the answer by the "
                               "same case with phi* = {:.1f} deg as friction_angle (docs/decisions/0018)",
                               text::percent_words(value), friction_angle_in_shear_bands(*weakest_in_shear_bands(run)) * 180 / pi);
          },
          text::percent_words};
}

TrustMeasure part_of_soil(const char* what, const char* check, const Limit& limit)
{
  return {what,
          &limit,
          has_soil,
          [check](Run run) { return run.check(check); },
          percent,
          [what](Run, Real value) { return fmt::format("{}: {}", what, text::percent_words(value)); },
          text::percent_words};
}

TrustMeasure count(const char* what, const char* timing)
{
  return {what, nullptr, always, [timing](Run run) { return run.timing(timing); }, [](Run, Real value) { return text::count_words(value); },
          {},   nullptr};
}

std::vector<TrustMeasure> mpm_measures()
{
  return {
      energy(limits::energy),
      kinetic("kinetic over internal energy, push", "push", pushes, &pipe::PipeStages::push),
      kinetic("kinetic over internal energy, drag", "drag", drags, &pipe::PipeStages::drag),
      {"out-of-balance force after the geostatic stage, over the weight", &limits::out_of_balance, settles,
       [](Run run) { return run.check("out_of_balance_after_geostatic"); }, bare,
       [](Run, Real value) {
         return fmt::format("the bed was out of balance by {:.2g} of its weight when the push began: give the geostatic stage more time",
                            value);
       },
       bare_limit},
      held(),
      {"noise of V in the push", &limits::noise_of_V, pushes, [](Run run) { return quantity_value(run, "V_noise"); }, percent,
       [](Run, Real value) {
         return fmt::format("V wavers by {} about its mean: a single value says little, take means", text::percent_words(value));
       },
       text::percent_words},
      {"noise of H in the drag", &limits::noise_of_H, drags, [](Run run) { return quantity_value(run, "H_noise"); }, percent,
       [](Run, Real value) {
         return fmt::format("H wavers by {} about its mean: a single value says little, take means", text::percent_words(value));
       },
       text::percent_words},
      {"pressure of unresolved motion at the pipe, over the mean pressure there", &limits::shaking, shakes,
       [](Run run) { return run.check("shaking_at_body"); }, bare,
       [](Run, Real value) {
         return fmt::format("the soil at the pipe shakes by {:.2g} of its pressure: it has lost strength, and resistance is too small",
                            value);
       },
       bare_limit},
      part_of_soil("soil at its smallest volume", "mass_at_min_volume", limits::at_bounds),
      part_of_soil("soil at its largest volume", "mass_at_max_volume", limits::at_bounds),
      part_of_soil("soil in the air", "mass_in_the_air", limits::in_the_air),
      {"mean contact gap, in cells h at the pipe", &limits::gap, has_pipe, gap_in_cells,
       [](Run run, Real value) {
         return fmt::format("{:.2g} h: the pipe acts up to {} larger", value, text::percent_words(acts_larger(run)));
       },
       [](Run run, Real value) {
         return fmt::format("gap is {:.2g} h: the pipe acts up to {} larger (2 gap/D)", value, text::percent_words(acts_larger(run)));
       },
       cells_limit},
      overlap(),
      {"second contact correction, over V", &limits::second_impulse, pushes,
       [](Run run) { return quantity_value(run, "second_impulse_over_V"); }, percent,
       [](Run, Real value) {
         return fmt::format("the second contact correction is {} of V: contact works against itself", text::percent_words(value));
       },
       text::percent_words},
      {"momentum that does not balance", &limits::momentum, always, [](Run run) { return run.check("momentum_error"); }, bare,
       [](Run, Real value) { return fmt::format("{:.2g} of the momentum is not accounted for", value); }, bare_limit},
      size_at_pipe("cells at the pipe", &limits::cells),
      shear_bands(),
      {"particles per cell at the pipe", &limits::particles, has_pipe, [](Run run) { return near_particles(run.settings); },
       [](Run, Real value) { return text::count_words(value); },
       [](Run, Real value) { return fmt::format("{:.0f} particles per cell at the pipe are few: stresses scatter", value); }, bare_limit},
      count("particles", "particles"),
      count("cells", "cells"),
  };
}

std::vector<TrustMeasure> fem_measures()
{
  return {
      {"largest unbalanced force, over what is accepted", &limits::unbalance, always,
       [](Run run) { return run.check("largest_unbalance") / run.settings.fem.tolerance; }, bare,
       [](Run, Real value) { return fmt::format("unbalanced forces are {:.2g} times what fem.tolerance accepts", value); }, bare_limit},
      {"increments that did not converge", &limits::loose, always,
       [](Run run) { return run.check("loose_increments") / run.timing("steps"); },
       [](Run run, Real) {
         return fmt::format("{} of {}", text::count_words(run.check("loose_increments")), text::count_words(run.timing("steps")));
       },
       [](Run, Real value) {
         return fmt::format("{} of the increments did not converge: try a larger fem.relaxation", text::percent_words(value));
       },
       text::percent_words},
      {"part of the stress beyond the strength", &limits::overstress, always, [](Run run) { return run.check("largest_overstress"); },
       percent, [](Run, Real value) { return fmt::format("{} of the stress is beyond the soil's strength", text::percent_words(value)); },
       text::percent_words},
      {"strength that lags behind the pressure, psi < phi, over what flow dissipates", &limits::lag,
       [](Run run) { return lost_in_shear_bands(run) > 0; }, [](Run run) { return run.check("strength_lag"); }, percent,
       [](Run, Real value) {
         return fmt::format("the strength of the soil lags by {} of what its flow dissipates: take a smaller fem.largest_step",
                            text::percent_words(value));
       },
       text::percent_words},
      energy(limits::energy_of_fem),
      held(),
      overlap(),
      size_at_pipe("elements at the pipe", &limits::elements),
      shear_bands(),
      count("nodes", "nodes"),
      count("elements", "cells"),
  };
}

}  // namespace

const std::vector<TrustMeasure>& trust_measures(problem::Method method)
{
  static const std::vector<TrustMeasure> mpm = mpm_measures(), fem = fem_measures();
  return method == problem::Method::mpm ? mpm : fem;
}

}  // namespace berm::report
