// SPDX-License-Identifier: BSD-3-Clause
#include "samples/small_cases.hpp"
#include "samples/study_of_falls.hpp"

#include "io/folder_lock.hpp"

#include <fmt/format.h>
#include <optional>
#include <sys/stat.h>

namespace berm::study::this_file {
namespace {

/// Two places and two gravities, one of which is left out in one place.
constexpr const char* four_falls = R"(title = "Falls"
[[case]]
name = "on high"
file = "stone.toml"
[[case]]
name = "low"
file = "stone.toml"
set = ["body.stone.block.center=[0.5, 0.6]"]
[[axis]]
name = "gravity"
[[axis.value]]
name = "earth"
[[axis.value]]
name = "moon"
set = ["gravity=[0, -1.6]"]
[[skip]]
case = "low"
gravity = "moon"
why = "nobody was there"
[[measure]]
name = "g"
column = "stone_vy_m_s"
measure = "acceleration"
scale = -100
unit = "cm/s^2"
[[measure]]
name = "done"
quantity = "finished"
cases = ["low"]
[[figure]]
name = "v over t"
x = "time_s"
y = "stone_vy_m_s"
)";

class StudyCommand : public test::StudyOfFalls {
protected:
  StudyCommand() : StudyOfFalls(four_falls) {}
};

TEST_F(StudyCommand, makes_a_table_of_all_combinations_but_those_left_out)
{
  const Ended ended = study();
  EXPECT_EQ(ended.status, 0) << ended.err;
  EXPECT_EQ(result("results.csv").find("case,gravity,g (cm/s^2),done,run\non high,earth,"), 0u) << result("results.csv");
  const std::string table = result("results.md");
  for (const char* line : {"# Falls\n", "| case | gravity | g (cm/s^2) | done |\n", "| on high | earth | 1000 |  |\n",
                           "| on high | moon | 160 |  |\n", "| low | earth | 1000 | 1 |\n", "Left out:\n\n- low, moon: nobody was there\n"})
    EXPECT_NE(table.find(line), std::string::npos) << line << " is not in\n" << table;
  EXPECT_EQ(names_in(folder_ / "results/runs"), (Words{"low.earth/", "on_high.earth/", "on_high.moon/"}));
  EXPECT_EQ(text_of_file(folder_ / "results/plots/v_over_t_2.dat").substr(0, 4), "0 0\n");
}
TEST_F(StudyCommand, writes_no_run_through_a_link)
{
  std::filesystem::create_directories(folder_ / "results");
  std::filesystem::create_directory(folder_ / "elsewhere");
  std::filesystem::create_directory_symlink("../elsewhere", folder_ / "results/runs");
  const Ended ended = study();
  EXPECT_EQ(ended.status, 1);
  EXPECT_NE(ended.err.find("it is a link, and berm writes through none"), std::string::npos) << ended.err;
  EXPECT_TRUE(std::filesystem::is_empty(folder_ / "elsewhere"));
}

TEST_F(StudyCommand, runs_only_what_has_no_result_yet)
{
  ASSERT_EQ(study().status, 0);
  const std::string table = result("results.csv");
  const Ended again = study();
  EXPECT_NE(again.err.find("3 of 3 runs have their result already"), std::string::npos) << again.err;
  EXPECT_EQ(result("results.csv"), table);

  // Another gravity is another case; an engine of another build is another program, and the times of files tell nothing.
  std::string changed = four_falls;
  changed.replace(changed.find("-1.6"), 4, "-1.7");
  write_study(changed);
  const Ended other = study();
  EXPECT_NE(other.err.find("2 of 3 runs have their result already"), std::string::npos) << other.err;
  EXPECT_NE(result("results.md").find("| on high | moon | 170 |"), std::string::npos);
  const std::filesystem::path summary = folder_ / "results/runs/low.earth/summary.json";
  std::filesystem::last_write_time(summary, std::filesystem::file_time_type::clock::now() - std::chrono::hours(100000));
  EXPECT_NE(study().err.find("3 of 3 runs have their result already"), std::string::npos);
  std::string of_another = text_of_file(summary);
  of_another.replace(of_another.find("engine_build\": \"") + 16, 4, "dead");
  folder_.write("results/runs/low.earth/summary.json", of_another);
  EXPECT_NE(study().err.find("2 of 3 runs have their result already"), std::string::npos);
}
TEST_F(StudyCommand, has_a_row_for_a_run_that_fails)
{
  std::string text = four_falls;
  text.replace(text.find("gravity=[0, -1.6]"), 17, "gravity=[0, -9e3]");  // it leaves the mesh
  write_study(text);
  const Ended ended = study();
  EXPECT_EQ(ended.status, 1) << ended.err;
  EXPECT_NE(ended.err.find("1 of 3 runs failed"), std::string::npos) << ended.err;
  const std::string table = result("results.md");
  EXPECT_NE(table.find("| on high | moon | failed |  |\n"), std::string::npos) << table;
  EXPECT_NE(table.find("- on high, moon: particle "), std::string::npos) << table;
  EXPECT_NE(table.find("| low | earth | 1000 | 1 |\n"), std::string::npos) << table;
}
TEST_F(StudyCommand, leaves_a_number_empty_that_a_run_does_not_have_and_says_so)
{
  std::string text = four_falls;
  text.replace(text.find("\"finished\""), 10, "\"finnished\"");
  write_study(text);
  const Ended ended = study();
  EXPECT_EQ(ended.status, 0);
  EXPECT_NE(ended.err.find("low, earth: \"done\" stays empty: summary.json has no quantity \"finnished\"; did you mean \"finished\"?"),
            std::string::npos)
      << ended.err;
}
TEST_F(StudyCommand, that_is_interrupted_goes_on_from_there)
{
  std::string text = four_falls;
  text.replace(text.find("gravity=[0, -1.6]"), 17, "stage.fall.until.time=1e6 s\", \"output.history_time=1 s\", \"gravity=[0, 0]");
  write_study(text);
  Program program(folder_.path(), {"study", ".", "-o", "results", "--threads", "2"});
  const auto is_there = [&](const std::string& name) { return std::filesystem::exists(folder_ / ("results/runs/" + name)); };
  ASSERT_TRUE(wait_until(
      [&] { return is_there("low.earth/summary.json") && !is_there("low.earth.messages") && is_there("on_high.moon/history.csv"); }));
  std::this_thread::sleep_for(std::chrono::milliseconds(100));  // until it is known that the others have ended
  program.signal(SIGTERM);
  const Ended ended = program.wait();
  EXPECT_EQ(ended.status, 75);
  EXPECT_NE(ended.err.find("interrupted: 2 of 3 runs are done"), std::string::npos) << ended.err;
  EXPECT_NE(result("results.md").find("| on high | moon | not run |"), std::string::npos);
  text.replace(text.find("1e6 s"), 5, "0.1 s");
  write_study(text);
  EXPECT_NE(study().err.find("2 of 3 runs have their result already"), std::string::npos);
}
TEST_F(StudyCommand, ends_with_a_message_where_a_fifo_lies_in_the_way_of_those_of_a_run)
{
  write_study(four_falls);
  std::filesystem::create_directories(folder_ / "results/runs");
  ASSERT_EQ(::mkfifo((folder_ / "results/runs/low.earth.messages").c_str(), 0600), 0);
  const Ended ended = study();
  EXPECT_EQ(ended.status, 1);
  EXPECT_NE(ended.err.find("low.earth.messages: it is not a regular file"), std::string::npos) << ended.err;
}
TEST_F(StudyCommand, draws_what_is_missing_of_a_run_that_was_killed_between_its_summary_and_its_pictures)
{
  ASSERT_EQ(study().status, 0);
  const std::filesystem::path run = folder_ / "results/runs/low.earth";
  ASSERT_TRUE(std::filesystem::remove(run / "soil.png"));
  std::filesystem::create_directory(run / "checkpoint");
  folder_.write("results/runs/low.earth/checkpoint/case_file.txt", (folder_ / "stone.toml").string());
  folder_.write("results/runs/on_high.moon.messages", "of a run that came to its end after its parent was killed");
  EXPECT_NE(study().err.find("2 of 3 runs have their result already"), std::string::npos);
  EXPECT_TRUE(std::filesystem::exists(run / "soil.png"));
  EXPECT_FALSE(std::filesystem::exists(run / "checkpoint"));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "results/runs/on_high.moon.messages"));
}
TEST_F(StudyCommand, refuses_names_that_cannot_be_those_of_rows_before_the_first_run)
{
  const auto refused = [&](const std::string& name, const std::string& says) {
    std::string text = four_falls;
    text.replace(text.find("name = \"moon\""), 13, "name = \"" + name + "\"");
    write_study(text);
    const Ended ended = study();
    EXPECT_EQ(ended.status, 2);
    EXPECT_NE(ended.err.find("study.toml:14: axis.gravity.value." + name + ".name: " + says), std::string::npos) << ended.err;
    EXPECT_FALSE(std::filesystem::exists(folder_ / "results"));
  };
  refused("=1+1", "\"=1+1\" is a formula");
  refused(std::string(101, 'x'), "is longer than 100 bytes");
  std::string text = four_falls;
  for (const char letter : {'a', 'b', 'c'})
    text += fmt::format("[[axis]]\nname = \"{}\"\n[[axis.value]]\nname = \"{}\"\n", letter, std::string(80, letter));
  write_study(text);
  EXPECT_NE(study().err.find("the name of its run folder would be longer than 240 bytes: choose shorter names"), std::string::npos);
}
TEST_F(StudyCommand, waits_for_a_process_that_still_writes_into_a_run_folder)
{
  // As one of an earlier command does, which was killed.
  const std::filesystem::path folder = folder_ / "results/runs/low.earth";
  std::filesystem::create_directories(folder);
  std::optional<io::FolderLock> lock(folder);
  Program program(folder_.path(), {"study", ".", "-o", "results", "--threads", "3"});
  ASSERT_TRUE(wait_until([&] { return std::filesystem::exists(folder_ / "results/runs/on_high.moon/summary.json"); }));
  EXPECT_FALSE(std::filesystem::exists(folder / "run.log"));
  lock.reset();
  const Ended ended = program.wait();
  EXPECT_EQ(ended.status, 0) << ended.err;
  EXPECT_NE(ended.err.find("results/runs/low.earth: waits for process "), std::string::npos) << ended.err;
  EXPECT_NE(result("results.md").find("| low | earth | 1000 | 1 |\n"), std::string::npos) << result("results.md");
}
TEST_F(StudyCommand, refuses_a_measure_that_the_run_of_a_pipe_cannot_have_and_runs_nothing)
{
  folder_.write("pipe.toml", test::small_case);
  std::string by_force = test::small_case;
  by_force.replace(by_force.find("velocity = \"1 m/s\"\n", by_force.find("kind = \"drag\"")), 19, "force = \"300 N/m\"\n");
  folder_.write("by_force.toml", by_force);
  const auto ended = [&](const std::string& file, const std::string& quantity) {
    write_study("[[case]]\nname = \"pipe\"\nfile = \"" + file + "\"\n[[measure]]\nname = \"m\"\nquantity = \"" + quantity + "\"\n");
    return study();
  };
  for (const auto& [file, quantity] : std::vector<std::pair<std::string, std::string>>{{"pipe.toml", "uplift.R_max"},
                                                                                       {"pipe.toml", "q_t_end"},
                                                                                       {"pipe.toml", "storm.H_maxx"},
                                                                                       {"pipe.toml", "finnished"},
                                                                                       {"by_force.toml", "H_residual"}}) {
    const Ended refused = ended(file, quantity);
    EXPECT_EQ(refused.status, 2) << quantity;
    EXPECT_NE(refused.err.find("study.toml: measure[0].quantity: a run of pipe has no \"" + quantity + "\""), std::string::npos)
        << refused.err;
    EXPECT_NE(refused.err.find("(allowed: "), std::string::npos) << refused.err;
    EXPECT_FALSE(std::filesystem::exists(folder_ / "results")) << quantity;
  }
  for (const char* quantity : {"energy_error", "seconds_per_step"}) {
    const Ended taken = ended("pipe.toml", quantity);
    EXPECT_EQ(taken.status, 0) << taken.err;
    EXPECT_EQ(taken.err.find("stays empty"), std::string::npos) << taken.err;
  }
}
TEST_F(StudyCommand, draws_forces_freed_from_noise_in_the_unit_that_suits)
{
  folder_.write("pipe.toml", test::small_case);
  write_study(R"toml([[case]]
name = "pipe"
file = "pipe.toml"
[[measure]]
name = "V(0.1 D)"
quantity = "V_at_w_0.1D"
[[figure]]
name = "V over w"
x = "w_m"
y = "V_N_m"
stage = ["push"]
)toml");
  ASSERT_EQ(study({}, {with_pictures()}).status, 0);
  EXPECT_TRUE(std::filesystem::exists(folder_ / "results/V_over_w.png"));
  EXPECT_NE(result("results.csv").find("case,V(0.1 D) (N/m),run\n"), std::string::npos);
  std::istringstream lines(text_of_file(folder_ / "results/plots/V_over_w_0.dat"));
  double w = 0, V = 0;
  while (lines >> w >> V) {
  }
  // The smoothed end of the curve is the quantity; mm and kN/m.
  EXPECT_NEAR(w, 2, 0.02);
  const std::string csv = result("results.csv");
  EXPECT_NEAR(V, std::stod(csv.substr(csv.find("pipe,") + 5)) / 1000, 0.01 * V);
}
TEST_F(StudyCommand, of_many_curves_each_value_of_what_varies_first_has_a_colour_and_one_thick_line)
{
  std::string text = "[[case]]\nname = \"stone\"\nfile = \"stone.toml\"\n";
  for (const auto& [axis, key] : {std::pair("damping", "body.stone.damping"), std::pair("courant", "mpm.courant")}) {
    text += std::string("[[axis]]\nname = \"") + axis + "\"\n";
    for (const char* value : {"0.1", "0.2", "0.3"})
      text += std::string("[[axis.value]]\nname = \"") + axis[0] + value + "\"\nset = ['" + key + "=" + value + "']\n";
  }
  write_study(
      text + "[[measure]]\nname = \"v\"\nquantity = \"finished\"\n[[figure]]\nname = \"v over t\"\nx = \"time_s\"\ny = \"stone_vy_m_s\"\n");
  const Ended ended = study();
  ASSERT_EQ(ended.status, 0) << ended.err;
  const std::string script = result("plots/v_over_t.gp");
  for (const char* title : {"'d0.1: c0.1 (thin: 2 more)'", "'d0.2: c0.1 (thin: 2 more)'", "'d0.3: c0.1 (thin: 2 more)'"})
    EXPECT_NE(script.find(title), std::string::npos) << title << " is not in\n" << script;
  const auto count = [&](const std::string& words) {
    int n = 0;
    for (std::size_t at = script.find(words); at != std::string::npos; at = script.find(words, at + 1)) ++n;
    return n;
  };
  EXPECT_EQ(count("notitle"), 6);
  EXPECT_EQ(count("lw 0.7"), 6);
  EXPECT_EQ(count("lw 2.8"), 3);
  EXPECT_GT(script.find("lw 2.8"), script.rfind("lw 0.7")) << "thick ones lie above";
}
TEST_F(StudyCommand, refuses_wrong_input_at_its_line_and_runs_nothing)
{
  struct Wrong {
    std::string replaced, by, says;
  };
  for (const Wrong& wrong : std::vector<Wrong>{
           {"gravity = \"moon\"", "gravty = \"moon\"", "study.toml:18: skip.gravty: is not an axis; did you mean \"gravity\"?"},
           {"gravity = \"moon\"", "gravity = \"mon\"", "study.toml:18: skip.gravity: \"mon\" is none of its names; did you mean \"moon\"?"},
           {"case = \"low\"\ngravity = \"moon\"\n", "", "study.toml:16: skip: names no axis"},
           {"cases = [\"low\"]", "cases = [\"lwo\"]", "study.toml:29: measure.done.cases: there is no such case; did you mean \"low\"?"},
           {"name = \"moon\"", "name = \"earth\"", "study.toml:14: axis.gravity.value.earth.name: is the name"},
           {"stone.toml", "stne.toml", "on high, earth: stne.toml: there is no such file"},
           {"gravity=[0", "gravty=[0", "on high, moon: --set gravty: unknown key; did you mean \"gravity\"?"},
           {"scale = -100", "scal = -100", "study.toml:24: measure.g.scal: unknown key; did you mean \"scale\"?"},
           {"y = \"stone_vy_m_s\"\n", "", "study.toml:30: figure.v over t.y: is missing"}}) {
    std::string text = four_falls;
    text.replace(text.find(wrong.replaced), wrong.replaced.size(), wrong.by);
    write_study(text);
    const Ended ended = study();
    EXPECT_EQ(ended.status, 2) << wrong.by;
    EXPECT_NE(ended.err.find(wrong.says), std::string::npos) << ended.err;
    EXPECT_EQ(ended.err.find('\n'), ended.err.size() - 1) << ended.err;
    EXPECT_FALSE(std::filesystem::exists(folder_ / "results")) << wrong.by;
  }
  EXPECT_NE(run_program(folder_.path(), {"study", "nothing.toml"}).err.find("nothing.toml: there is no such file"), std::string::npos);
}

}  // namespace
}  // namespace berm::study::this_file
