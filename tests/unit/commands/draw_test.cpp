// SPDX-License-Identifier: BSD-3-Clause
// `berm draw`, from outside.
#include "samples/drawn_run.hpp"
#include "samples/program.hpp"
#include "samples/small_cases.hpp"

#include <gtest/gtest.h>

namespace berm::commands::this_file {
namespace {

class Draw : public testing::Test {
protected:
  void SetUp() override
  {
    if (std::system("rsvg-convert --version > /dev/null 2>&1") != 0) GTEST_SKIP() << "rsvg-convert is not installed";
    folder_.write("case.toml", test::small_case);
  }
  Ended berm(const std::vector<std::string>& arguments) const { return run_program(folder_.path(), arguments); }
  TemporaryFolder folder_;
};

TEST_F(Draw, writes_a_picture_and_nothing_else_and_says_where)
{
  const Ended ended = berm({"draw", "case.toml", "-o", "pictures/model.png"});
  ASSERT_EQ(ended.status, 0) << ended.err;
  EXPECT_EQ(ended.out, "pictures/model.png\n");
  EXPECT_EQ(png_size(folder_ / "pictures/model.png").first, 1400);
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder_.path())) names.push_back(entry.path().filename());
  std::sort(names.begin(), names.end());
  EXPECT_EQ(names, (std::vector<std::string>{"case.toml", "model.png", "pictures"}));
}

TEST_F(Draw, writes_beside_the_run_folder_where_no_file_is_named)
{
  const Ended ended = berm({"draw", "case.toml"});
  ASSERT_EQ(ended.status, 0) << ended.err;
  EXPECT_EQ(ended.out, "out/case.png\n");
  EXPECT_TRUE(std::filesystem::exists(folder_ / "out/case.png"));
}

TEST_F(Draw, of_several_cases_each_has_its_picture_in_the_folder)
{
  folder_.write("other.toml", test::small_case);
  const Ended ended = berm({"draw", "case.toml", "other.toml", "-o", "models"});
  ASSERT_EQ(ended.status, 0) << ended.err;
  EXPECT_EQ(ended.out, "models/case.png\nmodels/other.png\n");
}

TEST_F(Draw, takes_changes_as_run_does)
{
  ASSERT_EQ(berm({"draw", "case.toml", "-o", "a.svg"}).status, 0);
  ASSERT_EQ(berm({"draw", "case.toml", "-o", "b.svg", "--set", "rigid.pipe.diameter=\"16 mm\""}).status, 0);
  EXPECT_NE(content_of(folder_ / "a.svg").find("D = 20 mm"), std::string::npos);
  EXPECT_NE(content_of(folder_ / "b.svg").find("D = 16 mm"), std::string::npos);
}

TEST_F(Draw, draws_the_finite_elements_of_a_seabed)
{
  const std::string wip = BERM_SOURCE_DIR "/examples/probe_test/wip_10.toml";
  const Ended ended = berm({"draw", wip, "-o", "wip.svg"});
  ASSERT_EQ(ended.status, 0) << ended.err;
  EXPECT_NE(content_of(folder_ / "wip.svg").find("finite elements"), std::string::npos);
  EXPECT_NE(content_of(folder_ / "wip.svg").find("w = 2 mm"), std::string::npos) << "the embedment at the start";
}

TEST_F(Draw, in_space_shows_box_bodies_and_stages)
{
  ASSERT_EQ(berm({"draw", BERM_SOURCE_DIR "/tests/browser/space/sphere.toml", "-o", "sphere.svg"}).status, 0);
  const std::string picture = content_of(folder_ / "sphere.svg");
  for (const char* words : {"A sphere in clay", "x: 400 mm", "y: 360 mm", "z: 300 mm", "160 mm", "w = 30 mm"})
    EXPECT_NE(picture.find(words), std::string::npos) << words;
  ASSERT_EQ(berm({"draw", BERM_SOURCE_DIR "/examples/bar/case_3d.toml", "-o", "bar.png"}).status, 0);
  EXPECT_EQ(png_size(folder_ / "bar.png").first, 1400);
  ASSERT_EQ(berm({"draw", BERM_SOURCE_DIR "/examples/circular_footing/space.toml", "-o", "quarter.svg"}).status, 0);
  EXPECT_NE(content_of(folder_ / "quarter.svg").find("a quarter of the whole, mirrored across x and z"), std::string::npos);
  const Ended floor = berm({"draw", BERM_SOURCE_DIR "/tests/browser/space/sphere.toml", "--set", "support.base.boundary=\"floor\""});
  EXPECT_EQ(floor.status, 2);
  EXPECT_NE(floor.err.find("support.base.boundary"), std::string::npos) << floor.err;
}

TEST_F(Draw, refuses_what_it_cannot_draw)
{
  const Ended name = berm({"draw", "case.toml", "-o", "model.pdf"});
  EXPECT_EQ(name.status, 2);
  EXPECT_NE(name.err.find("model.pdf"), std::string::npos) << name.err;
  EXPECT_NE(name.err.find(".svg"), std::string::npos) << name.err;
  const Ended boundary = berm({"draw", "case.toml", "--set", "support.base.boundary=\"floor\""});
  EXPECT_EQ(boundary.status, 2);
  EXPECT_NE(boundary.err.find("support.base.boundary"), std::string::npos) << boundary.err;
  const Ended missing = berm({"draw", "nothing.toml"});
  EXPECT_EQ(missing.status, 2);
  EXPECT_FALSE(std::filesystem::exists(folder_ / "out"));
}

TEST_F(Draw, fails_where_the_program_for_png_is_missing)
{
  const Ended ended = run_program(folder_.path(), {"draw", "case.toml"}, {"PATH=/nowhere"});
  EXPECT_EQ(ended.status, 1);
  EXPECT_NE(ended.err.find("rsvg-convert"), std::string::npos) << ended.err;
  EXPECT_FALSE(std::filesystem::exists(folder_ / "out/case.png"));
}

}  // namespace
}  // namespace berm::commands::this_file
