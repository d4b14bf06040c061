// SPDX-License-Identifier: BSD-3-Clause
#include "sample_fits.hpp"
#include "samples/error_of.hpp"
#include "samples/temporary_folder.hpp"
#include "soil_fit/fit_report.hpp"
#include "soil_fit/passages.hpp"
#include "soil_fit/usual_fit.hpp"

#include <gtest/gtest.h>

namespace berm::soil_fit::this_file {
namespace {

constexpr const char* clay =
    "[material.clay]\nlaw = \"clay\"\ndensity = 600\nrigidity_index = 100\npoisson_ratio = 0.49\nundrained_strength = \"8 "
    "kPa\"\nsensitivity = 3\nductility = 15\n";
constexpr const char* free_keys =
    "[[free]]\nkey = \"undrained_strength\"\nfrom = \"1 kPa\"\nto = \"100 kPa\"\n[[free]]\nkey = \"sensitivity\"\nfrom = 1.5\nto = 50\n"
    "[[free]]\nkey = \"ductility\"\nfrom = 2\nto = 100\n";
constexpr const char* bar = "[[measured]]\nname = \"site\"\nfile = \"tests.csv\"\nkind = \"t_bar\"\ndiameter = \"40 mm\"\n";

/// Strokes over the 0.5 m below `top`, rows each 10 mm, of which the first begins at `from`: the resistance of each, reached within two rows of its beginning, and a shift; kPa.
std::string rows_of(const std::vector<Real>& strokes, Real top = 2, Real shift = 0, Real from = 0)
{
  std::string rows;
  for (std::size_t k = 0; k < strokes.size(); ++k) {
    const bool down = k % 2 == 0;
    const Real begin = k == 0 ? from : down ? top : top + 0.5, end = down ? top + 0.5 : top;
    const int count = static_cast<int>(std::lround(std::abs(end - begin) / 0.01));
    for (int n = 0; n <= count; ++n)
      rows +=
          fmt::format("{:.4f},{:.6f}\n", begin + (end - begin) * n / count, (down ? 1 : -1) * std::min(1., n / 2.) * strokes[k] + shift);
  }
  return rows;
}

/// s_u = 10 kPa, sensitivity 5, ductility 20, N = 10.5, xi_T = 3.7.
std::vector<Real> strokes(int count)
{
  std::vector<Real> all;
  for (int k = 1; k <= count; ++k) all.push_back(105 * (0.2 + 0.8 * std::exp(-3 * (k - 0.5) * 3.7 / 20)));
  return all;
}

class PenetrometerTests : public testing::Test {
protected:
  FitCase fit_case(const std::string& rows, const std::string& more = "", const std::string& headings = "depth (m),resistance (kPa)\n")
  {
    folder_.write("tests.csv", headings + rows);
    return read_fit_text("case.toml", std::string("starts = 1\n") + clay + free_keys + tool_ + more, folder_.path());
  }
  FittedSoil fit(const std::string& rows, const std::string& more = "", const std::string& headings = "depth (m),resistance (kPa)\n")
  {
    const FitCase c = fit_case(rows, more, headings);
    return fit_soil(c, read_measured(c));
  }
  /// Without the folder.
  std::string fault(const std::string& rows, const std::string& more = "", const std::string& headings = "depth (m),resistance (kPa)\n")
  {
    std::string error = test::error_of<InputError>([&] { read_measured(fit_case(rows, more, headings)); });
    const std::string path = folder_.path().string() + "/";
    for (std::size_t at = error.find(path); at != std::string::npos; at = error.find(path)) error.erase(at, path.size());
    return error;
  }

