// SPDX-License-Identifier: BSD-3-Clause
#include "fem/remesher.hpp"

#include "os/error.hpp"
#include "samples/fem_sample_bed.hpp"
#include "samples/fem_sample_problem.hpp"

#include <gtest/gtest.h>

namespace berm::fem::this_file {
namespace {

/// A pipe of 0.4 m, its lowest point 0.1 m below the bed, in soil of a stress that is linear in space and deformed smoothly.
class Remeshing : public testing::Test {
protected:
  Remeshing()
  {
    c.fem.large_deformation = true;
    c.fem.contact_size = 0.04;
    c.stage = {resting(1)};
    problem = build_fem(c, ".", folder.path().string());
    for (Index node = 0; node < model().mesh.node_count(); ++node) {
      const Vec<2> u = displacement(model().mesh.position[node]);
      for (int d = 0; d < 2; ++d) state().displacement[2 * node + d] = u[d];
    }
    for (Index cell = 0; cell < model().mesh.cell_count(); ++cell) {
      AtSixNodes<Vec<2>> now;
      for (int k = 0; k < 6; ++k) now[k] = position_now(model(), state(), model().mesh.nodes[cell][k]);
      for (int q = 0; q < triangle_points; ++q) state().points[cell][q].stress = stress_at(position_of(shape_at(now, q), now));
    }
    place_contact(model(), state());
  }
  /// None at the walls, the base and the pipe.
  static Vec<2> displacement(const Vec<2>& x)
  {
    const Real from_pipe = (x - Vec<2>(0.03, 0.1)).norm() - 0.2;
    return Vec<2>(0, 0.05) * (x[0] + 1.4) * (1.6 - x[0]) * (x[1] + 1) * from_pipe;
  }
  static SymTensor<2> stress_at(const Vec<2>& x)
  {
    SymTensor<2> stress;
    stress[0] = -1e3 + 200 * x[0] + 3e3 * x[1], stress[1] = -2e3 + 5e3 * x[1], stress[2] = -1e3, stress[3] = 100 - 50 * x[0];
    return stress;
  }
  FemModel& model() { return problem.model; }
  FemState& state() { return problem.state; }

  TemporaryFolder folder;
  settings::Case c = bed_around(pipe_at(0.1));
  FemProblem problem;
};

Real area_now(const FemModel& model, const FemState& state)
{
  QuadraticMesh now = model.mesh;
  for (Index node = 0; node < now.node_count(); ++node) now.position[node] = position_now(model, state, node);
  return area_of(now);
}

// A stress that is linear in space is linear in each element but for its curved sides: a second derivative of 0.2/m bends one of 0.2 m by 1 mm, which is 5 Pa, and twice that where it is drawn out.
TEST_F(Remeshing, keeps_a_linear_stress_and_the_area_and_where_the_soil_was)
{
  const Real area = area_now(model(), state());
  Remesher(c, folder.path()).remesh(model(), state());
  EXPECT_NEAR(area_now(model(), state()), area, 1e-4 * area);
  Real largest = 0, farthest = 0;
  for (Index cell = 0; cell < model().mesh.cell_count(); ++cell) {
    const AtSixNodes<Vec<2>> nodes = model().mesh.positions_of(cell);
    for (int q = 0; q < triangle_points; ++q) {
      const SymTensor<2> there = stress_at(position_of(model().shape[cell][q], nodes));
      for (int k = 0; k < 4; ++k) largest = std::max(largest, std::abs(state().points[cell][q].stress[k] - there[k]));
    }
  }
  EXPECT_LT(largest, 10) << "of stresses of 5000 Pa";
  for (Index node = 0; node < model().mesh.node_count(); ++node) {
    const Vec<2> first = state().place_at(Moment::start)[node];
    farthest = std::max(farthest, (first + displacement(first) - model().mesh.position[node]).norm());
  }
  EXPECT_LT(farthest, 1e-3) << "m, of displacements of up to 0.05 m on elements of 0.04 to 0.2 m";
}

TEST_F(Remeshing, leaves_contact_on_the_circle_and_walls_and_base_where_they_are)
{
  Remesher(c, folder.path()).remesh(model(), state());
  int in_contact = 0;
  for (const FemContactPoint& point : model().contact) {
    const Real away = (model().mesh.position[point.node] - Vec<2>(0.03, 0.1)).norm() - 0.2;
    EXPECT_GT(away, -1e-12);
    in_contact += std::abs(away) < 1e-12;
  }
  EXPECT_GT(in_contact, 15) << "an arc of 0.42 m in sides of 0.02 to 0.04 m, each with its middle";
  const NodeField<std::uint8_t>& fixed = model().mesh.fixed.front();
  for (Index node = 0; node < model().mesh.node_count(); ++node) {
    const Vec<2>& x = model().mesh.position[node];
    const bool at_wall = x[0] == -1.4 || x[0] == 1.6, at_base = x[1] == -1;
    EXPECT_EQ(fixed[node], at_base ? 3 : at_wall ? 1 : 0) << x.transpose();
  }
}

TEST_F(Remeshing, makes_the_same_mesh_twice)
{
  FemProblem other = problem;
  Remesher(c, folder.path()).remesh(model(), state());
  Remesher(c, folder.path()).remesh(other.model, other.state);
  ASSERT_EQ(other.model.mesh.node_count(), model().mesh.node_count());
  for (Index node = 0; node < model().mesh.node_count(); ++node)
    EXPECT_EQ((other.model.mesh.position[node] - model().mesh.position[node]).norm(), 0);
}

TEST_F(Remeshing, is_due_after_a_travel_of_the_body)
{
  const Remesher remesher(c, folder.path());
  EXPECT_FALSE(remesher.is_due(model(), state()));
  state().state.rigid_bodies[model().rigid].displacement = {0.005, -0.005};
  EXPECT_FALSE(remesher.is_due(model(), state()));
  state().state.rigid_bodies[model().rigid].displacement = {0.006, -0.006};
  EXPECT_TRUE(remesher.is_due(model(), state())) << "8.5 mm of 0.02 x 0.4 m";
}

TEST(Remesher, refuses_what_it_cannot_mesh)
{
  settings::Case boxed = block_of(elastic_soil());
  EXPECT_THROW(Remesher(boxed, "."), KeyError);
  settings::Case apart = bed_around(pipe_at(0.1));
  fill_regions_apart(apart);
  EXPECT_THROW(Remesher(apart, "."), KeyError);
  EXPECT_THROW(Remesher(bed_around(bodies::PolygonSettings{{-0.1, 0.1, 0}, {0, 0, 0.2}}), "."), KeyError);
  settings::Case trial = bed_around(pipe_at(0.1));
  trial.safety.emplace();
  EXPECT_THROW(Remesher(trial, "."), KeyError);
}

TEST(LargeDeformation, needs_a_body_and_soil_whose_water_does_not_flow)
{
  settings::Case alone = bed_around(pipe_at(0.1));
  alone.fem.large_deformation = true;
  alone.contact.clear();
  EXPECT_NE(refusal_of([&] { fem_problem_of(alone); }).find("needs a rigid body in contact"), std::string::npos);
}

}  // namespace
}  // namespace berm::fem::this_file
