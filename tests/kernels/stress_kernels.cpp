// SPDX-License-Identifier: BSD-3-Clause
#include "kernels.hpp"
#include "trial_stresses.hpp"

#include <benchmark/benchmark.h>
#include <fmt/format.h>

namespace berm {
namespace {

/// The stresses of as many particles as a register holds; without a strain increment, so that the stress is the trial stress.
template <int dim>
void update_part(benchmark::State& state, const Trial& trial)
{
  constexpr int count = lanes_of<WidePart>;
  const material::PreparedMohrCoulomb law = trial_sand();
  SymTensor<dim, WidePart> begin, end, strain{};
  for (int l = 0; l < count; ++l)
    for (int k = 0; k < tensor_size<dim>; ++k) begin[k][l] = turned<dim>(trial, 0.3 + 0.1 * l)[k];

  for (auto _ : state) {
    benchmark::DoNotOptimize(begin);
    benchmark::DoNotOptimize(strain);
    SymTensor<dim, WidePart> stress;
    WidePart opening{};
    for (int k = 0; k < tensor_size<dim>; ++k) stress[k] = begin[k];
    update(law, stress, {strain}, &opening);
    for (int k = 0; k < tensor_size<dim>; ++k) end[k] = stress[k];
    benchmark::DoNotOptimize(opening);
    benchmark::DoNotOptimize(end);
  }
  state.SetItemsProcessed(state.iterations() * count);

  for (int l = 0; l < count; ++l) {
    SymTensor<dim> old_stress, new_stress;
    for (int k = 0; k < tensor_size<dim>; ++k) old_stress[k] = begin[k][l], new_stress[k] = end[k][l];
    if (!ends_there(trial, old_stress, new_stress)) state.SkipWithError("the return ends elsewhere");
  }
}

}  // namespace

void add_stress_kernels()
{
  for (const Trial& trial : trials) {
    benchmark::RegisterBenchmark(fmt::format("stress_2D/{}", trial.name).c_str(), update_part<2>, trial);
    benchmark::RegisterBenchmark(fmt::format("stress_3D/{}", trial.name).c_str(), update_part<3>, trial);
  }
}

}  // namespace berm
