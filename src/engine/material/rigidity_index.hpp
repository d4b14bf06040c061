// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/material/clay_test.cpp
#pragma once

#include "material/depth_profile.hpp"

namespace berm::material {

constexpr Real hard_clay = 5e5;  ///< Pa: what is stronger is rock

/// Young's modulus of undrained clay, Pa: as given, or by the rigidity index I_r = G / undrained_strength.
template <class Law>
Real young_modulus_of(const Law& law)
{
  return law.rigidity_index ? 2 * (1 + law.poisson_ratio) * *law.rigidity_index * law.undrained_strength : law.young_modulus;
}

/// The law with the strength at a depth (m) under the weight of the soil above (Pa), and the stiffness that goes with it.
template <class Law>
Law with_stiffness_at_depth(const Law& law, Real depth, Real weight_above)
{
  Law there = at_depth<Law>(law, depth, weight_above);
  there.young_modulus = young_modulus_of(there);
  there.rigidity_index.reset();
  return there;
}

/// Stiffness is given once, and a rigidity index has a strength at the surface.
template <class Law>
void check_rigidity_index(Describe& d, const std::string& path, const Law& law)
{
  const bool stiffness_given = law.young_modulus > 0 || law.young_modulus_gradient != 0 || !law.profile.young_modulus.empty();
  d.check(!law.rigidity_index || !stiffness_given, path + ".rigidity_index",
          "gives the stiffness, and so does young_modulus: leave one of them out");
  d.check(!law.rigidity_index || law.undrained_strength > 0, path + (law.shansep ? ".shansep.min_strength" : ".undrained_strength"),
          "must be above 0 at the surface where rigidity_index gives the stiffness: soil without strength would have no stiffness");
}

}  // namespace berm::material
