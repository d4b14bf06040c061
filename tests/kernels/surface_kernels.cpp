// SPDX-License-Identifier: BSD-3-Clause
#include "bodies/rigid/rotation.hpp"
#include "bodies/rigid/triangle_faults.hpp"
#include "kernels.hpp"

#include <benchmark/benchmark.h>
#include <cmath>
#include <fmt/format.h>

namespace berm {
namespace {

/// A pipe of radius 0.2 m and length 20 m along a direction, 64 triangles around.
bodies::Triangles pipe_along(const Vec<3>& direction, Index count)
{
  constexpr Index around = 64;
  const Index rings = count / (2 * around) - 1;  // two fans close it
  const Vec<3> along = direction / direction.norm(), aside = bodies::cross(along, Vec<3>(0.6, 0, 0.8)), up = bodies::cross(along, aside);
  Matrix<3> turn;
  turn << along, aside / aside.norm(), up / up.norm();
  bodies::Triangles t;
  for (Index r = 0; r <= rings; ++r)
    for (Index k = 0; k < around; ++k) {
      const Real angle = 2 * pi * k / around;
      t.points.push_back(turn * Vec<3>(20. * r / rings, 0.2 * std::cos(angle), 0.2 * std::sin(angle)));
    }
  const Index begin = static_cast<Index>(t.points.size()), end = begin + 1, last = rings * around;
  t.points.push_back(Vec<3>::Zero());
  t.points.push_back(turn * Vec<3>(20, 0, 0));
  for (Index k = 0; k < around; ++k) {
    const Index next = (k + 1) % around;
    for (Index first = 0; first < last; first += around) {
      t.corners.push_back({first + k, first + next, first + around + k});
      t.corners.push_back({first + next, first + around + next, first + around + k});
    }
    t.corners.push_back({begin, next, k});
    t.corners.push_back({end, last + k, last + next});
  }
  return t;
}

void faults_of_pipe(benchmark::State& state, const Vec<3>& direction)
{
  const bodies::Triangles t = pipe_along(direction, static_cast<Index>(state.range(0)));
  std::string fault;

  for (auto _ : state) {
    fault = fault_of(t);
    benchmark::DoNotOptimize(fault);
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(t.corners.size()));

  if (!fault.empty()) state.SkipWithError(fault.c_str());
}

}  // namespace

void add_surface_kernels()
{
  for (const auto& [name, direction] : {std::pair{"along_x", Vec<3>(1, 0, 0)}, {"along_z", Vec<3>(0, 0, 1)}, {"slanted", Vec<3>(1, 2, 3)}})
    benchmark::RegisterBenchmark(fmt::format("faults_of_pipe/{}", name).c_str(), faults_of_pipe, direction)
        ->Unit(benchmark::kMillisecond)
        ->Arg(10'000)
        ->Arg(100'000)
        ->Arg(1'000'000);
}

}  // namespace berm
