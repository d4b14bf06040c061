// SPDX-License-Identifier: BSD-3-Clause
#include "material/user_law.hpp"

#include "material/laws.hpp"

#include <gtest/gtest.h>

namespace berm::material::this_file {
namespace {

using Own = UserLaw<Interface::own>;

TEST(UserLaw, has_as_many_state_variables_as_the_input_says)
{
  Own law;
  law.state_variables = 2;
  EXPECT_EQ(state_size(Material(law)), 2);
  ASSERT_EQ(state_fields(law).size(), 2u);
  EXPECT_EQ(state_fields(law)[1].name, "law_state_2");
  law.state_names = {"void_ratio", "plastic_strain"};
  EXPECT_EQ(state_fields(law)[0].name, "law_void_ratio");
  EXPECT_EQ(state_fields(law)[0].label, "void_ratio");
}

TEST(UserLaw, begins_with_the_state_of_the_input)
{
  Own law;
  law.state_variables = 2;
  Real state[2] = {0, 0};
  initial_state(Material(law), {}, state);
  EXPECT_EQ(state[1], 0);
  law.initial_state = {0.8, 0.1};
  initial_state(Material(law), {}, state);
  EXPECT_EQ(state[0], 0.8);
  EXPECT_EQ(state[1], 0.1);
}

TEST(UserLaw, both_interfaces_share_what_a_step_needs)
{
  EXPECT_TRUE((std::is_same_v<PreparedLaw<Own>, PreparedLaw<UserLaw<Interface::umat>>>));
  EXPECT_STREQ(Own::word, "user");
  EXPECT_STREQ(UserLaw<Interface::umat>::word, "umat");
  EXPECT_EQ(std::variant_size_v<Laws::Prepared>, 2 * (std::variant_size_v<Laws::Any> - 1) - 2)
      << "each drained and, but for clay and ngi_adp, undrained";
}

TEST(UserLaw, yields_unless_the_input_says_that_it_cannot)
{
  Own law;
  EXPECT_TRUE(yields(law));
  law.can_yield = false;
  EXPECT_FALSE(yields(law));
  EXPECT_FALSE(strength_at_rest(law));
  EXPECT_FALSE(dilates(law));
}

}  // namespace
}  // namespace berm::material::this_file
