// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "element/run_test.hpp"
#include "material/mohr_coulomb.hpp"

namespace berm::element {

inline material::Material sand_of(Real friction, Real dilation, Real cohesion = 0)
{
  material::MohrCoulomb law;
  law.density = 1000;
  law.young_modulus = 30e6;
  law.poisson_ratio = 0.3;
  law.friction_angle = friction * pi / 180;
  law.dilation_angle = dilation * pi / 180;
  law.cohesion = cohesion;
  return law;
}

inline TestSettings test_of(TestKind kind, std::vector<Real> path)
{
  TestSettings test;
  test.name = "test";
  test.material = "sand";
  test.kind = std::move(kind);
  test.strain_path = std::move(path);
  return test;
}

inline StartStress isotropic(Real stress)
{
  return {.confining_stress = stress};
}

inline StartStress at_rest(Real vertical, Real k0)
{
  return {.vertical_stress = vertical, .k0 = k0};
}

}  // namespace berm::element
