// SPDX-License-Identifier: BSD-3-Clause
#include "input/write_case.hpp"
#include "report/setup/setup_section.hpp"
#include "samples/pipe_case.hpp"

#include <algorithm>
#include <gtest/gtest.h>
#include <sstream>

namespace berm::report::this_file {
namespace {

const ParameterEntry& entry_of(const std::vector<ParameterEntry>& all, const std::string& path)
{
  static const ParameterEntry none{"", "", "", ""};
  const auto found = std::find_if(all.begin(), all.end(), [&](const ParameterEntry& entry) { return entry.path == path; });
  return found == all.end() ? none : *found;
}

TEST(model_table, water_that_flows_is_told_with_its_permeability_and_where_it_is_stopped)
{
  const std::string html = compact_table({sample_record(sample_case_in_water(), "a")}).html();
  for (const char* words : {"flows (consolidation)", "1e-05 m/s", "porosity n", "does not cross it"})
    EXPECT_TRUE(contains(html, words)) << words;
  EXPECT_FALSE(contains(compact_table({sample_record(sample_case(), "a")}).html(), "water"));
}

TEST(model_table, supports_that_move_and_water_outside_are_told)
{
  settings::Case c = sample_case_in_water();
  boundary::SupportSettings& base = c.support.front().second;
  base.motion.emplace();
  base.motion->stages = {c.stage.back().name};
  base.motion->velocity[0] = {0, 1};
  base.head = 0.5;
  const std::string html = compact_table({sample_record(c, "a")}).html();
  for (const std::string& words :
       {"moves along x in " + c.stage.back().name, std::string("head of the water outside"), std::string("above the still sea")})
    EXPECT_TRUE(contains(html, words.c_str())) << words;
}

TEST(parameters, every_key_of_the_resolved_case_is_there_once)
{
  const settings::Case c = sample_case();
  std::vector<std::string> paths;
  for (const ParameterEntry& entry : parameters_of(c)) paths.push_back(entry.path);
  std::vector<std::string> sorted = paths;
  std::sort(sorted.begin(), sorted.end());
  EXPECT_EQ(std::adjacent_find(sorted.begin(), sorted.end()), sorted.end());
  // resolved.toml has a line for each; its other lines are tables, blank, or the remark at the top.
  std::istringstream lines(input::resolved_toml(c));
  std::size_t count = 0;
  std::string line;
  std::getline(lines, line);
  while (std::getline(lines, line))
    if (!line.empty() && line[0] != '[') ++count;
  EXPECT_EQ(paths.size(), count);
}

TEST(parameters, paths_are_those_of_set)
{
  const std::vector<ParameterEntry> all = parameters_of(sample_case());
  EXPECT_EQ(entry_of(all, "material.sand.young_modulus").value, "7000000");
  EXPECT_EQ(entry_of(all, "material.sand.young_modulus").unit, "Pa");
  EXPECT_EQ(entry_of(all, "material.sand.young_modulus").meaning, "Young's modulus");
  EXPECT_EQ(entry_of(all, "stage.push.until.embedment").value, "0.002");
  EXPECT_EQ(entry_of(all, "stage.push.until.force").value, "not set");
  EXPECT_EQ(entry_of(all, "gravity").value, "0, -490.3325");
  EXPECT_EQ(entry_of(all, "mpm.volumetric_projection").value, "yes");
  EXPECT_EQ(entry_of(all, "body.sand.regions").value, "near, bed, layer");
}

TEST(parameters, angles_are_told_in_degrees_too)
{
  const ParameterEntry angle = entry_of(parameters_of(sample_case()), "material.sand.friction_angle");
  EXPECT_EQ(angle.value, "0.610865238 (35°)");
  EXPECT_EQ(angle.unit, "rad");
}

TEST(parameters, rows_in_which_runs_differ_are_marked)
{
  const std::string html =
      parameter_columns({sample_record(sample_case(), "a"), sample_record(sample_case({"mesh.near_size=2 mm"}), "b")}).html();
  EXPECT_TRUE(contains(html, "<tr class=\"differs\"><th scope=\"row\"><code>mesh.near_size</code></th><td class=\"number\">0.001</td>"
                             "<td class=\"number\">0.002</td><td>m</td>"))
      << html;
  EXPECT_TRUE(contains(html, "<tr><th scope=\"row\"><code>mesh.length</code></th>"));
}

TEST(parameters, those_of_one_run_only_stand_behind_their_neighbour)
{
  const std::string more = "[material.clay]\nlaw = \"linear_elastic\"\ndensity = 1\nyoung_modulus = 1\npoisson_ratio = 0\n";
  const std::string html = parameter_columns({sample_record(sample_case(), "a"), sample_record(sample_case({}, more), "b")}).html();
  const std::size_t sand = html.find("material.sand.density"), clay = html.find("material.clay.density"),
                    body = html.find("body.sand.material");
  EXPECT_LT(sand, clay);
  EXPECT_LT(clay, body);
  EXPECT_TRUE(contains(html, "<code>material.clay.density</code></th><td class=\"number\">–</td><td class=\"number\">1</td>")) << html;
}

TEST(asked, the_place_of_a_trench_and_of_a_step_is_in_the_table)
{
  const std::string trench =
      compact_table({sample_record(sample_case({"mesh.trench={depth=0.01, width=0.06, side_slope=0.5, center=0.004}"}), "a")}).html();
  EXPECT_TRUE(contains(trench, "trench: x of its centre")) << trench;
  EXPECT_TRUE(contains(trench, "4 mm")) << trench;
  const std::string step =
      compact_table({sample_record(sample_case({"mesh.step={height=0.01, position=0.037, face_slope=0.5}"}), "a")}).html();
  EXPECT_TRUE(contains(step, "step: x where its face begins")) << step;
  EXPECT_TRUE(contains(step, "37 mm")) << step;
}

TEST(asked, runs_that_look_the_same_share_a_drawing)
{
  const auto drawings = [](const std::vector<record::RunRecord>& runs) {
    const std::string html = setup_section(runs);
    int count = 0;
    for (std::size_t at = 0; (at = html.find("<figure", at)) != std::string::npos; ++at) ++count;
    return count;
  };
  const record::RunRecord a = sample_record(sample_case(), "a"), finer = sample_record(sample_case({"mesh.near_size=2 mm"}), "b");
  const record::RunRecord deeper = sample_record(sample_case({"mesh.depth=200 mm"}), "c");
  EXPECT_EQ(drawings({a, finer}), 1);
  EXPECT_EQ(drawings({a, finer, deeper}), 2);
}

TEST(asked, compact_table_has_model_and_prototype)
{
  const std::string html = compact_table({sample_record(sample_case())}).html();
  for (const char* words : {"20 mm (1 m)", "430 kN/m³ (8.6 kN/m³)", "35°", "23.33°", "1 mm = D/20", "650 mm (32.5 m)",
                            "push: 0.1 m/s down, until w = 2 mm (w = 100 mm)", "drag: 0.1 m/s along x, V held, until 20 mm (1 m)"})
    EXPECT_TRUE(contains(html, words)) << words << "\n" << html;
}

TEST(asked, gravity_rounded_to_ten_makes_no_prototype)
{
  const std::string html = compact_table({sample_record(sample_case({"gravity=[0, -10]"}))}).html();
  EXPECT_TRUE(contains(html, "diameter</th><td>20 mm</td>")) << html;
  EXPECT_FALSE(contains(html, "prototype"));
}

TEST(asked, what_older_runs_lack_is_told)
{
  record::RunRecord run = sample_record(sample_case());
  EXPECT_TRUE(contains(computation_table({run}).html(), "machine</th><td>not recorded")) << computation_table({run}).html();
  run.summary->text["machine"] = "a machine";
  EXPECT_TRUE(contains(computation_table({run}).html(), "machine</th><td>a machine"));
  run.summary.reset();
  const std::string html = computation_table({run}).html();
  EXPECT_TRUE(contains(html, "machine</th><td>not recorded"));
  EXPECT_TRUE(contains(html, "particles</th><td>not known"));
}

TEST(asked, names_of_the_user_are_escaped)
{
  const std::string html = setup_section({sample_record(sample_case(), "<script>alert(1)</script>")});
  EXPECT_FALSE(contains(html, "<script>"));
}

}  // namespace
}  // namespace berm::report::this_file
