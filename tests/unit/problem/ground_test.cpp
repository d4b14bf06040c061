// SPDX-License-Identifier: BSD-3-Clause
// The ground that is not level: from the input, from a mesh, and embedment that counts from it.
#include "problem/ground.hpp"

#include "mesh/mesh_settings.hpp"
#include "problem/model.hpp"
#include "problem/stages.hpp"
#include "samples/sample_case.hpp"
#include "samples/temporary_folder.hpp"

#include <gtest/gtest.h>

namespace berm::problem::this_file {
namespace {

constexpr Real incline = 0.17632698070846498;  // tan 10 deg

mesh::SeabedMesh sloping_bed()
{
  mesh::SeabedMesh bed{.length = 2,
                       .depth = 0.6,
                       .headroom = 0.3,
                       .left = 1,
                       .near_size = 0.05,
                       .near_left = -0.3,
                       .near_right = 0.4,
                       .near_depth = 0.2,
                       .near_height = 0.1,
                       .far_size = {}};
  bed.slope = 10 * degree;
  return bed;
}

/// A pipe of 0.2 m that touches the slope, on a bed of that mesh.
settings::Case pipe_on(const mesh::MeshSettings& mesh)
{
  settings::Case c = pipe_over_box({stage_of(settings::StageKind::push, "push")});
  c.stage[0].velocity = 0.1;
  c.mesh = mesh;
  c.surface = 0;
  c.surface_given = false;
  c.gravity = {0, -10};
  c.body[0].second.block.reset();
  c.body[0].second.regions = {"near", "bed"};
  c.body[0].second.k0 = 0.5;
  c.support = {{"base", {"base", {"x", "y"}}}, {"left", {"left", {"x"}}}, {"right", {"right", {"x"}}}};
  c.rigid[0].second.shape = bodies::CircleSettings{{0, 0.1 / std::cos(10 * degree)}, 0.2};
  return c;
}

TEST(Ground, is_that_of_the_mesh_that_the_input_asks_for)
{
  const settings::Case c = pipe_on(sloping_bed());
  EXPECT_NEAR(ground_of(c).line.height(0.5), 0.5 * incline, 1e-15);
  EXPECT_TRUE(loads_by_gravity(c, ground_of(c)));
  mesh::SeabedMesh flat = sloping_bed();
  flat.slope = 0;
  EXPECT_TRUE(ground_of(pipe_on(flat)).line.level());
  EXPECT_FALSE(loads_by_gravity(pipe_on(flat), ground_of(pipe_on(flat))));
}

TEST(Ground, is_found_in_a_mesh_of_the_users)
{
  const TemporaryFolder folder;
  mesh::SeabedMesh bed = sloping_bed();
  bed.trench = mesh::Trench{.depth = 0.15, .width = 0.3, .side_slope = 60 * degree, .center = 0.1};
  const mesh::Mesh<2> mesh = mesh::make_mesh<2>(bed, ".", folder.path());
  settings::Case c = pipe_on(mesh::GmshFile{"mesh.msh"});
  const Ground found = ground_in(c, mesh, {});
  const mesh::GroundLine expected = ground_of(bed);
  ASSERT_EQ(found.line.corners.size(), expected.corners.size());
  for (std::size_t k = 0; k < expected.corners.size(); ++k) EXPECT_NEAR((found.line.corners[k] - expected.corners[k]).norm(), 0, 1e-9) << k;
  EXPECT_EQ(found.laid_down.corners, found.line.corners) << "a mesh does not say how the soil was laid down";
  EXPECT_TRUE(loads_by_gravity(c, found));
  c.surface_given = true;
  EXPECT_TRUE(ground_in(c, mesh, {}).laid_down.level()) << "depth in the soil counts from the level that the input names";
  EXPECT_FALSE(ground_in(c, mesh, {}).line.level());

  bed.slope = 0;
  bed.trench.reset();
  EXPECT_TRUE(ground_in(c, mesh::make_mesh<2>(bed, ".", folder.path()), {}).line.level());
}

// The nodes of the ground within the pipe's reach are put on its surface, as where a mesh is shaped around a pipe.
TEST(Ground, has_no_dent_where_the_mesh_is_shaped_around_the_pipe)
{
  const TemporaryFolder folder;
  mesh::Mesh<2> mesh = mesh::make_mesh<2>(sloping_bed(), ".", folder.path());
  const settings::Case c = pipe_on(mesh::GmshFile{"mesh.msh"});
  const Vec<2> center(0, 0.06);
  for (const Index i : mesh.boundary_nodes[mesh.find_boundary("surface")])
    if (Vec<2>& x = mesh.position[i]; (x - center).norm() < 0.1) x[1] = center[1] - std::sqrt(0.01 - x[0] * x[0]);
  EXPECT_LT(ground_in(c, mesh, {}).line.height(0), -0.03);
  const Ground found = ground_in(c, mesh, {bodies::Circle<2>{center, 0.1}});
  for (const Real x : {-0.09, 0., 0.05}) EXPECT_NEAR(found.line.height(x), incline * x, 1e-9);
}

TEST(Embedment, counts_from_the_ground_below_the_axis_of_the_pipe_where_it_is)
{
  const TemporaryFolder folder;
  const settings::Case c = pipe_on(sloping_bed());
  Problem<2> problem = build<2>(c, ".", folder.path().string());
  const Real touches = 0.1 - 0.1 / std::cos(10 * degree);
  EXPECT_NEAR(travel_of(problem.model, problem.state, 0).w, touches, 1e-15);
  problem.state.rigid_bodies[0].displacement = Vec<2>(0.3, 0.3 * incline);
  EXPECT_NEAR(travel_of(problem.model, problem.state, 0).w, touches, 1e-15) << "along the slope it stays";
  problem.state.rigid_bodies[0].displacement = Vec<2>(0.3, 0);
  EXPECT_NEAR(travel_of(problem.model, problem.state, 0).w, touches + 0.3 * incline, 1e-15) << "on a level way it comes deeper";
}

TEST(Embedment, counts_from_the_level_that_the_input_names)
{
  const TemporaryFolder folder;
  settings::Case c = pipe_on(sloping_bed());
  c.surface_given = true;
  Problem<2> problem = build<2>(c, ".", folder.path().string());
  problem.state.rigid_bodies[0].displacement = Vec<2>(0.3, 0);
  EXPECT_NEAR(travel_of(problem.model, problem.state, 0).w, 0.1 - 0.1 / std::cos(10 * degree), 1e-15);
}

TEST(Strength, counts_its_depth_from_the_ground_before_the_trench)
{
  const TemporaryFolder folder;
  mesh::SeabedMesh bed = sloping_bed();
  bed.trench = mesh::Trench{.depth = 0.15, .width = 0.3, .side_slope = 60 * degree, .center = 0};
  const Problem<2> problem = build<2>(pipe_on(bed), ".", folder.path().string());
  EXPECT_NEAR(problem.model.soil_depth(Vec<2>(0.05, -0.2)), 0.2 + 0.05 * incline, 1e-15);
  EXPECT_NEAR(problem.model.surface_at(Vec<2>(0.05, 0)), -0.15 + 0.05 * incline, 1e-15);
  const Ground& ground = problem.model.ground;
  EXPECT_NEAR(ground.soil_depth_at(0.05, 0.1, 0), 0.25, 1e-15) << "the lowest point of a pipe with w = 0.1 m in the trench";
  EXPECT_NEAR(ground.soil_depth_at(0.5, 0.1, 0), 0.1, 1e-15) << "on the slope beside it";
  EXPECT_EQ(Ground{}.soil_depth_at(0.5, 0.1, 7), 0.1) << "on a level bed";
}

}  // namespace
}  // namespace berm::problem::this_file
