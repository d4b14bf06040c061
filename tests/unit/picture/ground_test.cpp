// SPDX-License-Identifier: BSD-3-Clause
#include "picture/ground.hpp"

#include "os/error.hpp"
#include "samples/layered_box.hpp"

#include <gtest/gtest.h>

namespace berm::picture::this_file {
namespace {

Real area_of(const Points& points)
{
  Real twice = 0;
  for (std::size_t k = 0; k < points.size(); ++k) {
    const Vec<2>&a = points[k], &b = points[(k + 1) % points.size()];
    twice += a[0] * b[1] - a[1] * b[0];
  }
  return std::abs(twice) / 2;
}

/// Area of a kind, m2.
Real area_of(const Ground& ground, Index kind)
{
  Real sum = 0;
  for (const Piece& piece : ground.pieces)
    if (piece.kind == kind) sum += area_of(piece.corners);
  return sum;
}

Ground ground_of_case(const std::vector<std::string>& changes = {}, const std::string& more = "")
{
  const settings::Case c = test::layered_box(changes, more);
  return ground_of(c, mesh::make_mesh<2>(c.mesh, ".", "."), problem::ground_of(c));
}

TEST(Ground, cells_are_cut_where_a_layer_begins)
{
  const Ground ground = ground_of_case();  // 2 m by 1 m; the second layer from 0.3 m down, inside a row of cells
  ASSERT_EQ(ground.kinds.size(), 2u);
  EXPECT_EQ(ground.kinds[0].material, "sand");
  EXPECT_EQ(ground.kinds[1].material, "clay");
  EXPECT_NEAR(area_of(ground, 0), 2 * 0.3, 1e-12);
  EXPECT_NEAR(area_of(ground, 1), 2 * 0.7, 1e-12);
  for (const Piece& piece : ground.pieces)
    for (const Vec<2>& x : piece.corners)
      if (piece.kind == 0)
        EXPECT_GE(x[1], 0.7 - 1e-12);
      else
        EXPECT_LE(x[1], 0.7 + 1e-12);
}

TEST(Ground, layers_follow_the_surface_that_the_soil_was_laid_down_from)
{
  const settings::Case c = test::layered_box();
  problem::Ground bed;
  bed.line.corners = {{0, 1.2}, {0.5, 1.2}, {0.5, 0.9}, {2, 1}};  // a trench, which layers do not follow
  bed.laid_down.corners = {{0, 0.9}, {1, 1.1}, {1, 0.8}, {2, 0.8}};
  const Ground ground = ground_of(c, mesh::make_mesh<2>(c.mesh, ".", "."), bed);
  EXPECT_NEAR(area_of(ground, 0), 2 - (0.6 + 0.8) / 2 - 0.5, 1e-6);
  EXPECT_NEAR(area_of(ground, 1), (0.6 + 0.8) / 2 + 0.5, 1e-6);
  for (const Piece& piece : ground.pieces)
    for (const Vec<2>& x : piece.corners) {
      const Real border = x[0] < 1 ? 0.6 + 0.2 * x[0] : 0.5;
      if (x[0] == 1) continue;  // the face
      if (piece.kind == 0)
        EXPECT_GE(x[1], border - 1e-8);
      else
        EXPECT_LE(x[1], border + 1e-8);
    }
}

TEST(Ground, equal_materials_are_one_kind)
{
  EXPECT_EQ(ground_of_case({"body.bed.soil_layer=[{top=\"0.3 m\", material=\"sand\"}]"}).kinds.size(), 1u);
}

TEST(Ground, a_support_holds_the_sides_of_its_boundary)
{
  const Ground ground = ground_of_case();
  ASSERT_EQ(ground.held.size(), 2u);
  EXPECT_EQ(ground.held[0].words, "x, y fixed");
  EXPECT_EQ(ground.held[0].directions, 3);
  Real length = 0;
  for (const Side& side : ground.held[0].sides) {
    EXPECT_EQ(side.from[1], 0);
    EXPECT_EQ(side.outward, Vec<2>(0, -1));
    length += (side.to - side.from).norm();
  }
  EXPECT_NEAR(length, 2, 1e-12);
  EXPECT_EQ(ground.held[1].words, "x fixed in rest");
  for (const Side& side : ground.held[1].sides) EXPECT_EQ(side.outward, Vec<2>(-1, 0));
}

TEST(Ground, the_surface_is_where_soil_ends_below_nothing)
{
  const Ground ground = ground_of_case();
  Real length = 0;
  for (const Side& side : ground.surface) {
    EXPECT_EQ(side.from[1], 1);
    length += (side.to - side.from).norm();
  }
  EXPECT_NEAR(length, 2, 1e-12);
}

TEST(Ground, a_traction_pulls_at_the_soil_along_its_boundary)
{
  const Ground ground = ground_of_case({}, "[traction.load]\nboundary = \"top\"\npressure = \"10 kPa\"\nx_range = [\"0.5 m\", \"1 m\"]\n");
  ASSERT_FALSE(ground.loaded.empty());
  for (const LoadedSpot& spot : ground.loaded) {
    EXPECT_NEAR((spot.along - Vec<2>(0, -1)).norm(), 0, 1e-12);
    EXPECT_GE(spot.at[0], 0.5);
    EXPECT_LE(spot.at[0], 1);
  }
}

TEST(Ground, a_boundary_that_the_mesh_does_not_have_is_refused)
{
  EXPECT_THROW(ground_of_case({"support.base.boundary=\"bed\""}), KeyError);
  EXPECT_THROW(ground_of_case({"body.bed.regions=[\"nowhere\"]"}), KeyError);
}

}  // namespace
}  // namespace berm::picture::this_file
