// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/structures/penetration/penetration_test.cpp
#include "structures/penetration/footing.hpp"

#include "formulas/footing.hpp"
#include "formulas/penetrometer.hpp"
#include "structures/base/little_cohesion.hpp"
#include "structures/penetration/penetration_run.hpp"
#include "structures/penetration/penetrometers.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::penetration {
namespace {

using formulas::Base;

constexpr base::Limit footing_cells =
    base::too_large({100, 20, base::Effect::contact_width,
                     "soil beside the edge moves with a footing up to a cell beyond it: q is 2 h/D too large at most, around an "
                     "axis twice that (examples/circular_footing)",
                     true});
constexpr Real shallow = 0.02;  // of D: embedment and heave beside it add some percent to what a footing on the surface carries
constexpr Real deep = 3;        // of D: the base is deeper than what footings on the surface tell

/// The bases whose factors lie around that of a run: of what part of the soil's strength the interface carries.
std::vector<Base> bases_of(Real ratio)
{
  if (ratio <= 0) return {Base::smooth};
  if (ratio >= 1) return {Base::rough};
  return {Base::smooth, Base::rough};
}

const char* word_of(Base base)
{
  return base == Base::rough ? "rough base" : "smooth base";
}

std::vector<Comparison> on_clay(const PenetrationRun& run, bool round)
{
  const SoilAt end = run.soil.at(run.z_end());
  const Real D = run.whole_width(), N = run.last().factor;
  std::vector<Comparison> list;
  if (run.z_end() > deep * D) return {{"N<sub>c</sub>", N, formulas::deep_plate_factor(end.interface_ratio), "deep round plate", true}};
  const Real z = std::max(Real(0), run.z_end() - run.last().travel / 2);  // of which N is the mean
  const SoilAt here = run.soil.at(z);
  if (!(here.strength > 0)) return list;
  const Real growth = run.soil.growth(z, D) * D / here.strength;
  const std::string depth = fmt::format("z = {:.2g} D", z / D);
  for (const Base base : bases_of(here.interface_ratio)) {
    formulas::Formula surface = round ? formulas::n_c_circle(growth, base) : formulas::n_c_strip(growth, base);
    surface.valid = surface.valid && z <= shallow * D;
    list.push_back({"N<sub>c</sub>", N, surface, fmt::format("{}, of a footing on the surface of the soil below {}", word_of(base), depth),
                    growth == 0, word_of(base)});
  }
  formulas::Formula embedded = formulas::n_c_skempton(z / D, round);
  embedded.valid = embedded.valid && growth == 0;
  list.push_back({"N<sub>c</sub>", N, embedded, "at " + depth});
  return list;
}

std::vector<Comparison> on_sand(const PenetrationRun& run, bool round)
{
  const settings::Case& c = run.record.settings;
  const std::optional<material::Material> material = base::touched_material(c);
  const std::optional<material::Strength> law = material ? strength_at_rest(*material) : std::nullopt;
  if (!law || !base::has_little_cohesion(law->cohesion, law->friction_angle, run.soil.at(0).unit_weight, run.whole_width())) return {};
  const contact::ContactSettings& contact = *base::contact_of_body(c);
  const Real ratio = rules_of(contact.scheme).tied ? 1 : std::tan(contact.friction_angle) / std::tan(law->friction_angle);
  std::vector<Comparison> list;
  for (const Base base : bases_of(ratio)) {
    formulas::Formula N = round ? formulas::n_gamma_circle(law->friction_angle, base) : formulas::n_gamma(law->friction_angle, base);
    N.valid = N.valid && std::abs(law->dilation_angle - law->friction_angle) < associated;
    list.push_back({"N<sub>γ</sub>", run.last().factor, N, std::string(word_of(base)) + ", ψ = φ", true});
  }
  return list;
}

std::vector<Comparison> published_of_footing(const PenetrationRun& run)
{
  const settings::Case& c = run.record.settings;
  const bool in_space = c.geometry == settings::Geometry::space;
  const bool round =
      c.geometry == settings::Geometry::axisymmetric || (in_space && bodies::is_round_from_above(c.rigid[main_rigid(c)].second.shape));
  if (run.body.shoulder > 0 || (in_space && !round)) return {};
  return run.measure() == Measure::strength      ? on_clay(run, round)
         : run.measure() == Measure::half_weight ? on_sand(run, round)
                                                 : std::vector<Comparison>{};
}

}  // namespace

/// A footing or plate, strip or round: q = V over its area, N_c = (q - sigma_v0)/s_u on clay, N_gamma = 2 (q - sigma_v0)/(gamma' D) on sand; beside what any push and drag have.
const Penetrometer& footing()
{
  static const Penetrometer footing{
      .word = "footing",
      .level = "base of the footing",
      .resistance = {"q", "q"},
      .in_clay = {"N_c", "N<sub>c</sub>"},
      .in_sand = {"N_gamma", "N<sub>γ</sub>"},
      .sand_measure = SandMeasure::half_weight,
      .flows_around = false,
      .averaging = 0.01,
      .last_travel = 0.2,
      .depths = {0.0025, 0.005, 0.01, 0.02, 0.05, 0.1, 0.2, 0.3, 0.5, 0.75, 1, 1.5, 2, 3, 4, 5},
      .keeps_push = true,
      .cells = &footing_cells,
      .published = published_of_footing,
      .remark = "",
      .also = {.embedded = embedded_footing,
               .published_envelope = [](const settings::Case& c, const base::EnvelopeEnds&) { return footing_envelope(c); }}};
  return footing;
}

}  // namespace berm::penetration
