// SPDX-License-Identifier: BSD-3-Clause
#include "kernels.hpp"
#include "trial_stresses.hpp"

#include <benchmark/benchmark.h>

namespace berm {
namespace {

void axes_of_eight(benchmark::State& state)
{
  const Trial& trial = trials[1];
  SymTensor<3, Lanes> stress;
  for (int l = 0; l < lanes; ++l)
    for (int k = 0; k < 6; ++k) stress[k][l] = turned<3>(trial, 0.3 + 0.1 * l)[k];
  Lanes value[3], direction[3][3];

  for (auto _ : state) {
    benchmark::DoNotOptimize(stress);
    for (int first = 0; first < lanes; first += part_lanes) {
      SymTensor<3, LanePart> part;
      for (int k = 0; k < 6; ++k) part[k] = part_of(stress[k], first);
      const PrincipalAxes<LanePart> axes = principal_axes(part);
      for (int k = 0; k < 3; ++k) {
        set_part(value[k], first, axes.value[k]);
        for (int d = 0; d < 3; ++d) set_part(direction[k][d], first, axes.direction[k][d]);
      }
    }
    benchmark::DoNotOptimize(value);
    benchmark::DoNotOptimize(direction);
  }
  state.SetItemsProcessed(state.iterations() * lanes);

  for (int l = 0; l < lanes; ++l)
    for (int k = 0; k < 3; ++k)
      if (std::abs(value[k][l] - trial.principal[k]) > 1e-6) state.SkipWithError("these are not the principal values");
}

void sums_of_eight(benchmark::State& state)
{
  Lanes x[lanes];
  for (int k = 0; k < lanes; ++k) x[k] = lane_numbers * static_cast<Real>(k + 1);
  Lanes total;

  for (auto _ : state) {
    benchmark::DoNotOptimize(x);
    // As many at a time as a register holds.
    for (int first = 0; first < lanes; first += part_lanes) {
      LanePart all{};
      for (int part = 0; part < lanes; part += part_lanes) {
        LanePart some[part_lanes];
        for (int k = 0; k < part_lanes; ++k) some[k] = part_of(x[first + k], part);
        all += sums(some);
      }
      set_part(total, first, all);
    }
    benchmark::DoNotOptimize(total);
  }
  state.SetItemsProcessed(state.iterations() * lanes);

  for (int k = 0; k < lanes; ++k)
    if (total[k] != 28 * (k + 1)) state.SkipWithError("these are not the sums");
}

}  // namespace

void add_lane_kernels()
{
  benchmark::RegisterBenchmark("principal_axes", axes_of_eight);
  benchmark::RegisterBenchmark("sums", sums_of_eight);
}

}  // namespace berm
