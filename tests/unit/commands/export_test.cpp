// SPDX-License-Identifier: BSD-3-Clause
// `berm export`, from outside.
#include "samples/program.hpp"
#include "samples/small_cases.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace berm::commands::this_file {
namespace {

using Json = nlohmann::json;
using Words = std::vector<std::string>;

/// Strength of the clay, and with it of the interface, that is not known well.
constexpr const char* sample_of_strength = R"([[case]]
name = "pipe"
file = "case.toml"
[sample]
size = 10
[[sample.parameter]]
name = "s_u over best"
times = {"material.clay.cohesion" = "1 kPa", "contact.skin.adhesion" = "500 Pa", "material.clay.young_modulus" = "1 MPa"}
low = 0.8
high = 1.25
[[measure]]
name = "H_max"
unit = "N/m"
quantity = "H_max"
)";

class Export : public testing::Test {
protected:
  Export() { folder_.write("case.toml", test::small_fem_case); }
  Ended berm(const Words& arguments) const { return run_program(folder_.path(), arguments); }
  Json json(const std::string& file) const { return Json::parse(text_of_file(folder_ / file)); }
  bool exists(const std::string& file) const { return std::filesystem::exists(folder_ / file); }
  TemporaryFolder folder_;
};

TEST_F(Export, refuses_a_state_and_a_travel_that_the_run_has_not)
{
  ASSERT_EQ(berm({"run", "case.toml", "-o", "r"}).status, 0);
  const Ended state = berm({"export", "r", "--state", "operatoin"}), travel = berm({"export", "r", "--travels", "nowhere"});
  EXPECT_EQ(state.status, 2);
  EXPECT_NE(state.err.find("has no state \"operatoin\"; did you mean \"operation\"?"), std::string::npos) << state.err;
  EXPECT_EQ(travel.status, 2);
  EXPECT_NE(travel.err.find("has no drag \"nowhere\""), std::string::npos) << travel.err;
  EXPECT_FALSE(exists("r/export"));
  ASSERT_EQ(berm({"export", "r", "--to", "json", "--state", "operation", "--travels", " drag, drag "}).status, 0) << "blanks beside commas";
  EXPECT_EQ(json("r/export/springs.json")["springs"]["best"]["state"], "operation");
}

TEST_F(Export, says_of_a_run_folder_that_was_edited_so_in_decks_page_and_messages)
{
  ASSERT_EQ(berm({"run", "case.toml", "-o", "r"}).status, 0);
  const std::string whole = text_of_file(folder_ / "r/resolved.toml");
  folder_.write("r/resolved.toml", whole + "client = \"A client\"\n");
  EXPECT_EQ(berm({"report", "r"}).err, "") << "[report] is no part of what is computed";
  std::string edited = whole;
  edited.replace(edited.find("cohesion = 1000"), 15, "cohesion = 2000");
  folder_.write("r/resolved.toml", edited);
  const std::string words = "resolved.toml was changed after the run began: the run used an earlier version";
  const Ended report = berm({"report", "r"}), deck = berm({"export", "r", "--to", "ansys"});
  EXPECT_EQ(report.status, 0);
  EXPECT_NE(report.err.find("warning: r: " + words), std::string::npos) << report.err;
  EXPECT_NE(text_of_file(folder_ / "r/report.html").find(words), std::string::npos);
  EXPECT_NE(deck.err.find(words), std::string::npos) << deck.err;
  EXPECT_NE(text_of_file(folder_ / "r/export/springs_best.mac").find("! " + words + "\n"), std::string::npos);

  std::string summary = text_of_file(folder_ / "r/summary.json");
  summary.replace(summary.find("\"date\": \"") + 9, 0, "2026\\n/SYS,touch x");
  folder_.write("r/summary.json", summary);
  EXPECT_EQ(berm({"export", "r", "--to", "ansys"}).status, 0);
  EXPECT_EQ(text_of_file(folder_ / "r/export/springs_best.mac").find("/SYS"), std::string::npos);
}

