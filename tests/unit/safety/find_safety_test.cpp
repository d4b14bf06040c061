// SPDX-License-Identifier: BSD-3-Clause
#include "safety/safety_report.hpp"
#include "samples/program.hpp"

#include <gtest/gtest.h>

namespace berm::safety::this_file {
namespace {

/// A column of clay between two smooth plates, which carries 2 s_u = 20 kPa, under 14 kPa: F = 1.4286 for a uniform stress.
constexpr const char* column = R"(
method = "fem"
[mesh]
kind = "box"
size = [0.5, 1]
cells = [2, 4]
[material.clay]
law = "mohr_coulomb"
density = 2000
young_modulus = 10e6
poisson_ratio = 0.3
cohesion = 10e3
friction_angle = 0
[body.clay]
material = "clay"
regions = ["box"]
[support.middle]
boundary = "left"
fixed = ["x"]
[support.base]
boundary = "bottom"
fixed = ["y"]
[traction.load]
boundary = "top"
stress = [0, -14e3]
ramp = 0.1
[[stage]]
name = "load"
kind = "free"
until.time = 1
)";

class SafetyCommand : public testing::Test {
protected:
  void SetUp() override { folder_.write("column.toml", column); }
  Ended safety(std::vector<std::string> words) const
  {
    words.insert(words.begin(), {"safety", "column.toml", "-o", "found", "--threads", "2"});
    return run_program(folder_.path(), words);
  }
  std::string refusal(const std::vector<std::string>& words) const
  {
    const Ended ended = safety(words);
    EXPECT_EQ(ended.status, 2) << ended.err;
    EXPECT_FALSE(std::filesystem::exists(folder_ / "found")) << "a wrong input leaves nothing";
    return ended.err;
  }
  TemporaryFolder folder_;
};

TEST_F(SafetyCommand, finds_the_factor_of_a_column_of_clay_and_runs_nothing_twice)
{
  const std::vector<std::string> words = {"--low", "1.3", "--high", "1.6", "--tolerance", "0.05"};
  const Ended ended = safety(words);
  ASSERT_EQ(ended.status, 0) << ended.err;
  const std::string csv = text_of_file(folder_ / "found/safety.csv");
  Real stands = 0, fails = infinity;
  std::istringstream lines(csv);
  std::string line;
  std::getline(lines, line);
  EXPECT_EQ(line, "factor,end,movement_m,movement_limit_m,wall_s");
  while (std::getline(lines, line)) {
    const Real factor = std::stod(line);
    if (line.find(",stands,") != std::string::npos) stands = std::max(stands, factor);
    if (line.find(",fails,") != std::string::npos) fails = std::min(fails, factor);
  }
  EXPECT_LE(stands, 20. / 14);
  EXPECT_GT(fails, 20. / 14 * (1 - 1e-3)) << csv;
  EXPECT_LE(fails - stands, 0.05 * (1 + 1e-9));
  EXPECT_TRUE(std::filesystem::exists(folder_ / "found/safety.html"));
  EXPECT_NE(text_of_file(folder_ / "found/summary.json").find("factor_that_stands"), std::string::npos);

  const Ended again = safety(words);
  EXPECT_EQ(again.status, 0) << again.err;
  EXPECT_NE(again.err.find("trials have their result already"), std::string::npos) << again.err;
  EXPECT_EQ(again.err.find("F_"), std::string::npos) << "none is run again: " << again.err;
  EXPECT_EQ(again.out, ended.out);
}

TEST_F(SafetyCommand, says_that_soil_fails_as_it_is)
{
  const Ended ended = safety({"--tolerance", "0.3", "--set", "traction.load.stress=[0, -25e3]"});
  EXPECT_EQ(ended.status, 0) << ended.err;
  EXPECT_NE(ended.out.find("F is below 1: it fails with its own strength"), std::string::npos) << ended.out;
}

/// A column of consolidating soil between smooth walls, which cannot fail: c is 1 MPa and the load 20 kPa.
constexpr const char* strong = R"(
method = "fem"
[mesh]
kind = "box"
size = [0.5, 2]
cells = [1, 4]
[material.clay]
law = "mohr_coulomb"
density = 2000
young_modulus = 10e6
poisson_ratio = 0.3
cohesion = 1e6
friction_angle = 0.35
water.drainage = "consolidation"
water.bulk_modulus = 200e6
water.porosity = 0.4
water.permeability = 1e-4
[body.clay]
material = "clay"
regions = ["box"]
[support.left]
boundary = "left"
fixed = ["x"]
[support.right]
boundary = "right"
fixed = ["x"]
[support.base]
boundary = "bottom"
fixed = ["y"]
[traction.load]
boundary = "top"
stress = [0, -20e3]
ramp = 0.1
[[stage]]
name = "load"
kind = "free"
until.time = 2
)";

