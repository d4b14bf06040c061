// SPDX-License-Identifier: BSD-3-Clause
// A pipeline on slices as a run: its files, its answers, and that it goes on as if it had not been stopped.
#include "samples/error_of.hpp"
#include "samples/program.hpp"
#include "samples/small_cases.hpp"

#include <berm/berm.hpp>

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <sstream>

namespace berm::this_file {
namespace {

using OneRun = Run;  // the fixture has a Run of its own

class PipelineRun : public testing::Test {
protected:
  PipelineRun() { folder_.write("line.toml", test::small_line_case); }

  /// The line for a tenth of a second, far soil at rest.
  OneRun run_of(const std::string& name, const std::vector<std::string>& more = {}) const
  {
    RunOptions options;
    options.folder = (folder_ / name).string();
    options.set = {"stage.current.until.time=\"0.1 s\"",
                   "stage.current.ramp=\"0.05 s\"",
                   "stage.lay.until.time=\"0.6 s\"",
                   "mpm.active_distance=\"0.3 m\"",
                   "output.history_time=\"0.02 s\"",
                   "output.frame_time=\"0.03 s\"",
                   "pipeline.springs={travel=\"0.1 m\", velocity=\"0.2 m/s\"}"};
    options.set.insert(options.set.end(), more.begin(), more.end());
    return OneRun((folder_ / "line.toml").string(), options);
  }
  static void lay(OneRun& run)
  {
    while (run.stage() != "current") run.step();
  }
  static void to_the_line(OneRun& run)
  {
    lay(run);
    run.step(21);
  }

  /// Of a column, in the rows of a stage.
  std::vector<double> values(const std::string& name, const std::string& column, const std::string& stage) const
  {
    std::istringstream rows(folder_.read(name + "/history.csv"));
    std::string head, row;
    std::getline(rows, head);
    std::vector<double> found;
    while (std::getline(rows, row)) {
      std::istringstream names(head), cells(row);
      std::string of, cell, in;
      double value = std::nan("");
      while (std::getline(names, of, ',') && std::getline(cells, cell, ',')) {
        if (of == "stage") in = cell;
        if (of == column) value = std::stod(cell);
      }
      if (in == stage) found.push_back(value);
    }
    return found;
  }

