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

// Six elements meet at a corner, so the mean of +1 and -1 there is a third or so by size.
TEST_F(Remeshing, smooths_a_stress_that_alternates_from_element_to_element)
{
  for (Index cell = 0; cell < model().mesh.cell_count(); ++cell)
    for (SoilPoint& point : state().points[cell]) {
      point.stress = {};
      point.stress[0] = cell % 2 == 0 ? 1e3 : -1e3;
    }
  Remesher(c, folder.path()).remesh(model(), state());
  Real sum = 0;
  for (Index cell = 0; cell < model().mesh.cell_count(); ++cell)
    for (const SoilPoint& point : state().points[cell]) sum += point.stress[0] * point.stress[0];
  EXPECT_LT(std::sqrt(sum / static_cast<Real>(triangle_points * model().mesh.cell_count())), 500) << "Pa, of 1000 Pa";
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

TEST_F(Remeshing, has_walls_at_both_ends_of_the_soil_and_is_due_where_ground_goes_beyond_one)
{
  const std::vector<Wall> walls = walls_of(model(), state());
  ASSERT_EQ(walls.size(), 2u) << "the base holds the soil, too, but not at its left or right end";
  for (const Wall& wall : walls) EXPECT_EQ(wall.inwards, wall.x == -1.4 ? 1 : -1) << wall.x;
  EXPECT_FALSE(is_beyond_wall(model(), state()));
  for (const BoundarySide& side : model().mesh.boundary_sides)
    if (is_ground(model().model.mesh, side) && model().mesh.position[side.middle][0] > 1.4) state().displacement[2 * side.middle] = 1;
  EXPECT_TRUE(is_beyond_wall(model(), state()));
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
  state().state.rigid_bodies[model().model.main_rigid].displacement = {0.01, -0.01};
  EXPECT_FALSE(remesher.is_due(model(), state()));
  state().state.rigid_bodies[model().model.main_rigid].displacement = {0.012, -0.012};
  EXPECT_TRUE(remesher.is_due(model(), state())) << "17 mm of 0.04 x 0.4 m";
}

/// The problem of this case, remeshed at once, all ground near the body in contact with it.
FemProblem remeshed(settings::Case c)
{
  const TemporaryFolder folder;
  c.fem.large_deformation = true;
  c.stage = {resting(1)};
  FemProblem problem = build_fem(c, ".", folder.path().string());
  for (std::size_t k = 0; k < problem.model.contact.size(); ++k) problem.state.contact[k].traction = problem.model.contact[k].normal;
  Remesher(c, folder.path()).remesh(problem.model, problem.state);
  return problem;
}

/// The bed around the pipe, its water flowing.
settings::Case consolidating_bed()
{
  settings::Case c = bed_around(pipe_at(0.1));
  c.fem.large_deformation = true;
  c.fem.contact_size = 0.04;
  c.stage = {resting(1)};
  material::LinearElastic& soil = *c.material[0].second.get_if<material::LinearElastic>();
  soil.water = material::PoreWater{};
  soil.water->drainage = material::Drainage::consolidation;
  soil.water->porosity = 0.4;
  soil.water->permeability = 1e-6;
  return c;
}

// Pressures at the corners of straight sides are linear in each element, and so are those read from them; at the curved side of the pipe the linear functions of the corners are not those of space: 10 Pa of 6000.
TEST(Remesher, keeps_a_linear_pore_pressure)
{
  const TemporaryFolder folder;
  const settings::Case c = consolidating_bed();
  FemProblem problem = build_fem(c, ".", folder.path().string());
  const auto pressure = [](const Vec<2>& x) { return 1e3 * x[0] - 4e3 * x[1]; };
  const auto each = [&](const auto& visit) {
    const FemModel& model = problem.model;
    for (Index node = 0; node < model.mesh.node_count(); ++node)
      if (const Index unknown = model.flow.unknown[node]; unknown != none) visit(unknown, pressure(model.mesh.position[node]));
  };
  each([&](Index unknown, Real p) { problem.state.displacement[unknown] = p; });
  Remesher(c, folder.path()).remesh(problem.model, problem.state);
  int count = 0;
  each([&](Index unknown, Real p) {
    EXPECT_NEAR(problem.state.displacement[unknown], p, 10);
    ++count;
  });
  EXPECT_GT(count, 100);
}

TEST(Remesher, content_is_the_energy_and_area_of_the_soil)
{
  const TemporaryFolder folder;
  settings::Case c = bed_around(pipe_at(0.1));
  c.fem.large_deformation = true;
  c.stage = {resting(1)};
  FemProblem problem = build_fem(c, ".", folder.path().string());
  constexpr Real p = 2e3, t = 1e3;
  for (auto& points : problem.state.points)
    for (SoilPoint& point : points) {
      point.stress = {};
      for (int k = 0; k < 3; ++k) point.stress[k] = -p;
      point.stress[3] = t;
    }
  const Content content = content_of(problem.model, problem.state);
  const material::Elasticity elastic = elasticity(problem.model.soil_at(0, 0));
  EXPECT_NEAR(content.area, area_of(problem.model.mesh), 1e-9);
  EXPECT_NEAR(content.energy / content.area, p * p / (2 * (elastic.lame + 2 * elastic.shear / 3)) + t * t / (2 * elastic.shear), 1e-9);
}

TEST(Remesher, goes_around_a_corner_of_the_body_in_short_sides)
{
  settings::Case c = bed_around(bodies::BoxSettings{{0, 0}, {0.4, 0.3}});
  c.fem.contact_size = 0.04;
  const FemProblem problem = remeshed(c);
  int near_corner = 0;
  for (const FemContactPoint& point : problem.model.contact) {
    const Vec<2>& x = problem.model.mesh.position[point.node];
    EXPECT_GT(surface_now(problem.model, 0, {}, x).distance, -1e-12);
    near_corner += (x - Vec<2>(0.2, -0.15)).norm() < 0.02;
  }
  EXPECT_GE(near_corner, 5) << "40 mm along the outline in sides of 10 to 15 mm, a quarter of the elements, with their middles";
}

TEST(Remesher, keeps_nodes_on_the_axis_and_the_tip_of_a_cone)
{
  settings::Case c = bed_around(bodies::ProfileSettings{{0, 0.2, 0.2, 0}, {-0.3, -0.1, 0.2, 0.2}});
  mesh::SeabedMesh& bed = std::get<mesh::SeabedMesh>(c.mesh);
  c.geometry = settings::Geometry::axisymmetric;
  bed.left = 0, bed.near_left = 0;
  std::erase_if(c.support, [](const auto& support) { return support.first == "left"; });
  const FemProblem problem = remeshed(c);
  Real highest = -infinity;
  int on_axis = 0;
  for (Index node = 0; node < problem.model.mesh.node_count(); ++node)
    if (const Vec<2>& x = problem.model.mesh.position[node]; x[0] == 0) highest = std::max(highest, x[1]), ++on_axis;
  EXPECT_GT(on_axis, 10);
  // An arc of radius r in a tip of half angle 45 degrees is (sqrt(2) - 1) r above the tip; r is a quarter of the elements of 0.02 m.
  EXPECT_NEAR(highest, -0.3 + (std::sqrt(2.) - 1) * 0.005, 1e-9);
}

TEST(Remesher, refuses_what_it_cannot_mesh)
{
  EXPECT_THROW(Remesher(plate_on_block(elastic_soil()), "."), KeyError) << "not cut along the plate";
  settings::Case of_gmsh = block_of(elastic_soil());
  of_gmsh.mesh = mesh::GmshFile{"block.msh"};
  EXPECT_THROW(Remesher(of_gmsh, "."), KeyError) << "no size of elements";
  settings::Case apart = bed_around(pipe_at(0.1));
  fill_regions_apart(apart);
  EXPECT_THROW(Remesher(apart, "."), KeyError);
  EXPECT_THROW(Remesher(bed_around(bodies::HalfPlaneSettings{{0, 0}, {0, -1}}), "."), KeyError);
  settings::Case trial = bed_around(pipe_at(0.1));
  trial.safety.emplace();
  EXPECT_THROW(Remesher(trial, "."), KeyError);
}

// Tractions of a block act on its new sides, whose lengths have no sum but that of the top.
TEST(Remesher, meshes_a_loaded_block_without_a_rigid_body)
{
  settings::Case c = block_of(elastic_soil());
  boundary::TractionSettings load;
  load.boundary = "top";
  load.stress = {0, -1e3};
  c.traction = {{"load", load}};
  const FemProblem problem = remeshed(c);
  EXPECT_NEAR(content_of(problem.model, problem.state).area, 0.5, 1e-12);
  Vec<2> sum = Vec<2>::Zero();
  for (const NodalLoad& one : problem.model.loads.front()) sum += one.force;
  EXPECT_NEAR(sum[1], -1e3, 1e-9);
  EXPECT_NEAR(sum[0], 0, 1e-9);
}

/// Presses the pipe into its contact nodes by this overlap, m.
void press(FemModel& model, FemState& state, Real overlap)
{
  for (std::size_t k = 0; k < model.contact.size(); ++k) {
    const Index node = model.contact[k].node;
    const bodies::SurfacePoint<2> surface = surface_now(model, 0, {}, model.mesh.position[node]);
    if (std::abs(surface.distance) > 1e-3) continue;
    const Vec<2> to = -(surface.distance + overlap) * surface.normal;
    for (int d = 0; d < 2; ++d) state.displacement[2 * node + d] = to[d];
    state.contact[k].gap = -overlap;
    state.contact[k].traction = surface.normal;
  }
}

// Each contact node overlaps by what compressed the spring there: a uniform pressure stays, but for the ends of the contact, where the old sides have a pressure at one end only.
TEST_F(Remeshing, keeps_the_pressure_of_the_contact)
{
  constexpr Real overlap = 1e-5;
  press(model(), state(), overlap);
  Remesher(c, folder.path()).remesh(model(), state());
  int kept = 0;
  for (std::size_t k = 0; k < model().contact.size(); ++k)
    if (state().contact[k].gap < 1e-3 && model().mesh.position[model().contact[k].node][1] < -0.03) {
      EXPECT_NEAR(state().contact[k].gap, -overlap, 1e-3 * overlap);
      ++kept;
    }
  EXPECT_GT(kept, 5);
}

TEST(Remesher, leaves_a_body_shut_that_is_pressed_into_consolidating_soil)
{
  const TemporaryFolder folder;
  const settings::Case c = consolidating_bed();
  FemProblem problem = build_fem(c, ".", folder.path().string());
  press(problem.model, problem.state, 1e-5);
  Remesher(c, folder.path()).remesh(problem.model, problem.state);
  int shut = 0;
  for (const BoundarySide& side : problem.model.contact_sides)
    if (problem.model.mesh.position[side.middle][1] < -0.03) {
      EXPECT_FALSE(problem.model.flow.open[0][side.from]) << problem.model.mesh.position[side.from].transpose();
      ++shut;
    }
  EXPECT_GT(shut, 5);
}

}  // namespace
}  // namespace berm::fem::this_file
