// SPDX-License-Identifier: BSD-3-Clause
#include "input/read_case.hpp"
#include "os/error.hpp"
#include "samples/wrong_inputs.hpp"

#include <gtest/gtest.h>

namespace berm::input::this_file {
namespace {

/// What refuses the good case with reactions of supports and this; "" where nothing does.
std::string refusal_with(const std::vector<std::string>& keys, const std::string& more = "")
{
  std::vector<std::string> all = {"output.support_reactions=true"};
  all.insert(all.end(), keys.begin(), keys.end());
  try {
    read_case_text("case.toml", std::string(test::good_case) + more, all);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

void expect_refusal(const std::string& refusal, std::initializer_list<const char*> says)
{
  for (const char* part : says) EXPECT_NE(refusal.find(part), std::string::npos) << "no `" << part << "` in: " << refusal;
}

TEST(SupportReactions, are_asked_for_in_the_output)
{
  EXPECT_FALSE(read_case_text("case.toml", std::string(test::good_case)).output.support_reactions);
  EXPECT_TRUE(read_case_text("case.toml", std::string(test::good_case), {"output.support_reactions=true"}).output.support_reactions);
  EXPECT_EQ(refusal_with({}), "");
}

TEST(SupportReactions, are_refused_without_a_support)
{
  std::string text(test::good_case);
  const std::string support = "[support.base]\nboundary = \"bottom\"\nfixed = [\"x\", \"y\"]\n";
  text.erase(text.find(support), support.size());
  try {
    read_case_text("case.toml", text, {"output.support_reactions=true"});
    FAIL() << "it is taken";
  } catch (const InputError& error) {
    expect_refusal(error.what(), {"output.support_reactions", "add a [support.NAME]"});
  }
}

TEST(SupportReactions, are_refused_beside_soil_that_rests)
{
  expect_refusal(refusal_with({"mpm.active_distance=1.6 m"}), {"output.support_reactions", "mpm.active_distance", "inactive soil"});
}

TEST(SupportReactions, need_a_name_that_no_traction_has)
{
  const std::string load = "[traction.base]\nboundary = \"top\"\npressure = \"1 kPa\"\n";
  expect_refusal(refusal_with({}, load), {"support.base", "a [traction.base] has this name"});
  EXPECT_NO_THROW(read_case_text("case.toml", std::string(test::good_case) + load));  // without reactions there is no column of it
}

}  // namespace
}  // namespace berm::input::this_file
