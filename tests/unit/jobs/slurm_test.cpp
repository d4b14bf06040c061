// SPDX-License-Identifier: BSD-3-Clause
// What needs no Slurm; tests/slurm is the test with one.
#include "jobs/slurm.hpp"

#include "study_by_runner.hpp"

namespace berm::jobs::this_file {
namespace {

TEST(SlurmWords, of_an_array_count_its_tasks_and_pass_options_on)
{
  EXPECT_EQ(sbatch_command({"", 1, 0}, "/a/queue", 12),
            "env -u SLURM_CPUS_PER_TASK sbatch --parsable --array=0-11 --chdir=/a/queue  /a/queue/task.sh");
  EXPECT_EQ(sbatch_command({"--time=2:00:00 -p 'long one'", 5, 8}, "/my runs/queue", 12),
            "env -u SLURM_CPUS_PER_TASK sbatch --parsable --array=0-2%8 --chdir='/my runs/queue' --time=2:00:00 -p 'long one' '/my "
            "runs/queue/task.sh'");
}

TEST(SlurmWords, hold_the_number_of_the_job)
{
  EXPECT_EQ(job_number_in("123\n"), "123");
  EXPECT_EQ(job_number_in("sbatch: warning: 4 nodes are down\n123;north\n"), "123");
  EXPECT_EQ(job_number_in("sbatch: error: Batch job submission failed: 3 reasons\n"), "");
  EXPECT_EQ(job_number_in(""), "");
}

/// Stand-ins for sbatch, which does the tasks of the array one after the other at once, and squeue, which has nothing.
class StandIn : public StudyByRunner {
protected:
  void programs(const std::string& sbatch) const
  {
    std::filesystem::create_directories(folder_ / "bin");
    folder_.write("bin/sbatch", "#!/bin/bash\n" + sbatch);
    folder_.write("bin/squeue", "#!/bin/sh\nexit 0\n");
    for (const char* name : {"bin/sbatch", "bin/squeue"})
      std::filesystem::permissions(folder_ / name, std::filesystem::perms::owner_all, std::filesystem::perm_options::add);
  }
  berm::Ended by_slurm(const Words& more) const
  {
    Words words = {"--runner", "slurm"};
    words.insert(words.end(), more.begin(), more.end());
    return study(words, {"PATH=" + (folder_ / "bin").string() + ":/usr/bin:/bin"});
  }
  static constexpr const char* does_it_at_once = R"(
for word; do case $word in --array=*) last=${word#--array=0-} ;; --chdir=*) cd "${word#--chdir=}" ;; esac; done
export SLURM_ARRAY_JOB_ID=7 SLURM_ARRAY_TASK_ID
for ((SLURM_ARRAY_TASK_ID = 0; SLURM_ARRAY_TASK_ID <= last; ++SLURM_ARRAY_TASK_ID)); do bash "${!#}" > "task_$SLURM_ARRAY_TASK_ID" 2>&1; done
echo "$*" > said
echo 7
)";
};

TEST_F(StandIn, gets_the_runs_as_an_array_of_tasks_which_do_several_each)
{
  programs(does_it_at_once);
  const berm::Ended ended = by_slurm({"--pack", "2", "--sbatch", "--time=1:00:00 --comment='two words'", "--threads", "9"});
  EXPECT_EQ(ended.status, 0) << ended.err;
  const std::string said = text_of_file(folder_ / "results/queue/said");
  EXPECT_NE(said.find("--array=0-1%9 "), std::string::npos) << said;
  EXPECT_NE(said.find(" --time=1:00:00 --comment=two words "), std::string::npos) << said;
  EXPECT_EQ(text_of_file(folder_ / "results/results.csv"), local_table());
  EXPECT_EQ(names_in(folder_ / "results/queue"), (Words{"jobs", "run_job", "said", "task.sh", "task_0", "task_1"})) << "collected";
}

TEST_F(StandIn, that_refuses_is_quoted_in_one_error)
{
  programs("echo 'sbatch: error: invalid partition specified: nowhere' >&2; exit 1\n");
  const berm::Ended ended = by_slurm({"--sbatch", "-p nowhere"});
  EXPECT_EQ(ended.status, 1);
  EXPECT_EQ(ended.err, "berm: --runner slurm: sbatch refuses the 3 runs: sbatch: error: invalid partition specified: nowhere\n");
  EXPECT_FALSE(std::filesystem::exists(folder_ / "results/queue/open"));
}

TEST_F(StandIn, that_is_not_there_is_an_input_error)
{
  const berm::Ended ended = study({"--runner", "slurm"}, {"PATH=/nowhere"});
  EXPECT_EQ(ended.status, 2);
  EXPECT_EQ(ended.err, "berm: --runner slurm: there is no sbatch in PATH: this machine does not submit jobs to Slurm\n");
}

}  // namespace
}  // namespace berm::jobs::this_file
