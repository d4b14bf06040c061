// SPDX-License-Identifier: BSD-3-Clause
#include "soil_plot/soil_plot.hpp"

#include "samples/drawn_run.hpp"
#include "samples/pixel_color.hpp"

namespace berm::soil_plot::this_file {
namespace {

class SpacePlot : public DrawnRun {
protected:
  /// A cube of 1 m filled with 20^3 particles; those with z < 0.5 m have the strain 0 and the others 1.
  static run_folder::Frame<3> cube()
  {
    run_folder::Frame<3> frame;
    constexpr int n = 20;
    frame.allocate(n * n * n, run_folder::common_fields<3>());
    for (int k = 0; k < n * n * n; ++k) {
      frame.points[k] = (Vec<3>(k % n, k / n % n, k / n / n) + Vec<3>::Constant(0.5)) / n;
      frame.volume[k] = 1. / (n * n * n);
      frame.field("deviatoric_strain").at(k) = frame.points[k][2] < 0.5 ? 0 : 1;
    }
    return frame;
  }
  Color middle_of(const std::string& name)
  {
    const auto [width, height] = png_size(folder.file(name + ".png"));
    return color_at(folder.file(name + ".png"), 95 + (width - 270) / 3, 70 + (height - 180) * 3 / 5);  // on the side that is looked at
  }
};

TEST_F(SpacePlot, the_cut_shows_the_soil_in_its_middle_coloured_by_its_field)
{
  if (!gnuplot_is_there()) GTEST_SKIP() << "gnuplot is not installed";
  const Vec<3> lower(0, 0, 0), upper(1, 1, 1);
  ASSERT_TRUE(draw_soil(folder.path(), cube(), {"cut", "deviatoric_strain", view_of_all(lower, upper, false), "cut"}));
  ASSERT_TRUE(draw_soil(folder.path(), cube(), {"whole", "deviatoric_strain", {lower, upper}, "whole"}));
  const Color cut = middle_of("cut"), whole = middle_of("whole");
  EXPECT_GT(cut[2], cut[1] + 15);      // violet: zero
  EXPECT_GT(whole[0], whole[2] + 60);  // yellow: one
  EXPECT_GT(whole[1], whole[2] + 60);
}

TEST_F(SpacePlot, a_half_is_shown_as_the_other_half_so_that_its_plane_of_symmetry_is_seen)
{
  if (!gnuplot_is_there()) GTEST_SKIP() << "gnuplot is not installed";
  const SpaceView view = view_of_all({0, 0, 0}, {1, 1, 1}, true);
  EXPECT_EQ(view.lower[2], -1);
  EXPECT_EQ(view.upper[2], 0);
  ASSERT_TRUE(draw_soil(folder.path(), cube(), {"half", "deviatoric_strain", view, "half"}));
  const Color half = middle_of("half");
  EXPECT_GT(half[2], half[1] + 15);  // the particles of least z, whose strain is zero
}

TEST_F(SpacePlot, no_picture_is_drawn_where_no_soil_is)
{
  EXPECT_FALSE(draw_soil(folder.path(), cube(), {"none", "deviatoric_strain", {Vec<3>(2, 2, 2), Vec<3>(3, 3, 3)}, "none"}));
}

TEST(SpaceView, a_body_is_cut_along_its_middle_and_seen_with_the_soil_beside_it_as_far_as_the_mesh_reaches)
{
  bodies::SurfaceMesh<3> body;
  body.points = {Vec<3>(-0.1, 0, -0.3), Vec<3>(0.1, 0.2, 0.5)};
  const SpaceView view = view_around(body, 0.2, {-1, -0.1, -1}, {1, 1, 1}, false);
  EXPECT_NEAR((view.lower - Vec<3>(-0.6, -0.1, -0.8)).norm(), 0, 1e-12);
  EXPECT_NEAR((view.upper - Vec<3>(0.6, 0.24, 0.1)).norm(), 0, 1e-12);
}

}  // namespace
}  // namespace berm::soil_plot::this_file
