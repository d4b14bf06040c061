// SPDX-License-Identifier: BSD-3-Clause
#include "boundary/traction.hpp"

#include "mesh/box.hpp"
#include "os/error.hpp"

#include <gtest/gtest.h>

namespace berm::boundary::this_file {
namespace {

/// 2 m x 1 m (x 1 m), of which only y < 0.5 m is soil; boundary "surface" lies between soil and the rest.
template <int dim>
mesh::Mesh<dim> half_full()
{
  mesh::BoxMesh box;
  box.size.assign(dim, 1);
  box.size[0] = 2;
  box.cells.assign(dim, 2);
  box.cells[0] = 4;
  mesh::Mesh<dim> mesh = make_box<dim>(box);
  mesh.region_names = {"soil", "space"};
  for (Index cell = 0; cell < mesh.cell_count(); ++cell) mesh.region[cell] = mesh.centroid(cell)[1] < 0.5 ? 0 : 1;
  mesh.boundary_names.push_back("surface");
  mesh.boundary_nodes.emplace_back();
  for (Index i = 0; i < mesh.node_count(); ++i)
    if (mesh.position[i][1] == 0.5) mesh.boundary_nodes.back().push_back(i);
  return mesh;
}

template <int dim>
struct Load {
  Vec<dim> force = Vec<dim>::Zero(), moment = Vec<dim>::Zero();  ///< moment: sum of force[1] x
  Real area = 0;
};
template <int dim>
Load<dim> load_of(const TractionSettings& traction)
{
  Load<dim> load;
  const mesh::Mesh<dim> mesh = half_full<dim>();
  for (const LoadedPoint<dim>& place : loaded_points(mesh, "load", traction, {0, none})) {
    EXPECT_EQ(mesh.region[place.cell], 0);
    for (int k = 0; k <= dim; ++k) EXPECT_GT(mesh.shape(place.cell).value(k, place.x), -1e-12);
    load.force += place.force;
    load.moment += place.force[1] * place.x;
    load.area += place.area;
  }
  return load;
}

TEST(Traction, is_its_stress_times_the_surface_of_the_soil)
{
  TractionSettings traction;
  traction.boundary = "surface";
  traction.stress = {30, -100};
  const auto plane = load_of<2>(traction);
  EXPECT_NEAR((plane.force - Vec<2>(60, -200)).norm(), 0, 1e-12);
  EXPECT_NEAR((plane.moment - Vec<2>(-200, -100)).norm(), 0, 1e-12);
  EXPECT_NEAR(plane.area, 2, 1e-12);
  traction.stress = {30, -100, 7};
  const auto space = load_of<3>(traction);
  EXPECT_NEAR((space.force - Vec<3>(60, -200, 14)).norm(), 0, 1e-12);
  EXPECT_NEAR((space.moment - Vec<3>(-200, -100, -100)).norm(), 0, 1e-12);
}

TEST(Traction, of_a_pressure_pushes_at_a_right_angle_against_the_soil)
{
  TractionSettings traction;
  traction.pressure = 50;
  const auto of = [&](const char* boundary) {
    traction.boundary = boundary;
    return load_of<2>(traction).force;
  };
  EXPECT_NEAR((of("surface") - Vec<2>(0, -100)).norm(), 0, 1e-12);
  EXPECT_NEAR((of("bottom") - Vec<2>(0, 100)).norm(), 0, 1e-12);
  EXPECT_NEAR((of("left") - Vec<2>(25, 0)).norm(), 0, 1e-12);  // the soil's half of the side alone
}

TEST(Traction, of_a_pressure_that_grows_with_depth_has_the_thrust_of_water)
{
  TractionSettings traction;
  traction.boundary = "left";
  traction.pressure = 20;
  traction.pressure_gradient = 100;
  traction.level = 0.5;
  // 20 x 0.5 + 100 x 0.5^2 / 2: the points are the middles of equal parts, where what is linear is summed exactly.
  EXPECT_NEAR((load_of<2>(traction).force - Vec<2>(22.5, 0)).norm(), 0, 1e-12);
  traction.level = 0.25;  // above it the pressure is 20
  EXPECT_NEAR((load_of<2>(traction).force - Vec<2>(13.125, 0)).norm(), 0, 1e-12);
}

TEST(Traction, acts_within_its_range_to_the_point)
{
  TractionSettings traction;
  traction.boundary = "surface";
  traction.stress = {0, -100};
  traction.x_range = {0.6, 1.3};  // ends within edges
  const auto load = load_of<2>(traction);
  EXPECT_NEAR(load.force[1], -70, 1e-12);
  EXPECT_NEAR(load.moment[0] / load.force[1], 0.95, 1e-12);
}

std::string refusal_of(const TractionSettings& traction)
{
  try {
    loaded_points(half_full<2>(), "load", traction, {0, none});
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(Traction, names_the_boundaries_there_are_and_refuses_those_without_soil)
{
  TractionSettings traction;
  traction.stress = {0, -100};
  traction.boundary = "lid";
  EXPECT_EQ(refusal_of(traction), "traction.load.boundary: the mesh has no boundary \"lid\"; it has left, right, bottom, top, surface");
  traction.boundary = "top";
  EXPECT_EQ(refusal_of(traction), "traction.load.boundary: no body that fills regions has soil at the boundary \"top\"");
  traction.boundary = "surface";
  traction.x_range = {2, 3};
  EXPECT_EQ(refusal_of(traction), "traction.load.x_range: no body that fills regions has soil at the boundary \"surface\" in this range");
}

}  // namespace
}  // namespace berm::boundary::this_file
