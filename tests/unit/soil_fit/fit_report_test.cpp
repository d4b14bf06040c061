// SPDX-License-Identifier: BSD-3-Clause
#include "sample_fits.hpp"
#include "samples/program.hpp"
#include "samples/temporary_folder.hpp"
#include "soil_fit/fit_report.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace berm::soil_fit::this_file {
namespace {

/// NorSand from two tests, one of them held out, that it meets.
FitResults results()
{
  const SampleLaw& law = sample_laws()[2];
  FitResults all{fit_of(law), "# the input\n", {}, 1};
  std::vector<MeasuredTest> tests = {test_from(all.settings, law, 100e3), test_from(all.settings, law, 300e3)};
  tests[0].specimen["void_ratio"] = 0.72;
  tests[1].held_out = true;
  all.soil = fit_soil(all.settings, tests);
  return all;
}

TEST(FitReport, has_soil_to_paste_and_a_sample_for_a_study)
{
  const FitResults all = results();
  const std::string toml = material_toml(all);
  for (const char* line :
       {"[material.soil]\n", "law = \"norsand\"\n", "void_ratio = 0.72   # each specimen had its own: give that of the site\n"})
    EXPECT_NE(toml.find(line), std::string::npos) << line << " is not in\n" << toml;
  EXPECT_NE(toml.find("critical_friction_angle = \"33"), std::string::npos) << toml;
  EXPECT_NEAR(value_in(read_fit_text("pasted.toml",
                                     toml + "[[free]]\nkey = \"dilatancy\"\nfrom = 1\nto = 9\n[[measured]]\nname = \"a\"\nfile = "
                                            "\"a\"\nkind = \"triaxial\"\ndrained = true\n",
                                     "."),
                       {"dilatancy", 1, 9, "1"}),
              3.8, 0.04);
}

TEST(FitReport, leaves_all_its_files)
{
  TemporaryFolder folder;
  const FitResults all = results();
  write_results(all, folder.path());
  EXPECT_TRUE(holds_results(folder.path()));
  for (const char* file : {"case.toml", "curves.csv", "fit.html", "material.toml", "priors.toml", "summary.json", "triaxial_drained_q.png",
                           "triaxial_drained_volumetric_strain.png"})
    EXPECT_TRUE(std::filesystem::exists(folder / file)) << file;
  const nlohmann::json summary = nlohmann::json::parse(text_of_file(folder / "summary.json"));
  EXPECT_NEAR(double(summary["quantities"]["dilatancy"]["value"]), 3.8, 0.04);
  EXPECT_EQ(summary["correlation"]["dilatancy"]["dilatancy"], 1);
  EXPECT_LT(double(summary["quantities"]["held_out.rms.friction_angle_peak"]["value"]), 0.01);
  const std::string csv = folder.read("curves.csv");
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 1 + 4 * static_cast<int>(logged_strains().size()));
  EXPECT_NE(csv.find("test_300,0,q,"), std::string::npos) << "held out";
  const std::string words = words_of_results(all);
  EXPECT_NE(words.find("root mean square over held-out tests: phi, peak"), std::string::npos) << words;
}

}  // namespace
}  // namespace berm::soil_fit::this_file
