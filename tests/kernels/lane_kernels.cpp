// SPDX-License-Identifier: BSD-3-Clause
#include "kernels.hpp"
#include "trial_stresses.hpp"

#include <benchmark/benchmark.h>

namespace berm {
namespace {

constexpr int count = lanes_of<WidePart>;

void axes_of_part(benchmark::State& state)
{
  const Trial& trial = trials[1];
  SymTensor<3, WidePart> stress;
  for (int l = 0; l < count; ++l)
    for (int k = 0; k < 6; ++k) stress[k][l] = turned<3>(trial, 0.3 + 0.1 * l)[k];
  material::PrincipalAxes<WidePart> axes;

  for (auto _ : state) {
    benchmark::DoNotOptimize(stress);
    axes = material::principal_axes(stress);
    benchmark::DoNotOptimize(axes);
  }
  state.SetItemsProcessed(state.iterations() * count);

  for (int l = 0; l < count; ++l)
    for (int k = 0; k < 3; ++k)
      if (std::abs(axes.value[k][l] - trial.principal[k]) > 1e-6) state.SkipWithError("these are not the principal values");
}

void sums_of_parts(benchmark::State& state)
{
  WidePart x[count], total;
  for (int k = 0; k < count; ++k)
    for (int l = 0; l < count; ++l) x[k][l] = l * (k + 1);

  for (auto _ : state) {
    benchmark::DoNotOptimize(x);
    total = sums(x);
    benchmark::DoNotOptimize(total);
  }
  state.SetItemsProcessed(state.iterations() * count);

  for (int k = 0; k < count; ++k)
    if (total[k] != count * (count - 1) / 2 * (k + 1)) state.SkipWithError("these are not the sums");
}

}  // namespace

void add_lane_kernels()
{
  benchmark::RegisterBenchmark("principal_axes", axes_of_part);
  benchmark::RegisterBenchmark("sums", sums_of_parts);
}

}  // namespace berm
