// SPDX-License-Identifier: BSD-3-Clause
#include "structures/driven/quantities.hpp"

#include "samples/made_push.hpp"

#include <gtest/gtest.h>

namespace berm::driven::this_file {
namespace {

/// A box in space that is pushed, with moments that grow with its way.
record::RunRecord pushed_box(settings::Geometry geometry)
{
  MadePush made;
  made.geometry = geometry;
  made.shape = geometry == settings::Geometry::space ? bodies::BoxSettings{{0, 0.05, 0}, {0.2, 0.1, 0.2}}
                                                     : bodies::BoxSettings{{0, 0.05}, {0.2, 0.1}};
  record::RunRecord run = made.record();
  std::vector<std::string> names = {"time_s", "u_m", "w_m", "H_N", "V_N", "Mx_Nm", "My_Nm", "Mz_Nm"};
  run.history.columns = columns_named(names);
  const std::vector<Real> w = run.history.values[2];
  for (const Real slope : {30., 1e-3, -7.}) {
    run.history.values.push_back(w);
    for (Real& M : run.history.values.back()) M *= slope;
  }
  return run;
}

TEST(MomentsInSpace, are_those_at_the_end_of_the_push_without_what_is_noise)
{
  const std::vector<run_folder::Quantity> moments = moments_in_space(pushed_box(settings::Geometry::space));
  ASSERT_EQ(moments.size(), 2u);
  EXPECT_EQ(moments[0].name, "Mx_end_of_push");
  EXPECT_EQ(moments[0].unit, "N m");
  EXPECT_NEAR(moments[0].value, 30 * 2, 1e-9);
  EXPECT_EQ(moments[1].name, "Mz_end_of_push");
  EXPECT_NEAR(moments[1].value, -7 * 2, 1e-9);
}

TEST(MomentsInSpace, are_of_space_only)
{
  EXPECT_TRUE(moments_in_space(pushed_box(settings::Geometry::axisymmetric)).empty());
}

}  // namespace
}  // namespace berm::driven::this_file
