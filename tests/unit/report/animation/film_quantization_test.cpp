// SPDX-License-Identifier: BSD-3-Clause
#include "report/animation/film_quantization.hpp"

#include "samples/film_decoding.hpp"

#include <random>

namespace berm::report::this_file {
namespace {

struct Moving {
  std::vector<FilmFrame> frames;
  std::vector<const FilmFrame*> shown;
};

/// Points that jump anywhere in 3 x 1 m, corners among them.
Moving wild_points(std::size_t frames, std::size_t count)
{
  std::mt19937 random(1);
  std::uniform_real_distribution<float> anywhere(0, 1);
  Moving moving;
  for (std::size_t f = 0; f < frames; ++f) {
    FilmFrame& frame = moving.frames.emplace_back();
    for (std::size_t k = 0; k < count; ++k) {
      const bool corner = anywhere(random) < 0.2f;
      frame.x.push_back(-2 + 3 * (corner ? std::round(anywhere(random)) : anywhere(random)));
      frame.y.push_back(5 + (corner ? std::round(anywhere(random)) : anywhere(random)));
    }
  }
  for (const FilmFrame& frame : moving.frames) moving.shown.push_back(&frame);
  return moving;
}

TEST(film_codes, places_decode_within_half_a_step_however_far_points_jump)
{
  const Moving moving = wild_points(6, 500);
  const FilmGrid grid(box_of(moving.shown));
  EXPECT_NEAR(grid.step, 3. / 65535, 1e-12);
  const auto codes = decoded_places(position_bytes(moving.shown, grid), 6, 500);
  for (std::size_t f = 0; f < 6; ++f)
    for (std::size_t k = 0; k < 500; ++k) {
      EXPECT_NEAR(grid.lower[0] + grid.step * codes[0][f][k], moving.frames[f].x[k], grid.step * 0.5001);
      EXPECT_NEAR(grid.lower[1] + grid.step * codes[1][f][k], moving.frames[f].y[k], grid.step * 0.5001);
    }
}

TEST(film_codes, places_decode_at_survey_coordinates_as_they_do_at_the_origin)
{
  Moving near = wild_points(2, 100), far = wild_points(2, 100);
  for (FilmFrame& frame : far.frames) {
    for (Real& x : frame.x) x += 500'000;
    for (Real& y : frame.y) y += 6'500'000;
  }
  const FilmGrid grid(box_of(near.shown)), far_grid(box_of(far.shown));
  EXPECT_NEAR(far_grid.step, grid.step, 1e-13);
  const auto codes = decoded_places(position_bytes(near.shown, grid), 2, 100),
             far_codes = decoded_places(position_bytes(far.shown, far_grid), 2, 100);
  for (std::size_t d = 0; d < 2; ++d)
    for (std::size_t f = 0; f < 2; ++f)
      for (std::size_t k = 0; k < 100; ++k) EXPECT_NEAR(far_codes[d][f][k], codes[d][f][k], 1);
}

TEST(film_codes, small_moves_either_way_leave_the_plane_of_high_bytes_empty)
{
  Moving moving = wild_points(1, 200);
  const FilmGrid grid(box_of(moving.shown));
  FilmFrame next = moving.frames[0];
  for (std::size_t k = 0; k < 200; ++k) next.x[k] += (k % 2 == 0 ? 1 : -1) * 100 * grid.step;
  moving.shown.push_back(&next);
  const std::string bytes = position_bytes(moving.shown, grid);
  EXPECT_EQ(bytes.substr(3 * 200, 200), std::string(200, '\0'));  // x, high bytes, second frame
}

TEST(film_codes, a_single_point_that_rests_has_a_grid)
{
  const FilmFrame frame{.x = {1}, .y = {2}, .z = {}, .flow_x = {}, .flow_y = {}, .fields = {}, .rigid_bodies = {}};
  const FilmGrid grid(box_of({&frame}));
  EXPECT_GT(grid.step, 0);
  EXPECT_EQ(grid.code(1, 0), 0);
}

TEST(film_codes, field_decodes_within_half_a_level_and_is_clipped)
{
  std::mt19937 random(2);
  std::uniform_real_distribution<float> anywhere(-0.1f, 1.2f);
  const Real high = 0.8;
  std::vector<float> values;
  for (int k = 0; k < 3000; ++k) values.push_back(anywhere(random));
  const auto decoded = decoded_values(field_bytes(values, 500, {0, high}), 6, 500);
  for (std::size_t k = 0; k < 3000; ++k)
    EXPECT_NEAR(high * decoded[k / 500][k % 500] / 255, std::clamp<Real>(values[k], 0, high), high / 255 * 0.5001);
}

TEST(film_codes, range_ends_where_two_in_a_thousand_values_are_beyond)
{
  std::vector<float> values(10'000);
  for (std::size_t k = 0; k < values.size(); ++k)
    values[k] = 1e-3f * static_cast<float>((k * 7919) % values.size());  // 0 to 9.999, shuffled
  EXPECT_EQ(range_of(values).high, 10);
  for (std::size_t k = 0; k < 20; ++k) values[k] = 1e6f;
  EXPECT_EQ(range_of(values).high, 10);
  for (std::size_t k = 0; k < 25; ++k) values[k] = 1e6f;
  EXPECT_EQ(range_of(values).high, 1e6);
  EXPECT_EQ(range_of({0.29f}).high, 0.3);  // as it is written, not 3 * 0.1
  EXPECT_EQ(range_of({-0.1f, 0.1f, 3}).low, -0.1);
  std::vector<float> few(10'000, 0.f);
  few[7] = 0.2f;
  EXPECT_EQ(range_of(few).high, 0.2);
}

TEST(film_codes, range_of_nothing_is_not_empty)
{
  for (const std::vector<float>& values : {std::vector<float>{}, std::vector<float>{0, 0, 0}, std::vector<float>{-1, -2}})
    EXPECT_GT(range_of(values).high, range_of(values).low);
}

}  // namespace
}  // namespace berm::report::this_file
