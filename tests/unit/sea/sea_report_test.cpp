// SPDX-License-Identifier: BSD-3-Clause
#include "sample_sea.hpp"
#include "samples/temporary_folder.hpp"
#include "sea/sea_report.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace berm::sea::this_file {
namespace {

TEST(SeaReport, leaves_all_its_files)
{
  const TemporaryFolder folder;
  SeaResults results{.settings = sample_sea(), .input = "# the <input>\n", .answer = {}, .moved = {}};
  results.settings.record.seeds = 2;
  results.answer = answer_of(results.settings);
  write_results(results, folder / "out");
  for (const char* file : {"case.toml", "stage.toml", "storm.toml", "record_1.csv", "record_2.csv", "waves_1.csv", "waves_2.csv",
                           "sea.html", "summary.json", "spectrum.png", "waves.png"})
    EXPECT_TRUE(std::filesystem::exists(folder / "out" / file)) << file;
  const nlohmann::json quantities = nlohmann::json::parse(folder.read("out/summary.json"))["quantities"];
  EXPECT_NEAR(double(quantities["significant_velocity"]["value"]), 0.6698, 5e-4);
  EXPECT_EQ(quantities["peak_vertical_load"]["source"], "DNV-RP-F109");
  const std::string page = folder.read("out/sea.html"), record = folder.read("out/record_1.csv");
  EXPECT_NE(page.find("# the &lt;input&gt;"), std::string::npos);
  EXPECT_EQ(record.rfind("time_s,H_N_m,V_N_m\n0,", 0), 0u) << record.substr(0, 60);
  EXPECT_NE(folder.read("out/stage.toml").find("load_history = \"waves_1.csv\""), std::string::npos);
  EXPECT_EQ(folder.read("out/waves_1.csv").rfind("time_s,water_m_s\n0,0\n", 0), 0u);
  EXPECT_NE(folder.read("out/stage.toml").find("weight = \"400 N/m\"\npermeable = true"), std::string::npos);
  EXPECT_NE(words_of_results(results).find("absolute lateral stability"), std::string::npos);

  results.settings.record.seeds = 1;
  results.answer = answer_of(results.settings);
  write_results(results, folder / "out");
  EXPECT_FALSE(std::filesystem::exists(folder / "out/record_2.csv")) << "of an earlier input";
}

}  // namespace
}  // namespace berm::sea::this_file
