// SPDX-License-Identifier: BSD-3-Clause
#include "kernels.hpp"
#include "trial_stresses.hpp"

#include <benchmark/benchmark.h>
#include <fmt/format.h>

namespace berm {
namespace {

/// The stresses of eight particles, part by part as in a step; without a strain increment, so that the stress is the trial stress.
template <int dim>
void update_eight(benchmark::State& state, const Trial& trial)
{
  const PreparedMohrCoulomb law = trial_sand();
  SymTensor<dim, Lanes> begin, end;
  SymTensor<dim, LanePart> strain;
  for (int l = 0; l < lanes; ++l)
    for (int k = 0; k < tensor_size<dim>; ++k) begin[k][l] = turned<dim>(trial, 0.3 + 0.1 * l)[k];

  for (auto _ : state) {
    benchmark::DoNotOptimize(begin);
    benchmark::DoNotOptimize(strain);
    for (int first = 0; first < lanes; first += part_lanes) {
      SymTensor<dim, LanePart> stress;
      LanePart opening{};
      for (int k = 0; k < tensor_size<dim>; ++k) stress[k] = part_of(begin[k], first);
      update_stress<dim, LanePart>(law, stress, strain, &opening);
      for (int k = 0; k < tensor_size<dim>; ++k) set_part(end[k], first, stress[k]);
      benchmark::DoNotOptimize(opening);
    }
    benchmark::DoNotOptimize(end);
  }
  state.SetItemsProcessed(state.iterations() * lanes);

  for (int l = 0; l < lanes; ++l) {
    SymTensor<dim> old_stress, new_stress;
    for (int k = 0; k < tensor_size<dim>; ++k) old_stress[k] = begin[k][l], new_stress[k] = end[k][l];
    if (!ends_there(trial, old_stress, new_stress)) state.SkipWithError("the return ends elsewhere");
  }
}

}  // namespace

void add_stress_kernels()
{
  for (const Trial& trial : trials) {
    benchmark::RegisterBenchmark(fmt::format("stress_2D/{}", trial.name).c_str(), update_eight<2>, trial);
    benchmark::RegisterBenchmark(fmt::format("stress_3D/{}", trial.name).c_str(), update_eight<3>, trial);
  }
}

}  // namespace berm
