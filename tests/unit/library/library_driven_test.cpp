// SPDX-License-Identifier: BSD-3-Clause
// Runs that their caller drives, copies and keeps beside each other.
#include "samples/error_of.hpp"
#include "samples/program.hpp"
#include "samples/small_cases.hpp"

#include <berm/berm.hpp>

#include <cmath>
#include <gtest/gtest.h>
#include <limits>

namespace berm::this_file {
namespace {

using OneRun = Run;  // the fixture has a Run of its own

/// The small case, whose pipe is laid and then driven along x: as `drive` says, for 10 ms.
std::string driven_case(const std::string& drive)
{
  std::string text = test::small_case;
  text.erase(text.find("[[stage]]\nname = \"drag\""), text.find("[output]") - text.find("[[stage]]\nname = \"drag\""));
  return text + "\n[[stage]]\nname = \"follow\"\nkind = \"drive\"\nuntil.time = \"10 ms\"\n" + drive + "\n";
}

class DrivenRun : public testing::Test {
protected:
  DrivenRun()
  {
    folder_.write("still.toml", driven_case("drive.x.velocity = 0"));
    folder_.write("drag.toml", test::small_case);
    folder_.write("fem.toml", test::small_fem_case);
  }

  OneRun run_of(const std::string& name, const RunOptions& options = {}) const { return OneRun((folder_ / name).string(), options); }
  /// One that has come to the stage that its caller drives.
  OneRun laid(const std::string& name = "still.toml") const
  {
    OneRun run = run_of(name);
    while (run.stage() != "follow") run.step();
    return run;
  }

