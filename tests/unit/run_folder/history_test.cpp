// SPDX-License-Identifier: BSD-3-Clause
#include "core/error.hpp"
#include "io/atomic_file.hpp"
#include "samples/run_to_write.hpp"

#include <csignal>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <sys/resource.h>

namespace berm::run_folder {
namespace {

RC_GTEST_PROP(History, numbers_come_back_to_the_last_bit, (const std::vector<double>& numbers))
{
  const TemporaryFolder folder;
  const auto path = folder.path() / "history.csv";
  {
    HistoryFile file(path, {"u_m"});
    for (const double x : numbers) file.add(x / 3, "push", {x});
  }
  const History history = read_history(path);
  RC_ASSERT(history.rows() == static_cast<Index>(numbers.size()));
  for (std::size_t k = 0; k < numbers.size(); ++k) {
    RC_ASSERT(history["u_m"][k] == numbers[k]);
    RC_ASSERT(history["time_s"][k] == numbers[k] / 3);
  }
}

TEST(History, numbers_that_are_not_there_are_nan_and_ends_are_kept)
{
  const TemporaryFolder folder;
  {
    HistoryFile file(folder.path() / "h", {"a", "b"});
    file.add(0, "push", {-std::numeric_limits<Real>::quiet_NaN(), infinity});
  }
  EXPECT_EQ(content_of(folder.path() / "h"), "time_s,stage,a,b\n0,push,nan,inf\n");
  const History history = read_history(folder.path() / "h");
  EXPECT_TRUE(std::isnan(history["a"][0]));
  EXPECT_EQ(history["b"][0], infinity);
}

TEST(History, names_of_stages_may_hold_commas_quotes_and_line_ends)
{
  const TemporaryFolder folder;
  const std::string name = "push, \"hard\"\nthen rest";
  {
    HistoryFile file(folder.path() / "h", {"a"});
    file.add(0, name, {1});
    file.add(1, "plain", {2});
  }
  const History history = read_history(folder.path() / "h");
  EXPECT_EQ(history.stage, (std::vector<std::string>{name, "plain"}));
  EXPECT_EQ(history["a"], (std::vector<Real>{1, 2}));
}

TEST(History, a_row_is_on_the_disk_when_add_returns)
{
  const TemporaryFolder folder;
  HistoryFile file(folder.path() / "h", {"a"});
  file.add(0.5, "push", {1.25});
  EXPECT_EQ(content_of(folder.path() / "h"), "time_s,stage,a\n0.5,push,1.25\n");
}

TEST(History, a_last_line_cut_anywhere_is_left_out)
{
  const TemporaryFolder folder;
  const auto path = folder.path() / "h";
  const std::string whole = "time_s,stage,a\n0,push,1.5\n", last = "1,push,2.75";
  for (std::size_t length = 0; length <= last.size(); ++length) {
    put(path, whole + last.substr(0, length));
    const History history = read_history(path);
    EXPECT_EQ(history["a"], (std::vector<Real>{1.5})) << length;
    EXPECT_EQ(history["time_s"].size(), 1u);
    EXPECT_EQ(history.stage.size(), 1u);
  }
}

TEST(History, a_line_that_is_wrong_is_named)
{
  const TemporaryFolder folder;
  const auto message = [&](const std::string& text) -> std::string {
    put(folder.path() / "h", text);
    try {
      read_history(folder.path() / "h");
    } catch (const RunError& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_NE(message("time_s,stage,a\n0,push,1\n0,push\n").find("line 3: 2 fields for 3"), std::string::npos);
  EXPECT_NE(message("time_s,stage,a\n0,push,1x\n").find("line 2: \"1x\" is not a number"), std::string::npos);
  EXPECT_NE(message("time_s,a\n0,1\n").find("no column stage"), std::string::npos);
  EXPECT_NE(message("time_s,stage,a\n0,push,\"\x1b[2J\n" + std::string(100, 'x') + "\"\n").find("line 2: \"?[2J?xxxx"), std::string::npos);
  EXPECT_NE(message("time_s,stage,\"a\x1b[2J\"\n").find("line 1: \"a?[2J\" is no name"), std::string::npos);
  EXPECT_NE(message("").find("no header"), std::string::npos);
}

TEST(History, a_missing_column_is_named)
{
  const TemporaryFolder folder;
  put(folder.path() / "h", "time_s,stage,a\n");
  const History history = read_history(folder.path() / "h");
  EXPECT_TRUE(history.has("a"));
  EXPECT_FALSE(history.has("b"));
  EXPECT_THROW(history["b"], RunError);
  EXPECT_THROW(read_history(folder.path() / "none"), RunError);
}

TEST(HistoryFile, a_full_disk_is_an_error_with_its_reason)
{
  try {
    HistoryFile file("/dev/full", {"a"});
    FAIL() << "the header was written to a full disk";
  } catch (const RunError& error) {
    EXPECT_NE(std::string(error.what()).find("No space left"), std::string::npos) << error.what();
  }
}

// A limit on the size of files stands in for a disk that is full within the row.
TEST(HistoryFile, a_row_that_the_disk_takes_a_part_of_is_taken_back)
{
  const TemporaryFolder folder;
  const auto path = folder.path() / "history.csv";
  HistoryFile file(path, {"u_m"});
  file.add(1, "push", {0.5});
  const std::string before = io::read_text_file(path);
  rlimit unlimited{};
  ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &unlimited), 0);
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  const rlimit within_row{before.size() + 4, unlimited.rlim_max};
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &within_row), 0);
  EXPECT_THROW(file.add(2, "push", {0.75}), RunError);
  ::setrlimit(RLIMIT_FSIZE, &unlimited);
  std::signal(SIGXFSZ, handler);
  EXPECT_EQ(io::read_text_file(path), before);
}

TEST(HistoryFile, a_row_of_the_wrong_length_is_refused)
{
  const TemporaryFolder folder;
  HistoryFile file(folder.path() / "h", {"a", "b"});
  EXPECT_THROW(file.add(0, "push", {1}), RunError);
}

}  // namespace
}  // namespace berm::run_folder
