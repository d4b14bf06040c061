// SPDX-License-Identifier: BSD-3-Clause
#include "fem/element.hpp"

#include <gtest/gtest.h>

namespace berm::fem::this_file {
namespace {

using TenNodes = AtElementNodes<3, Vec<3>>;

TenNodes straight(const std::array<Vec<3>, 4>& corners)
{
  TenNodes x;
  for (int k = 0; k < 4; ++k) x[k] = corners[k];
  for (int e = 0; e < 6; ++e) x[4 + e] = (corners[element_edges<3>[e][0]] + corners[element_edges<3>[e][1]]) / 2;
  return x;
}

const TenNodes reference = straight({Vec<3>{0, 0, 0}, Vec<3>{1, 0, 0}, Vec<3>{0, 1, 0}, Vec<3>{0, 0, 1}});

// No edge is along an axis.
const std::array<Vec<3>, 4> corners{Vec<3>{0.3, -0.2, 0.1}, Vec<3>{1.7, 0.1, -0.3}, Vec<3>{0.5, 1.3, 0.2}, Vec<3>{0.4, 0.6, 1.5}};
const TenNodes sample = straight(corners);

// Numbers near 1 throughout: 1e-14 is some ten roundings.
constexpr Real rounding = 1e-14;

TEST(Tetrahedron, shape_functions_are_one_at_their_node_and_zero_at_the_others)
{
  for (int k = 0; k < 10; ++k)
    for (int l = 0; l < 10; ++l) EXPECT_EQ(shape_functions<3>(reference[l])[k], k == l ? 1 : 0) << k << " at " << l;
}

TEST(Tetrahedron, derivatives_are_those_of_the_shape_functions)
{
  // Central differences are exact for quadratic functions, to rounding over the step.
  const Vec<3> at(0.21, 0.37, 0.11);
  const Real step = 0.1;
  for (int d = 0; d < 3; ++d) {
    const Vec<3> away = step * Vec<3>::Unit(d);
    const auto after = shape_functions<3>(at + away), before = shape_functions<3>(at - away);
    for (int k = 0; k < 10; ++k) EXPECT_NEAR(shape_derivatives<3>(at)[k][d], (after[k] - before[k]) / (2 * step), rounding);
  }
}

TEST(Tetrahedron, points_share_the_volume_of_a_straight_element)
{
  Matrix<3> edges;
  for (int d = 0; d < 3; ++d) edges.col(d) = corners[d + 1] - corners[0];
  for (int q = 0; q < element_points<3>; ++q) EXPECT_NEAR(shape_at<3>(sample, q).area, edges.determinant() / 24, rounding);
}

TEST(Tetrahedron, volume_is_negative_where_the_element_is_inside_out)
{
  EXPECT_LT(shape_at<3>(straight({corners[0], corners[2], corners[1], corners[3]}), 0).area, 0);
}

TEST(Tetrahedron, points_integrate_squares_exactly)
{
  // Over the reference element, integrals of r^2 are 2!/5! and of r s 1/5!; of r 1/4!.
  Real r = 0, rr = 0, rs = 0;
  for (int q = 0; q < element_points<3>; ++q) {
    const ElementPoint<3> shape = shape_at<3>(reference, q);
    const Vec<3> x = position_of<3>(shape, reference);
    r += shape.area * x[0];
    rr += shape.area * x[0] * x[0];
    rs += shape.area * x[0] * x[1];
  }
  EXPECT_NEAR(r, 1. / 24, rounding);
  EXPECT_NEAR(rr, 1. / 60, rounding);
  EXPECT_NEAR(rs, 1. / 120, rounding);
}

TEST(Tetrahedron, gradient_of_a_quadratic_field_is_exact)
{
  const Matrix<3> curvature{{0.7, 0.2, -0.4}, {0.2, -0.5, 0.3}, {-0.4, 0.3, 0.9}};
  const Vec<3> slope(-2, 0.7, 1.1);
  for (int q = 0; q < element_points<3>; ++q) {
    const ElementPoint<3> shape = shape_at<3>(sample, q);
    Vec<3> gradient = Vec<3>::Zero();
    for (int k = 0; k < 10; ++k) gradient += (3 + slope.dot(sample[k]) + sample[k].dot(curvature * sample[k])) * shape.gradient[k];
    EXPECT_LT((gradient - slope - 2 * curvature * position_of<3>(shape, sample)).norm(), rounding);
  }
}

TEST(Tetrahedron, keeps_its_digits_at_survey_coordinates)
{
  // Numbers that survey coordinates hold exactly: what is left is rounding of the edges themselves.
  const Matrix<3> edges{{0.5, 0.125, 0.25}, {0.0625, 0.25, 0}, {0.125, 0, 0.5}};
  TenNodes x;
  for (int k = 0; k < 10; ++k) x[k] = Vec<3>(499'876.5, 6'543'210.75, -312.25) + edges * reference[k];
  EXPECT_LT((jacobian<3>(x, shape_derivatives<3>({0.3, 0.1, 0.2})) - edges).norm(), 1e-15);
}

// Four elements around one node off the centre of a tetrahedron, straight edges.
TEST(Tetrahedron, constant_stress_leaves_a_patch_in_equilibrium)
{
  const Vec<3> inside = 0.2 * corners[0] + 0.4 * corners[1] + 0.1 * corners[2] + 0.3 * corners[3];
  const Matrix<3> stress{{3, 1, -2}, {1, -1, 0.5}, {-2, 0.5, 2}};
  Vec<3> centre = Vec<3>::Zero();
  std::array<Vec<3>, 4> spokes;  // forces at the middles of the edges from the node inside to the corners
  spokes.fill(Vec<3>::Zero());
  for (int left_out = 0; left_out < 4; ++left_out) {
    std::array<Vec<3>, 4> of_cell = corners;
    of_cell[left_out] = inside;
    const TenNodes x = straight(of_cell);
    for (int q = 0; q < element_points<3>; ++q) {
      const ElementPoint<3> shape = shape_at<3>(x, q);
      ASSERT_GT(shape.area, 0);
      centre += shape.area * stress * shape.gradient[left_out];
      for (int e = 0; e < 6; ++e)
        if (const auto [a, b] = element_edges<3>[e]; a == left_out || b == left_out)
          spokes[a == left_out ? b : a] += shape.area * stress * shape.gradient[4 + e];
    }
  }
  EXPECT_LT(centre.norm(), rounding);
  for (const Vec<3>& spoke : spokes) EXPECT_LT(spoke.norm(), rounding);
}

}  // namespace
}  // namespace berm::fem::this_file