TEST_F(Export, refuses_a_study_whose_measure_no_run_can_have)
{
  std::string misspelt = sample_of_strength;
  misspelt.replace(misspelt.find("quantity = \"H_max\""), 18, "quantity = \"Hmax\"");
  folder_.write("study.toml", misspelt);
  const Ended study = berm({"study", "study.toml", "-o", "s"});
  EXPECT_EQ(study.status, 2);
  EXPECT_NE(study.err.find("has no \"Hmax\"; did you mean \"H_max\"?"), std::string::npos) << study.err;
  EXPECT_FALSE(exists("s")) << "no run is begun";
}

TEST_F(Export, of_a_sample_writes_low_best_and_high_for_each_program)
{
  folder_.write("study.toml", sample_of_strength);
  const Ended study = berm({"study", "study.toml", "-o", "s"});
  ASSERT_EQ(study.status, 0) << study.err;
  const Json rows = json("s/study.json")["rows"];
  ASSERT_EQ(rows.size(), 13u);
  EXPECT_EQ(rows[0]["kind"], "best");
  EXPECT_EQ(rows[1]["kind"], "low");
  EXPECT_EQ(rows[2]["kind"], "high");
  EXPECT_EQ(rows[12]["kind"], "draw");

  ASSERT_EQ(berm({"export", "s", "--to", "json"}).status, 0);
  const Json springs = json("s/export/springs.json")["springs"];
  const auto peak = [&](const char* estimate) { return springs[estimate]["lateral"][0]["peak_N_m"].get<double>(); };
  const std::string estimates = text_of_file(folder_ / "s/estimates.csv"), line = estimates.substr(estimates.find("pipe,H_max"));
  double best = 0, low = 0, middle = 0, high = 0;
  ASSERT_EQ(std::sscanf(line.c_str(), "pipe,H_max (N/m),%lf,%lf,%lf,%lf", &best, &low, &middle, &high), 4) << line;
  EXPECT_LT(low, best);
  EXPECT_LT(best, high);
  for (const auto& [estimate, H] : {std::pair("low", low), std::pair("best", best), std::pair("high", high)})
    EXPECT_NEAR(peak(estimate) / H, 1, 1e-6) << "the study measures the same H as the spring has";

  const std::pair<const char*, Words> formats[] = {{"table", {"springs.csv", "curves.csv"}},
                                                   {"abaqus", {"springs_low.inp", "springs_best.inp", "springs_high.inp"}},
                                                   {"orcaflex", {"springs_low.csv", "springs_best.csv", "springs_high.csv"}},
                                                   {"ansys", {"springs_low.mac", "springs_best.mac", "springs_high.mac"}},
                                                   {"sima", {"springs_low.inp", "springs_best.inp", "springs_high.inp"}},
                                                   {"calculix", {"springs_low_lateral_drag.inp", "springs_best_axial.inp"}},
                                                   {"opensees", {"springs_low.py", "springs_best.py", "springs_high.py"}},
                                                   {"moordyn", {"springs_low.txt", "springs_best.txt", "springs_high.txt"}},
                                                   {"buckpy", {"soils.csv"}}};
  for (const auto& [format, files] : formats) {
    const Ended ended = berm({"export", "s", "--to", format, "-o", format});
    EXPECT_EQ(ended.status, 0) << ended.err;
    for (const std::string& file : files) {
      EXPECT_TRUE(exists(std::string(format) + "/" + file)) << format << " " << file;
      EXPECT_NE(ended.out.find(std::string(format) + "/" + file + "\n"), std::string::npos) << ended.out;
    }
  }
}

