// SPDX-License-Identifier: BSD-3-Clause
#include "cpt/cpt_report.hpp"
#include "io/atomic_file.hpp"
#include "samples/temporary_folder.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace berm::cpt::this_file {
namespace {

/// Clay to 2.05 m, then sand.
CptResults clay_over_sand(TemporaryFolder& folder)
{
  std::string csv = "depth_cm,q_t_MPa,f_s_kPa\n";
  for (int i = 1; i <= 40; ++i) csv += std::to_string(10 * i) + (i <= 20 ? ",0.3,12\n" : ",10,50\n");
  CptResults results{site::read_sounding(folder.write("trial.csv", csv), ""), {}, {}};
  results.profile = profile_of(results.sounding, results.choice);
  return results;
}

TEST(CptReport, writes_what_it_found)
{
  TemporaryFolder folder;
  const CptResults results = clay_over_sand(folder);
  write_results(results, folder.path() / "out");
  const auto summary = nlohmann::json::parse(io::read_text_file(folder.path() / "out" / "summary.json"));
  ASSERT_EQ(summary["layers"].size(), results.profile.layers.size());
  EXPECT_EQ(summary["layers"].back()["base_m"], 4.0);
  EXPECT_NEAR(summary["layers"].back()["q_t_MPa"]["mean"].get<Real>(), 10, 1e-9);
  EXPECT_TRUE(summary["layers"].back()["undrained_strength_kPa"]["mean"].is_null());
  const std::string profile = io::read_text_file(folder.path() / "out" / "profile.csv");
  EXPECT_EQ(std::count(profile.begin(), profile.end(), '\n'), 41);
  EXPECT_TRUE(profile.starts_with("depth_m,q_t_MPa,f_s_kPa,u_2_kPa,B_q,Q_tn,F_r_percent,I_c,unit_weight_kN_m3,"));
  EXPECT_NE(io::read_text_file(folder.path() / "out" / page_file).find("To paste into a case"), std::string::npos);
}

TEST(CptReport, gives_materials_of_the_layers)
{
  TemporaryFolder folder;
  const CptResults results = clay_over_sand(folder);
  const std::string toml = layers_toml(results);
  EXPECT_NE(toml.find("{ top = \"2.05 m\", material = \"layer_"), std::string::npos);
  EXPECT_NE(toml.find("friction_angle = \"0 deg\"\ncohesion = \""), std::string::npos);
  EXPECT_NE(words_of_results(results).find("    2.05    4.00"), std::string::npos);
}

}  // namespace
}  // namespace berm::cpt::this_file
