// SPDX-License-Identifier: BSD-3-Clause
#include "fem/element.hpp"

#include <gtest/gtest.h>

namespace berm::fem::this_file {
namespace {

TEST(Triangle, shape_functions_are_one_at_their_node_and_zero_at_the_others)
{
  for (int k = 0; k < 6; ++k)
    for (int l = 0; l < 6; ++l) EXPECT_EQ(shape_functions<2>(six_nodes[l])[k], k == l ? 1 : 0) << k << " at " << l;
}

TEST(Triangle, derivatives_are_those_of_the_shape_functions)
{
  // Central differences are exact for quadratic functions, to rounding over the step.
  const Vec<2> at(0.21, 0.37);
  const Real step = 0.1;
  for (int d = 0; d < 2; ++d) {
    const Vec<2> away = step * Vec<2>::Unit(d);
    const auto after = shape_functions<2>(at + away), before = shape_functions<2>(at - away);
    for (int k = 0; k < 6; ++k) EXPECT_NEAR(shape_derivatives(at)[k][d], (after[k] - before[k]) / (2 * step), 1e-14);
  }
}

TEST(Triangle, jacobian_maps_the_reference_triangle_to_the_nodes)
{
  const Matrix<2> edges{{3, 1}, {0.5, 2}};
  AtSixNodes<Vec<2>> x;
  for (int k = 0; k < 6; ++k) x[k] = Vec<2>(7, -5) + edges * six_nodes[k];
  EXPECT_LT((jacobian(x, {0.3, 0.1}) - edges).norm(), 1e-14);
  EXPECT_NEAR(jacobian(x, {0.3, 0.1}).determinant(), 5.5, 1e-13);
}

TEST(Triangle, jacobian_keeps_its_digits_at_survey_coordinates)
{
  // Numbers that survey coordinates hold exactly: what is left is rounding of the edges themselves.
  const Matrix<2> edges{{0.5, 0.125}, {0.0625, 0.25}};
  AtSixNodes<Vec<2>> x;
  for (int k = 0; k < 6; ++k) x[k] = Vec<2>(499'876.5, 6'543'210.75) + edges * six_nodes[k];
  EXPECT_LT((jacobian(x, {0.3, 0.1}) - edges).norm(), 1e-15);
}

}  // namespace
}  // namespace berm::fem::this_file
