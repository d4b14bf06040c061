// SPDX-License-Identifier: BSD-3-Clause
#include "samples/made_springs.hpp"
#include "springs/written_springs.hpp"

#include <gtest/gtest.h>
#include <map>
#include <sstream>

namespace berm::springs::this_file {
namespace {

using Words = std::vector<std::string>;

/// Fields of a line of .csv, some between quotes.
Words fields_of(const std::string& line)
{
  Words fields{""};
  bool quoted = false;
  for (const char c : line) {
    if (c == '"')
      quoted = !quoted;
    else if (c == ',' && !quoted)
      fields.emplace_back();
    else
      fields.back() += c;
  }
  return fields;
}

using Row = std::map<std::string, std::string>;

std::vector<Row> rows_of(const std::string& text)
{
  std::vector<Row> rows;
  Words head;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with('#')) continue;
    const Words fields = fields_of(line);
    if (head.empty()) {
      head = fields;
      continue;
    }
    EXPECT_EQ(fields.size(), head.size()) << line;
    Row& row = rows.emplace_back();
    for (std::size_t k = 0; k < head.size(); ++k) row[head[k]] = fields[k];
  }
  return rows;
}

std::vector<Row> buckpy_rows(const Design& design)
{
  const ExportFiles files = buckpy_files(design);
  EXPECT_EQ(files.size(), 1u);
  EXPECT_EQ(files[0].name, "soils.csv");
  EXPECT_NE(files[0].text.find("Not run in BuckPy"), std::string::npos);
  return rows_of(files[0].text);
}

void expect_estimates(const Row& row, const std::string& of, Real low, Real best, Real high)
{
  EXPECT_NEAR(std::stod(row.at(of + " LE")), low, 1e-5 * low) << of;
  EXPECT_NEAR(std::stod(row.at(of + " BE")), best, 1e-5 * best) << of;
  EXPECT_NEAR(std::stod(row.at(of + " HE")), high, 1e-5 * high) << of;
  EXPECT_EQ(row.at(of + " Fit Bounds"), "LE_BE_HE");
}

TEST(BuckPyFormat, is_a_row_of_the_sheet_for_each_travel_with_friction_at_breakout)
{
  const Design design = made_design();
  const std::vector<Row> rows = buckpy_rows(design);
  ASSERT_EQ(rows.size(), 2u);
  EXPECT_EQ(rows[0].size(), 15u);
  EXPECT_EQ(rows[0].at("Friction Set"), "line sweep_1");
  // Ordered forces of eleven runs at 0.75 to 1.25 of the best.
  const Real low = design.low->lateral[0].peak / 1000, high = design.high->lateral[0].peak / 1000;
  EXPECT_LT(low, 0.65);
  EXPECT_GT(high, 0.95);
  expect_estimates(rows[0], "Lateral Operation", low, 0.8, high);
  expect_estimates(rows[0], "Axial", design.low->axial.undrained / 1000, 0.24, design.high->axial.undrained / 1000);
  for (const char* column : {"LE", "BE", "HE", "Fit Bounds"}) EXPECT_EQ(rows[0].at(std::string("Lateral Hydrotest ") + column), "");
  const std::string& description = rows[0].at("Soil Description");
  for (const char* words : {"run b1", "state operation", "sweep_1", "by White and Randolph 2007", "H at breakout divided by V = 1000 N/m"})
    EXPECT_NE(description.find(words), std::string::npos) << words << " in " << description;
}

TEST(BuckPyFormat, has_no_row_of_a_travel_that_meets_a_berm_alone)
{
  Springs s = made_springs();
  s.lateral[1].breaks = false;
  s.lateral[1].peak = nan;
  const std::vector<Row> rows = buckpy_rows(made_design(s));
  ASSERT_EQ(rows.size(), 1u) << "1129 N/m against a berm is no friction of operation";
  EXPECT_EQ(rows[0].at("Friction Set"), "line sweep_1");
}

