// SPDX-License-Identifier: BSD-3-Clause
#include "kernels/roofline_kernel.hpp"

#include "kernels/bare_step.hpp"

#include <tuple>

namespace berm::roofline {
namespace {

using Clock = std::chrono::steady_clock;

/// Calls `round` at least once and for at least `seconds`; gives the time and the number of rounds.
template <class Round>
std::pair<Real, BigIndex> time_of(Real seconds, const Round& round)
{
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
RooflineRun run_roofline_kernel(const mesh::Mesh<dim>& mesh, const bodies::Particles<dim>& particles, Real seconds)
{
  Bare<dim> bare(mesh, particles);
  RooflineRun run;
  run.cells = bare.cell_count();
  bare.for_each_part([&](const auto& part) {
    run.particles += std::min<Index>(part.left, part.size);
    run.lanes += part.size;
  });
  Timings timings;
  const Timings::Use use(timings);
  bare.step();  // warm-up
  timings.clear();
  std::tie(run.wall_s, run.steps) = time_of(seconds, [&] { bare.step(); });
  run.loops = timings.table();
  run.checksum = bare.checksum();
  return run;
}

template RooflineRun run_roofline_kernel(const mesh::Mesh<2>&, const bodies::Particles<2>&, Real);
template RooflineRun run_roofline_kernel(const mesh::Mesh<3>&, const bodies::Particles<3>&, Real);

Real triad_bandwidth(BigIndex bytes, Real seconds)
{
  const auto count = static_cast<Index>(bytes / 3 / static_cast<BigIndex>(sizeof(Real)));
  std::vector<Real> a(count), b(count), c(count);
  for_each("triad", count, [&](Index i) { a[i] = 0, b[i] = i, c[i] = 2. * i; });
  const auto round = [&] { for_each("triad", count, [&](Index i) { a[i] = b[i] + 1.5 * c[i]; }); };
  round();  // warm-up
  const auto [wall, rounds] = time_of(seconds, round);
  return static_cast<Real>(3 * sizeof(Real)) * count * static_cast<Real>(rounds) / wall;
}

}  // namespace berm::roofline
