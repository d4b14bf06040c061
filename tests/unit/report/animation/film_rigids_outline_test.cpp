// SPDX-License-Identifier: BSD-3-Clause
#include "report/animation/film_rigids.hpp"

#include <cstring>
#include <gtest/gtest.h>

namespace berm::report::this_file {
namespace {

FilmFrame with(run_folder::SavedRigids rigid_bodies)
{
  FilmFrame frame;
  frame.rigid_bodies = std::move(rigid_bodies);
  return frame;
}

TEST(film_outline, part_that_comes_later_is_not_there_before)
{
  const FilmFrame first = with({{0, 1, 0}, {0, 0, 1}, {0, 0, 0}, {{0, 1, 2}}, {run_folder::VtkCell::polygon}, {4}});
  const FilmFrame second = with(
      {{5, 6, 5, 7}, {0, 0, 1, 8}, {0, 0, 0, 0}, {{0, 1, 2}, {3, 0}}, {run_folder::VtkCell::polygon, run_folder::VtkCell::line}, {4, 4}});
  const std::vector<FilmOutline> outlines = film_outlines({&first, &second}, 2);
  ASSERT_EQ(outlines.size(), 2u);
  EXPECT_EQ(outlines[0].rigid, 4);
  EXPECT_EQ(outlines[0].points, 3);
  EXPECT_EQ(outlines[0].corners, (std::vector<Real>{0, 0, 1, 0, 0, 1, 5, 0, 6, 0, 5, 1}));
  EXPECT_EQ(outlines[1].rigid, 4);
  EXPECT_EQ(outlines[1].points, 2);
  ASSERT_EQ(outlines[1].corners.size(), 8u);
  for (std::size_t k = 0; k < 4; ++k) EXPECT_TRUE(std::isnan(outlines[1].corners[k]));
  EXPECT_EQ((std::vector<Real>(outlines[1].corners.begin() + 4, outlines[1].corners.end())), (std::vector<Real>{7, 8, 5, 0}));
}

TEST(film_outline, in_space_is_one_end_of_what_is_extruded_and_nothing_of_the_rest)
{
  // A prism over a triangle, and a box.
  run_folder::SavedRigids rigid_bodies;
  rigid_bodies.x = {0, 0, 1, 1, 0, 0, 9, 9, 9, 9, 9, 9, 9, 9};
  rigid_bodies.y = {0, 0, 0, 0, 1, 1, 9, 9, 9, 9, 9, 9, 9, 9};
  rigid_bodies.z = {-1, 1, -1, 1, -1, 1, 9, 9, 9, 9, 9, 9, 9, 9};
  rigid_bodies.cells = {{0, 2, 3, 1}, {2, 4, 5, 3}, {4, 0, 1, 5}, {6, 7, 8, 9, 10, 11, 12, 13}};
  rigid_bodies.types = {run_folder::VtkCell::quad, run_folder::VtkCell::quad, run_folder::VtkCell::quad, run_folder::VtkCell::hexahedron};
  rigid_bodies.rigid = {0, 0, 0, 1};
  const FilmFrame frame = with(rigid_bodies);
  const std::vector<FilmOutline> outlines = film_outlines({&frame}, 3);
  ASSERT_EQ(outlines.size(), 1u);
  EXPECT_EQ(outlines[0].corners, (std::vector<Real>{0, 0, 1, 0, 0, 1}));
}

TEST(film_outline, keeps_its_shape_at_survey_coordinates)
{
  constexpr Real east = 500'000.25, north = 6'500'000.5;
  const FilmFrame frame =
      with({{east, east + 0.01, east}, {north, north, north + 0.01}, {0, 0, 0}, {{0, 1, 2}}, {run_folder::VtkCell::polygon}, {0}});
  const FilmOutline outline = film_outlines({&frame}, 2).front();
  const std::string bytes = outline_bytes(outline, Vec<2>(east - 1, north - 1));
  std::array<float, 6> corners;
  ASSERT_EQ(bytes.size(), sizeof corners);
  std::memcpy(corners.data(), bytes.data(), sizeof corners);
  const Real expected[] = {1, 1, 1.01, 1, 1, 1.01};
  for (std::size_t k = 0; k < 6; ++k) EXPECT_NEAR(corners[k], expected[k], 1e-7);
}

}  // namespace
}  // namespace berm::report::this_file
