// SPDX-License-Identifier: BSD-3-Clause
#include "sea/sea_answer.hpp"

#include "formulas/pipe_in_sand.hpp"

#include <algorithm>
#include <array>

namespace berm::sea {
namespace {

constexpr std::size_t classes = 10;

formulas::PipeInSand pipe_in(const SeaCase& c, Real embedment)
{
  return {.diameter = c.pipe.diameter, .embedment = embedment, .unit_weight = c.bed.unit_weight.value_or(nan), .friction_angle = 0};
}

Extremes extremes_of(const LoadRecord& record, std::size_t waves)
{
  Extremes found{.least_V = infinity, .waves = waves};
  for (std::size_t row = 0; row < record.H.size(); ++row) {
    found.velocity = std::max(found.velocity, std::abs(record.velocity[row]));
    found.H = std::max(found.H, std::abs(record.H[row]));
    found.least_V = std::min(found.least_V, record.V[row]);
  }
  return found;
}

}  // namespace

Dimensionless dimensionless(const SeaCase& c, const SeaAnswer& a)
{
  const Real D = c.pipe.diameter, U = a.waves.velocity, T = a.waves.period, largest = a.design.velocity.value;
  return {.K = U * T / D,
          .M = a.current / U,
          .N = U / (standard_gravity * T),
          .L = c.pipe.weight / (c.sea.water_density * D / 2 * U * U),
          .design_K = largest * a.design.period.value / D,
          .design_M = a.current / largest,
          .tau = c.sea.duration / T};
}

SeaAnswer answer_of(const SeaCase& c)
{
  SeaAnswer a;
  const Real D = c.pipe.diameter;
  a.direction_factor = formulas::wave_direction_factor(c.sea.direction, c.sea.spreading.value_or(infinity));
  a.height = formulas::height_of(*c.spectrum);
  a.waves = formulas::waves_at_seabed(*c.spectrum, c.sea.depth);
  if (c.bed.grain_size) {
    formulas::BedFlow flow{.velocity = a.waves.velocity, .period = a.waves.period};
    if (c.current) {
      flow.current = c.current->velocity, flow.height = c.current->height, flow.roughness = c.current->roughness;
      flow.angle = c.sea.direction - c.current->direction;
    }
    a.shields = formulas::shields_parameter(flow, *c.bed.grain_size);
    a.critical_shields = formulas::critical_shields(*c.bed.grain_size);
  }
  a.waves.velocity *= a.direction_factor;
  if (c.current)
    a.current = formulas::current_on_pipe(c.current->velocity, c.current->height, c.current->roughness, c.current->direction, D).value;
  a.design = formulas::design_oscillation(a.waves, c.sea.duration, c.sea.depth, std::min(c.peakedness, Real(5)));
  a.embedment =
      c.pipe.embedment.value_or(c.bed.unit_weight ? std::min(formulas::sand_embedment(pipe_in(c, 0), c.pipe.weight).value, D) : 0);

  const Dimensionless n = dimensionless(c, a);
  a.left = formulas::f109_load_reductions(a.embedment / D, c.bed.trench_depth / D, c.bed.trench_angle, c.bed.permeable);
  a.peak = formulas::f109_peak_loads(n.design_K, n.design_M);
  const Real pressure = c.sea.water_density * D / 2 * std::pow(a.design.velocity.value + a.current, 2);
  a.horizontal = a.left.horizontal.value * a.peak.horizontal.value * pressure;
  a.vertical = a.left.vertical.value * a.peak.vertical.value * pressure;
  const Real on_bed = c.pipe.weight - a.vertical;
  constexpr Real friction_of_formula = 0.6;
  if (c.bed.unit_weight && on_bed > 0)
    a.passive = formulas::f109_sand_lateral(pipe_in(c, a.embedment), on_bed).value - friction_of_formula * on_bed;
  a.stable_weight = formulas::f109_weight_for_half_diameter(n.K, n.M, n.N);
  a.stable_weight.value *= c.bed.unit_weight ? c.pipe.weight / n.L : nan;

  const RecordFactors factors{.direction = a.direction_factor, .current = a.current, .embedment = a.embedment};
  for (int seed = 1; seed <= c.record.seeds; ++seed) {
    a.records.push_back(realisation(c, factors, static_cast<unsigned>(seed)));
    a.waves_of_record.push_back(waves_of(a.records.back()));
    a.extremes.push_back(extremes_of(a.records.back(), a.waves_of_record.back().size()));
  }
  return a;
}

Utilisation absolute_stability(const SeaCase& c, const SeaAnswer& a)
{
  return {c.bed.safety_factor * (a.horizontal + c.bed.friction * a.vertical) / (c.bed.friction * c.pipe.weight + a.passive),
          c.bed.safety_factor * a.vertical / c.pipe.weight};
}

std::vector<LoadClass> load_classes(const SeaAnswer& a)
{
  const auto half_height = [](const LoadWave& wave) { return (wave.crest - wave.trough) / 2; };
  Real largest = 0;
  for (const auto& waves : a.waves_of_record)
    for (const LoadWave& wave : waves) largest = std::max(largest, half_height(wave));
  std::array<Real, classes> cycles{};
  for (const auto& waves : a.waves_of_record)
    for (const LoadWave& wave : waves) cycles[std::min(static_cast<std::size_t>(half_height(wave) / largest * classes), classes - 1)] += 1;
  std::vector<LoadClass> found;
  for (std::size_t k = 0; k < classes; ++k)
    if (cycles[k] > 0)
      found.push_back({cycles[k] / static_cast<Real>(a.waves_of_record.size()), largest * static_cast<Real>(k + 1) / classes});
  return found;
}

}  // namespace berm::sea
