// SPDX-License-Identifier: BSD-3-Clause
#include "contact/contact_law.hpp"
#include "kernels.hpp"

#include <benchmark/benchmark.h>
#include <fmt/format.h>
#include <vector>

namespace berm {
namespace {

/// Relative velocity of a point along its surface and towards it, m/s, and what comes of it.
struct Approach {
  const char* name;
  Real along, towards;
  contact::ContactStatus status;
};

constexpr Approach approaches[] = {{"open", 0.3, -0.1, contact::ContactStatus::open},
                                   {"sticks", 0.02, 0.1, contact::ContactStatus::sticking},
                                   {"slides", 0.3, 0.1, contact::ContactStatus::slipping}};

template <int dim>
void correct_points(benchmark::State& state, const Approach& approach)
{
  constexpr int count = 256;
  constexpr Real mass = 0.2, turn = 0.05;
  const contact::Interface interface = {.friction = 0.43, .adhesion_impulse = 0, .allowed_approach = 0.01};
  std::vector<Vec<dim>> normal(count, Vec<dim>::Zero()), relative(count), impulse(count);
  for (int p = 0; p < count; ++p) {
    Vec<dim> along = Vec<dim>::Zero();
    normal[p].template head<2>() << std::cos(turn * p), std::sin(turn * p);
    along.template head<2>() << -normal[p][1], normal[p][0];
    relative[p] = approach.along * along - approach.towards * normal[p];
  }
  const Vec<dim> before = Vec<dim>::Zero();

  for (auto _ : state) {
    for (int p = 0; p < count; ++p) impulse[p] = contact_impulse<dim>(relative[p], normal[p], {mass, mass}, interface, before);
    benchmark::DoNotOptimize(impulse.data());
    benchmark::ClobberMemory();
  }
  state.SetItemsProcessed(state.iterations() * count);

  for (int p = 0; p < count; ++p)
    if (status_of<dim>(impulse[p], normal[p], interface) != approach.status) state.SkipWithError("a point does something else");
}

}  // namespace

void add_contact_kernels()
{
  for (const Approach& approach : approaches) {
    benchmark::RegisterBenchmark(fmt::format("contact_2D/{}", approach.name).c_str(), correct_points<2>, approach);
    benchmark::RegisterBenchmark(fmt::format("contact_3D/{}", approach.name).c_str(), correct_points<3>, approach);
  }
}

}  // namespace berm
