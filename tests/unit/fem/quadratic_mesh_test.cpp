// SPDX-License-Identifier: BSD-3-Clause
#include "fem/quadratic_mesh.hpp"

#include "samples/fem_sample_bed.hpp"

#include <gtest/gtest.h>
#include <map>
#include <set>

namespace berm::fem::this_file {
namespace {

class PipeInBed : public testing::TestWithParam<Real> {
protected:
  settings::Case c = bed_around(pipe_at(GetParam()));
  bodies::Circle<2> circle = std::get<bodies::Circle<2>>(shapes_of(c)[0]);
  QuadraticMesh mesh = quadratic_mesh_of(c);
  std::vector<BoundarySide> skin = contact_sides(mesh, circle);
  // Half the angle of the arc in the soil.
  Real half_angle = circle.center[1] < -circle.radius ? pi : std::acos(std::clamp(circle.center[1] / circle.radius, -1., 1.));
};

TEST_P(PipeInBed, leaves_the_area_of_the_bed_less_a_segment_of_the_circle)
{
  const Real square = circle.radius * circle.radius;
  const Real exact = 3 - square * (half_angle - std::sin(half_angle) * std::cos(half_angle));
  const Real area = area_of(mesh);
  EXPECT_NEAR(area, exact, 1e-6 * exact);
  // A parabola through three points of an arc of half angle a, the middle one halfway, encloses less with its chord than the arc does, by
  // R2 ((a - sin a cos a) - 4/3 sin a (1 - cos a)) = R2 a^5 / 30 (1 + O(a2)) with a = 0.05; this is found to 1 %.
  Real parabolas = 0;
  for (const BoundarySide& side : skin) {
    const Real chord = (mesh.position[side.to] - mesh.position[side.from]).norm();
    parabolas += square * std::pow(std::asin(chord / 2 / circle.radius), 5) / 30;
  }
  EXPECT_NEAR((area - exact) / parabolas, 1, 0.01);
}

TEST_P(PipeInBed, touches_the_circle_along_the_arc_in_the_soil)
{
  // The parabola's length differs from the arc's by the fourth power of a = 0.05, with a small factor.
  const Real arc = 2 * half_angle * circle.radius;
  EXPECT_NEAR(length_of(mesh, skin), arc, 1e-6 * arc);
  for (const BoundarySide& side : skin)
    for (const Index node : {side.from, side.middle, side.to})
      EXPECT_NEAR(surface_at<2>(circle, mesh.position[node]).distance, 0, 1e-12 * circle.radius);
}

TEST_P(PipeInBed, is_unfolded_and_counter_clockwise)
{
  for (Index cell = 0; cell < mesh.cell_count(); ++cell) {
    const auto x = mesh.positions_of(cell);
    const Real mean = jacobian(x, {1. / 3, 1. / 3}).determinant();
    // With a = 0.05 the middle of a side leaves its chord by a/4 = 1/80 of it, which changes the determinant by a few times that.
    for (const Vec<2>& at : six_nodes) EXPECT_GT(jacobian(x, at).determinant(), 0.8 * mean);
  }
}

TEST_P(PipeInBed, has_the_soil_to_the_left_of_its_boundary)
{
  // The boundary goes round the soil once, with holes the other way round: the area within is the soil's. Middles count as corners here.
  Real twice = 0;
  std::map<Index, int> balance;
  for (const BoundarySide& side : mesh.boundary_sides) {
    const Vec<2>&a = mesh.position[side.from], &m = mesh.position[side.middle], &b = mesh.position[side.to];
    twice += a[0] * m[1] - a[1] * m[0] + m[0] * b[1] - m[1] * b[0];
    ++balance[side.from];
    --balance[side.to];
  }
  for (const auto& [node, count] : balance) EXPECT_EQ(count, 0) << node;
  // The polygon through the middles misses a quarter of what the chords miss: sides of 0.02 m on R = 0.2 m miss up to 1e-4 of pi R2.
  EXPECT_NEAR(twice / 2, area_of(mesh), 1e-4);
}

INSTANTIATE_TEST_SUITE_P(At, PipeInBed, testing::Values(0.04, 0.1, 0.2, 0.3, 0.7));  // D/10, D/4, D/2, 3 D/4, buried

mesh::BoxMesh two_by_one()
{
  mesh::BoxMesh box;
  box.size = {2, 1};
  box.cells = {2, 1};
  return box;
}

// The left half of a mesh of four triangles is filled.
struct HalfFilledBox {
  mesh::Mesh<2> mesh = make_box<2>(two_by_one());
  settings::Case c = bed_around(bodies::CircleSettings{{0, 5}, 1});

