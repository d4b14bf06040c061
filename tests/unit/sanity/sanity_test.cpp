// SPDX-License-Identifier: BSD-3-Clause
// Whether a case makes sense: what is asked of check and run, in lines that name the key; and that no example is doubted.
#include "samples/program.hpp"
#include "samples/senseless_inputs_in_space.hpp"
#include "samples/senseless_load_histories.hpp"
#include "samples/senseless_meshes.hpp"
#include "samples/senseless_pipelines.hpp"
#include "samples/senseless_remeshed.hpp"
#include "samples/senseless_roles.hpp"
#include "samples/senseless_sizes.hpp"
#include "samples/senseless_soils.hpp"
#include "samples/senseless_supports.hpp"
#include "samples/small_cases.hpp"

#include <gtest/gtest.h>

namespace berm::sanity::this_file {
namespace {

namespace fs = std::filesystem;
using test::SenselessInput;

std::string base_of(const std::string& name)
{
  const fs::path examples = fs::path(BERM_SOURCE_DIR) / "examples", probe_test = examples / "probe_test";
  if (name == "cone") return text_of_file(examples / "cone_in_clay/case.toml");
  if (name == "settling") return text_of_file(examples / "downdrag/case.toml");
  if (name == "line") return text_of_file(examples / "lateral_buckle/case.toml");
  if (name == "remeshed") return text_of_file(examples / "remeshed_pipe/drag.toml");
  if (name == "pipes") return text_of_file(examples / "remeshed_pipes/case.toml");
  if (name == "space") return test::small_space_case;
  return name == "box" ? test::small_case : text_of_file(probe_test / (name == "bed" ? "case.toml" : "wip_10.toml"));
}

std::vector<std::string> arguments_for(const char* command, const SenselessInput& input)
{
  std::vector<std::string> arguments = {command, "case.toml", "--threads", "1"};
  if (input.base == std::string("bed")) arguments.insert(arguments.end(), {"--set", "mesh.near_size=4 mm"});
  for (const std::string& override : input.overrides) arguments.insert(arguments.end(), {"--set", override});
  return arguments;
}

/// The lines of a text that have all of these parts and begin so.
int lines_with(const std::string& text, const std::string& begin, const std::vector<std::string>& parts)
{
  int count = 0;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);)
    count += line.starts_with(begin) &&
             std::all_of(parts.begin(), parts.end(), [&](const std::string& part) { return line.find(part) != std::string::npos; });
  return count;
}

// What is known of a body that is left to gravity is that it falls.
TEST(FreeBodies, may_begin_above_the_soil_and_fall_onto_it_where_they_are_above_it)
{
  TemporaryFolder folder;
  const auto ended = [&](const char* motion, const char* center, const char* stages) {
    std::string text = test::small_case;
    const std::size_t begin = text.find("[[stage]]\nname = \"push\""), end = text.find("[output]");
    text.replace(begin, end - begin, stages);
    folder.write("case.toml", text);
    return run_program(folder.path(), {"check", "case.toml", "--threads", "1", "--set", std::string("rigid.pipe.motion=") + motion, "--set",
                                       std::string("rigid.pipe.center=") + center});
  };
  const char *above = "[\"50 mm\", \"75 mm\"]", *beside = "[\"150 mm\", \"75 mm\"]";
  const char* thrown = "[[stage]]\nname = \"throw\"\nkind = \"push\"\nvelocity = \"0.1 m/s\"\nuntil.time = \"2 ms\"\n"
                       "[[stage]]\nname = \"fall\"\nkind = \"free\"\nuntil.time = \"20 ms\"\n";
  const Ended falls = ended("free", above, thrown);
  EXPECT_EQ(falls.status, 0) << falls.err;
  EXPECT_EQ(lines_with(falls.err, "", {"rigid.pipe"}), 0) << falls.err;
  for (const Ended& refused : {ended("driven", above, thrown), ended("free", beside, thrown)}) {
    EXPECT_EQ(refused.status, 2);
    EXPECT_EQ(lines_with(refused.err, "berm: ", {"rigid.pipe", "touches no soil"}), 1) << refused.err;
  }
}

TEST(Roles, in_the_order_of_a_life_are_not_doubted_nor_those_without_operation_of_which_the_sweeps_are_said)
{
  TemporaryFolder folder;
  folder.write("case.toml", base_of("bed"));
  const auto answer = [&](const char* of_push, const char* of_drag) {
    return run_program(folder.path(), {"check", "case.toml", "--threads", "1", "--set", "mesh.near_size=4 mm", "--set",
                                       std::string("stage.push.role=") + of_push, "--set", std::string("stage.drag.role=") + of_drag});
  };
  for (const auto& [of_push, of_drag] : {std::pair{"touchdown", "breakout"}, {"operation", "automatic"}, {"touchdown", "sweep"}}) {
    const Ended ended = answer(of_push, of_drag);
    EXPECT_EQ(ended.status, 0) << ended.err;
    EXPECT_EQ(lines_with(ended.err, "", {".role"}), 0) << ended.err;
  }
}

