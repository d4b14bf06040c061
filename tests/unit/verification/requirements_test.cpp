// SPDX-License-Identifier: BSD-3-Clause
#include "verification/requirements.hpp"

#include <gtest/gtest.h>

namespace berm::verification::this_file {
namespace {

ExpectationResult result(Verdict verdict)
{
  ExpectationResult result;
  result.problem = std::string("slope/a");
  result.what = std::string("u");
  result.verdict = verdict;
  return result;
}

Expectation expectation(const std::string& requirement)
{
  Expectation e;
  e.run = std::string("a");
  e.requirement = requirement;
  e.derived = std::string("section 4");
  return e;
}

/// An example with three numbers of two promises; the second is missed.
ExamplePage page()
{
  ExamplePage page;
  page.example.name = std::string("slope");
  page.example.runs = {{"a", {}}};
  page.example.expectations = {expectation("it <slides>"), expectation("it stops"), expectation("it <slides>")};
  page.findings = {result(Verdict::met), result(Verdict::missed), result(Verdict::met)};
  return page;
}

TEST(Requirements, stand_once_with_all_numbers_that_prove_them)
{
  const std::vector<Promise> promises = promises_of(page().example);
  ASSERT_EQ(promises.size(), 2u);
  EXPECT_EQ(promises[0].requirement, "it <slides>");
  EXPECT_EQ(promises[0].derived, "section 4");
  EXPECT_EQ(promises[0].numbers, (std::vector<std::size_t>{0, 2}));
}

TEST(Requirements, are_printed_with_the_runs_that_prove_them_and_their_results)
{
  const std::string text = requirements_text({page()});
  EXPECT_NE(text.find("slope: it <slides>\n  derived: section 4\n  met: slope/a u\n  met: slope/a u\n"), std::string::npos) << text;
  EXPECT_NE(text.find("slope: it stops\n  derived: section 4\n  MISSED: slope/a u\n"), std::string::npos) << text;
}

TEST(Requirements, are_there_for_all_examples_of_the_manual)
{
  ProblemChoice all;
  all.examples = std::filesystem::path(BERM_SOURCE_DIR) / "examples";
  for (const Example& example : find_problems(all))
    for (const Promise& promise : promises_of(example)) EXPECT_TRUE(promise.requirement.ends_with('.')) << promise.requirement;
}

}  // namespace
}  // namespace berm::verification::this_file
