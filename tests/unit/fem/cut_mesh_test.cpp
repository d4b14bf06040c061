// SPDX-License-Identifier: BSD-3-Clause
#include "fem/cut_mesh.hpp"

#include "samples/fem_sample_bed.hpp"

#include <gtest/gtest.h>

namespace berm::fem::this_file {
namespace {

mesh::SeabedMesh& bed_of(settings::Case& c)
{
  return std::get<mesh::SeabedMesh>(c.mesh);
}

Real area_of(const mesh::Mesh<2>& mesh, const std::string& region)
{
  Real area = 0;
  for (Index cell = 0; cell < mesh.cell_count(); ++cell)
    if (mesh.region_names[mesh.region[cell]] == region) area += mesh.volume(cell);
  return area;
}

bool has_node(const mesh::Mesh<2>& mesh, const Vec<2>& x)
{
  return std::any_of(mesh.position.begin(), mesh.position.end(), [&](const Vec<2>& node) { return (node - x).norm() < 1e-12; });
}

// 1 for an equilateral triangle, 0 for a flat one: 4 sqrt(3) area over the sum of squared sides.
Real worst_quality(const mesh::Mesh<2>& mesh)
{
  Real worst = 1;
  for (Index cell = 0; cell < mesh.cell_count(); ++cell) {
    Real squares = 0;
    for (int k = 0; k < 3; ++k)
      squares += (mesh.position[mesh.nodes[cell][k]] - mesh.position[mesh.nodes[cell][(k + 1) % 3]]).squaredNorm();
    worst = std::min(worst, 4 * std::sqrt(3.) * mesh.volume(cell) / squares);
  }
  return worst;
}

class CutMesh : public testing::TestWithParam<bodies::CircleSettings> {};

TEST_P(CutMesh, keeps_out_of_the_circle_and_has_vertices_exactly_on_it)
{
  const settings::Case c = bed_around(GetParam());
  const mesh::Mesh<2> mesh = cut_mesh_of(c);
  const auto circle = std::get<bodies::Circle<2>>(shapes_of(c)[0]);
  int on_circle = 0;
  for (const Vec<2>& x : mesh.position) {
    const Real distance = surface_at<2>(circle, x).distance / circle.radius;
    EXPECT_GE(distance, -1e-12);
    EXPECT_TRUE(distance < 1e-12 || distance > 1e-3) << distance;  // sides are near R/10: no vertex is almost on the circle
    on_circle += distance < 1e-12;
    EXPECT_LE(x[1], 1e-12);
  }
  EXPECT_GT(on_circle, 5);
}

TEST_P(CutMesh, has_well_shaped_cells)
{
  // Frontal Delaunay meshes of smooth size fields come out with 0.6 and more; 0.4 is a triangle with a height of a fifth of its base.
  EXPECT_GT(worst_quality(cut_mesh_of(bed_around(GetParam()))), 0.4);
}

TEST_P(CutMesh, has_sides_of_contact_size_at_the_circle)
{
  settings::Case c = bed_around(GetParam());
  c.fem.contact_size = 0.01;
  const QuadraticMesh mesh = quadratic_mesh_of(c);
  const auto sides = contact_sides(mesh, shapes_of(c)[0]);
  // Each arc has a whole number of sides, which may shorten them where it is short.
  EXPECT_NEAR(length_of(mesh, sides) / static_cast<Real>(sides.size()), 0.01, 0.001);
}

INSTANTIATE_TEST_SUITE_P(Pipe, CutMesh,
                         testing::Values(pipe_at(0.04), pipe_at(0.1), pipe_at(0.2), pipe_at(0.33),  // D/10, D/4, D/2, more
                                         bodies::CircleSettings{{-1.4, 0.1}, 0.4},                  // half of it, at the axis of symmetry
                                         bodies::CircleSettings{{1.6, -0.5}, 0.4},                  // half of it, buried at the right wall
                                         bodies::CircleSettings{{0.1, -0.5}, 0.4}));                // buried

TEST(CutMesh, has_the_boundaries_of_the_bed)
{
  const mesh::Mesh<2> mesh = cut_mesh_of(bed_around(pipe_at(0.1)));
  const auto expect_on = [&](const char* name, int direction, Real coordinate) {
    std::vector<Index> expected;
    for (Index i = 0; i < mesh.node_count(); ++i)
      if (std::abs(mesh.position[i][direction] - coordinate) < 1e-12) expected.push_back(i);
    ASSERT_NE(mesh.find_boundary(name), none) << name;
    EXPECT_EQ(mesh.boundary_nodes[mesh.find_boundary(name)], expected) << name;
  };
  expect_on("left", 0, -1.4);
  expect_on("right", 0, 1.6);
  expect_on("base", 1, -1);
  ASSERT_NE(mesh.find_boundary("top"), none);
  EXPECT_TRUE(mesh.boundary_nodes[mesh.find_boundary("top")].empty());
}

TEST(CutMesh, divides_regions_of_different_bodies_by_lines_of_the_mesh)
{
  settings::Case c = bed_around(pipe_at(0.1));
  c.contact.clear();
  fill_regions_apart(c);
  const mesh::Mesh<2> mesh = cut_mesh_of(c);
  EXPECT_NEAR(area_of(mesh, "near"), 0.8 * 0.3, 1e-12);
  EXPECT_NEAR(area_of(mesh, "bed"), 2.6 * 0.8 - 0.8 * 0.3, 1e-12);
  EXPECT_NEAR(area_of(mesh, "layer"), 3 - 2.6 * 0.8, 1e-12);
  EXPECT_EQ(mesh.region_names.size(), 3u);
}

TEST(CutMesh, names_regions_of_one_body_by_centroids)
{
  settings::Case c = bed_around(pipe_at(0.1));
  c.contact.clear();
  const mesh::Mesh<2> mesh = cut_mesh_of(c);
  // Without a line the border runs between the cells, here of about 0.05 m at "near" and 0.2 m at "layer", now on one side, now on the other.
  EXPECT_NEAR(area_of(mesh, "near"), 0.8 * 0.3, 0.025 * 1.4);
  EXPECT_NEAR(area_of(mesh, "layer"), 3 - 2.6 * 0.8, 0.1 * 4.2);
  EXPECT_NE(area_of(mesh, "near"), 0.8 * 0.3);
}

TEST(CutMesh, has_no_layer_where_there_is_none)
{
  settings::Case c = bed_around(pipe_at(0.1));
  bed_of(c).layer = 0;
  const mesh::Mesh<2> mesh = cut_mesh_of(c);
  EXPECT_EQ(mesh.region_names, (std::vector<std::string>{"near", "bed"}));
}

TEST(CutMesh, gives_each_body_its_part_where_the_circle_cuts_through_all)
{
  // Of radius 0.6 m around (0.45, -0.8): its centre is below the corner of the fine zone and above the lower layer by zero.
  settings::Case c = bed_around(bodies::CircleSettings{{0.45, -0.8}, 1.2});
  fill_regions_apart(c);
  const QuadraticMesh mesh = quadratic_mesh_of(c);
  std::array<Real, 3> area{};
  for (Index cell = 0; cell < mesh.cell_count(); ++cell)
    for (int k = 3; k < 6; ++k) area[mesh.body[cell]] += jacobian(mesh.positions_of(cell), six_nodes[k]).determinant() / 6;
  const auto segment = [](Real distance) { return 0.36 * std::acos(distance / 0.6) - distance * std::sqrt(0.36 - distance * distance); };
  // The circle takes half of its segment above y = -0.3 from the fine zone; from the layer its lower half less the segment below the base.
  const Real near = segment(0.5) / 2, layer = pi * 0.36 / 2 - segment(0.2), all = pi * 0.36 - segment(0.2);
  EXPECT_NEAR(area[1], 0.8 * 0.3 - near, 1e-6);
  EXPECT_NEAR(area[2], 3 - 2.6 * 0.8 - layer, 1e-6);
  EXPECT_NEAR(area[0], 2.6 * 0.8 - 0.8 * 0.3 - (all - near - layer), 1e-6);
}

TEST(CutMesh, is_the_same_every_time)
{
  const TemporaryFolder first, second;
  make_cut_mesh(bed_around(pipe_at(0.1)), ".", first.path());
  make_cut_mesh(bed_around(pipe_at(0.1)), ".", second.path());
  EXPECT_GT(first.read("mesh.msh").size(), 1000u);
  EXPECT_EQ(first.read("mesh.msh"), second.read("mesh.msh"));
  EXPECT_EQ(first.read("mesh.geo"), second.read("mesh.geo"));
}

TEST(CutMesh, ends_a_footing_that_lies_on_the_bed_at_vertices)
{
  const settings::Case c = bed_around(bodies::BoxSettings{{0.0123, 0.1}, {0.4, 0.2}});
  const mesh::Mesh<2> mesh = cut_mesh_of(c);
  EXPECT_TRUE(has_node(mesh, {-0.1877, 0}));
  EXPECT_TRUE(has_node(mesh, {0.2123, 0}));
  const QuadraticMesh quadratic = make_quadratic(mesh, c, shapes_of(c));
  EXPECT_NEAR(length_of(quadratic, contact_sides(quadratic, shapes_of(c)[0])), 0.4, 1e-12);
}

TEST(CutMesh, takes_half_a_footing_at_the_axis_of_symmetry)
{
  const settings::Case c = bed_around(bodies::BoxSettings{{-1.4, 0.1}, {0.6, 0.2}});
  const QuadraticMesh mesh = quadratic_mesh_of(c);
  EXPECT_NEAR(length_of(mesh, contact_sides(mesh, shapes_of(c)[0])), 0.3, 1e-12);
}

TEST(CutMesh, cuts_out_boxes_turned_or_not)
{
  const settings::Case c = bed_around(bodies::BoxSettings{{0, -0.1}, {0.4, 0.3}});
  const QuadraticMesh mesh = quadratic_mesh_of(c);
  EXPECT_NEAR(berm::area_of(mesh), 3 - 0.4 * 0.25, 1e-12);
  EXPECT_NEAR(length_of(mesh, contact_sides(mesh, shapes_of(c)[0])), 0.4 + 2 * 0.25, 1e-12);

  const settings::Case turned = bed_around(bodies::BoxSettings{{0, -0.5}, {0.4, 0.3}, 0.3});
  const QuadraticMesh buried = quadratic_mesh_of(turned);
  EXPECT_NEAR(berm::area_of(buried), 3 - 0.4 * 0.3, 1e-12);
  EXPECT_NEAR(length_of(buried, contact_sides(buried, shapes_of(turned)[0])), 2 * 0.4 + 2 * 0.3, 1e-12);
}

TEST(CutMesh, cuts_out_polygons_and_profiles)
{
  const settings::Case c = bed_around(bodies::PolygonSettings{{-0.3, 0.3, 0}, {-0.2, -0.2, -0.5}});
  const QuadraticMesh mesh = quadratic_mesh_of(c);
  EXPECT_NEAR(berm::area_of(mesh), 3 - 0.3 * 0.3, 1e-12);
  EXPECT_NEAR(length_of(mesh, contact_sides(mesh, shapes_of(c)[0])), 0.6 + 2 * std::hypot(0.3, 0.3), 1e-12);

  const settings::Case cone = bed_around(bodies::ProfileSettings{{0, 0.3, 0.3, 0}, {-0.4, -0.1, 0.2, 0.2}});
  EXPECT_NEAR(berm::area_of(quadratic_mesh_of(cone)), 3 - 0.6 * (0.3 / 2 + 0.1), 1e-12);
}

TEST(CutMesh, cuts_out_every_rigid_body_with_a_contact_and_no_other)
{
  settings::Case c = bed_around(pipe_at(0.2));
  bodies::RigidSettings other;
  other.shape = bodies::CircleSettings{{0.8, -0.4}, 0.2};
  c.rigid.emplace_back("cable", other);
  EXPECT_NEAR(berm::area_of(quadratic_mesh_of(c)), 3 - pi * 0.04 / 2, 1e-5);
  c.contact.push_back({"other_skin", c.contact[0].second});
  c.contact[1].second.rigid = "cable";
  EXPECT_NEAR(berm::area_of(quadratic_mesh_of(c)), 3 - pi * 0.04 / 2 - pi * 0.01, 1e-5);
}

TEST(CutMesh, takes_lengths_of_a_model_in_millimetres)
{
  settings::Case c = bed_around(pipe_at(0.1));
  mesh::SeabedMesh& bed = bed_of(c);
  for (Real* length : {&bed.length, &bed.depth, &bed.headroom, &*bed.left, &bed.near_size, &bed.near_left, &bed.near_right, &bed.near_depth,
                       &bed.near_height, &*bed.far_size, &bed.layer, &*c.fem.contact_size})
    *length *= 0.02;
  c.rigid[0].second.shape = bodies::CircleSettings{{0.0006, 0.002}, 0.008};
  const QuadraticMesh mesh = quadratic_mesh_of(c);
  EXPECT_NEAR(length_of(mesh, contact_sides(mesh, shapes_of(c)[0])), 0.008 * pi / 3, 1e-6 * 0.008);
}

TEST(CutMesh, leaves_meshes_of_other_kinds_as_they_are)
{
  settings::Case c = bed_around(pipe_at(0.1));
  mesh::BoxMesh box;
  box.size = {2, 1};
  box.cells = {4, 2};
  c.mesh = box;
  const mesh::Mesh<2> mesh = cut_mesh_of(c);
  EXPECT_EQ(mesh.cell_count(), 16);
  EXPECT_EQ(mesh.region_names, std::vector<std::string>{"box"});
}

TEST(CutMesh, cuts_a_pipe_out_of_a_slope_and_a_trench)
{
  for (const bool trench : {false, true}) {
    SCOPED_TRACE(trench ? "trench" : "slope");
    const Vec<2> center(0.05, 0.1);
    settings::Case c = bed_around(bodies::CircleSettings{{center[0], center[1] - (trench ? 0.25 : 0)}, 0.4});
    if (trench)
      bed_of(c).trench = mesh::Trench{.depth = 0.25, .width = 0.6, .side_slope = 60 * pi / 180};
    else
      bed_of(c).slope = 15 * pi / 180;
    const mesh::GroundLine ground = ground_of(bed_of(c));
    const mesh::Mesh<2> mesh = cut_mesh_of(c);
    const auto circle = std::get<bodies::Circle<2>>(shapes_of(c)[0]);
    Real soil = 0, segment = 0;  // area; what the circle takes, by strips
    for (Index cell = 0; cell < mesh.cell_count(); ++cell) soil += mesh.volume(cell);
    constexpr int strips = 4000;
    for (int k = 0; k < strips; ++k) {
      const Real x = circle.radius * (2 * (k + 0.5) / strips - 1), half = std::sqrt(circle.radius * circle.radius - x * x),
                 y = circle.center[1];
      segment += std::clamp(ground.height(circle.center[0] + x) - (y - half), Real(0), 2 * half) * 2 * circle.radius / strips;
    }
    EXPECT_GT(segment, 0.02);
    const Real whole = trench ? 3 - 0.25 * (0.6 + 0.25 / std::tan(pi / 3)) : 3;  // the slope is 0 at x = 0, and the bed as deep everywhere
    EXPECT_NEAR(soil, whole - segment, 2e-3) << "straight sides of R/10 along the arc";
    for (const Vec<2>& x : mesh.position) EXPECT_LE(x[1], ground.height(x[0]) + 1e-9);
    EXPECT_GT(worst_quality(mesh), 0.2);
    for (const char* name : {"left", "right", "base", "surface"}) {
      ASSERT_NE(mesh.find_boundary(name), none) << name;
      EXPECT_GT(mesh.boundary_nodes[mesh.find_boundary(name)].size(), 3u) << name;
    }
    for (const Index i : mesh.boundary_nodes[mesh.find_boundary("base")])
      EXPECT_NEAR(mesh.position[i][1], -1 + std::tan(bed_of(c).slope) * mesh.position[i][0], 1e-9);
  }
}

TEST(CutMesh, leaves_a_slope_whole_below_a_pipe_above_it_in_large_deformations)
{
  settings::Case c = bed_around(bodies::CircleSettings{{0.5, 0.2}, 0.4});
  bed_of(c).slope = -15 * pi / 180;
  c.fem.large_deformation = true;
  const mesh::Mesh<2> mesh = cut_mesh_of(c);
  Real soil = 0;
  for (Index cell = 0; cell < mesh.cell_count(); ++cell) soil += mesh.volume(cell);
  EXPECT_NEAR(soil, 3, 1e-9) << "m2, 3 m by 1 m";
}

TEST(CutMesh, refuses_what_it_cannot_cut_out_of_a_slope)
{
  settings::Case c = bed_around(bodies::CircleSettings{{0.5, 0.2}, 0.4});
  bed_of(c).slope = -15 * pi / 180;
  EXPECT_EQ(refusal_of([&] { cut_mesh_of(c); }).find("rigid.pipe.center: the body at (0.5, 0.2) m"), 0u);
  c = bed_around(bodies::BoxSettings{{0, -0.1}, {0.4, 0.2}});
  bed_of(c).slope = -15 * pi / 180;
  EXPECT_EQ(refusal_of([&] { cut_mesh_of(c); }).find("rigid.pipe.shape: of a bed that is not level only a \"circle\""), 0u);
  c = bed_around(pipe_at(0.1));
  bed_of(c).slope = -15 * pi / 180;
  fill_regions_apart(c);
  EXPECT_EQ(refusal_of([&] { cut_mesh_of(c); }).find("body.soil.regions: "), 0u);
}

TEST(CutMesh, refuses_rigid_bodies_that_it_cannot_cut_out)
{
  const auto refusal = [](const bodies::RigidShapeSettings& shape) { return refusal_of([&] { cut_mesh_of(bed_around(shape)); }); };
  EXPECT_EQ(refusal(pipe_at(0)),
            "rigid.pipe.center: the body reaches from (-0.17, 0) to (0.23, 0.4) m; for finite elements it must lie in the soil, "
            "-1.4 < x < 1.6 m and -1 < y < 0 m, at least partly, or lie on it with a flat bottom; in large deformations it may also lie "
            "above it");
  EXPECT_EQ(refusal(bodies::CircleSettings{{2, 0}, 0.4}).find("rigid.pipe.center: "), 0u);
  EXPECT_EQ(refusal(bodies::CircleSettings{{0, -1.3}, 0.4}).find("rigid.pipe.center: "), 0u);
  EXPECT_EQ(refusal(bodies::BoxSettings{{0, 0.11}, {0.4, 0.2}}).find("rigid.pipe.center: "), 0u);
  EXPECT_EQ(refusal(bodies::BoxSettings{{0, std::sqrt(0.5)}, {1, 1}, pi / 4}).find("rigid.pipe.center: "), 0u);  // on its corner
  EXPECT_EQ(refusal(bodies::HalfPlaneSettings{{0, -0.1}, {0, 1}}).find("rigid.pipe.shape: "), 0u);
  EXPECT_EQ(refusal(bodies::PolygonSettings{{-0.1, 0.1, 0}, {0.2, 0.2, 0.1}}).find("rigid.pipe.center: "), 0u);
}

TEST(CutMesh, refuses_sizes_that_do_not_fit)
{
  settings::Case c = bed_around(pipe_at(0.1));
  c.fem.contact_size = 0.0003;
  EXPECT_EQ(refusal_of([&] { cut_mesh_of(c); }),
            "fem.contact_size: 0.0003 m is less than a thousandth of the width of [rigid.pipe], 0.4 m");
  c = bed_around(pipe_at(0.1));
  bed_of(c).near_depth = 0.95;
  EXPECT_EQ(refusal_of([&] { cut_mesh_of(c); }).find("mesh.near_depth"), 0u);
}

}  // namespace
}  // namespace berm::fem::this_file
