// SPDX-License-Identifier: BSD-3-Clause
#include "core/lane_parts.hpp"
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
  material::Principal<WidePart> s;

  for (auto _ : state) {
    benchmark::DoNotOptimize(stress);
    const material::AxisAndCircle<WidePart> split = material::axis_and_circle(stress);
    s = principal(split);
    stress = with_principal(split, s);
    benchmark::DoNotOptimize(stress);
  }
  state.SetItemsProcessed(state.iterations() * count);

  for (int l = 0; l < count; ++l)
    if (std::abs(s.s1[l] - trial.principal[0]) > 1e-6 || std::abs(s.s3[l] - trial.principal[2]) > 1e-6)
      state.SkipWithError("these are not the principal stresses");
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
  benchmark::RegisterBenchmark("axis_and_circle", axes_of_part);
  benchmark::RegisterBenchmark("sums", sums_of_parts);
}

}  // namespace berm
