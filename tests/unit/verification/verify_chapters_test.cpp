// SPDX-License-Identifier: BSD-3-Clause
#include "verification/problems.hpp"
#include "verify_falls.hpp"

namespace berm::verification::this_file {
namespace {

class VerifyChapters : public VerifyFalls {
protected:
  void SetUp() override
  {
    example("fall", std::string("chapter = \"motion\"\n[run.earth]\nlong = true\n[run.light]\nset = ['gravity=[0, -5]']\n") +
                        claim("earth", "-10") + claim("light", "-5"));
    example("drop", "chapter = \"clay\"\n" + std::string(two_runs) + claim("earth", "-10") + claim("light", "-5"));
  }
};

TEST_F(VerifyChapters, are_run_by_their_name)
{
  const Ended ended = verify({"--chapter", "clay"});
  EXPECT_EQ(ended.status, 0) << ended.err;
  EXPECT_TRUE(is_there("drop/light"));
  EXPECT_FALSE(is_there("fall"));
}

TEST_F(VerifyChapters, of_another_name_are_refused_with_the_nearest)
{
  const Ended ended = verify({"--chapter", "caly"});
  EXPECT_EQ(ended.status, 2);
  EXPECT_EQ(ended.err.find("berm: there is no chapter \"caly\"; did you mean \"clay\"? (allowed: motion, contact, laws"), 0u) << ended.err;
  EXPECT_NE(verify({"--chapter", "fem"}).err.find("none of these problems is of the chapter \"fem\""), std::string::npos);
  EXPECT_NE(verify({"--help"}).out.find("motion, contact, laws"), std::string::npos);
  example("drop", "chapter = \"caly\"\n" + std::string(two_runs) + claim("earth", "-10") + claim("light", "-5"));
  EXPECT_NE(verify({"drop"}).err.find("did you mean \"clay\"?"), std::string::npos);
}

TEST_F(VerifyChapters, order_the_list_and_the_book)
{
  const std::string list = verify({"--list", "--long"}).out;
  EXPECT_LT(list.find("motion   fall/earth  long  1"), list.find("clay     drop/earth  fast  1")) << list;
  EXPECT_NE(list.find("drop/earth  fast  1"), std::string::npos) << list;
  EXPECT_EQ(verify({}).status, 0);
  const std::string index = result("index.html");
  const std::size_t motion = index.find("<h2 id=\"motion\">Motion and waves</h2>"), clay = index.find("<h2 id=\"clay\">");
  ASSERT_NE(clay, std::string::npos) << index;
  EXPECT_LT(motion, index.find("fall.html#light"));
  EXPECT_LT(index.find("fall.html#light"), clay);
  EXPECT_LT(clay, index.find("drop.html#earth"));
  EXPECT_NE(index.find("<li><a href=\"#clay\">Structures in clay</a>: 2 numbers met</li>"), std::string::npos) << index;
}

TEST_F(VerifyChapters, leave_out_long_problems_that_are_not_asked_for)
{
  EXPECT_EQ(verify({}).status, 0);
  EXPECT_EQ(made(), Words{"light/"});
  EXPECT_EQ(verify({"--chapter", "motion", "--long"}).status, 0);
  EXPECT_EQ(made(), (Words{"earth/", "light/"}));
  std::filesystem::remove_all(folder_ / "out");
  EXPECT_EQ(verify({"fall/earth"}).status, 0);
  EXPECT_EQ(made(), Words{"earth/"});
  EXPECT_EQ(verify({"--fast", "--long"}).status, 2);
  example("fall", "[run.earth]\nfast = true\nlong = true\n" + claim("earth", "-10"));
  EXPECT_NE(verify({"fall"}).err.find("run.earth.long: the run is fast"), std::string::npos);
}

TEST_F(VerifyChapters, end_with_the_longest_runs)
{
  const Ended ended = verify({"--long"});
  EXPECT_EQ(ended.status, 0);
  const std::size_t table = ended.out.find("\nthe longest runs  time\n");
  ASSERT_NE(table, std::string::npos) << ended.out;
  const std::string rows = ended.out.substr(table);
  for (const char* problem : {"fall/earth ", "fall/light ", "drop/earth ", "drop/light "})
    EXPECT_NE(rows.find(problem), std::string::npos) << rows;
  const std::string index = result("index.html");
  EXPECT_LT(index.find("<h2 id=\"longest\">"), index.rfind("fall.html#earth"));
}

TEST_F(VerifyChapters, tell_how_far_they_are_and_how_long_the_rest_takes)
{
  const Ended ended = verify({"drop", "fall", "--threads", "2"});
  EXPECT_NE(ended.err.find("\n4 problems to run; about "), std::string::npos) << ended.err;
  EXPECT_NE(ended.err.find("\n1/4 "), std::string::npos) << ended.err;
  EXPECT_NE(ended.err.find("  (2 running, 1 to begin"), std::string::npos) << ended.err;
  EXPECT_NE(ended.err.find(" to the end)\n"), std::string::npos) << ended.err;
}

TEST(Book, has_every_example_in_a_chapter)
{
  ProblemChoice all;
  all.examples = std::filesystem::path(BERM_SOURCE_DIR) / "examples";
  all.with_long = true;
  for (const Example& example : find_problems(all)) EXPECT_NE(example.chapter, Chapter::other) << example.name;
}

}  // namespace
}  // namespace berm::verification::this_file
