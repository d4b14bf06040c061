// SPDX-License-Identifier: BSD-3-Clause
#include "io/duration_text.hpp"

#include <gtest/gtest.h>

namespace berm::io::this_file {
namespace {

TEST(Duration, is_said_in_words)
{
  const std::vector<std::pair<Real, std::string>> cases = {{0.04, "40 ms"},         {3.1, "3.1 s"},          {9.96, "10 s"},
                                                           {59.4, "59 s"},          {59.6, "1 min 00 s"},    {725, "12 min 05 s"},
                                                           {3599.4, "59 min 59 s"}, {3599.6, "1 h 00 min"},  {3720, "1 h 02 min"},
                                                           {7199, "2 h 00 min"},    {180000, "50 h 00 min"}, {0, "0 ms"}};
  for (const auto& [seconds, words] : cases) EXPECT_EQ(duration_text(seconds), words) << seconds;
  EXPECT_EQ(duration_text(std::numeric_limits<Real>::quiet_NaN()), "?");
  EXPECT_EQ(duration_text(-1), "?");
  EXPECT_EQ(duration_text(1e30), "3.17e+22 years");
  EXPECT_EQ(duration_text(infinity), "?");
}

}  // namespace
}  // namespace berm::io::this_file
