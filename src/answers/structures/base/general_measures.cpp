// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/report/quality/quality_section_test.cpp
#include "structures/base/general_measures.hpp"

#include "material/shear_band.hpp"
#include "structures/base/driven_body.hpp"
#include "structures/base/mechanism_cells.hpp"
#include "text/quantity_words.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::base {
namespace {

using Run = const record::RunRecord&;

namespace limits {

inline constexpr Limit energy{
    0.01, 0.05, Effect::energy,
    "a smaller mpm.courant lowers it; finer cells (examples/mesh_study) and another contact scheme (examples/contact_schemes) may, too"};
inline constexpr Limit energy_of_fem{
    0.02, 0.15, Effect::energy,
    "stress and contact forces are linear within an increment: a smaller fem.largest_step "
    "lowers it; a footing on sand with an energy error of 10 % is right to 2 % (examples/circular_footing)"};
inline constexpr Limit filter = too_large({0.02, 0.05, Effect::energy,
                                           "a filter that dissipates 4 % of the work makes the run-out of a sand column 5 % too short, one "
                                           "that dissipates 12 % makes it 23 % too short "
                                           "(docs/decisions/0059)"});
inline constexpr Limit viscosity =
    too_large({0.02, 0.05, Effect::energy, "as for the filter: what it dissipates is resistance that the soil does not have"});
inline constexpr Limit damping =
    too_large({0.05, 0.15, Effect::energy,
               "what it dissipates is resistance that the soil does not have; a sphere pressed on an elastic block, with 5 % of the work "
               "dissipated, settles to within 1 % of the exact depth (examples/hertz)"});
inline constexpr Limit out_of_balance{
    0.01, 0.05, Effect::balance,
    "a bed that has not reached equilibrium is far above, one in equilibrium far below (docs/theory/method.md, Volumetric locking)"};
inline constexpr Limit at_bounds{
    0.001, 0.01, Effect::volume_bounds,
    "soil at a bound of its volume no longer follows its law (docs/theory/soil_and_contact.md, Opening and bounds of volume)"};
inline constexpr Limit in_the_air{0.001, 0.01, Effect::volume_bounds, "soil in the air carries no load"};
inline constexpr Limit momentum{1e-9, 1e-6, Effect::energy,
                                "impulses add up to the change of momentum to round-off, or the program is wrong"};
inline constexpr Limit shear_bands =
    too_large({0.05, 0.25, Effect::dilation,
               "the more strength can be lost in shear bands, the more V depends on the size of the cells (examples/localisation)"});
inline constexpr Limit cells_of_band{material::cells_of_band, 2 * material::cells_of_band, Effect::dilation,
                                     "bands are some four cells wide, however fine these are (docs/decisions/0063)"};
inline constexpr Limit unbalance{1, 10, Effect::balance, "over fem.tolerance: up to 1 counts as equilibrium"};
inline constexpr Limit loose{0, 0.1, Effect::balance, "increments that did not converge leave unbalanced forces"};
inline constexpr Limit lag =
    too_small({0.01, 0.05, Effect::balance,
               "an increment is solved again until its own lag is 1 %; with the lag of large increments V is too small "
               "(docs/decisions/0013)"});
inline constexpr Limit overstress{
    0.01, 0.05, Effect::balance, "far below 0.01 it is right; above 0.05 the soil cannot carry the force (docs/how_to/finite_elements.md)"};

}  // namespace limits

bool settles(Run run)
{
  const std::vector<settings::StageSettings>& stages = run.settings.stage;
  return std::any_of(stages.begin(), stages.end(),
                     [](const settings::StageSettings& stage) { return stage.kind == settings::StageKind::geostatic; });
}

std::string energy_words(Run run, Real value)
{
  const std::string where = energy_error(run).where;
  return text::percent_words(value) + (where.empty() ? "" : fmt::format(" ({})", where));
}

/// The largest work of a history, J/m or J; NaN where it has none.
Real largest_work(const run_folder::History& h)
{
  if (h.rows() == 0 || !h.has_label("external") || !h.has_label("internal")) return nan;
  Real work = 0;
  for (const char* label : {"external", "internal"})
    for (const Real value : h.by_label(label)) work = std::max(work, std::abs(value));
  return work;
}

/// What local damping took in the pushes and drags, over the largest work of the run; NaN where that is not known.
Real damping_over_work(Run run)
{
  const run_folder::History& h = run.history;
  const Real work = largest_work(h);
  if (!(work > 0) || !h.has_label("damping")) return nan;
  const std::vector<Real>& damping = h.by_label("damping");
  Real taken = 0;
  for (Index k = 1; k < h.rows(); ++k) {
    const bool driven = std::any_of(run.settings.stage.begin(), run.settings.stage.end(), [&](const settings::StageSettings& stage) {
      return stage.name == h.stage[k] && (stage.kind == settings::StageKind::push || stage.kind == settings::StageKind::drag);
    });
    if (driven) taken += damping[k] - damping[k - 1];
  }
  return taken / work;
}

/// The soil that loses most in shear bands, of those whose bands have no width of their own; empty where none has a strength.
std::optional<material::Strength> weakest_in_shear_bands(Run run)
{
  std::optional<material::Strength> weakest;
  for (const auto& [name, material] : run.settings.material)
    if (const std::optional<material::Strength> soil = strength_at_rest(material); soil && !band_width(material))
      if (!weakest || friction_lost_in_shear_bands(*soil) > friction_lost_in_shear_bands(*weakest)) weakest = soil;
  return weakest;
}

/// Whether soil of a case can shear in bands: not where all slices of a pipeline are springs, nor around a cavity about the axis, whose wall alone moves along the radius.
bool can_form_bands(const settings::Case& c)
{
  if (c.pipeline && c.pipeline->slices.as_spring == settings::SliceAsSpring::always) return false;
  return c.geometry != settings::Geometry::axisymmetric ||
         std::none_of(c.stage.begin(), c.stage.end(), [](const settings::StageSettings& stage) {
           return stage.kind == settings::StageKind::drive && (stage.drive.x.velocity || stage.drive.x.force);
         });
}

Real lost_in_shear_bands(Run run)
{
  const std::optional<material::Strength> soil = weakest_in_shear_bands(run);
  return soil ? friction_lost_in_shear_bands(*soil) : 0;
}

TrustMeasure part_of_soil(const char* what, const char* check, const Limit& limit)
{
  return {what,
          &limit,
          has_soil,
          [check](Run run) { return run.check(check); },
          in_percent,
          fmt::format("{}: {{}}", what),
          text::percent_words};
}

}  // namespace

