// SPDX-License-Identifier: BSD-3-Clause
#include "os/text_of_list.hpp"

#include <gtest/gtest.h>
#include <vector>

namespace berm::this_file {
namespace {

TEST(TextOfList, has_its_text_between_elements_and_each_in_its_form)
{
  EXPECT_EQ(text_of_list(std::vector<std::string>{"", "a", ""}, ", "), ", a, ");
  EXPECT_EQ(text_of_list(std::vector<double>{0.5, 1. / 3}, "; ", "{:.2g} m"), "0.5 m; 0.33 m");
  EXPECT_EQ(text_of_list(std::vector<int>{7}, ", "), "7");
  EXPECT_EQ(text_of_list(std::vector<int>{}, ", "), "");
}

}  // namespace
}  // namespace berm::this_file