TEST(BuckPyFormat, puts_a_travel_of_the_flooded_pipe_into_the_columns_of_the_hydrotest)
{
  Springs s = made_springs();
  s.lateral[0].stage = "Hydrotest";
  s.lateral[0].V = 1600;
  const std::vector<Row> both = buckpy_rows(made_design(s));
  ASSERT_EQ(both.size(), 1u);
  EXPECT_EQ(both[0].at("Lateral Hydrotest BE"), "0.5");
  EXPECT_EQ(both[0].at("Lateral Operation BE"), "0.8");
  s.lateral[0].stage = "sweep";
  s.lateral[0].state = "flooded";
  const Row by_state = buckpy_rows(made_design(s)).at(0);
  EXPECT_EQ(by_state.at("Lateral Hydrotest BE"), "0.5");
  EXPECT_NE(by_state.at("Soil Description").find("sweep of the pipe in state flooded"), std::string::npos);
  s = made_springs();
  s.state = "flooded";
  const std::vector<Row> flooded = buckpy_rows(made_design(s));
  ASSERT_EQ(flooded.size(), 2u);
  EXPECT_EQ(flooded[0].at("Lateral Hydrotest BE"), "0.8");
  EXPECT_EQ(flooded[0].at("Lateral Operation BE"), "");
}

TEST(BuckPyFormat, of_one_run_has_no_bounds_and_no_fit)
{
  Design design;
  design.name = "alone";
  design.best = made_springs();
  design.best.axial.undrained = nan;
  const Row row = buckpy_rows(design).at(0);
  EXPECT_EQ(row.at("Lateral Operation BE"), "0.8");
  for (const char* column :
       {"Lateral Operation LE", "Lateral Operation HE", "Lateral Operation Fit Bounds", "Axial BE", "Axial Fit Bounds"})
    EXPECT_EQ(row.at(column), "") << column;
}

/// Values of the options before their keys, of each block of one program: a new one begins where a key comes again.
std::vector<std::map<std::string, Real>> blocks_of(const std::string& text, const std::string& first)
{
  std::vector<std::map<std::string, Real>> blocks;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with('#')) continue;
    std::istringstream words(line);
    Real value = nan;
    std::string key;
    words >> value >> key;
    if (key == "FrictionCoefficient" || key == "MU_KT") blocks.emplace_back();
    if (key.empty() || blocks.empty()) {
      ADD_FAILURE() << "no option: " << line;
      continue;
    }
    EXPECT_TRUE(blocks.back().emplace(key, value).second) << key << " twice";
  }
  std::erase_if(blocks, [&](const auto& block) { return block.count(first) == 0; });
  return blocks;
}

TEST(MoorDynFormat, has_the_residual_as_friction_and_the_peak_over_it)
{
  const Design design = made_design();
  const ExportFiles files = moordyn_files(design);
  ASSERT_EQ(files.size(), 3u);
  EXPECT_EQ(files[1].name, "springs_best.txt");
  const std::string& text = files[1].text;
  const auto C = blocks_of(text, "FrictionCoefficient"), F = blocks_of(text, "MU_KT");
  ASSERT_EQ(C.size(), 2u);
  ASSERT_EQ(F.size(), 2u);
  EXPECT_EQ(C[0].at("FrictionCoefficient"), 0.5);
  EXPECT_EQ(C[0].at("StatDynFricScale"), 1.6);
  EXPECT_EQ(F[0].at("MU_KT"), 0.5);
  EXPECT_EQ(F[0].at("MC"), 1.6);
  EXPECT_EQ(F[0].at("MU_KA"), 0.24);
  // V over w of the push, as the unloading has no stiffness, over D.
  for (const auto& block : {C[0], F[0]}) EXPECT_NEAR(block.at("kBot"), 2000 / 0.1 / 0.5, 0.1);
  EXPECT_EQ(C[1].at("FrictionCoefficient"), 0.8) << "of a travel that ends against a berm, its breakout";
  EXPECT_EQ(C[1].at("StatDynFricScale"), 1);
  for (const char* words : {"Not run in MoorDyn", "stage unload is not written: V fell", "sweep_1,"})
    EXPECT_NE(text.find(words), std::string::npos) << words << " in " << text;
}

TEST(MoorDynFormat, says_which_H_stands_for_a_residual_that_is_not_known)
{
  Springs s = made_springs();
  s.lateral[1].breaks = false;
  s.lateral[1].berm = nan;
  s.lateral[0].residual = nan;
  s.lateral[0].largest = 900, s.lateral[0].u_largest = 0.5;
  const std::string text = moordyn_files(made_design(s))[1].text;
  EXPECT_NE(text.find("H at breakout divided by V: it has no residual"), std::string::npos) << text;
  EXPECT_NE(text.find("largest H divided by V: it has no residual"), std::string::npos) << text;
  const std::string origin = origin_of(s, s.lateral[0]);
  EXPECT_NE(origin.find("largest H 900 N/m at u = 0.5 m, after its first peak"), std::string::npos) << origin;
}

}  // namespace
}  // namespace berm::springs::this_file