  TemporaryFolder folder_;
};

TEST_F(DrivenRun, goes_as_a_stage_of_the_same_velocity_to_the_bit)
{
  folder_.write("prescribed.toml", driven_case("drive.x.velocity = \"0.2 m/s\""));
  OneRun prescribed = run_of("prescribed.toml"), driven = laid();
  while (!driven.ended()) {
    driven.drive_by_velocity(Freedom::x, 0.2);
    driven.step();
  }
  prescribed.finish();
  EXPECT_EQ(driven.steps(), prescribed.steps());
  EXPECT_EQ(driven.row(), prescribed.row());
  EXPECT_GT(driven.rigid_bodies()[0].displacement[0], 1.9e-3);
}

TEST_F(DrivenRun, goes_as_a_stage_of_the_same_force_to_the_bit)
{
  folder_.write("prescribed.toml", driven_case("drive.x.force = \"40 N/m\""));
  OneRun prescribed = run_of("prescribed.toml"), driven = laid();
  driven.drive_by_force(Freedom::x, 40);  // stays until it is told otherwise
  prescribed.finish();
  driven.finish();
  EXPECT_EQ(driven.row(), prescribed.row());
}

TEST_F(DrivenRun, tells_the_impulse_of_the_soil_since_the_start)
{
  OneRun run = laid();
  run.drive_by_velocity(Freedom::x, 0.2);
  run.step(7);
  const RigidBodyNow first = run.rigid_bodies()[0];
  double sum[2] = {}, turn = 0;
  for (int k = 0; k < 20; ++k) {
    run.step();
    const RigidBodyNow now = run.rigid_bodies()[0];
    for (int d = 0; d < 2; ++d) sum[d] += now.force[d] * run.time_step();
    turn += now.torque[2] * run.time_step();
  }
  const RigidBodyNow last = run.rigid_bodies()[0];
  for (int d = 0; d < 2; ++d)
    EXPECT_NEAR(last.impulse[d] - first.impulse[d], sum[d], 1e-12 * std::abs(last.impulse[d]))
        << "round-off of the impulse of the whole run";
  EXPECT_NEAR(last.angular_impulse[2] - first.angular_impulse[2], turn, 1e-12 * std::abs(last.impulse[1]));
  EXPECT_LT(sum[0], 0) << "the soil holds it back";
  EXPECT_GT(sum[1], 0);
}

TEST_F(DrivenRun, takes_no_step_that_is_longer_than_its_caller_allows)
{
  OneRun run = laid();
  run.step();
  const double stable = run.time_step(), target = run.time() + 7.5 * stable;
  int steps = 0;
  while (run.time() < target) {
    run.limit_time_step(target - run.time());
    run.step();
    EXPECT_LE(run.time_step(), stable * 1.01);
    ++steps;
  }
  EXPECT_EQ(run.time(), target);
  EXPECT_EQ(steps, 8);
  run.limit_time_step(std::numeric_limits<double>::infinity());
  run.step();
  EXPECT_NEAR(run.time_step(), stable, 0.01 * stable);
}

TEST_F(DrivenRun, keeps_drives_and_limits_where_it_is_stopped)
{
  const auto half_driven = [&](const std::string& name) {
    RunOptions options;
    options.folder = (folder_ / name).string();
    OneRun run = run_of("still.toml", options);
    while (run.stage() != "follow") run.step();
    run.drive_by_velocity(Freedom::x, 0.3);
    run.limit_time_step(1e-5);
    run.step(50);
    return run;
  };
  OneRun whole = half_driven("whole");
  half_driven("parts").stop();
  OneRun resumed = OneRun::resume((folder_ / "parts").string());
  whole.finish();
  resumed.finish();
  EXPECT_EQ(whole.row(), resumed.row());
  EXPECT_EQ(folder_.read("whole/history.csv"), folder_.read("parts/history.csv"));
}

TEST_F(DrivenRun, has_clones_that_go_on_to_the_same_bits)
{
  OneRun run = laid();
  while (run.steps() % 16 != 0) run.step();  // the time step of the next one is due
  for (int more = 0; more < 2; ++more) {
    OneRun other = run.clone(), third = run.clone((folder_ / ("clone" + std::to_string(more))).string());
    EXPECT_EQ(other.steps(), run.steps());
    for (OneRun* each : {&run, &other, &third}) {
      each->drive_by_velocity(Freedom::x, 0.2);
      each->step(33);
    }
    EXPECT_EQ(run.rigid_bodies()[0].impulse[0], other.rigid_bodies()[0].impulse[0]);
    EXPECT_EQ(run.rigid_bodies()[0].impulse[1], third.rigid_bodies()[0].impulse[1]);
  }
  OneRun other = run.clone();
  other.drive_by_velocity(Freedom::x, -0.2);
  other.step(20);
  run.step(20);
  EXPECT_NE(run.rigid_bodies()[0].impulse[0], other.rigid_bodies()[0].impulse[0]);
  EXPECT_NE(test::error_of<InputError>([&] { run.clone((folder_ / "clone0").string()); }).find("holds a run"), std::string::npos);
  EXPECT_NE(test::error_of<InputError>([&] { run.clone(folder_.path().string()); }).find("not an empty folder"), std::string::npos);
  RunOptions options;
  options.folder = (folder_ / "own").string();
  OneRun kept = run_of("still.toml", options);
  EXPECT_NE(test::error_of<InputError>([&] { kept.clone((folder_ / "own/inner").string()); }).find("in the folder of its run"),
            std::string::npos);
}

TEST_F(DrivenRun, may_have_others_beside_it)
{
  std::vector<std::string> of_first, of_second;
  RunOptions first, second;
  first.message = [&](const std::string& line) { of_first.push_back(line); };
  second.message = [&](const std::string& line) { of_second.push_back(line); };
  OneRun alone = run_of("drag.toml");
  alone.finish();
  OneRun a = run_of("drag.toml", first);
  {
    OneRun b = run_of("drag.toml", second);
    a.step(100);
    b.step(50);
  }  // ends before the older one
  OneRun c = run_of("drag.toml", second);
  while (a.step(10) | c.step(25)) {
  }
  EXPECT_EQ(a.row(), alone.row());
  EXPECT_EQ(c.row(), alone.row());
  const auto begun = [](const std::vector<std::string>& lines) {
    return std::count_if(lines.begin(), lines.end(),
                         [](const std::string& line) { return line.find("particles, 1 thread") != std::string::npos; });
  };
  EXPECT_EQ(begun(of_first), 1);
  EXPECT_EQ(begun(of_second), 2);

  OneRun open = run_of("drag.toml");
  RunOptions two;
  two.threads = 2;
  OneRun of_two = run_of("drag.toml", two);
  EXPECT_NE(test::error_of<RunError>([&] { open.step(); }).find("one run at a time"), std::string::npos);
  of_two.finish();
  EXPECT_TRUE(open.step());
}

TEST_F(DrivenRun, is_not_driven_where_that_makes_no_sense)
{
  OneRun run = run_of("still.toml");
  EXPECT_NE(test::error_of<InputError>([&] { run.drive_by_velocity(Freedom::x, 1); }).find("is not of kind"), std::string::npos);
  while (run.stage() != "follow") run.step();
  EXPECT_NE(test::error_of<InputError>([&] { run.drive_by_velocity(Freedom::z, 1); }).find("x, y and rotation are"), std::string::npos);
  EXPECT_NE(test::error_of<InputError>([&] { run.drive_by_force(Freedom::x, std::nan("")); }).find("not finite"), std::string::npos);
  for (const double limit : {0., -1., std::nan("")})
    EXPECT_NE(test::error_of<InputError>([&] { run.limit_time_step(limit); }).find("more than 0"), std::string::npos);
  run.finish();
  EXPECT_NE(test::error_of<InputError>([&] { run.drive_by_velocity(Freedom::x, 1); }).find("has ended"), std::string::npos);
  EXPECT_NE(test::error_of<InputError>([&] { run.clone(); }).find("has ended"), std::string::npos);

  folder_.write("spring.toml", driven_case("drive.x.velocity = 0\ndrive.y.hold = true\ndrive.y.spring = \"1 kN/m^2\""));
  folder_.write("record.toml", driven_case("load_history = \"record.csv\""));
  folder_.write("record.csv", "time_s,x_m_s\n0,0\n1,0.1\n");
  OneRun of_elements = run_of("fem.toml");
  EXPECT_NE(test::error_of<InputError>([&] { of_elements.drive_by_velocity(Freedom::x, 1); }).find("mpm"), std::string::npos);
  OneRun with_spring = laid("spring.toml");
  EXPECT_NE(test::error_of<InputError>([&] { with_spring.drive_by_force(Freedom::y, 1); }).find("spring"), std::string::npos);
  OneRun with_record = laid("record.toml");
  EXPECT_NE(test::error_of<InputError>([&] { with_record.drive_by_velocity(Freedom::x, 1); }).find("load history"), std::string::npos);
  folder_.write("light.toml",
                driven_case("drive.x.velocity = 0").replace(driven_case("").find("mass ="), std::string("mass = \"1 kg/m\"").size(), ""));
  OneRun light = laid("light.toml");
  EXPECT_NE(test::error_of<InputError>([&] { light.drive_by_force(Freedom::x, 1); }).find("without a mass"), std::string::npos);
}

}  // namespace
}  // namespace berm::this_file
