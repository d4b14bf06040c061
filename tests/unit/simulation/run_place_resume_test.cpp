// SPDX-License-Identifier: BSD-3-Clause
// A run that was stopped or killed and goes on leaves the same files as one that was not, byte for byte.
#include "samples/program.hpp"
#include "samples/small_cases.hpp"

#include "mpm/time_step.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <set>

namespace berm::simulation::this_file {
namespace {

namespace fs = std::filesystem;
using Words = std::vector<std::string>;
using Json = nlohmann::json;

/// The small case with four times the particles, so that there is time to stop it, and a sand that dilates.
std::string finer_case()
{
  std::string text = test::small_case;
  const auto change = [&](const std::string& from, const std::string& to) { text.replace(text.find(from), from.size(), to); };
  change("cells = [30, 15]", "cells = [60, 30]");
  change("spacing = \"1.3333333 mm\"", "spacing = \"0.6666667 mm\"");
  change("friction_angle = \"35 deg\"", "friction_angle = \"35 deg\"\ndilation_angle = \"5 deg\"");
  change("frame_travel = \"1 mm\"", "frame_travel = \"0.3 mm\"");
  return text + "[watch.deep]\nbody = \"sand\"\npoint = [0.05, 0.03]\n";
}

/// Without what a clock, a machine or the number of threads says.
Json lasting(Json summary)
{
  for (const char* name : {"wall_s", "processors_s", "steps_s", "rows_s", "frames_s", "checkpoints_s", "beside_s", "particle_steps_per_s",
                           "seconds_per_step", "threads", "memory_bytes", "loops"})
    summary["timing"].erase(name);
  for (const char* name : {"machine", "date"}) summary["text"].erase(name);
  return summary;
}

class Resume : public testing::Test {
protected:
  Resume() { folder_.write("fine.toml", finer_case()); }

  Ended berm(const Words& arguments) const { return run_program(folder_.path(), arguments); }
  std::string text(const std::string& file) const { return text_of_file(folder_ / file); }
  std::size_t history_size(const std::string& folder) const
  {
    std::error_code error;
    const auto size = fs::file_size(folder_ / folder / "history.csv", error);
    return error ? 0 : static_cast<std::size_t>(size);
  }
  Words first(const std::string& folder, const Words& more = {}) const
  {
    Words words = {"run", "fine.toml", "--threads", "1", "-o", folder};
    words.insert(words.end(), more.begin(), more.end());
    return words;
  }
  static Words on(const std::string& folder, int threads = 1) { return {"run", "--resume", folder, "--threads", std::to_string(threads)}; }

  /// The folder "whole" of a run that nothing stopped: a copy of one that is made once for all tests.
  void copy_whole() const
  {
    static const TemporaryFolder made;
    if (!fs::exists(made / "whole")) {
      made.write("fine.toml", finer_case());
      ASSERT_EQ(run_program(made.path(), first("whole")).status, 0);
    }
    fs::copy(made / "whole", folder_ / "whole", fs::copy_options::recursive);
  }

  bool finished(const std::string& folder) const { return text(folder + "/summary.json").find("\"finished\": true") != std::string::npos; }

  /// Starts the program, waits until the history has grown to so many bytes or the run is finished, and signals. Gives how it ended.
  Ended run_until(const Words& arguments, const std::string& folder, std::size_t bytes, int signal) const
  {
    Program program(folder_.path(), arguments);
    wait_until([&] { return history_size(folder) > bytes || finished(folder); });
    program.signal(signal);
    return program.wait();
  }

  std::vector<std::string> checkpoints(const std::string& folder) const
  {
    Words names;
    for (const std::string& name : names_in(folder_ / folder / "checkpoint"))
      if (name.ends_with(".h5")) names.push_back(name);
    return names;
  }