EnergyError energy_error(const record::RunRecord& run)
{
  EnergyError found{run.check("energy_error"), ""};
  const run_folder::History& h = run.history;
  const Real work = largest_work(h);
  if (std::isnan(work) || !h.has_label("energy error")) return found;
  Real largest = 0;
  Index row = none;
  for (Index k = 0; k < h.rows(); ++k) {
    const Real error = std::abs(h.by_label("energy error")[k]);
    if (error > largest) largest = error, row = k;
  }
  if (std::isnan(found.over_work) && work > 0) found.over_work = largest / work;
  if (row == none) return found;
  const std::vector<settings::StageSettings>& stages = run.settings.stage;
  const bool drag = std::any_of(stages.begin(), stages.end(), [&](const settings::StageSettings& stage) {
    return stage.kind == settings::StageKind::drag && stage.name == h.stage[row];
  });
  const std::string at = drives_a_body(run.settings)
                             ? fmt::format("{} = {}", drag ? "u" : "w", text::length_words(h[drag ? "u_m" : "w_m"][row]))
                             : "t = " + text::time_words(h["time_s"][row]);
  found.where = fmt::format("{}, {}", h.stage[row], at);
  return found;
}

Real work_of_contact(const record::RunRecord& run)
{
  const run_folder::History& h = run.history;
  const Real work = largest_work(h);
  if (std::isnan(work) || !h.has_label("friction")) return nan;
  return work > 0 ? std::max(Real(0), -h.by_label("friction").back() / work) : 0;
}