TEST(Roles, of_a_free_stage_are_those_of_a_free_body)
{
  TemporaryFolder folder;
  std::string text = base_of("bed");
  const std::size_t drag = text.find("[[stage]]\nname = \"drag\"");
  text.insert(drag, "[[stage]]\nname = \"sink\"\nkind = \"free\"\nrole = \"operation\"\nuntil.time = \"5 ms\"\n\n");
  folder.write("case.toml", text);
  const auto answer = [&](const char* motion) {
    return run_program(folder.path(), {"check", "case.toml", "--threads", "1", "--set", "mesh.near_size=4 mm", "--set",
                                       std::string("rigid.pipe.motion=") + motion});
  };
  const Ended refused = answer("driven"), sinks = answer("free");
  EXPECT_EQ(refused.status, 2);
  EXPECT_EQ(lines_with(refused.err, "berm: ", {"stage.sink.role", "this one drives nothing"}), 1) << refused.err;
  EXPECT_EQ(lines_with(sinks.err, "", {"stage.sink.role"}), 0) << sinks.err;
}

class SenselessInputs : public testing::TestWithParam<SenselessInput> {
protected:
  SenselessInputs()
  {
    std::string text = base_of(GetParam().base);
    if (!GetParam().replaced.empty()) text.replace(text.find(GetParam().replaced), GetParam().replaced.size(), GetParam().by);
    folder_.write("case.toml", text);
  }

  TemporaryFolder folder_;
};

TEST_P(SenselessInputs, are_warned_of_or_refused_with_place_and_advice_before_anything_is_computed)
{
  const SenselessInput& input = GetParam();
  const Ended ended = run_program(folder_.path(), arguments_for("check", input));
  const bool refused = ended.status == 2;
  if (input.answer != SenselessInput::Answer::either) {
    EXPECT_EQ(refused, input.answer == SenselessInput::Answer::refused) << ended.err;
  }
  EXPECT_TRUE(refused || ended.status == 0) << ended.err;
  EXPECT_GE(lines_with(ended.err, refused ? "berm: " : "berm: warning: ", input.says), 1) << ended.err;
  const int placed = lines_with(ended.err, "berm: ", {"case.toml:"}) + lines_with(ended.err, "berm: ", {"--set "});
  EXPECT_EQ(placed, static_cast<int>(std::count(ended.err.begin(), ended.err.end(), '\n')))
      << "a line without file and line: " << ended.err;
  if (!refused) return;
  const Ended run = run_program(folder_.path(), arguments_for("run", input));
  EXPECT_EQ(run.status, 2);
  if (input.answer == SenselessInput::Answer::refused) {
    EXPECT_EQ(run.err, ended.err);
  }
  EXPECT_EQ(names_in(folder_.path()), std::vector<std::string>{"case.toml"}) << "something was written";
}

std::string name_of(const testing::TestParamInfo<SenselessInput>& row)
{
  return row.param.name;
}

INSTANTIATE_TEST_SUITE_P(Table, SenselessInputs, testing::ValuesIn(test::senseless_inputs()), name_of);
INSTANTIATE_TEST_SUITE_P(LoadHistories, SenselessInputs, testing::ValuesIn(test::senseless_load_histories()), name_of);
INSTANTIATE_TEST_SUITE_P(Remeshed, SenselessInputs, testing::ValuesIn(test::senseless_remeshed()), name_of);
INSTANTIATE_TEST_SUITE_P(Roles, SenselessInputs, testing::ValuesIn(test::senseless_roles()), name_of);
INSTANTIATE_TEST_SUITE_P(Sizes, SenselessInputs, testing::ValuesIn(test::senseless_sizes()), name_of);
INSTANTIATE_TEST_SUITE_P(Soils, SenselessInputs, testing::ValuesIn(test::senseless_soils()), name_of);
INSTANTIATE_TEST_SUITE_P(Supports, SenselessInputs, testing::ValuesIn(test::senseless_supports()), name_of);
INSTANTIATE_TEST_SUITE_P(Meshes, SenselessInputs, testing::ValuesIn(test::senseless_meshes()), name_of);
INSTANTIATE_TEST_SUITE_P(Pipelines, SenselessInputs, testing::ValuesIn(test::senseless_pipelines()), name_of);
INSTANTIATE_TEST_SUITE_P(InSpace, SenselessInputs, testing::ValuesIn(test::senseless_inputs_in_space()), name_of);

