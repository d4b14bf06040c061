// SPDX-License-Identifier: BSD-3-Clause
#include "../samples/anisotropic_clay.hpp"
#include "../samples/critical_state_soils.hpp"
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

/// The same of a law with a state under K0 with the strain of a step: unloading, or loading that yields (`loads`).
template <int dim, class Law>
void update_with_state(benchmark::State& state, const Law& law, bool loads)
{
  constexpr int count = lanes_of<WidePart>;
  constexpr Real strain_of_step = 1e-5;
  const SymTensor<3> at_rest{{-36e3, -50e3, -36e3}};
  Real state_at_rest[Law::state_size] = {};
  initial_state(law, at_rest, state_at_rest);
  const auto prepared = prepare(law);
  SymTensor<dim, WidePart> begin{}, end, strain{};
  WidePart begin_state[Law::state_size], end_state[Law::state_size];
  for (int k = 0; k < 3; ++k) begin[k] = at_rest[k] - WidePart{};
  for (int k = 0; k < Law::state_size; ++k) begin_state[k] = state_at_rest[k] - WidePart{};
  for (int l = 0; l < count; ++l) strain[1][l] = (loads ? -1 : 1) * (1 + 0.1 * l) * strain_of_step;

  for (auto _ : state) {
    benchmark::DoNotOptimize(begin);
    benchmark::DoNotOptimize(strain);
    SymTensor<dim, WidePart> stress = begin;
    std::copy_n(begin_state, Law::state_size, end_state);
    update(prepared, stress, {strain}, end_state);
    end = stress;
    benchmark::DoNotOptimize(end_state);
    benchmark::DoNotOptimize(end);
  }
  state.SetItemsProcessed(state.iterations() * count);
  for (int l = 0; l < count; ++l)
    if ((end_state[0][l] != begin_state[0][l]) != loads) state.SkipWithError("yields where it should not, or does not");
}

template <class Law>
void add_with_state(const char* name, const Law& law)
{
  for (const bool loads : {false, true}) {
    const char* what = loads ? "yields" : "elastic";
    benchmark::RegisterBenchmark(fmt::format("stress_2D/{}_{}", name, what).c_str(), update_with_state<2, Law>, law, loads);
    benchmark::RegisterBenchmark(fmt::format("stress_3D/{}_{}", name, what).c_str(), update_with_state<3, Law>, law, loads);
  }
}

template <class Law>
Law matsuoka_nakai(Law law)
{
  law.deviatoric_shape = material::DeviatoricShape::matsuoka_nakai;
  return law;
}

}  // namespace

void add_stress_kernels()
{
  for (const Trial& trial : trials) {
    benchmark::RegisterBenchmark(fmt::format("stress_2D/{}", trial.name).c_str(), update_part<2>, trial);
    benchmark::RegisterBenchmark(fmt::format("stress_3D/{}", trial.name).c_str(), update_part<3>, trial);
  }
  add_with_state("cam_clay", sample_cam_clay());
  add_with_state("norsand", sample_norsand());
  add_with_state("hypoplastic", sample_hypoplastic());
  add_with_state("ngi_adp", sample_ngi_adp(0));
  add_with_state("cam_clay_matsuoka_nakai", matsuoka_nakai(sample_cam_clay()));
  add_with_state("norsand_matsuoka_nakai", matsuoka_nakai(sample_norsand()));
}

}  // namespace berm
