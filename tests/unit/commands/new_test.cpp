// SPDX-License-Identifier: BSD-3-Clause
// `berm new`, from outside.
#include "core/types.hpp"
#include "samples/program.hpp"

#include <cmath>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace berm::commands::this_file {
namespace {

namespace fs = std::filesystem;

class New : public testing::Test {
protected:
  Ended berm(const std::vector<std::string>& arguments) const { return run_program(folder_.path(), arguments); }
  TemporaryFolder folder_;
};

/// The kinds that the command lists.
std::vector<std::string> kinds_in(const std::string& list)
{
  std::vector<std::string> kinds;
  std::istringstream lines(list);
  for (std::string line; std::getline(lines, line);)
    if (line.starts_with("  ")) kinds.push_back(line.substr(2, line.find(' ', 2) - 2));
  return kinds;
}

using NewOfAll = New;

/// What `berm check` says of files, all in one call; "" where it doubts none of them.
std::string doubts(const std::filesystem::path& folder, std::vector<std::string> files)
{
  files.insert(files.begin(), {"check", "--threads", "1"});
  const Ended checked = run_program(folder, files);
  return checked.status != 0 || checked.err.find("warning") != std::string::npos ? checked.err : "";
}

TEST_F(New, lists_its_kinds)
{
  const Ended ended = berm({"new"});
  EXPECT_EQ(ended.status, 0) << ended.err;
  const std::vector<std::string> kinds = kinds_in(ended.out);
  for (const char* kind : {"cable-in-sand", "pipe-in-clay", "pipe-in-sand"})
    EXPECT_NE(std::find(kinds.begin(), kinds.end(), kind), kinds.end()) << kind << " is not in\n" << ended.out;
}

TEST_F(New, writes_a_quick_case_of_each_kind_that_check_takes_without_a_doubt)
{
  std::vector<std::string> files;
  for (const std::string& kind : kinds_in(berm({"new"}).out)) {
    const Ended written = berm({"new", kind, "--size", "quick"});
    ASSERT_EQ(written.status, 0) << written.err;
    files.push_back(kind + ".toml");
  }
  EXPECT_GE(files.size(), 18u);
  EXPECT_EQ(doubts(folder_.path(), files), "");
}

TEST_F(NewOfAll, sizes_and_soils_check_takes_the_cases_without_a_doubt)
{
  std::vector<std::string> files;
  for (const auto& kind : nlohmann::json::parse(berm({"new", "--json"}).out)) {
    const std::string name = kind["kind"];
    for (const std::string size : kind["sizes"]) {
      files.push_back(name + "." + size + ".toml");
      ASSERT_EQ(berm({"new", name, files.back(), "--size", size}).status, 0);
    }
    for (const std::string soil : kind["soils"]) {
      files.push_back(name + "." + soil + ".toml");
      ASSERT_EQ(berm({"new", name, files.back(), "--size", "quick", "--soil", soil}).status, 0);
    }
  }
  EXPECT_EQ(doubts(folder_.path(), files), "");
}

TEST_F(New, lists_kinds_and_soils_as_json)
{
  const auto kinds = nlohmann::json::parse(berm({"new", "--json"}).out);
  const auto found = std::find_if(kinds.begin(), kinds.end(), [](const auto& kind) { return kind["kind"] == "pipe-in-clay"; });
  ASSERT_NE(found, kinds.end());
  EXPECT_EQ((*found)["group"], "Pipelines");
  EXPECT_EQ((*found)["sizes"], nlohmann::json({"quick", "normal", "fine"}));
  EXPECT_EQ((*found)["example"], "pipe_clay_life");
  for (const auto& kind : kinds) {
    const std::string name = kind["kind"];
    EXPECT_EQ(kind["sounding"].get<bool>(), name != "trench-and-backfill" && name != "consolidation" && name != "layers") << name;
  }
  const auto soils = nlohmann::json::parse(berm({"new", "--soils", "--json"}).out);
  for (const auto& soil : soils)
    for (const char* key : {"soil", "material", "title", "source", "trust"}) EXPECT_FALSE(soil[key].get<std::string>().empty()) << soil;
  for (const auto& soil : (*found)["soils"])
    EXPECT_TRUE(std::any_of(soils.begin(), soils.end(), [&](const auto& one) { return one["soil"] == soil; })) << soil;
}

TEST_F(New, writes_the_strength_of_a_sounding_and_says_what_counts_and_what_is_doubted)
{
  folder_.write("cpt.csv", "depth_m,q_c_MPa\n0.05,0.1\n0.15,0.12\n0.15,0.13\n0.25,0.14\n");
  const Ended written = berm({"new", "pipe-in-clay", "case.toml", "--cpt", "cpt.csv", "--n-kt", "12"});
  ASSERT_EQ(written.status, 0) << written.err;
  EXPECT_NE(written.out.find("cpt.csv: 3 of 4 rows, 0.05 to 0.25 m; left out: 1 not deeper than the row before; q_c for q_t: the file does "
                             "not say u_2 and the area ratio of the cone\n"),
            std::string::npos)
      << written.out;
  EXPECT_NE(written.err.find("warning: cpt.csv: 1 of 4 rows are left out"), std::string::npos) << written.err;
  EXPECT_NE(written.err.find("warning: cpt.csv: the sounding ends at 0.25 m"), std::string::npos) << written.err;
  EXPECT_NE(folder_.read("case.toml").find("N_kt = 12"), std::string::npos);
  EXPECT_EQ(doubts(folder_.path(), {"case.toml"}), "");
}

TEST_F(New, writes_cases_of_soundings_in_clay_and_sand_that_check_takes_without_a_doubt)
{
  std::string clay = "depth_m,q_t_kPa\n", sand = clay;
  for (int n = 1; n <= 60; ++n) {
    const Real z = 0.1 * n;
    clay += fmt::format("{:.2f},{:.1f}\n", z, 14 * (2 + 1.5 * z) + 15.81 * z);
    sand += fmt::format("{:.2f},{:.1f}\n", z, 4000 * std::sqrt(z));
  }
  folder_.write("clay.csv", clay);
  folder_.write("sand.csv", sand);
  std::vector<std::string> files;
  for (const auto& [kind, cpt] : {std::pair("pipe-in-clay", "clay.csv"), {"lateral-buckle", "clay.csv"}, {"pipe-in-sand", "sand.csv"}}) {
    files.push_back(std::string(kind) + ".toml");
    const Ended written = berm({"new", kind, "--size", "quick", "--cpt", cpt});
    ASSERT_EQ(written.status, 0) << written.err;
  }
  EXPECT_EQ(doubts(folder_.path(), files), "");
}

TEST_F(New, refuses_a_size_a_soil_and_a_sounding_that_do_not_fit)
{
  for (const auto& [arguments, said] : std::vector<std::pair<std::vector<std::string>, std::string>>{
           {{"--size", "quik"}, "did you mean \"quick\""},
           {{"--soil", "calcareous"}, "pipe-in-clay takes no soil \"calcareous\""},
           {{"--cpt", "none.csv"}, "none.csv: there is no such file"},
           {{"--cpt", "none.txt"}, "AGS 4 (.ags), GEF (.gef) or a table (.csv)"},
           {{"--location", "P7"}, "--location goes with --cpt FILE"},
           {{"--n-kt", "12"}, "--n-kt goes with --cpt FILE"},
           {{"--json"}, "without a KIND"}}) {
    std::vector<std::string> all = {"new", "pipe-in-clay"};
    all.insert(all.end(), arguments.begin(), arguments.end());
    const Ended ended = berm(all);
    EXPECT_EQ(ended.status, 2) << ended.out;
    EXPECT_NE(ended.err.find(said), std::string::npos) << ended.err;
    EXPECT_FALSE(fs::exists(folder_ / "pipe-in-clay.toml"));
  }
}

TEST_F(New, writes_to_the_file_that_is_named)
{
  const Ended ended = berm({"new", "pipe-in-clay", "my case.toml"});
  EXPECT_EQ(ended.status, 0) << ended.err;
  EXPECT_TRUE(fs::exists(folder_ / "my case.toml"));
}

TEST_F(New, replaces_nothing)
{
  folder_.write("pipe-in-clay.toml", "mine");
  const Ended ended = berm({"new", "pipe-in-clay"});
  EXPECT_EQ(ended.status, 2);
  EXPECT_NE(ended.err.find("pipe-in-clay.toml already exists"), std::string::npos) << ended.err;
  EXPECT_EQ(folder_.read("pipe-in-clay.toml"), "mine");
}

TEST_F(New, refuses_a_kind_that_it_does_not_know)
{
  const Ended ended = berm({"new", "pipe-in-cly"});
  EXPECT_EQ(ended.status, 2);
  EXPECT_NE(ended.err.find("did you mean \"pipe-in-clay\""), std::string::npos) << ended.err;
}

}  // namespace
}  // namespace berm::commands::this_file
