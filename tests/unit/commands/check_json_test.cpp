// SPDX-License-Identifier: BSD-3-Clause
// `berm check --json`, from outside, and the place that each error of an input has.
#include "input/read_case.hpp"
#include "samples/program.hpp"
#include "samples/small_cases.hpp"
#include "samples/wrong_inputs.hpp"

#include <algorithm>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <sched.h>

namespace berm::commands::this_file {
namespace {

using Json = nlohmann::json;
using test::WrongInput;

std::string text_changed(const std::string& from, const std::string& to)
{
  std::string text = test::small_case;
  return text.replace(text.find(from), from.size(), to);
}

std::vector<Json> of_level(const Json& of_case, const std::string& level)
{
  std::vector<Json> found;
  for (const Json& finding : of_case["findings"])
    if (finding["level"] == level) found.push_back(finding);
  return found;
}

class CheckJson : public testing::Test {
protected:
  Json check(const std::string& text, int status, std::vector<std::string> more = {})
  {
    folder_.write("case.toml", text);
    more.insert(more.begin(), {"check", "case.toml", "--json", "--threads", "1"});
    const Ended ended = run_program(folder_.path(), more);
    EXPECT_EQ(ended.status, status) << ended.err;
    EXPECT_EQ(ended.err, "");
    return Json::parse(ended.out).at(0);
  }
  TemporaryFolder folder_;
};

/// This process and its children share one processor with so many others, which always have work.
class BusyProcessor {
public:
  explicit BusyProcessor(int others)
  {
    ::sched_getaffinity(0, sizeof before_, &before_);
    cpu_set_t one;
    CPU_ZERO(&one);
    int first = 0;
    while (first < CPU_SETSIZE - 1 && !CPU_ISSET(first, &before_)) ++first;
    CPU_SET(first, &one);
    ::sched_setaffinity(0, sizeof one, &one);
    for (int k = 0; k < others; ++k) {
      const pid_t id = ::fork();
      for (volatile int turn = 0; id == 0;) turn = 1 - turn;
      others_.push_back(id);
    }
  }
  ~BusyProcessor()
  {
    for (const pid_t id : others_) ::kill(id, SIGKILL), ::waitpid(id, nullptr, 0);
    ::sched_setaffinity(0, sizeof before_, &before_);
  }
  BusyProcessor(const BusyProcessor&) = delete;
  BusyProcessor& operator=(const BusyProcessor&) = delete;

private:
  cpu_set_t before_{};
  std::vector<pid_t> others_;
};

// By the clock on the wall a step takes six times as long there, at least; what is shared is the cache.
TEST_F(CheckJson, estimates_the_time_on_a_free_machine_whatever_else_runs)
{
  const auto time_beside = [&](int others) {
    const BusyProcessor processor(others);
    return check(test::small_case, 0)["estimate"]["time_s"].get<double>();
  };
  const double alone = time_beside(0), beside_five = time_beside(5);
  EXPECT_LT(beside_five, 2 * alone);
}

TEST_F(CheckJson, gives_the_estimate_of_a_good_case_in_numbers_and_the_lines_of_the_text)
{
  const Json checked = check(test::small_case, 0);
  const Json& estimate = checked["estimate"];
  EXPECT_TRUE(of_level(checked, "error").empty()) << checked;
  for (const char* number : {"cells", "nodes", "particles", "memory_bytes", "time_s", "disk_bytes"})
    EXPECT_GT(estimate[number], 0) << number;
  const std::string text = run_program(folder_.path(), {"check", "case.toml", "--threads", "1"}).out;
  for (const std::string what : {"cells", "nodes", "particles"}) {
    const auto is_it = [&](const std::string& line) { return line.starts_with(what); };
    const auto lines = estimate["lines"].get<std::vector<std::string>>();
    const auto line = std::ranges::find_if(lines, is_it);
    ASSERT_NE(line, lines.end()) << what;
    EXPECT_NE(text.find("  " + *line + "\n"), std::string::npos) << *line;
  }
}

TEST_F(CheckJson, of_a_remeshed_run_tells_the_time_of_the_other_method_and_the_errors_of_both)
{
  const Json estimate = check(test::small_fem_case, 0, {"--set", "fem.large_deformation=true"})["estimate"];
  EXPECT_GT(estimate["time_s"], 0);
  EXPECT_EQ(estimate["other_method"]["method"], "mpm");
  EXPECT_GT(estimate["other_method"]["time_s"], 0);
  EXPECT_FALSE(estimate["other_method"].contains("why_not"));
  EXPECT_EQ(estimate["errors"]["fem"][1], (Json{{"size_over_D", 0.1}, {"error", 0.003}}));
  EXPECT_EQ(estimate["errors"]["mpm"][0], (Json{{"size_over_D", 0.1}, {"error", 0.037}}));
  const std::string text = run_program(folder_.path(), {"check", "case.toml", "--threads", "1", "--set", "fem.large_deformation=true"}).out;
  EXPECT_NE(text.find("  by material points (method = \"mpm\"): about "), std::string::npos) << text;
  EXPECT_NE(text.find("elements of D/5, D/10, D/20: 0.9, 0.3, 0.2 %; cells of D/10, D/20, D/40: 3.7, 1.7, 0.9 %"), std::string::npos)
      << text;
  EXPECT_FALSE(check(test::small_fem_case, 0)["estimate"].contains("errors")) << "small strain";
}

TEST_F(CheckJson, names_the_nearest_key_and_those_that_are_allowed)
{
  const Json checked = check(text_changed("poisson_ratio", "poison_ratio"), 2);
  const Json error = of_level(checked, "error").at(0);
  EXPECT_EQ(error["key"], "material.sand.poison_ratio");
  EXPECT_EQ(error["nearest"], "poisson_ratio");
  EXPECT_NE(std::ranges::find(error["expected"], Json("poisson_ratio")), error["expected"].end()) << error;
  EXPECT_TRUE(checked["estimate"].is_null());
}

TEST_F(CheckJson, says_what_is_senseless_and_what_is_doubtful_with_line_and_key)
{
  const Json refused = of_level(check(test::small_case, 2, {"--set", "support.left.boundary=west"}), "error").at(0);
  EXPECT_EQ(refused["key"], "support.left.boundary");
  EXPECT_EQ(refused["set"], "support.left.boundary");
  EXPECT_TRUE(refused["line"].is_null());
  const std::vector<Json> warnings = of_level(check(test::small_case, 0), "warning");
  for (const Json& warning : warnings) {
    EXPECT_GT(warning["line"], 0) << warning;
    EXPECT_NE(warning["key"], "") << warning;
  }
}

TEST_F(CheckJson, of_several_cases_tells_each_by_itself)
{
  folder_.write("good.toml", test::small_case);
  folder_.write("wrong.toml", text_changed("mohr_coulomb", "more_coulomb"));
  const Ended ended = run_program(folder_.path(), {"check", "wrong.toml", "good.toml", "--json"});
  const Json all = Json::parse(ended.out);
  EXPECT_EQ(ended.status, 2);
  EXPECT_EQ(of_level(all.at(0), "error").at(0)["line"], 12);
  EXPECT_TRUE(of_level(all.at(1), "error").empty());
}

TEST_F(CheckJson, takes_the_text_from_the_standard_input_as_if_it_lay_in_the_file)
{
  folder_.write("text", text_changed("mohr_coulomb", "more_coulomb"));
  const std::string program = BERM_PROGRAM, folder = folder_.path().string();
  const auto shell = [&](const std::string& line) { return std::system(("cd '" + folder + "' && '" + program + "' " + line).c_str()); };
  EXPECT_EQ(WEXITSTATUS(shell("check mine/case.toml --json --stdin < text > out.json")), 2);
  const Json error = of_level(Json::parse(text_of_file(folder_ / "out.json")).at(0), "error").at(0);
  EXPECT_EQ(error["file"], "mine/case.toml");
  EXPECT_EQ(error["line"], 12);
  folder_.write("text", test::small_case);
  EXPECT_EQ(WEXITSTATUS(shell("draw mine/case.toml -o - --stdin < text > model.svg")), 0);
  EXPECT_TRUE(text_of_file(folder_ / "model.svg").starts_with("<"));
  EXPECT_EQ(WEXITSTATUS(shell("check a.toml b.toml --stdin < text 2> err")), 2);
}

/// What is known of the place of the error of a wrong input.
input::Located located(const WrongInput& wrong)
{
  try {
    input::case_of(input::parse_text("case.toml", text_of(wrong)), wrong.overrides);
  } catch (const input::LocatedError& error) {
    return error.located;
  } catch (const InputError& error) {
    ADD_FAILURE() << wrong.name << ": nothing is known of its place: " << error.what();
  }
  return {};
}

TEST(WrongInputs, have_their_line_and_their_key_but_for_those_that_are_not_toml)
{
  std::vector<std::string> without_key, without_line;
  for (const WrongInput& wrong : test::wrong_inputs()) {
    const input::Located at = located(wrong);
    if (at.key.empty() && at.message.find("TOML") == std::string::npos) without_key.push_back(std::string(wrong.name) + ": " + at.message);
    if (at.line == 0 && at.override_key.empty()) without_line.push_back(wrong.name);
    EXPECT_TRUE(wrong.line == 0 || at.line == wrong.line) << wrong.name << ": " << at.text();
    for (const std::string& part : wrong.says) EXPECT_NE(at.text().find(part), std::string::npos) << at.text();
  }
  EXPECT_EQ(without_line, std::vector<std::string>());
  EXPECT_EQ(without_key, std::vector<std::string>({}));
}

}  // namespace
}  // namespace berm::commands::this_file
