// SPDX-License-Identifier: BSD-3-Clause
#include "report/animation/film_frames.hpp"

#include "samples/sample_film_run.hpp"

#include <algorithm>
#include <gtest/gtest.h>

namespace berm::report::this_file {
namespace {

constexpr std::size_t bytes_of_frame = 32 * 36;  // 32 particles of two places and five numbers

TEST(film_footage, takes_no_more_memory_than_it_may_and_keeps_the_ends_of_stages)
{
  const SampleFilmRun<2> sample(11);
  EXPECT_EQ(read_footage(sample.run).frames.size(), 11u);
  const FilmFrames footage = read_footage(sample.run, bytes_of_frame * 11 / 3);
  EXPECT_EQ(footage.step, 4);
  EXPECT_EQ(footage.time, (std::vector<Real>{0, sample.time(2), sample.time(4), sample.time(8), sample.time(10)}));
  EXPECT_EQ(footage.frames.size(), 5u);
  EXPECT_EQ(footage.stages(), (std::vector<std::string>{"settle", "settle", "drag", "drag", "drag"}));
  EXPECT_EQ(footage.fault, "");
}

TEST(film_footage, counts_the_shearing_of_the_frames_that_are_left_out)
{
  const SampleFilmRun<2> sample(11);
  const FilmFrames footage = read_footage(sample.run, bytes_of_frame * 11 / 3);
  const auto summed = std::find_if(footage.fields.begin(), footage.fields.end(), [](const FilmField& field) { return field.summed; });
  ASSERT_NE(summed, footage.fields.end());
  const auto sheared = static_cast<std::size_t>(summed - footage.fields.begin());
  for (std::size_t f = 0; f < footage.frames.size(); ++f)
    for (std::size_t k = 0; k < 32; ++k) {
      const Real frame = footage.time[f] / sample.first_time;
      EXPECT_NEAR(footage.frames[f].fields[sheared][k], 0.01 * frame * frame + 0.001 * frame * static_cast<Real>(k % 8), 1e-6);
    }
}

TEST(film_footage, counts_the_frames_of_the_run_in_what_it_says)
{
  const SampleFilmRun<2> sample(11);
  std::filesystem::remove(sample.file("particles_0008.vtu"));
  const FilmFrames footage = read_footage(sample.run, bytes_of_frame * 11 / 3);
  EXPECT_EQ(footage.frames.size(), 3u);
  EXPECT_EQ(footage.fault.find("frame 9 of 11 cannot be read: "), 0u) << footage.fault;
}

}  // namespace
}  // namespace berm::report::this_file
