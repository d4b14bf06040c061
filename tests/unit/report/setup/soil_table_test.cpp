// SPDX-License-Identifier: BSD-3-Clause
#include "report/setup/setup_section.hpp"

#include "samples/pipe_case.hpp"

#include <gtest/gtest.h>

namespace berm::report::this_file {
namespace {

record::RunRecord run_of(const std::string& name, const std::vector<std::string>& changes)
{
  record::RunRecord run;
  run.name = name;
  run.settings = sample_case(changes);
  return run;
}

/// The rows between the table's head and its end, without tags but with | for cells.
std::string plain(const std::string& html)
{
  std::string text;
  bool tag = false;
  for (const char c : html.substr(html.find("<tbody>"), html.find("</tbody>") - html.find("<tbody>"))) {
    if (c == '<')
      tag = true, text += text.empty() || text.back() == '|' || text.back() == '\n' ? "" : "|";
    else if (c == '>')
      tag = false;
    else if (!tag)
      text += c;
  }
  return text;
}

const std::vector<std::string> clay = {"material.sand.friction_angle=0", "material.sand.cohesion=2 kPa"};

std::vector<std::string> with(std::vector<std::string> changes, const std::vector<std::string>& more)
{
  changes.insert(changes.end(), more.begin(), more.end());
  return changes;
}

TEST(soil_over_depth, of_one_material_everywhere_is_left_out)
{
  EXPECT_EQ(soil_over_depth({run_of("a", clay)}), "");
}

TEST(soil_over_depth, of_a_strength_that_grows_is_one_row_to_the_bottom_of_the_bed)
{
  const std::string text = plain(soil_over_depth({run_of("a", with(clay, {"material.sand.cohesion_gradient=50 kPa/m"}))}));
  // 2 kPa + 50 kPa/m x 0.14 m = 9 kPa.
  EXPECT_NE(text.find("0 mm to 140 mm|sand|2 kPa to 9 kPa|0°|7 MPa|877 kg/m³"), std::string::npos) << text;
}

TEST(soil_over_depth, of_a_profile_has_a_row_between_its_entries)
{
  const std::string profile = "material.sand.profile={depth=[\"0 mm\", \"40 mm\", \"100 mm\"], cohesion=[\"1 kPa\", \"3 kPa\", \"4 kPa\"]}";
  const std::string text = plain(soil_over_depth({run_of("a", {"material.sand.friction_angle=0", profile})}));
  for (const char* row : {"0 mm to 40 mm|sand|1 kPa to 3 kPa|", "40 mm to 100 mm|sand|3 kPa to 4 kPa|", "100 mm to 140 mm|sand|4 kPa|"})
    EXPECT_NE(text.find(row), std::string::npos) << row << " in " << text;
}

TEST(soil_over_depth, of_regions_has_their_materials_and_runs_of_one_soil_stand_together)
{
  const std::vector<std::string> regions = with(
      clay, {"material.stiff={law=\"mohr_coulomb\", density=\"877 kg/m^3\", young_modulus=\"9 MPa\", poisson_ratio=0.25, friction_angle=0, "
             "cohesion=\"8 kPa\"}",
             "body.sand.region_material={near=\"stiff\"}"});
  const std::string text = plain(soil_over_depth({run_of("a", regions), run_of("b", regions), run_of("c", clay)}));
  EXPECT_NE(text.find("a, b: body sand|"), std::string::npos) << text;
  EXPECT_NE(text.find("a, b: body sand, region near|"), std::string::npos) << text;
  EXPECT_NE(text.find("|stiff|8 kPa|"), std::string::npos) << text;
}

}  // namespace
}  // namespace berm::report::this_file
