// SPDX-License-Identifier: BSD-3-Clause
#include "jobs/jobs.hpp"

#include "samples/small_cases.hpp"
#include "study_by_runner.hpp"

namespace berm::jobs::this_file {
namespace {

/// What a scheduler does, one line after the other.
const std::string one_by_one = "while read -r line; do sh -c \"$line\"; done < {jobs}";

class Runners : public StudyByRunner {
protected:
  bool is_there(const std::string& name) const { return std::filesystem::exists(folder_ / ("results/" + name)); }
};

TEST_F(Runners, that_are_commands_give_the_table_of_local_processes)
{
  const berm::Ended ended = study({"--runner", "echo {count} > count; " + one_by_one});
  EXPECT_EQ(ended.status, 0) << ended.err;
  EXPECT_EQ(result("results.csv"), local_table());
  EXPECT_EQ(text_of_file(folder_ / "count"), "3\n");
  EXPECT_EQ(names_in(folder_ / "results/runs"), (Words{"it_s_a_stone.earth/", "it_s_a_stone.mars/", "it_s_a_stone.moon/"}))
      << "no messages of runs that ended well";
  EXPECT_NE(study({"--runner", one_by_one}).err.find("3 of 3 runs have their result already"), std::string::npos);
}

TEST_F(Runners, keep_the_message_of_a_row_that_fails_and_go_on_with_the_others)
{
  write_study(falls_with("-9e3"));  // it leaves the mesh
  const berm::Ended ended = study({"--runner", one_by_one});
  EXPECT_EQ(ended.status, 1) << ended.err;
  EXPECT_NE(ended.err.find("1 of 3 runs failed"), std::string::npos) << ended.err;
  EXPECT_NE(result("results.md").find("- it's a stone, moon: particle "), std::string::npos) << result("results.md");
  EXPECT_NE(result("results.md").find("| it's a stone | mars | -3.7 |"), std::string::npos) << result("results.md");
}

TEST_F(Runners, need_not_be_waited_for_and_the_same_command_collects)
{
  const Words later = {"--no-wait", "--runner", "cp {jobs} later"};
  const berm::Ended first = study(later);
  EXPECT_EQ(first.status, 75) << first.err;
  EXPECT_NE(first.err.find("queued: 0 of 3 runs are done; the same command collects the others"), std::string::npos) << first.err;
  EXPECT_NE(result("results.md").find("| it's a stone | moon | queued |"), std::string::npos) << result("results.md");
  std::filesystem::rename(folder_ / "later", folder_ / "lines");
  ASSERT_EQ(std::system(("head -n 1 '" + (folder_ / "lines").string() + "' | sh").c_str()), 0);
  const berm::Ended second = study(later);
  EXPECT_EQ(second.status, 75) << second.err;
  EXPECT_NE(second.err.find("queued: 1 of 3 runs are done"), std::string::npos) << second.err;
  EXPECT_FALSE(std::filesystem::exists(folder_ / "later")) << "what is queued is not handed over again";
  ASSERT_EQ(std::system(("sh '" + (folder_ / "lines").string() + "'").c_str()), 0);
  EXPECT_EQ(study(later).status, 0);
  EXPECT_EQ(result("results.csv"), local_table());
  EXPECT_FALSE(is_there("queue/open"));
}

TEST_F(Runners, have_a_failed_row_tried_again_only_once_it_was_collected)
{
  write_study(falls_with("-9e3"));
  const Words now = {"--no-wait", "--runner", "wc -l < {jobs} >> count; " + one_by_one};
  EXPECT_EQ(study(now).status, 1) << "all have ended, one of them failed";
  EXPECT_EQ(study(now).status, 1);
  EXPECT_EQ(text_of_file(folder_ / "count"), "3\n1\n");
}

TEST_F(Runners, are_not_mixed_while_runs_are_queued)
{
  ASSERT_EQ(study({"--no-wait", "--runner", "cp {jobs} later"}).status, 75);
  const berm::Ended local = study();
  EXPECT_EQ(local.status, 1);
  EXPECT_NE(local.err.find("queue says that the runs were submitted (command)"), std::string::npos) << local.err;
  write_study(falls_with("-2.5"));
  const berm::Ended other = study({"--no-wait", "--runner", "cp {jobs} later"});
  EXPECT_EQ(other.status, 1);
  EXPECT_NE(other.err.find("results/runs/it_s_a_stone.moon is not among them"), std::string::npos) << other.err;
}

TEST_F(Runners, that_are_stopped_leave_checkpoints_and_go_on_to_the_same_bytes)
{
  folder_.write("stone.toml", test::small_case);
  folder_.write("study.toml", "[[case]]\nname = \"sand\"\nfile = \"stone.toml\"\nset = ['mesh.cells=[60, 30]', "
                              "'body.sand.block.spacing=\"0.6667 mm\"', 'stage.rest.until.time=\"10 ms\"']\n"
                              "[[measure]]\nname = \"H\"\nquantity = \"H_end_of_drag\"\n");
  const Words words = {"study", ".", "-o", "results", "--runner", one_by_one};
  {
    Program program(folder_.path(), words);
    ASSERT_TRUE(wait_until([&] { return result("runs/sand/history.csv").size() > 5000; }));
    program.signal(SIGTERM);
    const berm::Ended stopped = program.wait();
    EXPECT_EQ(stopped.status, 75) << stopped.err;
    EXPECT_NE(stopped.err.find("interrupted: 0 of 1 runs are done; the same command continues from there"), std::string::npos)
        << stopped.err;
  }
  EXPECT_EQ(result("runs/sand.status"), "75\n");
  const berm::Ended ended = run_program(folder_.path(), words);
  EXPECT_EQ(ended.status, 0) << ended.err;
  EXPECT_NE(result("runs/sand/run.log").find("resumes from the checkpoint"), std::string::npos);
  local_table();
  EXPECT_TRUE(result("runs/sand/history.csv") == text_of_file(folder_ / "local/runs/sand/history.csv"));
  EXPECT_FALSE(is_there("runs/sand.status"));
}

TEST_F(Runners, whose_jobs_are_killed_say_so_and_go_on)
{
  folder_.write("study.toml", "[[case]]\nname = \"stone\"\nfile = \"stone.toml\"\n[[measure]]\nname = \"g\"\nquantity = \"finished\"\n");
  const berm::Ended killed =
      study({"--runner", "touch results/runs/stone.messages # {jobs}"});  // as one that began and has left no word of its end
  EXPECT_EQ(killed.status, 1) << killed.err;
  EXPECT_NE(result("results.md").find("was ended from outside"), std::string::npos) << result("results.md");
  EXPECT_EQ(study({"--runner", one_by_one}).status, 0);
  EXPECT_EQ(result("results.csv").find("case,g,run\nstone,1,"), 0u) << result("results.csv");
}

TEST_F(Runners, that_cannot_work_are_one_clear_error)
{
  const std::pair<Words, const char*> wrong[] = {{{"--runner", "slrum"}, "--runner \"slrum\" is neither slurm nor a command with {jobs}"},
                                                 {{"--runner", "parallel"}, "is neither slurm nor a command with {jobs}"},
                                                 {{"--no-wait"}, "--no-wait requires --runner"},
                                                 {{"--sbatch", "-p x"}, "--sbatch goes with --runner slurm"},
                                                 {{"--pack", "3", "--runner", one_by_one}, "--pack goes with --runner slurm"},
                                                 {{"--pack", "0", "--runner", "slurm"}, "--pack"}};
  for (const auto& [words, says] : wrong) {
    const berm::Ended ended = study(words);
    EXPECT_EQ(ended.status, 2) << ended.err;
    EXPECT_NE(ended.err.find(says), std::string::npos) << ended.err;
    EXPECT_EQ(std::count(ended.err.begin(), ended.err.end(), '\n'), 1) << ended.err;
    EXPECT_FALSE(is_there("")) << "before anything is written";
  }
  const berm::Ended missing = study({"--runner", "no_such_program_as_this {jobs}"});
  EXPECT_EQ(missing.status, 1);
  EXPECT_NE(missing.err.find("berm: --runner: the command ended with status 127 before any run began"), std::string::npos) << missing.err;
  EXPECT_FALSE(is_there("queue/open"));
}

TEST_F(Runners, take_several_cases_of_run)
{
  folder_.write("block.toml", test::falling_stone);
  const Words words = {"run", "stone.toml", "block.toml", "-o", "results", "--runner", one_by_one};
  const berm::Ended ended = run_program(folder_.path(), words);
  EXPECT_EQ(ended.status, 0) << ended.err;
  for (const char* name : {"stone", "block"})
    EXPECT_NE(result(name + std::string("/summary.json")).find("\"finished\": true"), std::string::npos);
  const berm::Ended again = run_program(folder_.path(), words);
  EXPECT_EQ(again.status, 0);
  EXPECT_NE(again.err.find("results/block has its result already"), std::string::npos) << again.err;
  Words other = words;
  other.insert(other.end(), {"--set", "gravity=[0, -1]"});
  EXPECT_EQ(run_program(folder_.path(), other).status, 2) << "another case is not replaced unasked";
}

}  // namespace
}  // namespace berm::jobs::this_file
