// SPDX-License-Identifier: BSD-3-Clause
// A pipeline on slices as a run: its files, its answers, and that it goes on as if it had not been stopped.
#include "samples/error_of.hpp"
#include "samples/program.hpp"
#include "samples/small_cases.hpp"

#include <berm/berm.hpp>

#include <algorithm>
#include <gtest/gtest.h>

namespace berm::this_file {
namespace {

using OneRun = Run;  // the fixture has a Run of its own

class PipelineRun : public testing::Test {
protected:
  PipelineRun() { folder_.write("line.toml", test::small_line_case); }

  /// The line for a tenth of a second, far soil at rest.
  OneRun run_of(const std::string& name) const
  {
    RunOptions options;
    options.folder = (folder_ / name).string();
    options.set = {"stage.current.until.time=\"0.1 s\"", "stage.current.ramp=\"0.05 s\"",  "stage.lay.until.time=\"0.6 s\"",
                   "mpm.active_distance=\"0.3 m\"",      "output.history_time=\"0.02 s\"", "output.frame_time=\"0.03 s\""};
    return OneRun((folder_ / "line.toml").string(), options);
  }
  static void to_the_line(OneRun& run)
  {
    while (run.stage() != "current") run.step();
    run.step(21);
  }

  TemporaryFolder folder_;
};

TEST_F(PipelineRun, goes_on_to_the_same_bytes_after_it_was_stopped_and_as_a_clone)
{
  run_of("whole").finish();
  {
    OneRun parts = run_of("parts");
    to_the_line(parts);
    OneRun clone = parts.clone((folder_ / "clone").string());
    clone.finish();
    parts.stop();
  }
  OneRun::resume((folder_ / "parts").string()).finish();
  for (const std::string name : {"history.csv", "line.csv"}) {
    ASSERT_FALSE(folder_.read("whole/" + name).empty()) << name;
    EXPECT_EQ(folder_.read("whole/" + name), folder_.read("parts/" + name)) << name;
    EXPECT_EQ(folder_.read("whole/" + name), folder_.read("clone/" + name)) << name;
  }
}

TEST_F(PipelineRun, has_columns_of_its_line_and_of_each_slice_and_answers_for_each_of_its_stages)
{
  OneRun run = run_of("run");
  run.finish();
  std::vector<std::string> names;
  for (const HistoryColumn& column : run.columns()) names.push_back(column.name);
  for (const char* name :
       {"line_T_K", "line_P0_N", "line_P_N", "line_y_m", "line_M_Nm", "line_strain_min", "slice_1_u_m", "slice_3_H_N_m", "slice_3_V_N_m"})
    EXPECT_NE(std::find(names.begin(), names.end(), name), names.end()) << name;
  const std::string shape = folder_.read("run/line.csv"), summary = folder_.read("run/summary.json");
  EXPECT_EQ(shape.substr(0, shape.find('\n')), "frame,time_s,stage,x_m,y_m,z_m,u_m,P_N,M_Nm,strain_max,strain_min");
  for (const char* name : {"current.y", "current.P", "current.M", "current.feed_in", "line_slope", "contact_mass_over_mass"})
    EXPECT_NE(summary.find(name), std::string::npos) << name;
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
