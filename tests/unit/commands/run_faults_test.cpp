// SPDX-License-Identifier: BSD-3-Clause
// The built program where something goes wrong: what it says, how it ends, what it leaves.
#include "samples/program.hpp"
#include "samples/small_cases.hpp"

#include "io/folder_lock.hpp"
#include "run_folder/history.hpp"

#include <cstdlib>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace berm::commands::this_file {
namespace {

using Words = std::vector<std::string>;

struct Place {
  TemporaryFolder folder;

  Place() { folder.write("small.toml", test::small_case); }
  Ended run(const Words& more) const
  {
    Words words = {"run", "small.toml", "--threads", "1", "-o", "results"};
    words.insert(words.end(), more.begin(), more.end());
    return run_program(folder.path(), words);
  }
  std::string text(const std::string& file) const { return text_of_file(folder / file); }
  bool has(const std::string& file) const { return std::filesystem::exists(folder / file); }
  /// A run that failed has left its rows, a frame of its last state and a summary that says so.
  void expect_results_of_a_failure() const
  {
    EXPECT_GE(run_folder::read_history(folder / "results/history.csv").rows(), 1);
    const std::string frames = text("results/frames/frames.pvd");
    EXPECT_NE(frames.find("particles_0001.vtu"), std::string::npos) << frames;
    EXPECT_TRUE(has("results/frames/particles_0001.vtu"));
    EXPECT_EQ(nlohmann::json::parse(text("results/summary.json"))["checks"]["finished"], false);
    EXPECT_FALSE(has("results/lock"));
  }
};

void expect_parts(const std::string& message, const std::vector<const char*>& parts)
{
  for (const char* part : parts) EXPECT_NE(message.find(part), std::string::npos) << part << " is not in: " << message;
}

TEST(Faults, a_second_run_into_the_same_folder_is_refused_and_the_first_goes_on)
{
  const Place place;
  const Words endless = {"--set", "stage.rest.until.time=100 s"};
  Program first(place.folder.path(), {"run", "small.toml", "--threads", "1", "-o", "results", endless[0], endless[1]});
  ASSERT_TRUE(wait_until([&] { return place.text("results/history.csv").size() > 2000; }));
  const Ended second = place.run({"--force"});
  EXPECT_EQ(second.status, 1);
  expect_parts(second.err, {"cannot use results as the run folder", "another run is writing into it (process ", " on "});
  EXPECT_GT(place.text("results/history.csv").size(), 2000u);
  first.signal(SIGINT);
  EXPECT_EQ(first.wait().status, 75);
  EXPECT_EQ(nlohmann::json::parse(place.text("results/summary.json"))["checks"]["finished"], false);
}

TEST(Faults, the_folder_of_a_run_that_was_killed_can_be_used_again)
{
  const Place place;
  {
    Program killed(place.folder.path(), {"run", "small.toml", "--threads", "1", "-o", "results", "--set", "stage.rest.until.time=100 s"});
    ASSERT_TRUE(wait_until([&] { return place.text("results/history.csv").size() > 2000; }));
  }
  EXPECT_TRUE(place.has("results/lock"));
  EXPECT_EQ(place.run({"--force"}).status, 0);
  EXPECT_FALSE(place.has("results/lock"));
}

TEST(Faults, a_case_that_there_is_no_memory_for_is_refused_before_anything_is_made)
{
  const Place place;
  const Words huge = {"--set", "body.sand.block.spacing=1 nm"};
  const Ended run = place.run(huge), check = run_program(place.folder.path(), {"check", "small.toml", huge[0], huge[1]});
  for (const Ended& ended : {run, check}) {
    EXPECT_EQ(ended.status, 2);
    expect_parts(ended.err,
                 {"berm: small.toml:", ": mesh: ", "more than 1e+15 particles", "more than 1000 TiB of memory at least", " MiB; "});
  }
  EXPECT_FALSE(place.has("results"));
}

TEST(Faults, check_tells_the_memory_of_a_run)
{
  const Place place;
  expect_parts(run_program(place.folder.path(), {"check", "small.toml", "--threads", "1"}).out, {"  memory       about ", " MiB"});
}

TEST(Faults, forces_beyond_all_numbers_name_particle_cell_and_time_and_leave_a_frame)
{
  // 1e308 Pa times the volume and slopes of a cell is still a number; its sum over cells is not.
  const Place place;
  std::string text = test::small_case;
  text.replace(text.find("k0 = 0.43"), 9, "initial_stress = [-1e307, 1e307, -1e307]");
  place.folder.write("small.toml", text);
  const Ended ended = place.run({});
  EXPECT_EQ(ended.status, 1);
  expect_parts(ended.err, {"body \"sand\"", "at t = ", "(step ", "mpm.courant"});
  EXPECT_EQ(nlohmann::json::parse(place.text("results/summary.json"))["checks"]["finished"], false);
  EXPECT_TRUE(place.has("results/frames/particles_0000.vtu"));
}

TEST(Faults, a_time_step_that_falls_to_nothing_ends_the_run_with_what_made_it_small)
{
  const Place place;
  place.folder.write("small.toml", test::small_case + "[[body.sand.initial_velocity]]\namplitude = [1e7, 0]\n");
  const Ended ended = place.run({});
  EXPECT_EQ(ended.status, 1);
  expect_parts(ended.err, {"the time step has fallen to ", "(at rest it is ", "at t = 0 s", "body \"sand\"", "1e+07 m/s"});
  EXPECT_EQ(nlohmann::json::parse(place.text("results/summary.json"))["checks"]["finished"], false);
}

TEST(Faults, a_pipe_that_drives_the_soil_out_of_the_mesh_ends_the_run_with_place_time_and_advice)
{
  const Place place;
  const Ended down = place.run(
      {"--set", "stage.push.until.embedment=60 mm", "--set", "stage.push.until.force=1e12", "--set", "stage.push.velocity=20 m/s"});
  EXPECT_EQ(down.status, 1);
  expect_parts(down.err, {"left the mesh", "at t = ", "rigid body \"pipe\"", "make the mesh", "the stage \"push\" earlier"});
  place.expect_results_of_a_failure();
}

TEST(Faults, a_pipe_pulled_out_through_the_top_of_the_mesh_ends_the_run)
{
  const Place place;
  const Ended out = place.run({"--set", "stage.push.velocity=-20 m/s", "--set", "stage.push.until={time=\"10 ms\", force=-1e12}"});
  EXPECT_EQ(out.status, 1);
  expect_parts(out.err, {"may leave the mesh", "\"pipe\" has left the mesh through its top", "where the mesh ends at 0.06 m"});
  place.expect_results_of_a_failure();
}

TEST(Faults, a_pipe_driven_beyond_a_side_of_the_mesh_ends_the_run_and_leaves_a_frame_of_its_last_state)
{
  const Place place;
  const Ended out =
      place.run({"--set", "rigid.pipe.center=[\"108 mm\", \"50 mm\"]", "--set", "stage.drag.until.displacement=20 mm", "--set",
                 "stage.drag.until.force=1e12", "--set", "stage.drag.velocity=5 m/s", "--set", "output.frame_travel=1 m"});
  EXPECT_EQ(out.status, 1);
  expect_parts(out.err,
               {"\"pipe\" has left the mesh through its right side", "at t = ", "make the mesh longer", "the stage \"drag\" earlier"});
  place.expect_results_of_a_failure();
  EXPECT_TRUE(place.has("results/frames/particles_0003.vtu")) << "after those of the start and the ends of two stages";
}

TEST(Faults, a_frame_that_cannot_be_written_ends_the_run_that_steps_on_meanwhile)
{
  const Place place;
  Program run(place.folder.path(), {"run", "small.toml", "--threads", "1", "-o", "results", "--set", "stage.rest.until.time=10 s", "--set",
                                    "output.frame_time=1 ms"});
  ASSERT_TRUE(wait_until([&] { return place.has("results/frames/particles_0003.vtu"); }));
  std::filesystem::rename(place.folder / "results/frames", place.folder / "results/taken_away");
  const Ended ended = run.wait();
  EXPECT_EQ(ended.status, 1);
  expect_parts(ended.err, {"cannot write results/frames/", ": No such file or directory"});
  EXPECT_EQ(nlohmann::json::parse(place.text("results/summary.json"))["checks"]["finished"], false);
  EXPECT_FALSE(place.has("results/lock"));
}

TEST(Faults, the_last_frame_that_cannot_be_written_is_named_and_in_no_list)
{
  const Place place;
  Program run(place.folder.path(), {"run", "small.toml", "--threads", "1", "-o", "results", "--set", "stage.rest.until.time=100 s"});
  ASSERT_TRUE(wait_until([&] { return place.text("results/history.csv").size() > 2000; }));
  std::filesystem::create_directory(place.folder / "results/frames/particles_0001.vtu");
  run.signal(SIGINT);
  const Ended ended = run.wait();
  EXPECT_EQ(ended.status, 1);
  expect_parts(ended.err, {"cannot write results/frames/particles_0001.vtu: Is a directory"});
  const std::string listed = place.text("results/frames/frames.pvd");
  EXPECT_NE(listed.find("particles_0000.vtu"), std::string::npos);
  EXPECT_EQ(listed.find("particles_0001.vtu"), std::string::npos);
}

TEST(Faults, a_full_standard_output_is_an_error)
{
  const Place place;
  const std::string messages = (place.folder / "messages").string();
  EXPECT_NE(std::system((std::string(BERM_PROGRAM " params > /dev/full 2> '") + messages + "'").c_str()), 0);
  expect_parts(place.text("messages"), {"berm: ", "No space left on device"});
}

}  // namespace
}  // namespace berm::commands::this_file
