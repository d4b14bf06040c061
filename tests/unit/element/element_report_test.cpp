// SPDX-License-Identifier: BSD-3-Clause
#include "element/element_report.hpp"
#include "element/element_table.hpp"
#include "os/error.hpp"
#include "run_folder/history.hpp"
#include "run_folder/summary_file.hpp"
#include "sample_tests.hpp"
#include "samples/program.hpp"

#include <gtest/gtest.h>

namespace berm::element::this_file {
namespace {

constexpr const char* input = R"([material.sand]
law = "mohr_coulomb"
density = 1000
young_modulus = 30e6
poisson_ratio = 0.3
friction_angle = "30 deg"

[[test]]
name = "drained"
kind = "triaxial"
material = "sand"
drained = true
confining_stress = 1e5
strain_path = [0.05]
steps = 20

[[test]]
name = "undrained"
kind = "triaxial"
material = "sand"
drained = false
confining_stress = 1e5
strain_path = [0.01, -0.01]
cycles = 2
steps = 10

[[test]]
name = "fails"
kind = "oedometer"
material = "sand"
vertical_stress = 0
k0 = 0
stress_path = [1e6, 1e9]
steps = 4
)";

ElementResults results_in(const TemporaryFolder& folder)
{
  folder.write("case.toml", input);
  ElementResults results{folder.path() / "case.toml", read_element_case(folder.path() / "case.toml"), {}, 0.01};
  for (const TestSettings& test : results.settings.test) results.records.push_back(run_test(test, material_of(results.settings, test)));
  return results;
}

TEST(ElementResults, are_rows_with_a_schema_figures_a_summary_and_a_page)
{
  TemporaryFolder folder;
  const ElementResults results = results_in(folder);
  const std::filesystem::path out = folder.path() / "out";
  write_results(results, out);
  const run_folder::History rows = run_folder::read_history(out / "undrained" / "element.csv");
  EXPECT_EQ(rows.rows(), 41);
  EXPECT_EQ(rows.stage[1], "cycle 1 leg 1");
  EXPECT_EQ(rows.stage.back(), "cycle 2 leg 2");
  EXPECT_NEAR(rows["axial_strain"].back(), -0.01, 1e-12);
  EXPECT_EQ(rows["q_Pa"][1], deviator_stress(results.records[1].rows[1]));
  EXPECT_EQ(rows.column("excess_pore_pressure_Pa").unit, "Pa");
  EXPECT_FALSE(run_folder::read_history(out / "drained" / "element.csv").has("excess_pore_pressure_Pa"));

  const std::optional<run_folder::RunSummary> summary = run_folder::read_summary(out);
  ASSERT_TRUE(summary && summary->finished());
  EXPECT_EQ(summary->quantities.front().name, "drained.q_peak");
  EXPECT_NEAR(summary->quantities.front().value, 200e3, 1);
  EXPECT_EQ(summary->checks.at("fails.failed"), 1);
  EXPECT_EQ(summary->checks.at("drained.failed"), 0);
  EXPECT_NE(summary->text.at("fails.failure").find("the specimen failed"), std::string::npos);

  const std::string page = text_of_file(out / "element.html");
  for (const char* part : {"triaxial, drained", "triaxial, undrained", "data:image/png;base64,", "the specimen failed", "q, peak (kPa)"})
    EXPECT_NE(page.find(part), std::string::npos) << part;
  EXPECT_EQ(names_in(out),
            (std::vector<std::string>{"case.toml", "drained/", "element.html", "fails/", "oedometer_compression.png",
                                      "oedometer_stress_path.png", "plots/", "resolved.toml", "summary.json", "triaxial_pore_pressure.png",
                                      "triaxial_stress_path.png", "triaxial_stress_strain.png", "triaxial_volume.png", "undrained/"}));
}

TEST(ElementResults, replace_those_of_earlier_tests_and_nothing_else)
{
  TemporaryFolder folder;
  ElementResults results = results_in(folder);
  const std::filesystem::path out = folder.path() / "out";
  EXPECT_FALSE(holds_results(out));
  write_results(results, out);
  EXPECT_TRUE(holds_results(out));
  folder.write("out/notes.txt", "mine");
  results.records.resize(1);
  write_results(results, out);
  const std::vector<std::string> names = names_in(out);
  for (const char* gone : {"undrained/", "fails/", "oedometer_compression.png", "triaxial_pore_pressure.png"})
    EXPECT_EQ(std::count(names.begin(), names.end(), gone), 0) << gone;
  EXPECT_EQ(std::count(names.begin(), names.end(), "notes.txt"), 1);
}

TEST(ElementResults, are_not_written_over_a_run)
{
  TemporaryFolder folder;
  folder.write("history.csv", "");
  EXPECT_THROW(holds_results(folder.path()), InputError);
}

TEST(ElementResults, resolved_read_back_as_the_same_tests)
{
  TemporaryFolder folder;
  folder.write("own.toml", input);
  folder.write("case.toml",
               std::string("materials_from = \"own_case.toml\"\n") + std::string(input).substr(std::string(input).find("[[test]]")));
  folder.write("own_case.toml", std::string("surface = 0\n") + std::string(input).substr(0, std::string(input).find("[[test]]")));
  const std::string whole = resolved_toml(read_element_case(folder.path() / "case.toml"));
  EXPECT_EQ(whole, resolved_toml(read_element_case(folder.path() / "own.toml"))) << "materials of a case are in it";
  folder.write("again.toml", whole);
  EXPECT_EQ(resolved_toml(read_element_case(folder.path() / "again.toml")), whole);
}

TEST(TriaxialStrength, is_the_line_of_the_triaxial_test)
{
  const Real phi = 30 * pi / 180, c = 2e3, p = 50e3;
  TestRecord record = run_test(test_of(Triaxial{isotropic(1e5)}, {0.01}), sand_of(30, 0, c));
  // q = 6 (p sin phi + c cos phi)/(3 -+ sin phi)
  const Real rise = 6 * (p * std::sin(phi) + c * std::cos(phi));
  EXPECT_NEAR(*triaxial_strength(record, p, Direction::compression), rise / (3 - std::sin(phi)), 1e-6);
  EXPECT_NEAR(*triaxial_strength(record, p, Direction::extension), -rise / (3 + std::sin(phi)), 1e-6);
}

TEST(TestWords, say_kind_drainage_material_and_start)
{
  SimpleShear kind{at_rest(100e3, 0.5)};
  kind.drained = false;
  TestSettings test = test_of(kind, {0.1});
  EXPECT_EQ(words_of_test(run_test(test, sand_of(30, 0))), "simple shear, undrained, sand, from 100 kPa vertically, K0 = 0.5");
}

}  // namespace
}  // namespace berm::element::this_file
