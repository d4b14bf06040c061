// SPDX-License-Identifier: BSD-3-Clause
#include "io/revision.hpp"

#include <gtest/gtest.h>
#include <regex>

namespace berm::io::this_file {
namespace {

TEST(Revision, is_a_commit_and_stands_behind_the_version)
{
  EXPECT_TRUE(std::regex_match(revision, std::regex("([0-9a-f]{7,40}\\+?)?"))) << revision;
  EXPECT_TRUE(std::regex_match(version_words(), std::regex(R"(\d+\.\d+\.\d+( \([0-9a-f]{7,40}\+?\))?)"))) << version_words();
}

}  // namespace
}  // namespace berm::io::this_file