  std::string tool_ = bar;
  TemporaryFolder folder_;
};

// The law that made the passages is found where the search ends, to the six digits of the rows.
TEST_F(PenetrometerTests, give_strength_sensitivity_and_ductility)
{
  const FittedSoil soil = fit(rows_of(strokes(12)));
  ASSERT_EQ(soil.tests.size(), 1u);
  EXPECT_EQ(soil.tests[0].measured.rows(), 12u);
  EXPECT_NEAR(soil.tests[0].measured.passages->depth, 2.25, 1e-6);
  EXPECT_NEAR(soil.keys[0].value, 10e3, 0.01 * 10e3);
  EXPECT_NEAR(soil.keys[1].value, 5, 0.01 * 5);
  EXPECT_NEAR(soil.keys[2].value, 20, 0.01 * 20);
  EXPECT_TRUE(doubts(soil).empty()) << doubts(soil).front();
}

// A force over an area, mm, a ball, and other headings are the same test; the ductility goes with xi_T, the strength with 1/N.
TEST_F(PenetrometerTests, may_have_other_units_and_tools)
{
  std::string rows;
  std::istringstream lines(rows_of(strokes(12)));
  for (std::string line; std::getline(lines, line);) {
    const std::size_t comma = line.find(',');
    rows += fmt::format("{:.1f};{:.5f}\n", 1e3 * std::stod(line.substr(0, comma)), std::stod(line.substr(comma + 1)) * 0.01);
  }
  const FittedSoil soil =
      fit(rows, "area = \"100 cm^2\"\nresistance_factor = 21\npassage_strain = 1.85\n[measured.columns]\nforce = \"load\"\n",
          "depth_mm;load [kN]\n");
  EXPECT_NEAR(soil.keys[0].value, 5e3, 0.01 * 5e3);
  EXPECT_NEAR(soil.keys[1].value, 5, 0.01 * 5);
  EXPECT_NEAR(soil.keys[2].value, 10, 0.01 * 10);
}

// As the law itself: sensitivity, ductility and rate apart.
TEST_F(PenetrometerTests, follow_the_law_of_clay)
{
  const FitCase c = fit_case(rows_of(strokes(6)));
  MeasuredTest test = read_measured(c).front();
  test.settings.strain_rate = 3.17e-4;
  const material::Material law = material_with(
      c, {{"undrained_strength", 10e3}, {"sensitivity", 5}, {"ductility", 20}, {"rate_parameter", 0.1}, {"reference_rate", 3.17e-6}});
  const std::vector<Real> computed = resistances(test, law);
  for (std::size_t k = 0; k < 6; ++k) EXPECT_NEAR(computed[k], 1.2 * 1e3 * strokes(6)[k], 1e-6 * computed[k]) << "two decades: a fifth";
}

TEST_F(PenetrometerTests, at_several_depths_are_as_many_tests)
{
  const FitCase c = fit_case(rows_of(strokes(6)) + rows_of(strokes(8), 4, 0, 2), "held_out = [\"site\"]\n");
  const LaboratoryTable table(c.folder / "tests.csv", c.measured[0]);
  const std::vector<MeasuredTest> found = passages_of(c.measured[0], table, "site", table.tests()[0].second);
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(found[0].name, "site 2.25 m");
  EXPECT_EQ(found[1].name, "site 4.25 m");
  EXPECT_EQ(found[0].rows(), 7u) << "the penetration that goes on passes here, too";
  EXPECT_EQ(found[1].rows(), 8u);
}

TEST_F(PenetrometerTests, that_cannot_be_are_refused)
{
  const std::string good = rows_of(strokes(8));
  EXPECT_EQ(
      fault(rows_of(strokes(1))),
      "tests.csv:2: from 0 to 2.5 m the tool passes no depth more often than once: remoulding takes 6 passages, three cycles down and "
      "up, or more");
  EXPECT_EQ(fault(rows_of(strokes(2))),
            "tests.csv:2: from 0 to 2.5 m the tool passes no depth more often than 2 times: remoulding takes 6 passages, three cycles down "
            "and up, or more");
  EXPECT_EQ(fault(good, "", "depth,resistance (kPa)\n"),
            "tests.csv: the column \"depth\" has no unit: measured.site.columns = {depth = \"depth (m)\"}");
  EXPECT_EQ(fault(good, "", "depth (km),resistance (kPa)\n").rfind("tests.csv:", 0), 0u);
  EXPECT_NE(fault(good, "", "depth (km),resistance (kPa)\n").find("deeper below the seabed than any such test: is its unit right?"),
            std::string::npos);
  EXPECT_NE(fault(good, "", "depth (kPa),resistance (kPa)\n").find("\"kPa\" is not a unit of it: m, cm or mm"), std::string::npos);
  EXPECT_NE(fault(good, "", "depth (m),resistance (GPa)\n").find("is not the resistance of clay: is its unit right?"), std::string::npos);
  EXPECT_NE(fault(good, "", "depth (m),tip (kPa)\n").find("no column is resistance (resistance of the tool, down positive), or force"),
            std::string::npos);
  EXPECT_NE(
      fault(good, "", "depth (m),force (kN)\n").find("is a force, and needs an area, diameter times length of the bar: measured.site.area"),
      std::string::npos);
  EXPECT_NE(fault(good, "zero_shift = \"-200 kPa\"\n")
                .find("the resistance of the first extraction is 142.5 kPa on average: it is positive down, and negative where the tool is "
                      "pulled up"),
            std::string::npos)
      << fault(good, "zero_shift = \"-200 kPa\"\n");
  std::string up;
  std::istringstream lines(good);
  for (std::string line; std::getline(lines, line);) up += "-" + line + "\n";
  EXPECT_NE(fault(up).find("it is positive below the seabed"), std::string::npos) << fault(up);
  EXPECT_NE(fault(good, "specimen = {density = \"rho\"}\n").find("is of laboratory tests"), std::string::npos);
  folder_.write("tests.csv", "");
  const std::string sand = std::string("[material.sand]\nlaw = \"mohr_coulomb\"\ndensity = 1000\nyoung_modulus = 2e7\npoisson_ratio = "
                                       "0.3\nfriction_angle = 0.5\n[[free]]\nkey = \"friction_angle\"\nfrom = 0.3\nto = 0.7\n") +
                           bar;
  EXPECT_NE(test::error_of<InputError>([&] { read_fit_text("case.toml", sand, "."); }).find("is a test of clay that softens"),
            std::string::npos);
}

TEST_F(PenetrometerTests, say_what_is_doubtful)
{
  const auto has = [](const std::vector<std::string>& all, const std::string& what) {
    return std::any_of(all.begin(), all.end(), [&](const std::string& doubt) { return doubt.find(what) != std::string::npos; });
  };
  const std::vector<std::string> shifted = doubts(fit(rows_of(strokes(20), 2, 3)));
  EXPECT_TRUE(has(shifted, "was not subtracted, zero_shift = \"3 kPa\"")) << (shifted.empty() ? "" : shifted[0]);
  EXPECT_FALSE(has(doubts(fit(rows_of(strokes(20), 2, 3), "zero_shift = \"3 kPa\"\n")), "zero"));
  EXPECT_TRUE(has(doubts(fit(rows_of(strokes(6)))), "would lose another"));
  EXPECT_FALSE(has(doubts(fit(rows_of(strokes(12)))), "would lose another"));
  tool_.replace(tool_.find("40 mm"), 5, "150 mm");
  const std::vector<std::string> wide = doubts(fit(rows_of(strokes(12), 0.)));
  EXPECT_TRUE(has(wide, "1.7 diameters below the seabed clay does not flow around the tool"));
  EXPECT_TRUE(has(wide, "the interval is 3.3 diameters"));
}

TEST_F(PenetrometerTests, have_pages_with_each_passage)
{
  FitResults results{fit_case(rows_of(strokes(12))), "# the input\n", {}, 1};
  results.soil = fit_soil(results.settings, read_measured(results.settings));
  write_results(results, folder_ / "out");
  EXPECT_TRUE(std::filesystem::exists(folder_ / "out/t_bar_resistance.png"));
  EXPECT_NE(folder_.read("out/fit.html").find("q_k / q_1"), std::string::npos);
  EXPECT_NE(folder_.read("out/curves.csv").find("site,1,resistance,12,"), std::string::npos);
  EXPECT_NE(folder_.read("out/material.toml").find("sensitivity = 5"), std::string::npos) << folder_.read("out/material.toml");
}

TEST_F(PenetrometerTests, of_a_law_and_a_file_have_usual_numbers)
{
  folder_.write("tests.csv", "depth (m),resistance (kPa)\n" + rows_of(strokes(12)));
  const UsualFit request{.law = "clay", .files = {folder_ / "tests.csv"}, .kind = "t_bar", .diameter = "40 mm"};
  const FitCase c = read_fit_text("case.toml", usual_fit(request), folder_.path());
  const FittedSoil soil = fit_soil(c, read_measured(c));
  EXPECT_NEAR(soil.keys[1].value, 5, 0.01 * 5);
  UsualFit other = request;
  other.law = "norsand";
  EXPECT_EQ(test::error_of<InputError>([&] { usual_fit(other); }),
            "t_bar is a test of clay that softens: berm fit clay TEST.csv --kind t_bar");
  other = request, other.diameter = "";
  EXPECT_NE(test::error_of<InputError>([&] { usual_fit(other); }).find("--diameter is needed"), std::string::npos);
  other = request, other.kind = "triaxial";
  EXPECT_NE(test::error_of<InputError>([&] { usual_fit(other); }).find("--diameter is that of a penetrometer"), std::string::npos);
}

}  // namespace
}  // namespace berm::soil_fit::this_file