Real quantity_value(const record::RunRecord& run, const std::string& name)
{
  const run_folder::Quantity* quantity = run.quantity(name);
  return quantity == nullptr ? nan : quantity->value;
}

bool has_soil(Run run)
{
  return std::any_of(run.settings.material.begin(), run.settings.material.end(), [](const auto& entry) { return yields(entry.second); });
}

TrustMeasure energy_balance(settings::Method method)
{
  return {"energy that does not balance, divided by the work",
          method == settings::Method::mpm ? &limits::energy : &limits::energy_of_fem,
          always,
          [](Run run) { return energy_error(run).over_work; },
          energy_words,
          [](Run run, Real value) {
            const char* smaller = run.settings.method != settings::Method::mpm ? "halve fem.largest_step"
                                  : run.settings.mpm.courant                   ? "halve mpm.courant"
                                                                               : "set mpm.courant to 0.5 or less";
            return fmt::format("{} of the work is not balanced by energy ({}): {}", text::percent_words(value), energy_error(run).where,
                               smaller);
          },
          text::percent_words};
}

TrustMeasures energy_that_the_method_takes()
{
  return {{"energy dissipated by the velocity filter, divided by the work", &limits::filter,
           [](Run run) { return has_soil(run) && run.settings.mpm.velocity_filter > 0; },
           [](Run run) { return run.check("filter_over_work"); }, in_percent,
           "the velocity filter dissipated {} of the work, which slows flowing soil: take finer cells, or a smaller mpm.velocity_filter",
           text::percent_words},
          {"energy dissipated by the bulk viscosity, divided by the work", &limits::viscosity,
           [](Run run) { return has_soil(run) && run.settings.mpm.bulk_viscosity > 0; },
           [](Run run) { return run.check("viscosity_over_work"); }, in_percent,
           "the bulk viscosity dissipated {} of the work: drive slower, take finer cells, or a smaller mpm.bulk_viscosity",
           text::percent_words},
          {"energy dissipated by local damping while a body is driven, divided by the work", &limits::damping,
           [](Run run) { return drives_a_body(run.settings) && !std::isnan(damping_over_work(run)); }, damping_over_work, in_percent,
           "local damping dissipated {} of the work while the body was driven: take a smaller damping there, or drive slower",
           text::percent_words}};
}

TrustMeasure balance_after_geostatic(const std::string& when)
{
  return {"out-of-balance force after the geostatic stage, divided by the weight",
          &limits::out_of_balance,
          settles,
          [](Run run) { return run.check("out_of_balance_after_geostatic"); },
          as_number,
          fmt::format("the bed was out of balance by {{}} of its weight {}: give the geostatic stage more time", when),
          bare_limit};
}

TrustMeasure soil_at_largest_volume()
{
  return part_of_soil("soil at its largest volume", "mass_at_max_volume", limits::at_bounds);
}

TrustMeasures soil_volumes()
{
  return {part_of_soil("soil at its smallest volume", "mass_at_min_volume", limits::at_bounds), soil_at_largest_volume(),
          part_of_soil("soil in the air", "mass_in_the_air", limits::in_the_air)};
}

TrustMeasure momentum_balance()
{
  return {
      "momentum that does not balance",          &limits::momentum, always, [](Run run) { return run.check("momentum_error"); }, as_number,
      "{} of the momentum is not accounted for", bare_limit};
}

