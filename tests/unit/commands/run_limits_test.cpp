// SPDX-License-Identifier: BSD-3-Clause
// Signals and limits of the system that would end a program which does not look at them.
#include "samples/program.hpp"
#include "samples/small_cases.hpp"

#include <gtest/gtest.h>
#include <sys/resource.h>

namespace berm::commands::this_file {
namespace {

namespace fs = std::filesystem;
using Words = std::vector<std::string>;

const Words endless = {"run", "small.toml", "--threads", "1", "-o", "results", "--set", "stage.rest.until.time=100 s"};

class Limits : public testing::Test {
protected:
  Limits() { place_.write("small.toml", test::small_case); }
  bool has_rows() const
  {
    return wait_until([&] { return text_of_file(place_ / "results/history.csv").size() > 2000; });
  }

  TemporaryFolder place_;
};

/// The size that files may have, for programs that are started while this lives.
class FileSizeLimit {
public:
  explicit FileSizeLimit(rlim_t bytes)
  {
    ::getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit small{bytes, before_.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &small);
  }
  ~FileSizeLimit() { ::setrlimit(RLIMIT_FSIZE, &before_); }

private:
  rlimit before_{};
};

TEST_F(Limits, of_file_sizes_end_a_run_like_a_full_disk_and_it_is_resumed_to_the_same_bytes)
{
  const auto run_into = [&](const char* folder) {
    return run_program(place_.path(), {"run", "small.toml", "--threads", "1", "-o", folder, "--set", "output.history_time=0.01 ms"});
  };
  ASSERT_EQ(run_into("undisturbed").status, 0);
  {
    const FileSizeLimit limit(60'000);  // resolved.toml is shorter
    const Ended ended = run_into("results");
    EXPECT_EQ(ended.status, 1) << ended.err;
    EXPECT_NE(ended.err.find("File too large"), std::string::npos) << ended.err;
  }
  const Ended resumed = run_program(place_.path(), {"run", "--resume", "results", "--threads", "1"});
  EXPECT_EQ(resumed.status, 0) << resumed.err;
  for (const char* name : {"history.csv", "frames/particles_0001.vtu", "frames/frames.pvd"})
    EXPECT_TRUE(text_of_file(place_ / "results" / name) == text_of_file(place_ / "undisturbed" / name)) << name;
}

TEST_F(Limits, of_file_sizes_name_the_file_that_begins_a_run)
{
  const FileSizeLimit limit(100);
  const Ended ended = run_program(place_.path(), {"run", "small.toml", "--threads", "1", "-o", "results"});
  EXPECT_EQ(ended.status, 1) << ended.err;
  EXPECT_FALSE(fs::exists(place_ / "results/resolved.toml"));
}

TEST_F(Limits, a_run_whose_messages_nobody_reads_goes_to_its_end)
{
  const std::string command =
      "cd '" + place_.path().string() + "' && { '" BERM_PROGRAM "' run small.toml --threads 1 -o results 2>&1; echo $? > status; } | true";
  ASSERT_EQ(std::system(command.c_str()), 0);
  EXPECT_NE(text_of_file(place_ / "results/run.log").find("everything is in"), std::string::npos);
  EXPECT_EQ(place_.read("status"), "1\n") << "the results on the standard output were lost";
}

TEST_F(Limits, a_closed_terminal_stops_a_run_with_a_checkpoint)
{
  Program run(place_.path(), endless);
  ASSERT_TRUE(has_rows());
  run.signal(SIGHUP);
  run.signal(SIGHUP);  // shells send a second one
  EXPECT_EQ(run.wait().status, 75);
  EXPECT_TRUE(fs::exists(place_ / "results/checkpoint"));
}

TEST_F(Limits, a_closed_terminal_is_ignored_where_it_was_from_the_start)
{
  const auto before = std::signal(SIGHUP, SIG_IGN);  // as nohup does
  Program run(place_.path(), endless);
  std::signal(SIGHUP, before);
  ASSERT_TRUE(has_rows());
  run.signal(SIGHUP);
  const auto rows = text_of_file(place_ / "results/history.csv").size();
  EXPECT_TRUE(wait_until([&] { return text_of_file(place_ / "results/history.csv").size() > 2 * rows; }));
  run.signal(SIGTERM);
  EXPECT_EQ(run.wait().status, 75);
}

TEST_F(Limits, programs_that_berm_starts_find_the_signals_as_it_did)
{
  place_.write("gnuplot", "#!/bin/sh\ngrep SigIgn /proc/self/status > '" + (place_ / "ignored").string() + "'\nexit 1\n");
  fs::permissions(place_ / "gnuplot", fs::perms::owner_all);
  run_program(place_.path(), {"run", "small.toml", "--threads", "1", "-o", "results"},
              {"PATH=" + place_.path().string() + ":" + std::getenv("PATH")});
  const std::string ignored = place_.read("ignored");
  ASSERT_NE(ignored.find("SigIgn:"), std::string::npos) << ignored;
  const auto mask = std::stoull(ignored.substr(ignored.find(':') + 1), nullptr, 16);
  for (const int signal : {SIGXFSZ, SIGPIPE, SIGHUP}) EXPECT_EQ(mask >> (signal - 1) & 1U, 0U) << signal;
}

}  // namespace
}  // namespace berm::commands::this_file