TEST_F(SafetyCommand, lets_a_column_that_cannot_fail_stand_while_its_water_flows)
{
  folder_.write("column.toml", strong);
  const Ended ended = safety({"--tolerance", "0.5"});
  EXPECT_EQ(ended.out.find(" fails "), std::string::npos) << ended.out;
  EXPECT_NE(ended.out.find("F is above 10, where the soil still stands"), std::string::npos) << ended.out;
  EXPECT_NE(ended.err.find("the water of the soil still flows when the last stage ends: c_v T / H2 is"), std::string::npos) << ended.err;
  EXPECT_NE(text_of_file(folder_ / "found/safety.html").find("still flows"), std::string::npos);
}

TEST_F(SafetyCommand, counts_no_strength_that_clay_has_by_its_rate)
{
  std::string creeps = column;
  const std::string law = "law = \"mohr_coulomb\"", strength = "cohesion = 10e3\nfriction_angle = 0\n";
  creeps.replace(creeps.find(law), law.size(), "law = \"clay\"");
  creeps.replace(creeps.find(strength), strength.size(), "undrained_strength = 10e3\nrate_parameter = 0.1\nreference_rate = 1e-6\n");
  folder_.write("column.toml", creeps);
  const Ended ended = safety({"--tolerance", "0.1", "--low", "1.4", "--high", "1.5"});
  EXPECT_NE(ended.out.find("1.4000  stands"), std::string::npos) << ended.out;
  EXPECT_NE(ended.out.find("1.5000  fails"), std::string::npos) << ended.out;
}

TEST_F(SafetyCommand, tries_the_same_factors_on_any_number_of_threads)
{
  std::vector<std::string> tables;
  for (const char* threads : {"1", "2", "4"}) {
    const Ended ended = run_program(
        folder_.path(), {"safety", "column.toml", "-o", std::string("on_") + threads, "--threads", threads, "--tolerance", "0.05"});
    EXPECT_EQ(ended.status, 0) << ended.err;
    std::string table = text_of_file(folder_ / (std::string("on_") + threads + "/safety.csv"));
    std::string without_times;
    std::istringstream lines(table);
    for (std::string line; std::getline(lines, line);) without_times += line.substr(0, line.rfind(',')) + "\n";
    tables.push_back(without_times);
  }
  EXPECT_EQ(tables[0], tables[1]);
  EXPECT_EQ(tables[0], tables[2]);
}

TEST_F(SafetyCommand, keeps_trials_of_another_case_apart)
{
  ASSERT_EQ(safety({"--tolerance", "0.5", "--low", "1.3"}).status, 0);
  const Ended other = safety({"--tolerance", "0.5", "--low", "1.3", "--set", "material.clay.cohesion=15e3"});
  EXPECT_EQ(other.status, 0) << other.err;
  EXPECT_EQ(other.err.find("already"), std::string::npos) << other.err;
}