  HalfFilledBox()
  {
    mesh.region_names = {"left half", "right half"};
    for (Index cell = 0; cell < mesh.cell_count(); ++cell) mesh.region[cell] = mesh.centroid(cell)[0] > 1;
    c.body[0].second.regions = {"left half"};
    c.support.clear();
  }
  QuadraticMesh make() const { return make_quadratic(mesh, c, {}); }
};

Index node_at(const QuadraticMesh& mesh, Real x, Real y)
{
  for (Index i = 0; i < mesh.node_count(); ++i)
    if (mesh.position[i] == Vec<2>(x, y)) return i;
  ADD_FAILURE() << "no node at " << x << ", " << y;
  return 0;
}

TEST(QuadraticMesh, has_the_cells_of_the_bodies_alone_and_their_nodes)
{
  const QuadraticMesh mesh = HalfFilledBox().make();
  EXPECT_EQ(mesh.cell_count(), 2);
  EXPECT_EQ(mesh.node_count(), 9);
  std::set<Index> used;
  for (const auto& nodes : mesh.nodes) used.insert(nodes.begin(), nodes.end());
  EXPECT_EQ(used.size(), 9u);
  EXPECT_EQ(mesh.boundary_sides.size(), 4u);  // what borders on cells of no body is boundary
  EXPECT_NEAR(area_of(mesh), 1, 1e-14);
}

TEST(QuadraticMesh, has_its_middles_between_the_corners_in_order)
{
  HalfFilledBox box;
  box.c.body[0].second.regions = {"left half", "right half"};
  const QuadraticMesh mesh = box.make();
  EXPECT_EQ(mesh.node_count(), 15);  // 5 x 3: neighbours share middles
  for (Index cell = 0; cell < mesh.cell_count(); ++cell) {
    const auto x = mesh.positions_of(cell);
    for (int k = 0; k < 3; ++k) EXPECT_EQ(x[3 + k], Vec<2>((x[k] + x[(k + 1) % 3]) / 2));
  }
}

TEST(QuadraticMesh, numbers_the_body_of_each_cell)
{
  HalfFilledBox box;
  box.c.body.push_back({"other", box.c.body[0].second});
  box.c.body[1].second.regions = {"right half"};
  const QuadraticMesh mesh = box.make();
  ASSERT_EQ(mesh.cell_count(), 4);
  for (Index cell = 0; cell < 4; ++cell) EXPECT_EQ(mesh.body[cell], mesh.positions_of(cell)[3][0] > 1 || mesh.positions_of(cell)[4][0] > 1);
}

TEST(QuadraticMesh, holds_corners_and_middles_of_supported_sides)
{
  HalfFilledBox box;
  box.c.support = {{"a", {"left", {"x"}}}, {"b", {"bottom", {"x", "y"}}}};
  const QuadraticMesh mesh = box.make();
  const auto held = [&](Real x, Real y) { return static_cast<int>(mesh.fixed[0][node_at(mesh, x, y)]); };
  EXPECT_EQ(held(0, 1), 1);
  EXPECT_EQ(held(0, 0.5), 1);
  EXPECT_EQ(held(0, 0), 3);
  EXPECT_EQ(held(0.5, 0), 3);
  EXPECT_EQ(held(1, 0), 3);
  EXPECT_EQ(held(0.5, 0.5), 0);
  EXPECT_EQ(held(1, 1), 0);
  EXPECT_EQ(held(1, 0.5), 0);
}

TEST(QuadraticMesh, gives_a_corner_between_two_boundaries_the_head_of_the_first)
{
  HalfFilledBox box;
  box.c.support = {{"a", {"left", {"x"}}}, {"b", {"bottom", {"x", "y"}}}};
  for (auto& entry : box.c.support) entry.second.head = 1;
  const QuadraticMesh mesh = box.make();
  ASSERT_EQ(mesh.head_nodes.size(), 2u);
  const auto has = [&](std::size_t head, Real x, Real y) {
    return std::count(mesh.head_nodes[head].begin(), mesh.head_nodes[head].end(), node_at(mesh, x, y));
  };
  EXPECT_EQ(has(0, 0, 0), 1);
  EXPECT_EQ(has(1, 0, 0), 0);
  EXPECT_EQ(has(1, 1, 0), 1);
}

TEST(QuadraticMesh, does_not_hold_the_middle_between_two_supports)
{
  HalfFilledBox box;
  box.c.body[0].second.regions = {"left half", "right half"};
  box.c.support = {{"a", {"bottom", {"x"}}}, {"b", {"top", {"x"}}}};
  const QuadraticMesh mesh = box.make();
  for (const Real x : {0., 2.}) EXPECT_EQ(mesh.fixed[0][node_at(mesh, x, 0.5)], 0);  // a side of one cell from bottom to top
  // The diagonals' ends are held as well.
  for (const Real x : {0.5, 1., 1.5}) EXPECT_EQ(mesh.fixed[0][node_at(mesh, x, 0.5)], 0);
}

TEST(QuadraticMesh, holds_no_middle_inside_though_both_ends_are_held)
{
  // In the corner of the box a diagonal runs from wall to wall.
  HalfFilledBox box;
  box.mesh.boundary_names.push_back("all round");
  box.mesh.boundary_nodes.push_back({0, 1, 2, 3, 4, 5});
  box.c.support = {{"a", {"all round", {"x"}}}};
  const QuadraticMesh mesh = box.make();
  EXPECT_EQ(mesh.fixed[0][node_at(mesh, 0.5, 0.5)], 0);
  EXPECT_EQ(mesh.fixed[0][node_at(mesh, 0.5, 1)], 1);
}

TEST(QuadraticMesh, holds_the_walls_and_the_base_of_a_bed)
{
  const QuadraticMesh mesh = quadratic_mesh_of(bed_around(bodies::CircleSettings{{-1.4, 0.1}, 0.4}));
  for (Index i = 0; i < mesh.node_count(); ++i) {
    const Vec<2>& x = mesh.position[i];
    const bool base = x[1] < -1 + 1e-9, wall = x[0] < -1.4 + 1e-9 || x[0] > 1.6 - 1e-9;
    EXPECT_EQ(static_cast<int>(mesh.fixed[0][i]), base ? 3 : wall ? 1 : 0) << x.transpose();
  }
}

TEST(QuadraticMesh, refuses_what_finite_elements_do_not_know)
{
  const auto refusal = [](const auto& change) {
    HalfFilledBox box;
    change(box.c);
    return refusal_of([&] { box.make(); });
  };
  EXPECT_EQ(refusal([](settings::Case& c) { c.body[0].second.regions = {"bed"}; }),
            "body.soil.regions: the mesh has no region \"bed\"; it has left half, right half");
  EXPECT_EQ(refusal([](settings::Case& c) {
              c.support = {{"base", {"base", {"x"}}}};
            }),
            "support.base.boundary: the mesh has no boundary \"base\"; it has left, right, bottom, top");
  EXPECT_EQ(refusal([](settings::Case& c) {
              c.body.push_back({"other", c.body[0].second});
            }),
            "body.other.regions: the region \"left half\" is filled by [body.soil] already; for finite elements a region has one body");
  EXPECT_EQ(refusal([](settings::Case& c) { c.body[0].second.block.emplace(); }),
            "body.soil.block: for finite elements a body must fill regions of the mesh: regions = [...]");
  EXPECT_EQ(refusal([](settings::Case& c) { c.body[0].second.disk.emplace(); }),
            "body.soil.disk: for finite elements a body must fill regions of the mesh: regions = [...]");
}

TEST(QuadraticMesh, refuses_elements_that_a_circle_folds)
{
  // The right side of the filled half, from (1, 0) to (1, 1), becomes a half circle about (1, 0.5), whose middle is at (0.5, 0.5) or (1.5, 0.5).
  const HalfFilledBox box;
  const auto message = refusal_of([&] { make_quadratic(box.mesh, box.c, {bodies::Circle<2>{{1.0001, 0.5}, std::hypot(1e-4, 0.5)}}); });
  EXPECT_EQ(message.find("fem.contact_size: an element near "), 0u) << message;
}

}  // namespace
}  // namespace berm::fem::this_file
