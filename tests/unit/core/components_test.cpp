// SPDX-License-Identifier: BSD-3-Clause
#include "core/components.hpp"

#include <gtest/gtest.h>

namespace berm::this_file {
namespace {

template <class Dimension>
class Components : public testing::Test {
};
using Dimensions = testing::Types<std::integral_constant<int, 2>, std::integral_constant<int, 3>>;
TYPED_TEST_SUITE(Components, Dimensions);

TYPED_TEST(Components, come_from_any_place_in_memory_and_go_there_and_no_further)
{
  constexpr int dim = TypeParam::value;
  const Real from[] = {9, 1, 2, 4, 9};
  const berm::Components<dim> twice = 2 * components<dim>(from + 1);
  Real to[] = {0, 0, 0, 0, 0};
  store<dim>(twice, to + 1);
  for (int d = 0; d < 5; ++d) EXPECT_EQ(to[d], d >= 1 && d <= dim ? 2 * from[d] : 0) << d;
  EXPECT_EQ(sum_of_components<dim>(twice), dim == 2 ? 6 : 14);
  EXPECT_EQ(components(vector_of<dim>(twice))[dim - 1], 2 * from[dim]);
}

}  // namespace
}  // namespace berm::this_file
