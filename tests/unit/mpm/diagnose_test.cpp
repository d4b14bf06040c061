// SPDX-License-Identifier: BSD-3-Clause
#include "mpm/diagnose.hpp"

#include "mpm/moments.hpp"
#include "mpm/step.hpp"
#include "os/error.hpp"
#include "sample_problem.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace berm::mpm::this_file {
namespace {

constexpr Real not_a_number = std::numeric_limits<Real>::quiet_NaN();

template <class Dimension>
class Sound : public testing::Test {
};
using Dimensions = testing::Types<std::integral_constant<int, 2>, std::integral_constant<int, 3>>;
TYPED_TEST_SUITE(Sound, Dimensions);

template <class Steps>
std::string refusal(const Steps& steps)
{
  try {
    steps();
  } catch (const RunError& error) {
    return error.what();
  }
  return "";
}

/// A particle in the middle of a body that rests is spoilt after some steps; the next step has to name it.
template <int dim, class Spoil>
void expect_named(bool update_stress_first, const char* what, const Spoil& spoil)
{
  auto problem = problem_on<dim>(shaken_box<dim>(), sample_solid(), 0);
  problem.model.update_stress_first = update_stress_first;
  Workspace<dim> workspace(problem.model, problem.state);
  for (int n = 0; n < 3; ++n) step(problem.model, problem.state, workspace);
  bodies::Particles<dim>& particles = problem.state.particles[0];
  const Index cell = particles.occupied()[particles.occupied().size() / 2], block = particles.first_block(cell);
  const int id = particles.block(block).id[0];
  spoil(particles.block(block));
  sum_moments(problem.model.mesh, particles, workspace.grids[0]);  // as the step that had spoilt it
  const std::string message = refusal([&] { step(problem.model, problem.state, workspace); });
  for (const std::string& part : {fmt::format("particle {} of body \"body\"", id), fmt::format("in cell {}", cell), std::string(what),
                                  fmt::format("t = {:.6g} s (step 3)", problem.state.time), std::string("mpm.courant")})
    EXPECT_NE(message.find(part), std::string::npos) << part << " is not in: " << message;
  EXPECT_EQ(problem.state.step, 3);
  EXPECT_TRUE(update_stress_first || std::isfinite(problem.state.ledger.totals.internal + problem.state.ledger.totals.external));
}

TYPED_TEST(Sound, what_is_not_finite_of_one_particle_is_named_within_the_step_with_its_number_cell_and_time)
{
  constexpr int dim = TypeParam::value;
  constexpr bool last = false, first = true;
  expect_named<dim>(last, "its velocity is not a number", [](bodies::Block<dim>& p) { p.v[0][0] = not_a_number; });
  expect_named<dim>(last, "its velocity is infinite", [](bodies::Block<dim>& p) { p.v[dim - 1][0] = infinity; });
  expect_named<dim>(last, "its position is not a number", [](bodies::Block<dim>& p) { p.x[0][0] = not_a_number; });
  expect_named<dim>(last, "its volume is not a number", [](bodies::Block<dim>& p) { p.volume[0] = not_a_number; });
  expect_named<dim>(last, "its mass is not a number", [](bodies::Block<dim>& p) { p.mass[0] = not_a_number; });
  for (int k = 0; k < tensor_size<dim>; ++k)
    if (dim == 3 || k != 2)  // the stress across the plane makes no force: its work tells, a step later
      expect_named<dim>(last, "its stress is not a number", [&](bodies::Block<dim>& p) { p.stress[k][0] = not_a_number; });
  expect_named<dim>(first, "its velocity is not a number", [](bodies::Block<dim>& p) { p.v[0][0] = not_a_number; });
  expect_named<dim>(first, "its stress is not a number", [](bodies::Block<dim>& p) { p.stress[1][0] = not_a_number; });
}

TYPED_TEST(Sound, a_body_that_moves_and_strains_is_not_refused)
{
  constexpr int dim = TypeParam::value;
  auto problem = problem_on<dim>(shaken_box<dim>(), sample_solid(), 0);
  for_each_particle(problem.state.particles[0], [](bodies::Block<dim>& p, int l) { p.v[0][l] = 1e-3 * p.x[1][l]; });
  Workspace<dim> workspace(problem.model, problem.state);
  EXPECT_EQ(refusal([&] {
              for (int n = 0; n < 20; ++n) step(problem.model, problem.state, workspace);
            }),
            "");
}

/// A mesh of 1.5 m or more a side, and a rigid body in its middle that has moved by `moved`.
template <int dim>
std::string rigid_refusal(const bodies::RigidShapeSettings& shape, const Vec<dim>& moved)
{
  auto problem = problem_on<dim>(make_box<dim>(sample_box<dim>()), sample_solid(), 1);
  problem.model.rigid_bodies.push_back({"pipe", make_shape<dim>(shape)});
  problem.state.rigid_bodies.emplace_back();
  problem.state.rigid_bodies[0].displacement = moved;
  problem.state.time = 0.125;
  return refusal([&] { refuse_rigid_outside_mesh(problem.model, problem.state); });
}

TYPED_TEST(Sound, a_pipe_that_leaves_the_mesh_is_named_with_side_place_time_and_advice)
{
  constexpr int dim = TypeParam::value;
  const mesh::Mesh<dim> mesh = make_box<dim>(sample_box<dim>());
  const Vec<dim> middle = 0.5 * (mesh.lower + mesh.upper);
  const bodies::CircleSettings pipe{std::vector<Real>(middle.begin(), middle.end()), 0.2};
  const Real down = middle[1] - mesh.lower[1] - 0.1, right = mesh.upper[0] - middle[0] - 0.1;
  const auto x = [](Real by) { return Vec<dim>(by * Vec<dim>::UnitX()); };
  const auto y = [](Real by) { return Vec<dim>(by * Vec<dim>::UnitY()); };
  EXPECT_EQ(rigid_refusal<dim>(pipe, y(-0.999 * down)), "");
  const Real up = mesh.upper[1] - middle[1] + 0.1;
  EXPECT_EQ(rigid_refusal<dim>(pipe, y(0.999 * up)), "") << "a part of it is in the mesh";
  EXPECT_EQ(rigid_refusal<dim>(pipe, x(0.999 * right)), "");
  const std::pair<Vec<dim>, const char*> outside[] = {
      {y(-1.001 * down), "bottom"}, {y(1.001 * up), "top"}, {x(1.001 * right), "right side"}, {x(-1.001 * right), "left side"}};
  for (const auto& [moved, side] : outside) {
    const std::string message = rigid_refusal<dim>(pipe, moved);
    for (const char* part : {"rigid body \"pipe\" has left the mesh through its ", side, "t = 0.125 s", "make the mesh", "end the stage"})
      EXPECT_NE(message.find(part), std::string::npos) << part << " is not in: " << message;
  }
  EXPECT_NE(rigid_refusal<dim>(pipe, x(not_a_number)), "");
}

TYPED_TEST(Sound, a_rigid_body_that_began_beyond_a_side_may_stay_there)
{
  constexpr int dim = TypeParam::value;
  const mesh::Mesh<dim> mesh = make_box<dim>(sample_box<dim>());
  std::vector<Real> at_wall(mesh.lower.begin(), mesh.lower.end());
  EXPECT_EQ(rigid_refusal<dim>(bodies::CircleSettings{at_wall, 0.2}, Vec<dim>(-0.05 * Vec<dim>::UnitX() - 0.05 * Vec<dim>::UnitY())), "");
  std::vector<Real> up(dim, 0);
  up[1] = 1;
  EXPECT_EQ(rigid_refusal<dim>(bodies::HalfPlaneSettings{at_wall, up}, Vec<dim>(-Vec<dim>::UnitY())), "");
}

}  // namespace
}  // namespace berm::mpm::this_file
