// SPDX-License-Identifier: BSD-3-Clause
#include "io/atomic_file.hpp"
#include "os/error.hpp"
#include "samples/history_columns.hpp"
#include "samples/run_to_write.hpp"

#include <csignal>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <sys/resource.h>

namespace berm::run_folder::this_file {
namespace {

RC_GTEST_PROP(History, numbers_come_back_to_the_last_bit, (const std::vector<double>& numbers))
{
  const TemporaryFolder folder;
  const auto path = folder.path() / "history.csv";
  {
    NamedHistory file(path, {"u_m"});
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
    NamedHistory file(folder.path() / "h", {"a", "b"});
    file.add(0, "push", {-std::numeric_limits<Real>::quiet_NaN(), infinity});
  }
  EXPECT_EQ(content_of(folder.path() / "h"), "time_s,stage,a,b\n0,push,nan,inf\n");
  const History history = read_history(folder.path() / "h");
  EXPECT_TRUE(std::isnan(history["a"][0]));
  EXPECT_EQ(history["b"][0], infinity);
}

TEST(History, names_of_stages_may_hold_commas_and_quotes)
{
  const TemporaryFolder folder;
  const std::string name = "push, \"hard\", then rest";
  {
    NamedHistory file(folder.path() / "h", {"a"});
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
  NamedHistory file(folder.path() / "h", {"a"});
  file.add(0.5, "push", {1.25});
  EXPECT_EQ(content_of(folder.path() / "h"), "time_s,stage,a\n0.5,push,1.25\n");
}

TEST(History, a_last_line_cut_anywhere_is_left_out)
{
  const TemporaryFolder folder;
  const auto path = folder.path() / "h";
  const std::string whole = "time_s,stage,a\n0,push,1.5\n", last = "1,push,2.75";
  for (std::size_t length = 0; length <= last.size(); ++length) {
    put_schema(path, {"time_s", "a"});
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
    put_schema(folder.path() / "h", {"time_s", "a"});
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
  EXPECT_NE(message("time_s,stage,\"a\x1b[2J\"\n").find("line 1: \"a?[2J\" is not a name"), std::string::npos);
  EXPECT_NE(message("time_s,sta").find("no header"), std::string::npos);
}

TEST(History, a_missing_column_is_named)
{
  const TemporaryFolder folder;
  put_schema(folder.path() / "h", {"time_s", "a"});
  put(folder.path() / "h", "time_s,stage,a\n");
  const History history = read_history(folder.path() / "h");
  EXPECT_TRUE(history.has("a"));
  EXPECT_FALSE(history.has("b"));
  EXPECT_THROW(history["b"], RunError);
  EXPECT_THROW(read_history(folder.path() / "none"), RunError);
}

// A limit on the size of files stands in for a full disk, here and below.
TEST(HistoryFile, a_full_disk_is_an_error_with_its_reason)
{
  const TemporaryFolder folder;
  NamedHistory file(folder.path() / "history.csv", {"a"});
  rlimit before{};
  ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &before), 0);
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  const rlimit none{1, before.rlim_max};
  std::string message;
  try {
    file.add(0, "push", {1});
    ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &none), 0);
    file.add(1, "push", {1});
  } catch (const RunError& error) {
    message = error.what();
  }
  ::setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, handler);
  EXPECT_NE(message.find("File too large"), std::string::npos) << message;
}

TEST(HistoryFile, a_row_that_the_disk_takes_a_part_of_is_taken_back)
{
  const TemporaryFolder folder;
  const auto path = folder.path() / "history.csv";
  NamedHistory file(path, {"u_m"});
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
  NamedHistory file(folder.path() / "h", {"a", "b"});
  file.add(0, "push", {1, 2});
  EXPECT_THROW(file.add(0, "push", {1}), RunError);
  EXPECT_THROW(file.add(0, "push", {1, 2, 3}), RunError);
  EXPECT_NO_THROW(file.add(1, "push", {3, 4}));
}

TEST(HistoryFile, a_column_that_changes_its_name_is_refused)
{
  Row row;
  row.begin(0, "push");
  row("u", 1, metres, "displacement");
  row.end();
  row.begin(1, "push");
  EXPECT_THROW(row("w", 1, metres, "embedment"), RunError);
}

TEST(HistoryFile, tells_name_unit_meaning_and_of_what_each_column_is)
{
  const TemporaryFolder folder;
  {
    HistoryFile file(folder.path() / "history.csv");
    Row row;
    row.begin(0, "push");
    row.of_main("pipe");
    row("H", 5, newtons<3>, "horizontal resistance");
    row.of("tip_1");
    row("u", Vec<2>(1, 2), metres, "displacement");
    row.component("L", 2, 3, newton_metre_seconds<2>, "angular momentum");
    file.add(row);
  }
  EXPECT_EQ(content_of(folder.path() / "history.csv"), "time_s,stage,H_N,tip_1_ux_m,tip_1_uy_m,tip_1_Lz_N_s\n0,push,5,1,2,3\n");
  const History history = read_history(folder.path() / "history.csv");
  EXPECT_EQ(history.column("H_N"), (Column{"H_N", "H", "N", "horizontal resistance", "pipe"}));
  EXPECT_EQ(history.column("tip_1_uy_m"), (Column{"tip_1_uy_m", "tip 1 uy", "m", "displacement, y", "tip_1"}));
  EXPECT_EQ(history.column("tip_1_Lz_N_s").unit, "N s");
  EXPECT_EQ(history.column("time_s").unit, "s");
  EXPECT_EQ(history.by_label("H"), (std::vector<Real>{5}));
  EXPECT_EQ(history.column("H_N").words(), "horizontal resistance");
  EXPECT_EQ(history.column("tip_1_uy_m").words(), "tip 1 uy");
}

