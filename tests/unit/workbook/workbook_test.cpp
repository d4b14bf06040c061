// SPDX-License-Identifier: BSD-3-Clause
#include "workbook/workbook.hpp"

#include "os/error.hpp"
#include "samples/run_to_write.hpp"

#include <gtest/gtest.h>

#include <cstdio>

namespace berm::workbook::this_file {
namespace {

using Row = std::vector<Sheet::Cell>;

void put_results(const std::filesystem::path& folder)
{
  put(folder / "half_cycles.csv", "# turns, of 1 %\nstage,u_end_m,H_N_m,time_s\nstorm,3.048,nan,2\n\"a, b\",0.3048,14.59390293720636,3\n");
  put(folder / "summary.json",
      R"({"quantities": {"H_breakout": {"value": 1000, "unit": "N/m", "meaning": "force"}, "ratio": {"value": 2, "unit": "1"}},
          "timing": {}, "checks": {"finished": true}, "text": {}})");
}

TEST(Sheets, have_the_numbers_and_the_tables_of_a_folder)
{
  const TemporaryFolder folder;
  put_results(folder.path());
  const std::vector<Sheet> sheets = sheets_of(folder.path(), Units::si);
  ASSERT_EQ(sheets.size(), 2u);
  EXPECT_EQ(sheets[0].rows[1], (Row{"H_breakout", 1000., "N/m", "force"}));
  EXPECT_EQ(sheets[1].name, "half_cycles");
  EXPECT_EQ(sheets[1].names_row, 1u);
  EXPECT_EQ(sheets[1].rows[0], (Row{"# turns, of 1 %"}));
  EXPECT_EQ(sheets[1].rows[2], (Row{"storm", 3.048, "", 2.}));
  EXPECT_EQ(sheets[1].rows[3][0], Sheet::Cell("a, b"));
}

// 1 ft = 0.3048 m and 1 lbf = 4.4482216152605 N are exact.
TEST(Sheets, in_imperial_units_name_them)
{
  const TemporaryFolder folder;
  put_results(folder.path());
  const std::vector<Sheet> sheets = sheets_of(folder.path(), Units::imperial);
  EXPECT_EQ(sheets[0].rows[1][2], Sheet::Cell("lbf/ft"));
  EXPECT_NEAR(std::get<double>(sheets[0].rows[1][1]), 1000 * 0.3048 / 4.4482216152605, 1e-9);
  EXPECT_EQ(sheets[0].rows[2], (Row{"ratio", 2., "1", ""}));
  EXPECT_EQ(sheets[1].rows[1], (Row{"stage", "u_end_ft", "H_lbf_ft", "time_s"}));
  EXPECT_NEAR(std::get<double>(sheets[1].rows[2][1]), 10, 1e-12);
  EXPECT_NEAR(std::get<double>(sheets[1].rows[3][2]), 1, 1e-12);
}

TEST(Sheets, of_a_folder_without_results_are_refused)
{
  const TemporaryFolder folder;
  EXPECT_THROW(sheets_of(folder.path(), Units::si), InputError);
}

/// What another program finds in the sheets of a workbook, by its own parser.
std::string read_back(const std::filesystem::path& file)
{
  const std::string script = "import re,sys,zipfile; z=zipfile.ZipFile(sys.argv[1]); "
                             "print(re.findall(r\"name=.(.*?). sheetId\", z.read(\"xl/workbook.xml\").decode())); "
                             "print(re.findall(r\"r=.B3.*?<v>(.*?)</v>\", z.read(\"xl/worksheets/sheet2.xml\").decode()))";
  FILE* pipe = ::popen(("python3 -c '" + script + "' '" + file.string() + "'").c_str(), "r");
  std::string text;
  for (int c; (c = std::fgetc(pipe)) != EOF;) text += static_cast<char>(c);
  ::pclose(pipe);
  return text;
}

TEST(Workbook, has_sheets_of_names_that_excel_takes)
{
  const TemporaryFolder folder;
  const std::vector<Sheet> sheets = {
      {.name = "results", .rows = {{"x"}}}, {.name = "Results", .rows = {{"x"}, {1.}, {0.5, 0.5}}}, {.name = "history", .rows = {{"x"}}}};
  put(folder / "tables.xlsx", xlsx_of(sheets));
  EXPECT_EQ(read_back(folder / "tables.xlsx"), "['results', 'Results_2', 'rows of history']\n['0.5']\n");
}

TEST(Workbook, is_read_by_another_program)
{
  const TemporaryFolder folder;
  const char* name = "a very long name of a table, more than allowed";
  const std::vector<Sheet> sheets = {{.name = name, .rows = {{"x"}}},
                                     {.name = name, .rows = {{"# note"}, {"x", "y"}, {1., 0.25}}, .names_row = 1}};
  put(folder / "tables.xlsx", xlsx_of(sheets));
  EXPECT_EQ(read_back(folder / "tables.xlsx"), "['a very long name of a table, mo', 'a very long name of a table, _2']\n['0.25']\n");
}

}  // namespace
}  // namespace berm::workbook::this_file
