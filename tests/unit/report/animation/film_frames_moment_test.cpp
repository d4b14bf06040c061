// SPDX-License-Identifier: BSD-3-Clause
#include "report/animation/film_frames.hpp"
#include "samples/history_columns.hpp"

#include <gtest/gtest.h>

namespace berm::report::this_file {
namespace {

/// A pipe that goes 3 m along x and 4 m down from t = 1 to 2 s, back the same way until 3 s.
run_folder::History there_and_back()
{
  run_folder::History h;
  h.columns = columns_named({"time_s", "u_m", "w_m", "H_N_m", "V_N_m"});
  h.values = {{0, 1, 2, 3}, {0, 0, 3, 0}, {0, 0, 4, 0}, {0, 10, 20, 30}, {0, 100, 200, 300}};
  h.stage = {"settle", "settle", "push", "drag"};
  return h;
}

TEST(film_moment, place_is_between_rows_and_forces_are_of_the_nearest_row)
{
  const run_folder::History h = there_and_back();
  const FilmMoment moment = moment_at(h, 1.75);
  EXPECT_DOUBLE_EQ(moment.u, 2.25);
  EXPECT_DOUBLE_EQ(moment.w, 3);
  EXPECT_EQ(moment.H, 20);
  EXPECT_EQ(moment.V, 200);
  EXPECT_EQ(moment.stage, "push");
  EXPECT_EQ(moment_at(h, 1.25).V, 100);
  EXPECT_EQ(moment_at(h, 1).stage, "settle");
  EXPECT_EQ(moment_at(h, 1).u, 0);
  EXPECT_EQ(moment_at(h, 2).u, 3);
}

TEST(film_moment, beyond_the_rows_is_that_of_the_first_or_last)
{
  const run_folder::History h = there_and_back();
  EXPECT_EQ(moment_at(h, -5).stage, "settle");
  EXPECT_EQ(moment_at(h, -5).V, 0);
  EXPECT_EQ(moment_at(h, 99).stage, "drag");
  EXPECT_EQ(moment_at(h, 99).V, 300);
  EXPECT_EQ(moment_at(h, 99).u, 0);
}

TEST(film_moment, of_an_empty_history_is_unknown)
{
  const FilmMoment moment = moment_at(run_folder::History{}, 1);
  EXPECT_EQ(moment.stage, "");
  EXPECT_TRUE(std::isnan(moment.u) && std::isnan(moment.w) && std::isnan(moment.H) && std::isnan(moment.V));
  EXPECT_TRUE(std::isnan(way_between(run_folder::History{}, 0, 1)));
}

TEST(film_moment, way_is_the_length_of_the_path_not_the_distance)
{
  const run_folder::History h = there_and_back();
  EXPECT_DOUBLE_EQ(way_between(h, 0, 1), 0);
  EXPECT_DOUBLE_EQ(way_between(h, 1, 2), 5);
  EXPECT_DOUBLE_EQ(way_between(h, 1.5, 2.5), 5);  // it returns to where it was
  EXPECT_DOUBLE_EQ(way_between(h, 1.2, 1.4), 1);
  EXPECT_DOUBLE_EQ(way_between(h, 0, 9), 10);
}

}  // namespace
}  // namespace berm::report::this_file
