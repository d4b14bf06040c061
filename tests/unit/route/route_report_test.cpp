// SPDX-License-Identifier: BSD-3-Clause
#include "route/route_report.hpp"

#include "run_folder/csv_line.hpp"
#include "sample_route.hpp"
#include "samples/temporary_folder.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace berm::route::this_file {
namespace {

RouteResults sample_results()
{
  RouteResults results{.settings = sample_route(), .input = "[pipe]\n", .answer = {}};
  results.answer = answer_of(results.settings, no_run);
  return results;
}

std::vector<std::vector<std::string>> rows_of(const std::string& text)
{
  std::vector<std::vector<std::string>> rows;
  std::vector<std::string> fields;
  for (std::size_t at = 0; run_folder::next_csv_line(text, at, fields);) rows.push_back(fields);
  return rows;
}

TEST(RouteReport, has_the_springs_by_kp_and_coefficients_for_buckpy)
{
  const TemporaryFolder folder;
  const RouteResults results = sample_results();
  write_results(results, folder.path());
  const auto rows = rows_of(folder.read("springs.csv"));
  ASSERT_EQ(rows.size(), 4u);
  const auto column = [&](const std::string& name) {
    return static_cast<std::size_t>(std::find(rows[0].begin(), rows[0].end(), name) - rows[0].begin());
  };
  EXPECT_EQ(rows[1][1], "4");
  EXPECT_NEAR(std::stod(rows[1][column("axial_breakout (N/m)")]), results.answer[0].soil.axial_breakout.best, 1e-3);
  EXPECT_EQ(rows[3][column("axial_breakout (N/m)")], "") << "buried";
  EXPECT_NEAR(std::stod(rows[3][column("uplift_LE (N/m)")]), 4579.2, 0.1);
  const auto soils = rows_of(folder.read("soils.csv"));
  ASSERT_EQ(soils.size(), 3u) << "no buried section";
  EXPECT_EQ(soils[0], buckpy_columns());
  for (const auto& row : soils) EXPECT_EQ(row.size(), soils[0].size());
  EXPECT_NEAR(std::stod(soils[1][3]), results.answer[0].soil.axial_breakout.best / 900, 1e-5);
  EXPECT_NEAR(std::stod(soils[1][7]), results.answer[0].soil.hydrotest_breakout.best / 1250, 1e-5) << "over the flooded weight";
  EXPECT_EQ(soils[1][5], "LE_BE_HE");
}

TEST(RouteReport, says_where_it_is_worst_and_writes_page_and_summary)
{
  const TemporaryFolder folder;
  write_results(sample_results(), folder.path());
  const auto summary = nlohmann::json::parse(folder.read("summary.json"));
  EXPECT_NEAR(summary["quantities"]["landfall.required_download"]["value"], 1090.6, 0.1);
  const std::string answer = summary["text"]["answer"];
  EXPECT_NE(answer.find("Lateral buckling is possible: utilisation"), std::string::npos) << answer;
  EXPECT_NE(answer.find("No upheaval buckling: utilisation 0.199 at most, in landfall (KP 11.500 to 12.000)"), std::string::npos) << answer;
  const std::string page = folder.read("route.html");
  for (const char* words : {"A hot line", "Hobbs 1984", "Palmer", "DNV-RP-F114", "data:image/png"})
    EXPECT_NE(page.find(words), std::string::npos) << words;
  EXPECT_EQ(page.find("nan"), std::string::npos);
}

}  // namespace
}  // namespace berm::route::this_file
