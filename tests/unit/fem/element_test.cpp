// SPDX-License-Identifier: BSD-3-Clause
#include "fem/element.hpp"

#include <gtest/gtest.h>

namespace berm::fem::this_file {
namespace {

AtSixNodes<Vec<2>> straight(const Vec<2>& a, const Vec<2>& b, const Vec<2>& c)
{
  return {a, b, c, (a + b) / 2, (b + c) / 2, (c + a) / 2};
}

// No side is along an axis, and the matrix of its edges is not symmetric.
const AtSixNodes<Vec<2>> sample = straight({0.3, -0.2}, {1.7, 0.1}, {0.5, 1.3});

// The sample with one side bent outwards.
AtSixNodes<Vec<2>> bent()
{
  AtSixNodes<Vec<2>> x = sample;
  x[4] += Vec<2>(0.1, 0.13);
  return x;
}

Vec<2> index_of(const AtSixNodes<Vec<2>>& nodes, const ShapeAtPoint& shape)
{
  Vec<2> x = Vec<2>::Zero();
  for (int k = 0; k < 6; ++k) x += shape.value[k] * nodes[k];
  return x;
}

template <class Field>
Vec<2> gradient_of(const Field& field, const AtSixNodes<Vec<2>>& nodes, const ShapeAtPoint& shape)
{
  Vec<2> sum = Vec<2>::Zero();
  for (int k = 0; k < 6; ++k) sum += field(nodes[k]) * shape.gradient[k];
  return sum;
}

// Numbers near 1 throughout: 1e-14 is some ten roundings.
constexpr Real rounding = 1e-14;

TEST(Element, points_share_the_area_of_a_straight_triangle)
{
  const Real area = ((1.7 - 0.3) * (1.3 + 0.2) - (0.5 - 0.3) * (0.1 + 0.2)) / 2;
  for (int q = 0; q < triangle_points; ++q) EXPECT_NEAR(shape_at(sample, q).area, area / 3, rounding);
}

TEST(Element, area_is_negative_where_the_triangle_is_inside_out)
{
  EXPECT_LT(shape_at(straight({0, 0}, {0, 1}, {1, 0}), 0).area, 0);
}

TEST(Element, area_of_a_bent_side_is_that_of_its_parabola)
{
  // A parabola encloses 2/3 of chord times rise with its chord; the part of the rise across the chord counts.
  const Vec<2> chord = sample[2] - sample[1], rise(0.1, 0.13);
  const Real more = 2. / 3 * (chord[1] * rise[0] - chord[0] * rise[1]);
  Real area = 0, before = 0;
  for (int q = 0; q < triangle_points; ++q) {
    area += shape_at(bent(), q).area;
    before += shape_at(sample, q).area;
  }
  EXPECT_NEAR(area - before, more, rounding);
}

TEST(Element, gradients_reproduce_linear_fields_with_bent_sides_too)
{
  const auto field = [](const Vec<2>& x) { return 3 - 2 * x[0] + 0.7 * x[1]; };
  for (const auto& nodes : {sample, bent()})
    for (int q = 0; q < triangle_points; ++q) EXPECT_LT((gradient_of(field, nodes, shape_at(nodes, q)) - Vec<2>(-2, 0.7)).norm(), rounding);
}

TEST(Element, values_and_gradients_reproduce_quadratic_fields_with_straight_sides)
{
  const auto field = [](const Vec<2>& x) { return x[0] * x[0] - 3 * x[0] * x[1] + 0.5 * x[1] * x[1] + x[1]; };
  for (int q = 0; q < triangle_points; ++q) {
    const ShapeAtPoint shape = shape_at(sample, q);
    const Vec<2> x = index_of(sample, shape);
    Real value = 0;
    for (int k = 0; k < 6; ++k) value += shape.value[k] * field(sample[k]);
    EXPECT_NEAR(value, field(x), rounding);
    EXPECT_LT((gradient_of(field, sample, shape) - Vec<2>(2 * x[0] - 3 * x[1], -3 * x[0] + x[1] + 1)).norm(), rounding);
  }
}

TEST(Element, points_integrate_quadratic_functions_exactly)
{
  // Over the reference triangle: r2 -> 1/12, r s -> 1/24.
  const AtSixNodes<Vec<2>> reference = six_nodes;
  Real rr = 0, rs = 0;
  for (int q = 0; q < triangle_points; ++q) {
    const ShapeAtPoint shape = shape_at(reference, q);
    const Vec<2> x = index_of(reference, shape);
    rr += shape.area * x[0] * x[0];
    rs += shape.area * x[0] * x[1];
  }
  EXPECT_NEAR(rr, 1. / 12, rounding);
  EXPECT_NEAR(rs, 1. / 24, rounding);
}

}  // namespace
}  // namespace berm::fem::this_file
