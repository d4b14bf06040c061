// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "material/increment.hpp"
#include "material/tangent.hpp"
#include "samples/critical_state_soils.hpp"

#include <gtest/gtest.h>
#include <random>

namespace berm::material {

/// A soil element that begins under a stress, Pa, with the state of soil at rest. Strains are compression positive: axial is yy.
template <class L>
struct Element {
  L law;
  decltype(prepare(std::declval<L>())) prepared = prepare(law);
  SymTensor<3> stress;
  Real state[L::state_size] = {};
  Real volumetric = 0;  ///< sum of the volumetric strain

  Element(const L& soil, const SymTensor<3>& begin) : law(soil), stress(begin) { initial_state(law, begin, state); }

  void compress(Real axial, Real across, Real out_of_plane)
  {
    update(prepared, stress, Increment<3, Real>{{{-across, -axial, -out_of_plane}}}, state);
    volumetric += axial + across + out_of_plane;
  }
  void compress(Real axial, Real across) { compress(axial, across, across); }
  Real pressure() const { return -trace(stress) / 3; }
  Real q() const
  {
    SymTensor<3> s = stress;
    for (int k = 0; k < 3; ++k) s[k] += pressure();
    return std::sqrt(1.5 * double_dot(s, s));
  }
  Real ratio() const { return q() / pressure(); }
};

inline SymTensor<3> isotropic(Real pressure)
{
  return {{-pressure, -pressure, -pressure}};
}

template <class L>
void shear_undrained(Element<L>& soil, Real strain, int steps)
{
  for (int k = 0; k < steps; ++k) soil.compress(strain / steps, -0.5 * strain / steps);
}

/// A step of the drained triaxial test: the stress across stays, by the secant method.
template <class L>
void shear_drained(Element<L>& soil, Real axial)
{
  const Element<L> begin = soil;
  const auto missing = [&](Real across) {
    soil = begin;
    soil.compress(axial, across);
    return soil.stress[0] - begin.stress[0];
  };
  Real a = 0, b = -0.5 * axial, at_a = missing(a), at_b = missing(b);
  for (int k = 0; k < 60 && std::abs(at_b) > 1e-9 * begin.pressure(); ++k) {
    const Real c = b - at_b * (b - a) / (at_b - at_a);
    a = b, at_a = at_b;
    b = c, at_b = missing(c);
  }
}

/// A stress in compression, 10 Pa to 1 MPa, whose q / p' is up to that of the critical state.
template <int dim>
SymTensor<dim> random_stress(std::mt19937_64& random, Real slope)
{
  std::uniform_real_distribution<Real> unit(-1, 1), decades(1, 6);
  const Real pressure = std::pow(10, decades(random));
  SymTensor<dim> stress;
  for (int k = 0; k < tensor_size<dim>; ++k) stress[k] = unit(random);
  const Real mean = trace(stress) / 3;
  for (int k = 0; k < 3; ++k) stress[k] -= mean;
  const Real part = slope * std::abs(unit(random)) * pressure / std::sqrt(1.5 * double_dot(stress, stress));
  for (int k = 0; k < tensor_size<dim>; ++k) stress[k] = part * stress[k] - (k < 3 ? pressure : 0);
  return stress;
}

/// A strain of either sign in all directions, from 1e-8 to `largest`.
template <int dim>
SymTensor<dim> random_strain(std::mt19937_64& random, Real largest)
{
  std::uniform_real_distribution<Real> unit(-1, 1), decades(-8, std::log10(largest));
  const Real size = std::pow(10, decades(random));
  SymTensor<dim> strain;
  for (int k = 0; k < tensor_size<dim>; ++k) strain[k] = size * unit(random);
  return strain;
}

template <int dim>
SymTensor<3> in_space(const SymTensor<dim>& stress)
{
  SymTensor<3> all;
  std::copy_n(stress.c, tensor_size<dim>, all.c);
  return all;
}

/// One block of particles, by lanes and one by one. A law that chooses its pieces by their error takes others for large strains, where rounding decides.
template <class L>
void expect_lanes_like_single_numbers(const L& law, Real slope, Real largest_strain = 0.1)
{
  std::mt19937_64 random(13);
  const auto prepared = prepare(law);
  for (int block = 0; block < 1000; ++block) {
    SymTensor<2, Lanes> stresses, turned;
    Increment<2, Lanes> increments, turned_increments;
    Lanes states[L::state_size], turned_states[L::state_size];
    SymTensor<2> stress[lanes], strain[lanes];
    Real state[lanes][L::state_size] = {};
    for (int l = 0; l < lanes; ++l) {
      stress[l] = random_stress<2>(random, slope);
      strain[l] = random_strain<2>(random, largest_strain);
      initial_state(law, in_space(stress[l]), state[l]);
    }
    for (int l = 0; l < lanes; ++l) {
      const int other = (l + 1) % lanes;
      for (int k = 0; k < 4; ++k) {
        stresses[k][l] = stress[l][k], turned[k][l] = stress[other][k];
        increments.strain[k][l] = strain[l][k], turned_increments.strain[k][l] = strain[other][k];
      }
      for (int k = 0; k < L::state_size; ++k) states[k][l] = state[l][k], turned_states[k][l] = state[other][k];
    }
    update(prepared, stresses, increments, states);
    update(prepared, turned, turned_increments, turned_states);
    for (int l = 0; l < lanes; ++l) {
      update(prepared, stress[l], Increment<2, Real>{strain[l]}, state[l]);
      const Real size = 1e-9 * std::sqrt(double_dot(stress[l], stress[l]));
      for (int k = 0; k < 4; ++k) {
        // The compiler may fuse products and sums in one form and not in the other; near a corner of the surface the iteration makes more of it.
        ASSERT_NEAR(stresses[k][l], stress[l][k], size);
        ASSERT_EQ(turned[k][l], stresses[k][(l + 1) % lanes]) << "a lane knows nothing of its neighbours";
      }
      for (int k = 0; k < L::state_size; ++k) {
        ASSERT_NEAR(states[k][l], state[l][k], 1e-9 * std::abs(state[l][k]));
        ASSERT_EQ(turned_states[k][l], states[k][(l + 1) % lanes]);
      }
    }
  }
}

/// The tangent against central differences, where two of these agree: they do not where the increment ends at a corner or changes the number of its pieces.
template <class L>
void expect_tangent_of_differences(const L& law, Real slope, Real largest_strain)
{
  std::mt19937_64 random(17);
  const auto prepared = prepare(law);
  int checked = 0, yielding = 0;
  constexpr int count = 3000;
  for (int n = 0; n < count; ++n) {
    const SymTensor<2> begin = random_stress<2>(random, slope);
    SymTensor<2> strain = random_strain<2>(random, largest_strain);
    strain[2] = 0;
    Real at_rest[L::state_size] = {};
    initial_state(law, in_space(begin), at_rest);
    const auto end_of = [&](const SymTensor<2>& by) {
      SymTensor<2> stress = begin;
      Real state[L::state_size];
      std::copy_n(at_rest, L::state_size, state);
      update(prepared, stress, Increment<2, Real>{by}, state);
      return stress;
    };
    const auto by_differences = [&](Real h) {
      Tangent tangent;
      for (int j = 0; j < 3; ++j) {
        SymTensor<2> plus = strain, minus = strain;
        plus[j < 2 ? j : 3] += j < 2 ? h : h / 2;
        minus[j < 2 ? j : 3] -= j < 2 ? h : h / 2;
        const SymTensor<2> more = end_of(plus), less = end_of(minus);
        for (int k = 0; k < 4; ++k) tangent(k, j) = (more[k] - less[k]) / (2 * h);
      }
      return tangent;
    };
    SymTensor<2> stress = begin;
    Real state[L::state_size];
    std::copy_n(at_rest, L::state_size, state);
    Tangent tangent;
    update_stress_and_tangent(prepared, stress, {strain}, state, tangent);
    for (int k = 0; k < 4; ++k) ASSERT_NEAR(stress[k], end_of(strain)[k], 1e-9 * std::sqrt(double_dot(stress, stress)));
    // Smaller than the strain: many of these soils begin at yield, where shorter steps of either sign end in different parts of the law.
    const Real h = 1e-4 * std::sqrt(double_dot(strain, strain));
    const Tangent wide = by_differences(2 * h), narrow = by_differences(h);
    const Real size = narrow.cwiseAbs().maxCoeff();
    if ((wide - narrow).cwiseAbs().maxCoeff() > 1e-5 * size) continue;
    ASSERT_LE((tangent - narrow).cwiseAbs().maxCoeff(), 1e-4 * size) << tangent << "\n\n" << narrow;
    ++checked;
    yielding += state[0] != at_rest[0];
  }
  EXPECT_GT(checked, count / 2);
  EXPECT_GT(yielding, count / 10);
}

/// The work of random increments is at most that of the moduli that the time step is made for, but for a part that flow may add where it is not associated.
template <class L>
void expect_no_stiffness_beyond_that_of_the_time_step(const L& law, Real slope, Real of_flow)
{
  std::mt19937_64 random(19);
  const Elasticity stiffest = elasticity(law);
  for (int n = 0; n < 20000; ++n) {
    const SymTensor<3> begin = random_stress<3>(random, slope), strain = random_strain<3>(random, 1e-2);
    if (-trace(begin) / 3 < law.min_pressure) continue;
    Element<L> soil(law, begin);
    update(soil.prepared, soil.stress, Increment<3, Real>{strain}, soil.state);
    SymTensor<3> change = soil.stress, elastic{};
    for (int k = 0; k < 6; ++k) change[k] -= begin[k];
    add_elastic_stress(stiffest, elastic, strain);
    // The stress has the rounding of its own size.
    const Real rounding = 1e-12 * std::sqrt(double_dot(begin, begin) * double_dot(strain, strain));
    ASSERT_LE(double_dot(change, strain), double_dot(elastic, strain) * (1 + of_flow) + rounding) << n;
  }
}

}  // namespace berm::material
