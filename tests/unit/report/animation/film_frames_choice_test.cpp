// SPDX-License-Identifier: BSD-3-Clause
#include "report/animation/film_frames.hpp"

#include <gtest/gtest.h>

namespace berm::report::this_file {
namespace {

const std::vector<std::string> stages = {"settle", "settle", "push", "push", "push", "push", "drag", "drag", "drag"};

TEST(film_choice, keeps_the_first_the_last_and_the_last_of_each_stage)
{
  EXPECT_EQ(kept_frames(stages, 1), (std::vector<Index>{0, 1, 2, 3, 4, 5, 6, 7, 8}));
  EXPECT_EQ(kept_frames(stages, 2), (std::vector<Index>{0, 1, 2, 4, 5, 6, 8}));
  EXPECT_EQ(kept_frames(stages, 4), (std::vector<Index>{0, 1, 4, 5, 8}));
  EXPECT_EQ(kept_frames(stages, 100), (std::vector<Index>{0, 1, 5, 8}));
  EXPECT_EQ(kept_frames({"a"}, 3), (std::vector<Index>{0}));
}

TEST(film_choice, is_told_in_words)
{
  EXPECT_EQ(kept_words(1), "");
  EXPECT_EQ(kept_words(2), "every 2nd frame");
  EXPECT_EQ(kept_words(3), "every 3rd frame");
  EXPECT_EQ(kept_words(4), "every 4th frame");
  EXPECT_EQ(kept_words(11), "every 11th frame");
  EXPECT_EQ(kept_words(12), "every 12th frame");
  EXPECT_EQ(kept_words(21), "every 21st frame");
  EXPECT_EQ(kept_words(112), "every 112th frame");
}

}  // namespace
}  // namespace berm::report::this_file
