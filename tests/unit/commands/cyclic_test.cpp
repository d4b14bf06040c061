// SPDX-License-Identifier: BSD-3-Clause
#include "samples/program.hpp"
#include "samples/temporary_folder.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace berm::commands::this_file {
namespace {

class CyclicCommand : public testing::Test {
protected:
  CyclicCommand()
  {
    folder_.write("contours.csv", "shear_strain,average_stress_ratio,cycles,cyclic_stress_ratio\n0.15,0,1,1\n0.15,0,100,0.6\n");
    folder_.write("storm.toml", "[contours]\ntable = \"contours.csv\"\n[storm]\ncycles = [10]\nload = [0.4]\n");
  }
  Ended cyclic(std::vector<std::string> words)
  {
    words.insert(words.begin(), "cyclic");
    return run_program(folder_.path(), words);
  }
  TemporaryFolder folder_;
};

TEST_F(CyclicCommand, gives_the_strength_on_a_contour_and_a_page)
{
  const Ended ended = cyclic({"storm.toml"});
  EXPECT_EQ(ended.status, 0) << ended.err;
  EXPECT_NE(ended.out.find("tau_f,cy = (0 + 0.8) s_u = 0.8 s_u"), std::string::npos) << "halfway in log N" << ended.out;
  EXPECT_NE(ended.err.find("the page is out/storm/cyclic.html"), std::string::npos) << ended.err;
}

TEST_F(CyclicCommand, replaces_results_with_force_alone)
{
  EXPECT_EQ(cyclic({"storm.toml", "-o", "here"}).status, 0);
  const Ended again = cyclic({"storm.toml", "-o", "here"});
  EXPECT_EQ(again.status, 2);
  EXPECT_NE(again.err.find("here holds results of berm cyclic: replace them with --force"), std::string::npos) << again.err;
  EXPECT_EQ(cyclic({"storm.toml", "-o", "here", "--force", "--set", "storm.load=[0.5]"}).status, 0);
  const nlohmann::json summary = nlohmann::json::parse(folder_.read("here/summary.json"));
  EXPECT_NEAR(double(summary["quantities"]["load_multiplier"]["value"]), 1.6, 1e-6);
  EXPECT_NE(cyclic({"storm.toml", "-o", ".", "--force"}).err.find("holds files that are not of berm cyclic"), std::string::npos);
}

TEST_F(CyclicCommand, refuses_a_storm_that_leaves_the_contours)
{
  const Ended ended = cyclic({"storm.toml", "--set", "storm.cycles=[200]"});
  EXPECT_EQ(ended.status, 2);
  EXPECT_EQ(ended.err, "berm: storm.toml: parcel 1, 200 cycles of 0.4 s_u, ends at N = 200, and the contours at N = "
                       "100: give them to more cycles\n");
}

}  // namespace
}  // namespace berm::commands::this_file
