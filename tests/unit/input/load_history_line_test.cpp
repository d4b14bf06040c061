// SPDX-License-Identifier: BSD-3-Clause
// Load histories of a pipeline.
#include "input/load_history.hpp"

#include "samples/error_of.hpp"
#include "samples/pipeline_case.hpp"
#include "samples/temporary_folder.hpp"

#include "os/error.hpp"

#include <gtest/gtest.h>

namespace berm::input::this_file {
namespace {

std::string with(std::string text, const std::string& what, const std::string& by)
{
  return text.replace(text.find(what), what.size(), by);
}

/// A line of steel whose last stage has the load history "heat.csv".
class LineLoadHistory : public testing::Test {
protected:
  settings::Case read(const std::string& table, const std::vector<std::string>& set = {})
  {
    folder_.write("heat.csv", table);
    const std::string steel = with(test::small_line_case, "bending_stiffness = \"1e9 N m^2\"\naxial_stiffness = \"1e9 N\"",
                                   "wall = \"15 mm\"\nyoung_modulus = \"206 GPa\"\nexpansion = \"1.17e-5 1/K\"");
    return read_case_text((folder_.path() / "line.toml").string(),
                          with(steel, "pipeline.lateral = \"1 kN/m\"\nramp = \"1 s\"\nuntil.time = \"2 s\"", "load_history = \"heat.csv\""),
                          set);
  }
  std::string error_of(const std::string& table, const std::vector<std::string>& set = {})
  {
    return test::error_of<InputError>([&] { read(table, set); });
  }

  TemporaryFolder folder_;
};

TEST_F(LineLoadHistory, is_read_with_its_units_and_ends_the_stage)
{
  const settings::StageSettings stage =
      read("time_min,temperature_K,pressure_MPa,weight_kN_m,lateral_N_m,pull_kN\n0,0,0,1.5,0,0\n1,30,10,1.2,100,50\n2,10,0,1.5,0,0\n")
          .stage.back();
  EXPECT_EQ(stage.load_times, (std::vector<Real>{0, 60, 120}));
  EXPECT_EQ(stage.loads.of("temperature"), (std::vector<Real>{0, 30, 10}));
  EXPECT_EQ(stage.loads.of("pressure"), (std::vector<Real>{0, 10e6, 0}));
  EXPECT_EQ(stage.loads.of("weight"), (std::vector<Real>{1500, 1200, 1500}));
  EXPECT_EQ(stage.loads.of("lateral"), (std::vector<Real>{0, 100, 0}));
  EXPECT_EQ(stage.loads.of("pull"), (std::vector<Real>{0, 50e3, 0}));
  EXPECT_EQ(stage.until.time, 120);
}

TEST_F(LineLoadHistory, is_repeated_and_slowed_down_as_any)
{
  const settings::StageSettings stage =
      read("time_s,temperature_K\n0,0\n1,30\n2,0\n", {"stage.current.load_repeat=3", "stage.current.time_scale=10"}).stage.back();
  EXPECT_EQ(stage.load_times, (std::vector<Real>{0, 1, 2, 3, 4, 5, 6}));
  EXPECT_EQ(stage.until.time, 60);
}

TEST_F(LineLoadHistory, is_refused_with_file_and_line_or_key_where_it_makes_no_sense)
{
  const std::string good = "time_s,temperature_K\n0,0\n1,30\n";
  struct Wrong {
    std::string table;
    std::vector<std::string> set;
    std::string says;
  };
  const std::vector<Wrong> wrong = {
      {"time_s,temperature_K,weight_N_m\n0,0,1500\n1,30,0\n", {}, "heat.csv:3: weight is 0 N/m at 1 s: it must be more than 0"},
      {"time_s,temperature_K\n1,0\n0,30\n", {}, "heat.csv:3: times must ascend"},
      {"time_s,temperature_m\n0,0\n1,30\n", {}, "heat.csv:1: "},
      {"time_s,pull_N\n0,0\n1,30\n", {"pipeline.end=anchored"}, "heat.csv:1: "},
      {"time_s,H_N_m\n0,0\n1,30\n", {}, "heat.csv:1: "},
      {"0,0\n1,1\n", {}, "stage.current.load_factors: multiply what a push or a drag drives; a stage of kind pipeline has"},
      {good, {"stage.current.ramp=1"}, "stage.current.ramp: is not for loads of the line"},
      {good, {"stage.current.pipeline.weight=1500"}, "stage.current.pipeline: cannot be combined with a load history"},
      {good, {"stage.current.time_scale=automatic"}, "stage.current.time_scale: is chosen for a record of forces"},
      {good, {"stage.lay.load_history=heat.csv"}, "heat.csv:1: "},
  };
  for (const Wrong& one : wrong)
    EXPECT_NE(error_of(one.table, one.set).find(one.says), std::string::npos) << one.says << ", not: " << error_of(one.table, one.set);
}

}  // namespace
}  // namespace berm::input::this_file