TrustMeasure shear_bands()
{
  return {"friction that shear bands can lose, psi < phi",
          &limits::shear_bands,
          [](Run run) { return has_soil(run) && can_form_bands(run.settings); },
          lost_in_shear_bands,
          in_percent,
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

namespace {

/// The soil with the narrowest shear bands of a width of their own, and the cells in which such soil shears.
struct BandedSoil {
  material::Strength strength;
  Real width = infinity;  ///< m; infinity: there is none
  CellSizes cells;
  Real friction_angle(Real size) const { return friction_angle_in_cells(strength, width, size) * 180 / pi; }
};

BandedSoil banded_soil(Run run)
{
  BandedSoil soil;
  for (const auto& [name, material] : run.settings.material)
    if (const std::optional<Real> width = band_width(material); width && *width < soil.width)
      if (const std::optional<material::Strength> strength = strength_at_rest(material)) soil.strength = *strength, soil.width = *width;
  const Real near = near_cells(run).first;
  if (soil.width < infinity) soil.cells = sheared_cell_sizes(run).value_or(CellSizes{near, near});
  return soil;
}

}  // namespace

TrustMeasure friction_of_cells()
{
  return {"cells across a shear band of the soil, psi < phi",
          &limits::cells_of_band,
          [](Run run) {
            return can_form_bands(run.settings) &&
                   std::any_of(run.settings.material.begin(), run.settings.material.end(),
                               [](const auto& named) { return band_width(named.second) && strength_at_rest(named.second); });
          },
          [](Run run) {
            const BandedSoil soil = banded_soil(run);
            return soil.width / soil.cells.smallest;
          },
          [](Run run, Real value) {
            const BandedSoil soil = banded_soil(run);
            return fmt::format(
                "{:.2g}: phi is {:.1f} deg in the finest cells that shear, {}, and {:.1f} deg in the coarsest, {}; bands are {} wide",
                value, soil.friction_angle(soil.cells.smallest), text::length_words(soil.cells.smallest),
                soil.friction_angle(soil.cells.largest), text::length_words(soil.cells.largest), text::length_words(soil.width));
          },
          [](Run, Real value) {
            return fmt::format("there are {:.2g} cells across a shear band of the soil: with fewer than four they localise in narrower "
                               "bands, and resistance is too small; take cells {:.2g} times as large there",
                               value, value / material::cells_of_band);
          },
          bare_limit};
}

TrustMeasures convergence()
{
  return {
      {"largest unbalanced force, divided by the accepted one", &limits::unbalance, always,
       [](Run run) { return run.check("largest_unbalance") / run.settings.fem.tolerance; }, as_number,
       "unbalanced forces are {} times what fem.tolerance accepts", bare_limit},
      {"increments that did not converge", &limits::loose, always,
       [](Run run) { return run.check("loose_increments") / run.timing("steps"); },
       [](Run run, Real) {
         return fmt::format("{} of {}", text::count_words(run.check("loose_increments")), text::count_words(run.timing("steps")));
       },
       [](Run, Real value) {
         return fmt::format("{} of the increments did not converge: try a larger fem.relaxation", text::percent_words(value));
       },
       text::percent_words},
      {"fraction of the stress beyond the strength", &limits::overstress, always, [](Run run) { return run.check("largest_overstress"); },
       in_percent, "{} of the stress is beyond the soil's strength", text::percent_words},
      {"strength that lags behind the pressure, psi < phi, divided by plastic dissipation", &limits::lag,
       [](Run run) {
         return std::any_of(run.settings.material.begin(), run.settings.material.end(),
                            [](const auto& material) { return non_associated(material.second); });
       },
       [](Run run) { return run.check("strength_lag"); }, in_percent,
       "the strength of the soil lags behind the pressure by {} of the plastic dissipation: take a smaller fem.largest_step",
       text::percent_words},
  };
}

TrustMeasure counted(const char* what, const char* timing)
{
  return {what, nullptr, always, [timing](Run run) { return run.timing(timing); }, [](Run, Real value) { return text::count_words(value); },
          {},   nullptr};
}

}  // namespace berm::base
