// SPDX-License-Identifier: BSD-3-Clause
#include "cyclic/cyclic_report.hpp"
#include "sample_contours.hpp"
#include "samples/temporary_folder.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace berm::cyclic::this_file {
namespace {

/// Three parcels across a pipe in a clay, at 0.25 s_u of average stress: N_eq = 25.5 and 1.055 s_u by hand (storm_test.cpp).
CyclicResults results(const TemporaryFolder& folder)
{
  CyclicResults all;
  all.settings = read_cyclic_case(std::filesystem::path(BERM_SOURCE_DIR) / "examples/storm_strength/case.toml");
  all.input = "# the <input>\n";
  all.strength = strength_in(all.settings.diagram, all.settings.parcels(), all.settings.failure);
  write_results(all, folder / "out");
  return all;
}

TEST(CyclicReport, has_the_clay_with_its_strength_multiplied_and_its_stiffness_as_it_was)
{
  const TemporaryFolder folder;
  const CyclicResults all = results(folder);
  folder.write("contours.csv", "shear_strain,average_stress_ratio,cycles,cyclic_stress_ratio\n0.1,0,1,1\n0.1,0,2,1\n");
  folder.write("pasted.toml", material_toml(all) + "[contours]\ntable = \"contours.csv\"\n[storm]\ncycles = [1]\nload = [1]\n");
  const material::Material &before = all.settings.material.front().second,
                           after = read_cyclic_case(folder / "pasted.toml").material.front().second;
  EXPECT_NEAR(all.factor(), 1.0551, 1e-4);
  EXPECT_NEAR(material::strength_at_rest(after)->cohesion, 3000 * all.factor(), 1e-9);
  EXPECT_NEAR(material::strength_at_rest(after)->cohesion_gradient, 1500 * all.factor(), 1e-9);
  EXPECT_NEAR(material::young_poisson(after).young_modulus / material::young_poisson(before).young_modulus, 1, 1e-12);
  EXPECT_NE(material_toml(all).find("rate_parameter = 0 "), std::string::npos) << "the contours have the rate in them";
}

TEST(CyclicReport, leaves_all_its_files)
{
  const TemporaryFolder folder;
  const CyclicResults all = results(folder);
  for (const char* file : {"case.toml", "parcels.csv", "cyclic.html", "material.toml", "summary.json", "contours.png"})
    EXPECT_TRUE(std::filesystem::exists(folder / "out" / file)) << file;
  const nlohmann::json quantities = nlohmann::json::parse(folder.read("out/summary.json"))["quantities"];
  EXPECT_NEAR(double(quantities["strength_factor"]["value"]), 1.0551, 1e-4);
  EXPECT_NEAR(double(quantities["equivalent_cycles"]["value"]), 25.5, 0.1);
  EXPECT_NEAR(double(quantities["load_multiplier"]["value"]), 0.8051 / 0.6, 2e-4);
  const std::string csv = folder.read("out/parcels.csv"), page = folder.read("out/cyclic.html");
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 1 + 2 * 3);
  EXPECT_NE(csv.find("\nto failure,3,12,0.8051,13.53,25.53,0.15\n"), std::string::npos) << csv;
  for (const char* words : {"N_eq = 25.5 cycles", "= 1.055 s_u", "data:image/png;base64,", "# the &lt;input&gt;", "[material.clay]"})
    EXPECT_NE(page.find(words), std::string::npos) << words;
}

TEST(CyclicReport, says_in_words_what_the_storm_does)
{
  const TemporaryFolder folder;
  CyclicResults all = results(folder);
  const std::string words = words_of_results(all);
  EXPECT_NE(words.find("The storm as given ends at 11.2 % shear strain, equivalent to 25.5 cycles of its largest load."), std::string::npos)
      << words;
  EXPECT_NE(words.find("With its cyclic loads times 1.342 it just reaches 15 % shear strain"), std::string::npos) << words;
  EXPECT_NE(words.find("The table has one contour"), std::string::npos);
  for (Real& load : all.settings.storm.load) load *= 1.4;
  all.strength = strength_in(all.settings.diagram, all.settings.parcels(), all.settings.failure);
  EXPECT_NE(words_of_results(all).find("Under the storm as given the clay fails in parcel 3."), std::string::npos);
}

}  // namespace
}  // namespace berm::cyclic::this_file
