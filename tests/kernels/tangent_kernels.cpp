// SPDX-License-Identifier: BSD-3-Clause
#include "kernels.hpp"
#include "material/tangent.hpp"
#include "trial_stresses.hpp"

#include <benchmark/benchmark.h>
#include <fmt/format.h>

namespace berm {
namespace {

void differentiate_point(benchmark::State& state, const Trial& trial)
{
  const material::PreparedMohrCoulomb law = trial_sand();
  SymTensor<2> begin = turned<2>(trial, 0.3), strain, end;
  material::Tangent tangent;

  for (auto _ : state) {
    benchmark::DoNotOptimize(begin);
    benchmark::DoNotOptimize(strain);
    Real opening = 0;
    end = begin;
    update_stress_and_tangent(law, end, {strain}, &opening, tangent);
    benchmark::DoNotOptimize(end);
    benchmark::DoNotOptimize(opening);
    benchmark::DoNotOptimize(tangent);
  }
  state.SetItemsProcessed(state.iterations());

  if (!ends_there(trial, begin, end)) state.SkipWithError("the return ends elsewhere");
  const bool stiff = tangent.norm() > 0.01 * law.elastic.shear;
  if (stiff == (trial.equal == 2)) state.SkipWithError("stiffness at the apex, or none elsewhere");
}

}  // namespace

void add_tangent_kernels()
{
  for (const Trial& trial : trials) benchmark::RegisterBenchmark(fmt::format("tangent/{}", trial.name).c_str(), differentiate_point, trial);
}

}  // namespace berm
