// SPDX-License-Identifier: BSD-3-Clause
#include "roofline/roofline_kernel.hpp"

#include "core/for_each.hpp"
#include "roofline/bare_step.hpp"

#include <algorithm>
#include <chrono>
#include <tuple>
#include <vector>

namespace berm::roofline {
namespace {

using Clock = std::chrono::steady_clock;

/// Calls `round` once for warming up, then at least once and for at least `seconds`; gives the time and the number of rounds.
template <class Round>
std::pair<Real, BigIndex> time_of(Real seconds, const Round& round)
{
  round();  // warm-up
  const Clock::time_point start = Clock::now();
  Real passed = 0;
  BigIndex rounds = 0;
  do {
    round();
    ++rounds;
    passed = std::chrono::duration<Real>(Clock::now() - start).count();
  } while (passed < seconds);
  return {passed, rounds};
}

}  // namespace

template <int dim>
RooflineRun run_roofline_kernel(BigIndex particles, int per_cell, Real seconds)
{
  const Real boxes = static_cast<Real>(particles) / per_cell / (dim == 2 ? 2 : 6);
  const auto side = static_cast<Index>(std::lround(dim == 2 ? std::sqrt(boxes) : std::cbrt(boxes)));
  Bare<dim> bare(std::max(side, 1), per_cell);
  RooflineRun run;
  run.cells = bare.cell_count();
  run.particles = run.cells * per_cell;
  std::tie(run.wall_s, run.steps) = time_of(seconds, [&] { bare.step(); });
  run.checksum = bare.checksum();
  return run;
}

template RooflineRun run_roofline_kernel<2>(BigIndex, int, Real);
template RooflineRun run_roofline_kernel<3>(BigIndex, int, Real);

Real triad_bandwidth(BigIndex bytes, Real seconds)
{
  const auto count = static_cast<Index>(bytes / 3 / static_cast<BigIndex>(sizeof(Real)));
  std::vector<Real> a(count), b(count), c(count);
  for_each("triad", count, [&](Index i) { a[i] = 0, b[i] = i, c[i] = 2. * i; });
  const auto [wall, rounds] = time_of(seconds, [&] { for_each("triad", count, [&](Index i) { a[i] = b[i] + 1.5 * c[i]; }); });
  return static_cast<Real>(3 * sizeof(Real)) * count * static_cast<Real>(rounds) / wall;
}

}  // namespace berm::roofline