class Examples : public testing::TestWithParam<fs::path> {};

TEST_P(Examples, are_not_doubted)
{
  const fs::path examples = fs::path(BERM_SOURCE_DIR) / "examples";
  const Ended ended = run_program(examples, {"check", GetParam().string(), "--threads", "1"});
  EXPECT_EQ(ended.status, 0);
  // How deep the anchor digs is for the run to find, and its flukes are thinner than two cells; a buckle is heated in seconds: their pages say so.
  struct Doubted {
    const char* page;
    std::vector<std::vector<std::string>> says;
  };
  const std::vector<Doubted> doubted = {{"drag_anchor/case.toml", {{"rigid.anchor: is ", " thick at "}}},
                                        {"load_table/case.toml", {{"rigid.pipe: begins 50 mm above"}}},
                                        {"lateral_buckle/case.toml", {{"stage.heat.ramp: ", "its inertia matters"}}},
                                        {"lateral_buckle/sand.toml", {{"stage.heat.ramp: ", "its inertia matters"}}}};
  std::ptrdiff_t lines = 0;
  for (const Doubted& one : doubted) {
    if (GetParam() != one.page) continue;
    lines = static_cast<std::ptrdiff_t>(one.says.size());
    for (const std::vector<std::string>& says : one.says) EXPECT_EQ(lines_with(ended.err, "berm: warning: ", says), 1) << ended.err;
  }
  EXPECT_EQ(std::count(ended.err.begin(), ended.err.end(), '\n'), lines) << ended.err;
}

/// Every case of berm run in the examples, by its path there.
std::vector<fs::path> all_examples()
{
  std::vector<fs::path> cases;
  const fs::path examples = fs::path(BERM_SOURCE_DIR) / "examples";
  for (const auto& entry : fs::recursive_directory_iterator(examples)) {
    const std::string name = entry.path().filename().string();
    if (entry.path().extension() != ".toml") continue;
    const std::string text = text_of_file(entry.path());
    const bool of_tests = text.find("\n[[test]]") != std::string::npos || text.find("\n[[measured]]") != std::string::npos ||
                          text.find("\n[contours]") != std::string::npos || text.find("\n[sea]") != std::string::npos ||
                          text.find("\n[[section]]") != std::string::npos || text.find("\n[[measure]]") != std::string::npos;
    const bool other = of_tests || name == "expected.toml" || name == "study.toml";
    if (!other) cases.push_back(fs::relative(entry.path(), examples));
  }
  std::sort(cases.begin(), cases.end());
  return cases;
}

INSTANTIATE_TEST_SUITE_P(All, Examples, testing::ValuesIn(all_examples()), [](const auto& of) {
  std::string name = of.param.string();
  for (char& c : name)
    if (std::isalnum(static_cast<unsigned char>(c)) == 0) c = '_';
  return name;
});

TEST(Diagnostics, stand_in_the_log_and_in_the_summary_and_a_resumed_run_keeps_them)
{
  TemporaryFolder folder;
  folder.write("case.toml", test::small_case);
  const std::vector<std::string> says = {"case.toml:", "stage.push.velocity", "inertia"};
  const fs::path summary = folder / "results/summary.json", history = folder / "results/history.csv";
  const auto stop = [&](const std::vector<std::string>& arguments) {
    const std::uintmax_t before = fs::exists(history) ? fs::file_size(history) : 0;
    Program program(folder.path(), arguments);
    EXPECT_TRUE(wait_until([&] { return fs::exists(history) && fs::file_size(history) > before + 2000; }));
    program.signal(SIGINT);
    return program.wait();
  };
  const Ended ended = stop({"run", "case.toml", "-o", "results", "--threads", "1", "--set", "stage.rest.until.time=100 s"});
  ASSERT_EQ(ended.status, 75) << ended.err;
  EXPECT_EQ(lines_with(ended.err, "berm: warning: ", says), 1) << ended.err;
  EXPECT_EQ(lines_with(text_of_file(folder / "results/run.log"), "", says), 1);
  EXPECT_EQ(lines_with(text_of_file(summary), "", says), 1);
  fs::remove(summary);
  ASSERT_EQ(stop({"run", "--resume", "results", "--threads", "1"}).status, 75);
  EXPECT_EQ(lines_with(text_of_file(summary), "", says), 1);
}

}  // namespace
}  // namespace berm::sanity::this_file
