// SPDX-License-Identifier: BSD-3-Clause
#include "fem/moved_cell.hpp"

#include <gtest/gtest.h>

namespace berm::fem::this_file {
namespace {

constexpr Real round_off = 1e-13;

/// A triangle with one curved side.
AtSixNodes<Vec<2>> curved_triangle()
{
  return {Vec<2>{1, 2}, Vec<2>{1.4, 2.1}, Vec<2>{1.1, 2.5}, Vec<2>{1.2, 2.03}, Vec<2>{1.27, 2.32}, Vec<2>{1.05, 2.25}};
}

AtSixNodes<Vec<2>> moved_by(const AtSixNodes<Vec<2>>& nodes, const Matrix<2>& gradient, const Vec<2>& shift = {0, 0})
{
  AtSixNodes<Vec<2>> change;
  for (int k = 0; k < 6; ++k) change[k] = shift + gradient * nodes[k];
  return change;
}

Matrix<2> turned(Real angle)
{
  Matrix<2> q;
  q << std::cos(angle), -std::sin(angle), std::sin(angle), std::cos(angle);
  return q;
}

Matrix<2> strain_at(const ShapeAtPoint& shape, const AtSixNodes<Vec<2>>& change)
{
  Matrix<2> gradient = Matrix<2>::Zero();
  for (int k = 0; k < 6; ++k) gradient += change[k] * shape.gradient[k].transpose();
  return (gradient + gradient.transpose()) / 2;
}

TEST(MovedCell, that_rotates_far_has_no_strain_and_the_whole_angle)
{
  const AtSixNodes<Vec<2>> nodes = curved_triangle();
  const AtSixNodes<Vec<2>> change = moved_by(nodes, turned(0.7) - Matrix<2>::Identity(), {0.3, -0.2});
  const MovedCell moved = move_cell(nodes, change, mesh::Metric::cartesian);
  for (int q = 0; q < triangle_points; ++q) {
    EXPECT_LT(strain_at(moved.middle[q], change).norm(), round_off);
    EXPECT_NEAR(moved.rotation[q].cosine, std::cos(1.4), round_off);
    EXPECT_NEAR(moved.rotation[q].sine, std::sin(1.4), round_off);
    EXPECT_NEAR(moved.end[q].area, shape_at(nodes, q).area, round_off);
  }
}

// The middle configuration gives 2 (l - 1)/(l + 1) for ln l, which is (ln l)^3/12 less: 6e-4 of .2^3.
TEST(MovedCell, that_stretches_has_the_logarithm_of_the_stretch_as_its_strain)
{
  const AtSixNodes<Vec<2>> nodes = curved_triangle();
  Matrix<2> stretch = Matrix<2>::Zero();
  stretch(0, 0) = std::exp(0.2) - 1;
  const AtSixNodes<Vec<2>> change = moved_by(nodes, stretch);
  const MovedCell moved = move_cell(nodes, change, mesh::Metric::cartesian);
  for (int q = 0; q < triangle_points; ++q) {
    EXPECT_NEAR(strain_at(moved.middle[q], change)(0, 0), 0.2 - 0.008 / 12, 1e-5);
    EXPECT_NEAR(moved.end[q].area / shape_at(nodes, q).area, std::exp(0.2), round_off);
    EXPECT_NEAR(moved.rotation[q].sine, 0, round_off);
  }
}

TEST(MovedCell, is_told_where_it_folds)
{
  const AtSixNodes<Vec<2>> nodes = curved_triangle();
  Matrix<2> mirror = Matrix<2>::Zero();
  mirror(0, 0) = -2;
  EXPECT_TRUE(move_cell(nodes, moved_by(nodes, mirror), mesh::Metric::cartesian).inverted);
  EXPECT_FALSE(move_cell(nodes, moved_by(nodes, mirror / 4), mesh::Metric::cartesian).inverted);
}

TEST(MovedCell, has_its_volume_around_an_axis)
{
  const AtSixNodes<Vec<2>> nodes = curved_triangle();
  Matrix<2> wider = Matrix<2>::Zero();
  wider(0, 0) = 0.1;
  const AtSixNodes<Vec<2>> change = moved_by(nodes, wider);
  const MovedCell moved = move_cell(nodes, change, mesh::Metric::axisymmetric);
  for (int q = 0; q < triangle_points; ++q) {
    const ShapeAtPoint first = shape_at(nodes, q);
    const Real radius = position_of(first, nodes)[0];
    EXPECT_NEAR(moved.end[q].area, first.area * 1.1 * 1.1 * radius, round_off);
    EXPECT_NEAR(moved.middle[q].per_radius, 1 / (1.05 * radius), round_off);
  }
}

TEST(RotatedStress, has_its_principal_stresses_in_turned_directions)
{
  SymTensor<2> stress;
  stress[0] = -3, stress[1] = 1, stress[2] = 5, stress[3] = 0.5;
  const SymTensor<2> now = rotated(stress, {std::cos(0.8), std::sin(0.8)});
  Matrix<2> before, after;
  before << stress[0], stress[3], stress[3], stress[1];
  after << now[0], now[3], now[3], now[1];
  EXPECT_LT((turned(0.4) * before * turned(0.4).transpose() - after).norm(), round_off);
  EXPECT_EQ(now[2], 5);
}

}  // namespace
}  // namespace berm::fem::this_file
