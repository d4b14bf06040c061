// SPDX-License-Identifier: BSD-3-Clause
#include "run_folder/progress.hpp"

#include "io/log.hpp"
#include "os/error.hpp"
#include "samples/run_to_write.hpp"

#include <gtest/gtest.h>
#include <spdlog/spdlog.h>

namespace berm::run_folder::this_file {
namespace {

TEST(ProgressLine, says_stage_travel_forces_speed_and_time_left)
{
  ProgressReport report{.stage = "drag",
                        .done = 0.25,
                        .drag = true,
                        .u = 0.006,
                        .w = 0.0025,
                        .V = 2000,
                        .H = 700.4,
                        .diameter = 0.02,
                        .particle_steps = 6.12e9};
  EXPECT_EQ(progress_line(report, 100),
            "drag  25 %  5 min 00 s left  u/D 0.300  w 2.50 mm  V 2.000  H 0.700 kN/m  61.2 M particle-steps/s");
  report.drag = false;
  EXPECT_EQ(progress_line(report, 100).find("u/D"), std::string::npos);
}

TEST(ProgressLine, leaves_out_what_is_not_known)
{
  EXPECT_EQ(progress_line({.stage = "settle"}, 3), "settle");
  EXPECT_EQ(progress_line({.stage = "settle", .done = 0}, 3), "settle  0 %");
}

std::vector<std::string> log_of(const std::function<void(Progress&)>& run)
{
  const TemporaryFolder folder;
  {
    RunLog log(folder.path() / "run.log");
    Progress progress(log);
    run(progress);
  }
  std::ifstream file(folder.path() / "run.log");
  std::vector<std::string> lines;
  for (std::string line; std::getline(file, line);) lines.push_back(line.substr(20));  // after the date and time
  return lines;
}

TEST(Progress, tells_every_tenth_of_the_run_once)
{
  const auto lines = log_of([](Progress& progress) {
    for (int k = 0; k <= 1000; ++k) progress.update({.stage = "push", .done = k / 1000.});
  });
  ASSERT_EQ(lines.size(), 11u);
  for (int k = 0; k <= 10; ++k) EXPECT_EQ(lines[k].rfind(fmt::format("push  {} %", 10 * k), 0), 0u) << lines[k];
}

TEST(Progress, tells_when_a_stage_begins)
{
  const auto lines = log_of([](Progress& progress) {
    for (const char* stage : {"settle", "settle", "push", "drag"}) progress.update({.stage = stage, .done = 0.05});
  });
  EXPECT_EQ(lines.size(), 3u);
}

TEST(Progress, is_due_at_most_five_times_a_second)
{
  log_of([](Progress& progress) {
    EXPECT_TRUE(progress.due());
    progress.update({.stage = "push", .done = 0.01});
    EXPECT_FALSE(progress.due());  // asked within 0.2 s
  });
}

TEST(RunLog, messages_go_to_the_file_with_their_level_and_end_with_the_log)
{
  const TemporaryFolder folder;
  const auto before = spdlog::default_logger();
  {
    RunLog log(folder.path() / "run.log");
    io::info("plain");
    io::warn("odd {}", 7);
    log.info_to_file("quiet {}");
    EXPECT_NE(content_of(folder.path() / "run.log").find("quiet {}\n"), std::string::npos);  // on the disk at once
  }
  EXPECT_EQ(spdlog::default_logger(), before);
  const std::string text = content_of(folder.path() / "run.log");
  EXPECT_NE(text.find(" plain\n"), std::string::npos);
  EXPECT_NE(text.find(" warning: odd 7\n"), std::string::npos);
  EXPECT_EQ(text.find('\x1b'), std::string::npos);
}

TEST(RunLog, a_file_that_cannot_be_written_is_an_error)
{
  EXPECT_THROW(RunLog("/proc/berm/run.log"), RunError);
}

}  // namespace
}  // namespace berm::run_folder::this_file