  TemporaryFolder folder_;
};

TEST_F(PipelineRun, goes_on_to_the_same_bytes_after_it_was_stopped_and_as_a_clone)
{
  // One slice is resolved after the stop, and another has a soil of its own.
  const std::vector<std::string> more = {"pipeline.slices.as_spring=\"until_sliding\"",
                                         "pipeline.far_soil={friction=0.9, axial_angle=\"20 deg\"}",
                                         "pipeline.soil=[{from=\"2 m\", to=\"2 m\", set=[\"material.clay.cohesion=3 kPa\"]}]"};
  run_of("whole", more).finish();
  {
    OneRun parts = run_of("parts", more);
    to_the_line(parts);
    OneRun clone = parts.clone((folder_ / "clone").string());
    for (const double u : values("parts", "slice_1_u_m", "current")) EXPECT_EQ(u, 0) << "it sleeps";
    clone.finish();
    parts.stop();
  }
  OneRun::resume((folder_ / "parts").string()).finish();
  EXPECT_GT(values("parts", "slice_1_u_m", "current").back(), 1e-5) << "it woke";
  {
    OneRun laid = run_of("laid", more);  // the resistance of springs is not known yet
    lay(laid);
    laid.stop();
  }
  OneRun::resume((folder_ / "laid").string()).finish();
  for (const std::string name : {"history.csv", "line.csv", "berms.csv", "springs.csv"}) {
    ASSERT_FALSE(folder_.read("whole/" + name).empty()) << name;
    EXPECT_EQ(folder_.read("whole/" + name), folder_.read("parts/" + name)) << name;
    EXPECT_EQ(folder_.read("whole/" + name), folder_.read("clone/" + name)) << name;
    EXPECT_EQ(folder_.read("whole/" + name), folder_.read("laid/" + name)) << name;
  }
}

TEST_F(PipelineRun, goes_on_to_the_same_bytes_while_all_its_slices_sleep)
{
  const std::vector<std::string> more = {"pipeline.slices.as_spring=\"always\"",
                                         "pipeline.far_soil={friction=0.9, axial_angle=\"20 deg\"}"};
  run_of("whole", more).finish();
  {
    OneRun parts = run_of("parts", more);
    to_the_line(parts);
    parts.stop();
  }
  OneRun::resume((folder_ / "parts").string()).finish();
  EXPECT_GT(values("parts", "out_of_balance", "current").back(), 0) << "the last that the soil had";
  for (const std::string name : {"history.csv", "line.csv", "springs.csv"})
    EXPECT_EQ(folder_.read("whole/" + name), folder_.read("parts/" + name)) << name;
}

TEST_F(PipelineRun, has_columns_of_its_line_and_of_each_slice_and_answers_for_each_of_its_stages)
{
  OneRun run = run_of("run");
  run.finish();
  std::vector<std::string> names;
  for (const HistoryColumn& column : run.columns()) names.push_back(column.name);
  for (const char* name : {"line_T_K", "line_P0_N", "line_P_N", "line_y_m", "line_M_Nm", "line_strain_min", "springs_y_m", "springs_x_m",
                           "springs_P_N", "springs_M_Nm", "slice_1_u_m", "slice_3_H_N_m", "slice_3_V_N_m"})
    EXPECT_NE(std::find(names.begin(), names.end(), name), names.end()) << name;
  const std::string shape = folder_.read("run/line.csv"), summary = folder_.read("run/summary.json");
  EXPECT_EQ(shape.substr(0, shape.find('\n')), "frame,time_s,stage,x_m,y_m,z_m,u_m,P_N,M_Nm,strain_max,strain_min");
  const std::string springs = folder_.read("run/springs.csv");
  EXPECT_EQ(springs.substr(0, springs.find('\n')), "u_m,H_N_m");
  for (const char* name :
       {"current.y", "current.P", "current.M", "current.feed_in", "current.springs_y", "line_slope", "contact_mass_over_mass"})
    EXPECT_NE(summary.find(name), std::string::npos) << name;
}

TEST_F(PipelineRun, lays_its_pipe_in_each_soil)
{
  OneRun run = run_of("soils", {"pipeline.soil=[{from=\"2 m\", to=\"3 m\", set=[\"material.clay.cohesion=4 kPa\"]}]"});
  to_the_line(run);
  run.finish();
  const auto deep = [&](const std::string& column) { return values("soils", column, "current").back(); };
  EXPECT_LT(deep("slice_2_w_m"), 0.75 * deep("slice_1_w_m")) << "twice the strength, half the depth, some of it elastic";
  EXPECT_NEAR(deep("slice_3_w_m"), deep("slice_2_w_m"), 1e-3) << "the same soil; the line hardly bends";
}

TEST_F(PipelineRun, counts_forces_of_each_soil_from_when_the_slices_are_coupled)
{
  OneRun run = run_of("soils", {"pipeline.soil=[{from=\"2 m\", to=\"3 m\", set=[\"material.clay.cohesion=4 kPa\"]}]",
                                "stage.lay.until={embedment=\"10 mm\", time=\"1 s\"}"});
  to_the_line(run);
  run.finish();
  // The pipe had to be pushed longer into one of them: an impulse of laying would be many times the weight.
  for (const double V : values("soils", "slice_2_V_N_m", "current")) EXPECT_NEAR(V, 1500, 1500);
}

TEST_F(PipelineRun, refuses_soil_where_no_slice_lies_or_that_makes_no_sense)
{
  EXPECT_NE(test::error_of<InputError>([&] {
              run_of("nowhere", {"pipeline.soil=[{from=\"1.2 m\", to=\"1.6 m\", set=[\"material.clay.cohesion=4 kPa\"]}]"});
            }).find("no slice lies between"),
            std::string::npos);
  EXPECT_NE(test::error_of<InputError>([&] {
              run_of("wrong", {"pipeline.soil=[{from=\"1 m\", to=\"1 m\", set=[\"material.clay.cohesin=4 kPa\"]}]"});
            }).find("cohesion"),
            std::string::npos);
}

TEST_F(PipelineRun, is_driven_by_its_line_alone)
{
  OneRun run = run_of("driven");
  to_the_line(run);
  EXPECT_NE(test::error_of<InputError>([&] { run.drive_by_velocity(Freedom::x, 1); }).find("whose line drives the pipe"),
            std::string::npos);
}

}  // namespace
}  // namespace berm::this_file
