// SPDX-License-Identifier: BSD-3-Clause
#include "material/principal_axes.hpp"

#include "mohr_coulomb_cases.hpp"

#include <gtest/gtest.h>
#include <numeric>

namespace berm::material::this_file {
namespace {

TEST(PrincipalAxes, give_the_tensor_back_with_right_angles_between_them)
{
  std::mt19937_64 random(10);
  for (int n = 0; n < 20000; ++n) {
    SymTensor<3> a = random_trial<3>(random);
    // A third of them with two values that are equal, or nearly so.
    if (n % 3 == 0) a = tensor_from({1e3, 1e3 * (1 - 1e-3 * std::exp(-n % 60)), -5e2}, principal_axes(a).direction);
    const PrincipalAxes axes = principal_axes(a);
    ASSERT_GE(axes.value[0], axes.value[1]);
    ASSERT_GE(axes.value[1], axes.value[2]);
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j)
        ASSERT_NEAR(std::inner_product(axes.direction[i], axes.direction[i] + 3, axes.direction[j], 0.), i == j, 1e-14);
    ASSERT_LE(size_of(difference(tensor_from(axes.value, axes.direction), a)), 1e-14 * size_of(a));
  }
}

}  // namespace
}  // namespace berm::material::this_file