  void expect_same(const std::string& a, const std::string& b) const
  {
    EXPECT_GT(text(a + "/history.csv").size(), 10000u);
    EXPECT_TRUE(text(a + "/history.csv") == text(b + "/history.csv")) << "history.csv differs";
    EXPECT_EQ(names_in(folder_ / a), names_in(folder_ / b));
    EXPECT_EQ(names_in(folder_ / a / "frames"), names_in(folder_ / b / "frames"));
    EXPECT_GT(names_in(folder_ / a / "frames").size(), 20u);
    for (const std::string& name : names_in(folder_ / a / "frames"))
      EXPECT_TRUE(text(a + "/frames/" + name) == text(b + "/frames/" + name)) << name << " differs";
    EXPECT_EQ(lasting(Json::parse(text(a + "/summary.json"))), lasting(Json::parse(text(b + "/summary.json"))));
    for (const char* name : {"case.toml", "resolved.toml"}) EXPECT_EQ(text(a + "/" + name), text(b + "/" + name));
  }

  TemporaryFolder folder_;
};

TEST_F(Resume, after_signals_leaves_what_an_uninterrupted_run_leaves)
{
  copy_whole();
  const std::size_t size = history_size("whole");
  int stops = 0;
  Words arguments = first("parts");
  Ended ended;
  do {
    ended = run_until(arguments, "parts", history_size("parts") + size / 6, stops % 2 == 0 ? SIGTERM : SIGINT);
    if (ended.status == 0) break;
    ASSERT_EQ(ended.status, 75) << ended.err;
    EXPECT_NE(ended.err.find("To resume: berm run --resume parts"), std::string::npos) << ended.err;
    EXPECT_FALSE(checkpoints("parts").empty());
    EXPECT_LE(checkpoints("parts").size(), 2u);
    EXPECT_EQ(Json::parse(text("parts/summary.json"))["checks"]["finished"], false);
    ++stops;
    arguments = on("parts", 1 + stops % 2);
  } while (stops < 20);
  ASSERT_EQ(ended.status, 0) << ended.err;
  EXPECT_GE(stops, 2);
  expect_same("whole", "parts");
  EXPECT_FALSE(fs::exists(folder_ / "parts/checkpoint")) << "a finished run needs no checkpoints";
  EXPECT_NE(text("parts/run.log").find("resumes from the checkpoint"), std::string::npos);
}

TEST_F(Resume, after_kills_leaves_what_an_uninterrupted_run_leaves)
{
  const Words often = {"--set", "output.checkpoint_wall_time=5 ms"};
  ASSERT_EQ(berm(first("whole", often)).status, 0);
  const std::size_t size = history_size("whole");
  int kills = 0;
  Words arguments = first("parts", often);
  for (Ended ended; ended.status != 0 && kills < 20; ++kills, arguments = on("parts", 1 + kills % 2)) {
    ended = run_until(arguments, "parts", history_size("parts") + size / 8, SIGKILL);
    ASSERT_TRUE(ended.status == -1 || ended.status == 0) << ended.err;
  }
  EXPECT_GE(kills, 3);
  if (fs::exists(folder_ / "parts/checkpoint")) {  // killed at its very end
    ASSERT_EQ(berm(on("parts")).status, 0);
  }
  expect_same("whole", "parts");
}

TEST_F(Resume, is_never_from_where_the_next_step_asks_for_more_than_the_state)
{
  // A checkpoint after each step, seen in passing: those that stand before the choice of a time step are left out.
  Program program(folder_.path(), first("parts", {"--set", "output.checkpoint_wall_time=1e-9"}));
  std::set<long> steps;
  for (int n = 0; n < 60000 && !finished("parts") && (steps.empty() || *steps.rbegin() < 300); ++n) {
    std::error_code error;
    for (fs::directory_iterator entry(folder_ / "parts/checkpoint", error), end; !error && entry != end; entry.increment(error))
      if (entry->path().extension() == ".h5") steps.insert(std::stol(entry->path().stem().string().substr(5)));
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  EXPECT_GT(steps.size(), 30u);
  for (const long step : steps) EXPECT_NE(step % mpm::steps_between_time_steps, 0) << step;
}

TEST_F(Resume, without_a_checkpoint_begins_at_the_start)
{
  copy_whole();
  run_until(first("parts"), "parts", 100, SIGKILL);
  for (const std::string& name : checkpoints("parts")) fs::remove(folder_ / "parts/checkpoint" / name);
  folder_.write("parts/checkpoint/case_file.txt", "/nowhere\x1b[2J/fine.toml");
  const Ended ended = berm(on("parts"));
  ASSERT_EQ(ended.status, 0) << ended.err;
  EXPECT_NE(ended.err.find("there is no checkpoint in parts: begins at the start"), std::string::npos) << ended.err;
  EXPECT_EQ(ended.err.find('\x1b'), std::string::npos) << "nothing moves a terminal's cursor";
  expect_same("whole", "parts");
}

TEST_F(Resume, goes_on_with_the_values_that_were_set_and_without_the_case_file)
{
  const Words set = {"--set", "material.sand.friction_angle=30 deg"};
  ASSERT_EQ(berm(first("whole", set)).status, 0);
  ASSERT_EQ(run_until(first("parts", set), "parts", history_size("whole") / 3, SIGTERM).status, 75);
  fs::remove(folder_ / "fine.toml");
  const Ended ended = berm(on("parts"));
  ASSERT_EQ(ended.status, 0) << ended.err;
  expect_same("whole", "parts");
}

TEST_F(Resume, of_a_finished_run_says_so)
{
  copy_whole();
  const std::string log = text("whole/run.log");
  const Ended ended = berm(on("whole"));
  EXPECT_EQ(ended.status, 0);
  EXPECT_EQ(ended.out, "the run in whole is finished\n");
  EXPECT_EQ(text("whole/run.log"), log);
}

TEST_F(Resume, is_refused_before_all_that_the_run_was_given_is_in_its_folder)
{
  copy_whole();
  fs::create_directory(folder_ / "early");
  for (const char* name : {"resolved.toml", "case.toml"}) fs::copy(folder_ / "whole" / name, folder_ / "early" / name);
  const Ended ended = berm(on("early"));
  EXPECT_EQ(ended.status, 2);
  EXPECT_NE(ended.err.find("there is no checkpoint/case_file.txt"), std::string::npos) << ended.err;
  EXPECT_EQ(berm(first("early")).status, 0) << "nothing is lost by beginning it";
}

TEST_F(Resume, of_a_run_that_was_killed_while_it_removed_its_checkpoints_says_that_it_is_finished)
{
  copy_whole();
  fs::create_directory(folder_ / "whole/checkpoint");
  folder_.write("whole/checkpoint/step_7.h5", "left");
  const Ended ended = berm(on("whole"));
  EXPECT_EQ(ended.status, 0) << ended.err;
  EXPECT_EQ(ended.out, "the run in whole is finished\n");
}

TEST_F(Resume, is_refused_where_a_damaged_summary_does_not_tell_whether_the_run_is_finished)
{
  copy_whole();
  const std::string history = text("whole/history.csv");
  for (const char* damaged : {"", "[]", "5", R"({"checks": 5})", R"({"checks": {"finished": "yes"}})"}) {
    folder_.write("whole/summary.json", damaged);
    const Ended ended = berm(on("whole"));
    EXPECT_EQ(ended.status, 1) << damaged;
    EXPECT_NE(ended.err.find("berm: --resume: whole/summary.json is damaged: "), std::string::npos) << ended.err;
    EXPECT_EQ(text("whole/history.csv"), history);
  }
}

TEST_F(Resume, uses_the_older_checkpoint_where_the_last_is_damaged_and_none_where_all_are)
{
  const Words often = {"--set", "output.checkpoint_wall_time=5 ms"};
  ASSERT_EQ(berm(first("whole", often)).status, 0);
  ASSERT_EQ(run_until(first("parts", often), "parts", history_size("whole") / 2, SIGTERM).status, 75);
  const Words names = checkpoints("parts");
  ASSERT_EQ(names.size(), 2u);
  const auto damage = [&](const std::string& name) {
    std::string content = text("parts/checkpoint/" + name);
    content[content.size() / 2] = static_cast<char>(content[content.size() / 2] ^ 16);
    folder_.write("parts/checkpoint/" + name, content);
  };
  fs::copy(folder_ / "parts", folder_ / "lost", fs::copy_options::recursive);
  const auto step_in = [](const std::string& name) { return std::stol(name.substr(5)); };
  const std::string last = step_in(names[0]) > step_in(names[1]) ? names[0] : names[1];
  damage(last);
  const Ended ended = berm(on("parts"));
  ASSERT_EQ(ended.status, 0) << ended.err;
  EXPECT_NE(ended.err.find("warning: the checkpoint parts/checkpoint/" + last + " is not used: it is damaged"), std::string::npos)
      << ended.err;
  expect_same("whole", "parts");

  const std::string history = text("lost/history.csv"), summary = text("lost/summary.json");
  for (const std::string& name : checkpoints("lost")) folder_.write("lost/checkpoint/" + name, "no checkpoint");
  const Ended refused = berm(on("lost"));
  EXPECT_EQ(refused.status, 1);
  EXPECT_NE(refused.err.find("it is not a checkpoint of berm"), std::string::npos) << refused.err;
  EXPECT_NE(refused.err.find("berm: none of the checkpoints in lost/checkpoint can be used"), std::string::npos) << refused.err;
  EXPECT_EQ(text("lost/history.csv"), history) << "what was computed is still there";
  EXPECT_EQ(text("lost/summary.json"), summary);
}

TEST_F(Resume, takes_another_report_table_which_changes_no_result)
{
  copy_whole();
  ASSERT_EQ(run_until(first("parts"), "parts", 30000, SIGTERM).status, 75);
  std::string resolved = text("parts/resolved.toml");
  const std::string unset = "# revision is not set";
  ASSERT_NE(resolved.find(unset), std::string::npos);
  resolved.replace(resolved.find(unset), unset.size(), "revision = \"B\"");
  folder_.write("parts/resolved.toml", resolved);
  const Ended ended = berm(on("parts"));
  EXPECT_EQ(ended.status, 0) << ended.err;
  EXPECT_TRUE(text("whole/history.csv") == text("parts/history.csv"));
  EXPECT_EQ(Json::parse(text("parts/origin.json"))["sessions"].size(), 2u);
}

TEST_F(Resume, refuses_another_case_a_changed_history_and_a_missing_frame)
{
  ASSERT_EQ(run_until(first("parts"), "parts", 30000, SIGTERM).status, 75);
  const auto refusal = [&](const std::string& folder) {
    const Ended ended = berm(on(folder));
    EXPECT_EQ(ended.status, 1);
    return ended.err;
  };
  for (const char* name : {"other", "shorter", "changed", "frames"})
    fs::copy(folder_ / "parts", folder_ / name, fs::copy_options::recursive);
  std::string resolved = text("other/resolved.toml");
  resolved.replace(resolved.find("velocity = 1 "), 13, "velocity = 2 ");
  folder_.write("other/resolved.toml", resolved);
  EXPECT_NE(refusal("other").find("it is of another case than resolved.toml"), std::string::npos);

  std::string history = text("parts/history.csv");
  folder_.write("shorter/history.csv", history.substr(0, 5000));
  EXPECT_NE(refusal("shorter").find("history.csv has not the "), std::string::npos);
  history[2000] = '\0';
  folder_.write("changed/history.csv", history);
  EXPECT_NE(refusal("changed").find("history.csv has not the "), std::string::npos);
  fs::remove(folder_ / "frames/frames/particles_0001.vtu");
  EXPECT_NE(refusal("frames").find("particles_0001.vtu is gone"), std::string::npos);
}

TEST_F(Resume, is_refused_where_there_is_no_run_and_beside_a_case)
{
  for (const Words& arguments : {Words{"run", "--resume", "nowhere"}, Words{"run", "--resume", "nowhere", "fine.toml"},
                                 Words{"run", "--resume", "nowhere", "-o", "there"}, Words{"run"}})
    EXPECT_EQ(berm(arguments).status, 2);
  EXPECT_NE(berm({"run", "--resume", "nowhere"}).err.find("nowhere is not the folder of a run that has begun: there is no resolved.toml"),
            std::string::npos);
}

TEST_F(Resume, a_new_run_over_an_unfinished_one_says_what_it_replaces)
{
  ASSERT_EQ(run_until(first("parts"), "parts", 30000, SIGTERM).status, 75);
  EXPECT_EQ(
      berm(first("parts")).err,
      "berm: parts holds an unfinished run: continue it with berm run --resume parts, replace it with --force, or name another folder "
      "with -o\n");
  const Ended ended = berm(first("parts", {"--force"}));
  EXPECT_NE(ended.err.find("the unfinished run in parts is replaced"), std::string::npos) << ended.err;
  EXPECT_NE(ended.err.find("--resume"), std::string::npos);
}

}  // namespace
}  // namespace berm::simulation::this_file
