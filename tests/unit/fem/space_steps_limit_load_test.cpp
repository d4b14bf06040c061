// SPDX-License-Identifier: BSD-3-Clause
#include "samples/space_footing.hpp"

#include "problem/stages.hpp"

#include <gtest/gtest.h>

namespace berm::fem::this_file {
namespace {

/// A stage on its way to its end.
struct Pushed {
  SpaceProblem problem;
  SpaceSteps steps;

  explicit Pushed(SpaceProblem of) : problem(std::move(of)), steps(problem.model, problem.state)
  {
    steps.find_first_equilibrium();
    while (!stage_ended(problem.model.model, problem.state.state)) steps.advance();
  }
  const bodies::RigidState<3>& rigid() const { return problem.state.state.rigid_bodies[0]; }
};

material::LinearElastic elastic(Real poisson_ratio)
{
  material::LinearElastic soil = elastic_soil();
  soil.young_modulus = 2 * (1 + poisson_ratio);  // G = 1 Pa
  soil.poisson_ratio = poisson_ratio;
  return soil;
}

/// Stiffness of a quarter of a disk of R = 1 m on elastic soil of G = 1 Pa against its movement along or about one axis; `odd`: vertical displacements are odd
/// in x, as under a horizontal force along x and a moment about z.
Real stiffness(Real poisson_ratio, int freedom, bool odd)
{
  const SpaceFooting disk{.cells = 4, .growth = 1.6, .far = 40, .soil = elastic(poisson_ratio)};
  settings::Case c = disk.settings();
  c.rigid[0].second.shape = bodies::CylinderSettings{{0, 5e-4, 0}, {0, 1, 0}, 2, 1e-3};  // a thin one, whose centre is that of its base
  c.symmetry.clear();
  c.support.push_back({"left", {"left", odd ? std::vector<std::string>{"y", "z"} : std::vector<std::string>{"x"}}});
  c.support.push_back({"back", {"back", {"z"}}});
  SpaceProblem p = build_in_space(c, disk.mesh());
  SpaceNewton newton(p.model);
  ElementLoads<3> loads;
  loads.rigid[freedom].value = 1e-3;
  std::vector<Real> change(static_cast<std::size_t>(p.model.unknowns()), 0.);
  EXPECT_TRUE(newton.find_equilibrium(p.state, loads, 0, change).converged);
  const Vec<3> force = freedom < 3 ? newton.assembly().reaction(0) : newton.assembly().torque(0);
  return -force[freedom % 3] / 1e-3;
}

TEST(SpaceSteps, column_under_its_weight_stays_in_equilibrium_with_k0)
{
  settings::Case c = block_in_space(plastic_soil(50e3, 0, 0));
  c.gravity = {0, -10, 0};
  c.body[0].second.k0 = 0.6;
  Pushed column(space_problem_of(c));
  // The shape functions balance a stress that grows linearly with depth but for rounding.
  EXPECT_LT(column.problem.state.unbalanced, 1e-9 * column.problem.model.weight);
  for (const Real u : column.problem.state.displacement) EXPECT_NEAR(u, 0, 1e-12);
}

/// The settlement of an elastic column under its weight: the mean over the nodes of its top, m.
Real settlement(Real cells)
{
  settings::Case c = block_in_space(elastic_soil(), cells);
  c.gravity = {0, -10, 0};
  const Pushed column(space_problem_of(c));
  Real sum = 0, count = 0;
  for (Index node = 0; node < column.problem.model.mesh.node_count(); ++node)
    if (column.problem.model.mesh.position[node][1] == 0) sum -= column.problem.state.displacement[3 * node + 1], ++count;
  return sum / count;
}

TEST(SpaceSteps, column_of_elastic_soil_settles_under_its_weight_with_an_error_of_second_order)
{
  // rho g H^2 / (2 M). A volumetric strain that is constant in an element does not follow the parabola within it: a quarter of the error for half the size.
  const Real exact = 1000 * 10 / (2 * oedometer_modulus);
  const Real coarse = settlement(2) - exact, fine = settlement(4) - exact;
  EXPECT_LT(std::abs(coarse), 0.1 * exact);
  EXPECT_NEAR(fine / coarse, 0.25, 0.08);
}

// The soil ends at 40 R, which stiffens it by about R/40; four elements across R, and growing ones outside, do so by some per cent.
constexpr Real of_ends_and_mesh = 0.04;

TEST(SpaceNewton, rough_disk_has_its_vertical_stiffness)
{
  constexpr Real nu = 0.3;
  const Real exact = 4 * std::log(3 - 4 * nu) / (1 - 2 * nu);
  EXPECT_NEAR(4 * stiffness(nu, 1, false), exact, of_ends_and_mesh * exact);
}

// The formulas of a smooth disk are exact for a rough one at nu = 1/2, where the vertical and the horizontal are not coupled.
constexpr Real incompressible = 0.499;

TEST(SpaceNewton, rough_disk_has_its_horizontal_stiffness)
{
  const Real exact = 32 * (1 - incompressible) / (7 - 8 * incompressible);
  EXPECT_NEAR(4 * stiffness(incompressible, 0, true), exact, of_ends_and_mesh * exact);
}

TEST(SpaceNewton, rough_disk_has_its_stiffness_against_a_moment)
{
  const Real exact = 8 / (3 * (1 - incompressible));
  EXPECT_NEAR(4 * stiffness(incompressible, 5, true), exact, of_ends_and_mesh * exact);
}

TEST(SpaceSteps, rough_circle_comes_to_its_limit_load)
{
  // 6.05 s_u (exact). The same element in a program of its own gave 6.25 with four cells across R at 0.03 R.
  material::MohrCoulomb clay = plastic_soil(1, 0, 0);
  clay.young_modulus = 1000;
  clay.poisson_ratio = 0.49;
  const SpaceFooting disk{.cells = 4, .soil = clay};
  settings::Case c = disk.settings();
  c.stage[0].until.embedment = 0.03;
  Pushed pushed(build_in_space(c, disk.mesh()));
  EXPECT_NEAR(pushed.rigid().reaction[1] / (pi / 4), 6.05, 0.05 * 6.05);
}

}  // namespace
}  // namespace berm::fem::this_file
