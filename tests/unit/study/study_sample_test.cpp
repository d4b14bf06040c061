// SPDX-License-Identifier: BSD-3-Clause
#include "core/types.hpp"
#include "samples/study_of_falls.hpp"
#include "study/estimates.hpp"

namespace berm::study::this_file {
namespace {

/// A stone that falls for a time that is not known well. The measure is that time, on which its stiffness has no part.
constexpr const char* falls = R"([[case]]
name = "stone"
file = "stone.toml"
set = ["mpm.courant=0.05"]
[sample]
size = 20
[[sample.parameter]]
name = "stiffness"
times = {"material.stone.young_modulus" = "1 MPa"}
distribution = "lognormal"
low = 0.5
high = 2
[[sample.parameter]]
name = "time"
keys = ["stage.*.until.time"]
distribution = "uniform"
low = "50 ms"
high = "0.1 s"
[[measure]]
name = "end"
column = "time_s"
)";

class StudySampleCommand : public test::StudyOfFalls {
protected:
  StudySampleCommand() : StudyOfFalls(falls) {}
};

/// The numbers in a line of a .csv text that begins so.
std::vector<Real> numbers_in(const std::string& text, const std::string& begin)
{
  std::vector<Real> numbers;
  const std::size_t at = text.find('\n' + begin + ',');
  EXPECT_NE(at, std::string::npos) << begin << " is not in\n" << text;
  if (at == std::string::npos) return std::vector<Real>(9);
  std::istringstream fields(text.substr(at + begin.size() + 2, text.find('\n', at + 1) - at - begin.size() - 2));
  for (std::string field; std::getline(fields, field, ',');)
    numbers.push_back(field.empty() ? std::numeric_limits<Real>::quiet_NaN() : std::stod(field));
  return numbers;
}

TEST(Estimates, of_a_table_begin_with_the_parameter_of_the_largest_correlation_whatever_its_sign)
{
  // Ranks 1 3 2 4 and 4 3 2 1 beside 1 2 3 4: correlations of 0.8 and -1, but for round-off.
  StudyAxis axis{.name = "row", .value = {}, .sample_from = 0, .parameter = {{"along", ""}, {"against", ""}}};
  StudyPlan plan;
  const Real along[] = {1, 3, 2, 4};
  for (std::size_t k = 0; k < 4; ++k) {
    const Real number = 1 + static_cast<Real>(k);
    axis.value.push_back({.name = std::to_string(k), .set = {}, .place = "", .number = {along[k], 5 - number}});
    StudyRow row;
    row.choice = {0, k};
    row.names = {"stone", axis.value.back().name};
    row.end.kind = jobs::JobEnd::Kind::finished;
    row.numbers = {number};
    plan.rows.push_back(row);
  }
  plan.study.axis = {axis};
  plan.study.measure.resize(1);
  const std::vector<Estimate> estimates = estimates_of(plan);
  ASSERT_EQ(estimates.size(), 1u);
  ASSERT_EQ(estimates[0].swing.size(), 2u);
  EXPECT_EQ(estimates[0].swing[0].parameter, 1u);
  EXPECT_NEAR(estimates[0].swing[0].correlation, -1, 1e-15);
  EXPECT_NEAR(estimates[0].swing[1].correlation, 0.8, 1e-15);
}

TEST_F(StudySampleCommand, tells_low_best_and_high)
{
  const Ended ended = study();
  ASSERT_EQ(ended.status, 0) << ended.err;
  EXPECT_EQ(ended.err.find("is too small for 5 and 95 %"), std::string::npos) << ended.err;
  const std::vector<Real> end = numbers_in(result("estimates.csv"), "stone,end (s)");
  ASSERT_EQ(end.size(), 7u);
  // From 50 to 100 ms. A part of the hypercube is 2.5 ms wide, and a row lies somewhere in it; a run ends with the
  // step that reaches its end, of 0.4 ms at most.
  EXPECT_NEAR(end[0], 0.075, 5e-4) << "best";
  EXPECT_NEAR(end[1], 0.0525, 0.003);
  EXPECT_NEAR(end[2], 0.075, 0.003);
  EXPECT_NEAR(end[3], 0.0975, 0.003);
  EXPECT_NEAR(end[4], 0.075, 0.002) << "mean";
  EXPECT_EQ(end[5], 20);
  EXPECT_EQ(end[6], 0) << "failed";
  const std::string table = result("results.md");
  for (const char* words :
       {"## Low, best and high\n", "| case | measure | best | 5 % |", "![tornado.end](tornado.end.png)", "| stone | best | 0.07"})
    EXPECT_NE(table.find(words), std::string::npos) << words << " is not in\n" << table;
}
TEST_F(StudySampleCommand, tells_what_each_parameter_does_the_widest_first)
{
  ASSERT_EQ(study({}, {with_pictures()}).status, 0);
  const std::string text = result("sensitivity.csv");
  EXPECT_LT(text.find("time (s)"), text.find("stiffness"));
  const std::vector<Real> time = numbers_in(text, "stone,end (s),time (s)"), stiffness = numbers_in(text, "stone,end (s),stiffness");
  // 5 and 95 % of 50 to 100 ms, and the ends of these runs, to a step.
  const std::vector<Real> expected = {0.0525, 0.0975, 0.0525, 0.0975, 0.045, 1};
  for (std::size_t k = 0; k < expected.size(); ++k) EXPECT_NEAR(time.at(k), expected[k], 5e-4) << k;
  EXPECT_NEAR(stiffness.at(4), 0, 5e-4) << "stiffness does nothing";
  // Of two orders at random of 20 rows the correlation has a deviation of 1/sqrt(19) = 0.23; three of them.
  EXPECT_LT(std::abs(stiffness.at(5)), 0.69);
  const std::string script = result("plots/tornado.end.gp");
  EXPECT_NE(script.find("'time: 0.0525 s to 0.0975 s' 2, 'stiffness: 0.5 to 2' 1, 'all, 5 to 95 %% of 20 runs' 0"), std::string::npos)
      << script;
  EXPECT_TRUE(std::filesystem::exists(folder_ / "results/tornado.end.png"));
}
TEST_F(StudySampleCommand, leaves_its_sample_as_a_table_that_gives_the_same_numbers)
{
  ASSERT_EQ(study().status, 0);
  const std::vector<Real> before = numbers_in(result("estimates.csv"), "stone,end (s)");
  folder_.write("drawn.csv", result("samples.csv"));
  std::string text = falls;
  text.replace(text.find("[sample]"), text.find("[[measure]]") - text.find("[sample]"), "[[table]]\nfile = \"drawn.csv\"\n");
  write_study(text);
  std::filesystem::remove_all(folder_ / "results");
  const Ended ended = study();
  ASSERT_EQ(ended.status, 0) << ended.err;
  const std::vector<Real> after = numbers_in(result("estimates.csv"), "stone,end (s)");
  EXPECT_TRUE(std::isnan(after.at(0))) << "there is no best run";
  for (std::size_t k = 1; k < before.size(); ++k) EXPECT_EQ(after.at(k), before[k]);
  EXPECT_NE(result("plots/tornado.end.gp").find("rank correlation with end"), std::string::npos);
}
TEST_F(StudySampleCommand, that_is_small_warns_and_counts_what_failed)
{
  std::string text = falls;
  text.replace(text.find("size = 20"), 9, "size = 4");
  text.replace(text.find("\"0.1 s\""), 7, "\"2 s\"");  // it leaves the mesh after 0.3 s
  write_study(text);
  const Ended ended = study();
  EXPECT_EQ(ended.status, 1) << ended.err;
  EXPECT_NE(ended.err.find("a sample of 4 rows is too small for 5 and 95 %, which stay empty: take 20 at least"), std::string::npos)
      << ended.err;
  const std::vector<Real> end = numbers_in(result("estimates.csv"), "stone,end (s)");
  EXPECT_TRUE(std::isnan(end.at(1)));
  EXPECT_EQ(end.at(5) + end.at(6), 4);
  EXPECT_GE(end.at(6), 3) << "three of four rows take more than 0.53 s";
  EXPECT_NE(result("results.md").find("Failed runs are not included"), std::string::npos);
}
TEST_F(StudySampleCommand, refuses_wrong_input_and_runs_nothing)
{
  struct Wrong {
    std::string replaced, by, says;
  };
  for (const Wrong& wrong : std::vector<Wrong>{
           {"low = 0.5", "low = 2.5", "study.toml:11: sample.parameter.stiffness.low: must be less than high"},
           {"low = 0.5", "low = -1", "sample.parameter.stiffness.low: must be more than 0 where the logarithm is distributed"},
           {"low = 0.5", "low = 0.5\nbest = 3", "sample.parameter.stiffness.best: must lie between low and high"},
           {"low = 0.5", "low = 0.5\nmin = 1", "sample.parameter.stiffness.min: must be at most low"},
           {"low = \"50 ms\"", "low = \"50 ms\"\nmax = 1", "sample.parameter.time.max: is only for normal and lognormal distributions"},
           {"low = \"50 ms\"", "low = \"50 mm\"", "sample.parameter.time.high: \"0.1 s\" is in s, another number of this parameter in m"},
           {"\"uniform\"", "\"triangular\"", "sample.parameter.time: a triangular distribution needs best"},
           {"\"uniform\"", "\"unifrom\"", "\"unifrom\" is not one of its words; did you mean \"uniform\"?"},
           {"name = \"time\"", "name = \"stiffness\"", "sample.parameter.stiffness.name: is the name"},
           {"keys = [\"stage.*.until.time\"]\n", "", "sample.parameter.time: sets nothing"},
           {"stage.*.until.time", "material.*.young_modulus",
            "study.toml:5: sample: material.*.young_modulus is set twice, here and by sample"},
           {"stage.*.until.time", "stage.*.until.tme",
            "study.toml: stone, best: --set stage.*.until.tme: stage.fall.until.tme: unknown key; did you mean \"time\"?"},
           {"low = 0.5\nhigh = 2", "low = \"1 Pa\"\nhigh = \"2 Pa\"", "sample.parameter.stiffness.times: multiplies by the number"},
           {"\"1 MPa\"", "\"1 MPo\"", "sample.parameter.stiffness.times.material.stone.young_modulus: \"1 MPo\" has the unknown unit"},
           {"size = 20", "size = 0", "sample.size: must be from 1 to 1e+05"},
           {"[[measure]]", "[[table]]\nfile = \"t.csv\"\n[[measure]]", "study.toml:5: sample: is a second sample"},
           {"[sample]", "[[sample]]", "sample: must be a table"}}) {
    folder_.write("t.csv", "material.stone.density\n1000\n");
    std::string text = falls;
    text.replace(text.find(wrong.replaced), wrong.replaced.size(), wrong.by);
    write_study(text);
    const Ended ended = study();
    EXPECT_EQ(ended.status, 2) << wrong.by;
    EXPECT_NE(ended.err.find(wrong.says), std::string::npos) << ended.err << "and not\n" << wrong.says;
    EXPECT_EQ(ended.err.find('\n'), ended.err.size() - 1) << ended.err;
    EXPECT_FALSE(std::filesystem::exists(folder_ / "results")) << wrong.by;
  }
}

}  // namespace
}  // namespace berm::study::this_file
