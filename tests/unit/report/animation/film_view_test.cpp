// SPDX-License-Identifier: BSD-3-Clause
#include "report/animation/film_view.hpp"

#include "samples/sample_film_run.hpp"

#include <gtest/gtest.h>

namespace berm::report::this_file {
namespace {

const FilmBox wide{Vec<2>(-9, -9), Vec<2>(9, 0)};

TEST(film_view, is_around_the_whole_path_of_the_pipe)
{
  SampleFilmRun<2> sample(13);  // to u = 0.22 D, w = 0.11 D
  std::get<mesh::BoxMesh>(sample.run.settings.mesh).size[1] = 20;
  const Real D = sample.D;
  const FilmBox view = film_view(sample.run, wide);
  EXPECT_NEAR(view.lower[0], -2.5 * D, 1e-12);
  EXPECT_NEAR(view.upper[0], sample.u(12) + 2.5 * D, 1e-12);
  EXPECT_NEAR(view.lower[1], -sample.w(12) - 2 * D, 1e-12);
  EXPECT_NEAR(view.upper[1], 1.3 * D, 1e-12);
}

TEST(film_view, ends_with_the_soil_and_the_room_above_it)
{
  SampleFilmRun<2> sample(13);
  const FilmBox view = film_view(sample.run, {Vec<2>(-0.03, -0.01), Vec<2>(0.04, 0.001)});
  EXPECT_EQ(view.lower, Vec<2>(-0.03, -0.01));
  EXPECT_EQ(view.upper[0], 0.04);
  mesh::SeabedMesh seabed;
  seabed.headroom = 0.012;
  sample.run.settings.mesh = seabed;
  EXPECT_EQ(film_view(sample.run, wide).upper[1], 0.012);
}

TEST(film_view, of_a_pipe_that_starts_high_above_the_soil_is_near_the_soil)
{
  SampleFilmRun<2> sample(1);
  std::get<mesh::BoxMesh>(sample.run.settings.mesh).size[1] = 20;
  std::get<bodies::CircleSettings>(sample.run.settings.rigid[0].second.shape).center[1] = 3.01;
  sample.run.history.values[2] = {-3};
  EXPECT_NEAR(film_view(sample.run, wide).upper[1], 3 + 1.3 * sample.D, 1e-12);  // it never comes down
  sample.run.history.values = {{0, 1}, {0, 0}, {-3, 0.01}, {0, 0}, {0, 0}};
  sample.run.history.stage = {"push", "push"};
  EXPECT_NEAR(film_view(sample.run, wide).upper[1], 1.3 * sample.D, 1e-12);
}

TEST(film_view, passes_over_rows_that_are_no_numbers)
{
  SampleFilmRun<2> sample(13);
  const FilmBox before = film_view(sample.run, wide);
  sample.run.history.values[1][4] = std::numeric_limits<Real>::quiet_NaN();
  EXPECT_EQ(film_view(sample.run, wide).lower, before.lower);
  EXPECT_EQ(film_view(sample.run, wide).upper, before.upper);
}

TEST(film_view, without_a_pipe_is_the_soil)
{
  const SampleFilmRun<2> sample(1, false);
  EXPECT_EQ(film_view(sample.run, wide).lower, wide.lower);
  EXPECT_EQ(film_view(sample.run, wide).upper, wide.upper);
}

TEST(film_view, surface_is_known_of_a_flat_bed)
{
  record::RunRecord run;
  settings::Case& c = run.settings;
  c.mesh = mesh::BoxMesh{};
  c.surface = 0.5;
  c.body = {{"sand", bodies::BodySettings{}}};
  EXPECT_FALSE(film_surface(run));
  c.body[0].second.k0 = 1;
  EXPECT_EQ(film_surface(run), 0.5);
  c.body[0].second.k0.reset();
  c.mesh = mesh::SeabedMesh{};
  EXPECT_EQ(film_surface(run), 0.5);
}

}  // namespace
}  // namespace berm::report::this_file