TEST(HistoryFile, that_goes_on_keeps_its_schema_and_refuses_other_columns)
{
  const TemporaryFolder folder;
  const auto path = folder.path() / "history.csv";
  {
    NamedHistory(path, {"u_m"}).add(0, "push", {1});
  }
  const auto bytes = static_cast<BigIndex>(std::filesystem::file_size(path));
  const auto goes_on = [&](const std::string& column) {
    HistoryFile file(path, bytes);
    NamedRow row({column});
    file.add(row.with(1, "push", {2}));
  };
  EXPECT_THROW(goes_on("w_m"), RunError);
  goes_on("u_m");
  EXPECT_EQ(content_of(path), "time_s,stage,u_m\n0,push,1\n1,push,2\n");
  EXPECT_EQ(read_history(path)["u_m"], (std::vector<Real>{1, 2}));
}

TEST(HistoryFile, hands_on_the_rows_that_can_be_read_from_it_those_before_it_went_on_too)
{
  const TemporaryFolder folder;
  const auto path = folder.path() / "history.csv";
  const auto expect_as_read = [&](const History& history) {
    const History read = read_history(path);
    EXPECT_EQ(history.columns, read.columns);
    EXPECT_EQ(history.values, read.values);
    EXPECT_EQ(history.stage, read.stage);
  };
  NamedRow row({"u_m", "V_N_m"});
  BigIndex bytes = 0;
  {
    HistoryFile file(path);
    EXPECT_EQ(file.history().rows(), 0);
    file.add(row.with(0, "a \"push\", slow", {1. / 3, -0.}));
    bytes = file.bytes();
    file.add(row.with(1, "drag", {1e-310, infinity}));
    expect_as_read(file.history());
  }
  HistoryFile file(path, bytes);
  expect_as_read(file.history());
  file.add(row.with(2, "drag", {5e300, 7}));
  expect_as_read(file.history());
  EXPECT_EQ(file.history().rows(), 2);
}

TEST(History, without_a_schema_or_with_that_of_another_is_refused)
{
  const TemporaryFolder folder;
  const auto path = folder.path() / "history.csv";
  put(path, "time_s,stage,a\n0,push,1\n");
  EXPECT_THROW(read_history(path), RunError);
  put_schema(path, {"time_s", "b"});
  EXPECT_THROW(read_history(path), RunError);
  for (const char* damaged : {"", "{", "[]", "{\"columns\": [{\"name\": 5}]}",
                              R"({"columns": [{"name": "time_s", "label": "t", "unit": "s\n", "meaning": "", "of": "run"}]})"}) {
    put(schema_path(path), damaged);
    EXPECT_THROW(read_history(path), RunError) << damaged;
  }
  put_schema(path, {"time_s", "a"});
  EXPECT_EQ(read_history(path).rows(), 1);
}

TEST(History, has_no_stage_whose_name_moves_a_cursor_or_ends_a_line)
{
  const TemporaryFolder folder;
  const auto path = folder.path() / "history.csv";
  put_schema(path, {"time_s", "a"});
  for (const char* stage : {"\"pu\nsh\"", "pu\x1B[2Jsh", "pu\xC2\x9Bsh"}) {
    put(path, fmt::format("time_s,stage,a\n0,{},1\n", stage));
    EXPECT_THROW(read_history(path), RunError) << stage;
  }
}

TEST(History, of_a_run_that_ended_before_its_first_row_is_empty)
{
  const TemporaryFolder folder;
  {
    HistoryFile file(folder.path() / "history.csv");
  }
  EXPECT_EQ(read_history(folder.path() / "history.csv").rows(), 0);
  EXPECT_TRUE(read_history(folder.path() / "history.csv").columns.empty());
}

TEST(Row, per_radian_has_the_columns_of_the_whole_two_pi_times_as_large)
{
  Row row;
  row.count_parts(2 * pi);
  row.begin(0.5, "push");
  row("w", 3, metres, "embedment");
  row("V", 5, newtons<2>, "vertical reaction");
  row("internal", 7, joules<2>, "internal energy");
  row("contact", 2, surface<2>, "surface in contact");
  row.end();
  std::vector<std::string> names, units;
  for (const Column& column : row.columns()) names.push_back(column.name), units.push_back(column.unit);
  EXPECT_EQ(names, (std::vector<std::string>{"time_s", "w_m", "V_N", "internal_J", "contact_m2"}));
  EXPECT_EQ(units, (std::vector<std::string>{"s", "m", "N", "J", "m2"}));
  EXPECT_EQ(row.values(), (std::vector<Real>{0.5, 3, 2 * pi * 5, 2 * pi * 7, 2 * pi * 2}));
}

TEST(Row, of_a_quarter_in_space_has_the_same_columns_four_times_as_large)
{
  Row row;
  row.count_parts(4);
  row.begin(0.5, "push");
  row("w", 3, metres, "embedment");
  row("F", Vec<3>(5, 0, 6), newtons<3>, "force");
  row("internal", 7, joules<3>, "internal energy");
  row.end();
  std::vector<std::string> names;
  for (const Column& column : row.columns()) names.push_back(column.name);
  EXPECT_EQ(names, (std::vector<std::string>{"time_s", "w_m", "Fx_N", "Fy_N", "Fz_N", "internal_J"}));
  EXPECT_EQ(row.values(), (std::vector<Real>{0.5, 3, 20, 0, 24, 28}));
}

}  // namespace
}  // namespace berm::run_folder::this_file