TEST_F(Export, of_a_run_writes_its_springs_and_of_several_each_to_a_folder_of_its_name)
{
  for (const char* name : {"a", "b"}) ASSERT_EQ(berm({"run", "case.toml", "-o", name}).status, 0);
  ASSERT_EQ(berm({"export", "a", "--to", "abaqus"}).status, 0);
  EXPECT_TRUE(exists("a/export/springs_best.inp"));
  EXPECT_FALSE(exists("a/export/springs_low.inp"));
  ASSERT_EQ(berm({"export", "a", "b", "-o", "both"}).status, 0);
  EXPECT_TRUE(exists("both/a/springs.csv") && exists("both/b/springs.csv"));
  std::filesystem::create_directory(folder_ / "elsewhere");
  std::filesystem::create_directory_symlink("../elsewhere", folder_ / "b/export");
  const Ended linked = berm({"export", "b", "--to", "abaqus"});
  EXPECT_EQ(linked.status, 1);
  EXPECT_NE(linked.err.find("it is a link, and berm writes through none"), std::string::npos) << linked.err;
  EXPECT_TRUE(std::filesystem::is_empty(folder_ / "elsewhere")) << "whoever sent the run may have made the link";
  const Ended twice = berm({"export", "a", "a", "-o", "twice"});
  EXPECT_EQ(twice.status, 2);
  EXPECT_FALSE(exists("twice")) << "what cannot be written whole is not begun";
}

TEST_F(Export, of_a_pipeline_writes_its_shapes_and_the_curves_of_its_slices_and_of_nothing_else)
{
  folder_.write("line.toml", test::small_line_case);
  Words run{"run", "line.toml", "-o", "line"};
  for (const char* set : {"stage.current.until.time=\"0.1 s\"", "stage.current.ramp=\"0.05 s\"", "stage.lay.until.time=\"0.6 s\"",
                          "mpm.active_distance=\"0.3 m\"", "output.history_time=\"0.02 s\""})
    run.insert(run.end(), {"--set", set});
  ASSERT_EQ(berm(run).status, 0);
  ASSERT_EQ(berm({"export", "line", "--to", "line"}).status, 0);
  ASSERT_EQ(berm({"export", "line", "--to", "py", "-o", "out"}).status, 0);
  EXPECT_NE(text_of_file(folder_ / "line/export/line.csv").find("\ntime_s,stage,x_m,y_m"), std::string::npos);
  EXPECT_NE(text_of_file(folder_ / "out/py.csv").find("\n3,3,"), std::string::npos) << "the fourth slice, at 3 m";
  EXPECT_NE(text_of_file(folder_ / "out/py_backbone.csv").find("SHA-256 of the case"), std::string::npos);
  const Ended state = berm({"export", "line", "--to", "py", "--state", "laid"});
  EXPECT_EQ(state.status, 2);
  EXPECT_NE(state.err.find("--state and --travels choose springs"), std::string::npos) << state.err;
  ASSERT_EQ(berm({"run", "case.toml", "-o", "pipe"}).status, 0);
  const Ended other = berm({"export", "pipe", "--to", "line"});
  EXPECT_EQ(other.status, 2);
  EXPECT_NE(other.err.find("pipe is not a run of a pipeline: its case has no [pipeline]"), std::string::npos) << other.err;
  EXPECT_FALSE(exists("pipe/export"));
}

TEST_F(Export, says_what_it_takes_where_it_is_given_something_else)
{
  const auto refusal = [&](const Words& arguments) {
    const Ended ended = berm(arguments);
    EXPECT_NE(ended.status, 0);
    EXPECT_EQ(std::count(ended.err.begin(), ended.err.end(), '\n'), 1) << ended.err;
    return ended.err;
  };
  EXPECT_NE(refusal({"export", "nowhere"}).find("nowhere is not a folder"), std::string::npos);
  EXPECT_NE(refusal({"export", "."}).find("neither a run folder nor the output of berm study"), std::string::npos);
  EXPECT_NE(refusal({"export", ".", "--to", "excel"}).find("orcaflex"), std::string::npos) << "what is allowed";
}

}  // namespace
}  // namespace berm::commands::this_file