TEST_F(SafetyCommand, refuses_what_has_no_factor_of_safety)
{
  EXPECT_NE(refusal({"--low", "2", "--high", "1.5"}).find("--low 2 is not below --high 1.5"), std::string::npos);
  EXPECT_NE(refusal({"--tolerance", "0"}).find("--tolerance"), std::string::npos);
  const auto replace = [this](const std::string& words, const std::string& by) {
    std::string text = column;
    folder_.write("column.toml", text.replace(text.find(words), words.size(), by));
  };
  replace("kind = \"box\"\nsize = [0.5, 1]\ncells = [2, 4]", "kind = \"gmsh\"\nfile = \"none.msh\"");
  EXPECT_NE(refusal({}).find("none.msh"), std::string::npos);
  replace("[traction.load]\nboundary = \"top\"\nstress = [0, -14e3]\nramp = 0.1\n", "");
  EXPECT_NE(refusal({}).find("nothing loads the soil"), std::string::npos);
  replace("law = \"mohr_coulomb\"\ndensity = 2000\nyoung_modulus = 10e6\npoisson_ratio = 0.3\ncohesion = 10e3\nfriction_angle = 0",
          "law = \"linear_elastic\"\ndensity = 2000\nyoung_modulus = 10e6\npoisson_ratio = 0.3");
  EXPECT_NE(refusal({}).find("no soil of this case has a strength"), std::string::npos);
}

TEST(SafetyReport, tells_the_ends_of_the_bracket_and_what_is_doubtful)
{
  std::vector<Trial> trials = {
      {1, TrialEnd::stands, 0.001, 0.1, 2}, {1.25, TrialEnd::stands, 0.012, 0.1, 3}, {1.3, TrialEnd::fails, 0.11, 0.1, 5}};
  EXPECT_EQ(answer_in_words(trials),
            "F = 1.25 to 1.3: the soil stands with its strength divided by 1.25 (it moves by 0.012 m) and fails with it divided by 1.3");
  EXPECT_EQ(safety_csv(trials),
            "factor,end,movement_m,movement_limit_m,wall_s\n1,stands,0.001,0.1,2\n1.25,stands,0.012,0.1,3\n1.3,fails,0.11,0.1,5\n");
  trials.push_back({1.28, TrialEnd::undecided});
  trials.push_back({1.4, TrialEnd::stands});
  EXPECT_NE(answer_in_words(trials).find("undecided: 1.28"), std::string::npos);
  EXPECT_NE(answer_in_words(trials).find("yet it stands at 1.4"), std::string::npos);
  EXPECT_NE(safety_csv(trials).find("\n1.28,undecided,,,\n"), std::string::npos);
  EXPECT_EQ(answer_in_words({{10, TrialEnd::stands}}), "F is above 10, where the soil still stands");
  EXPECT_EQ(answer_in_words({{0.1, TrialEnd::fails}}),
            "F is below 0.1, where the soil still fails; F is below 1: it fails with its own strength");
}

bool says(const std::vector<std::string>& doubts, const std::string& words)
{
  return std::any_of(doubts.begin(), doubts.end(), [&](const std::string& doubt) { return doubt.find(words) != std::string::npos; });
}

TEST(SafetyReport, doubts_soil_that_fails_at_every_factor_or_moves_alike_at_all_of_them)
{
  const std::vector<Trial> plain = {{1, TrialEnd::stands, 0.001, 0.1, 2}, {1.3, TrialEnd::fails, 0.11, 0.1, 5}};
  EXPECT_TRUE(doubts_of(plain, settings::Method::fem).empty());
  EXPECT_TRUE(says(doubts_of(plain, settings::Method::mpm), "the factor of the material point method is too large on coarse cells"));
  const std::vector<Trial> all = {{0.1, TrialEnd::fails, 0.11, 0.1}, {1, TrialEnd::fails, 0.12, 0.1}};
  EXPECT_TRUE(says(doubts_of(all, settings::Method::fem), "fails even with 10 times its strength"));
  EXPECT_FALSE(says(doubts_of(all, settings::Method::fem), "moves by the same"));
  const std::vector<Trial> alike = {{0.5, TrialEnd::fails, 0.0045, 0.1}, {1, TrialEnd::undecided, 0.0045, 0.1}};
  EXPECT_TRUE(says(doubts_of(alike, settings::Method::fem), "moves by the same"));
  std::vector<Trial> wet = plain;
  wet[1].time_factor = 0.2;
  EXPECT_TRUE(says(doubts_of(wet, settings::Method::fem), "c_v T / H2 is 0.2"));
  wet[1].time_factor = 1;
  EXPECT_TRUE(doubts_of(wet, settings::Method::fem).empty());
}

}  // namespace
}  // namespace berm::safety::this_file
