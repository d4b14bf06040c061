// SPDX-License-Identifier: BSD-3-Clause
#include "output/summary.hpp"

#include "sample_run.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace berm {
namespace {

Summary sample_summary()
{
  Summary summary;
  summary.quantities = {{"V_at_w_0.1D", 764.25, "N/m"}, {"H_max", std::numeric_limits<Real>::quiet_NaN(), "N/m"}};
  summary.timing = {
      .wall_s = 12.5, .threads = 2, .cells = 800, .steps = 5'000'000'000, .counts = MpmCounts{9000}, .loops = {{"move", 1.5, 7}}};
  summary.checks = {{"reached_the_end", true}, {"energy_balance", 0.01}};
  summary.text = {{"title", "a \"pipe\""}, {"berm", "0.1.0"}};
  return summary;
}

TEST(Summary, has_the_form_that_readers_rely_on)
{
  const TemporaryFolder folder;
  sample_summary().write(folder.path / "summary.json");
  const auto json = nlohmann::json::parse(content_of(folder.path / "summary.json"));
  EXPECT_EQ(json["quantities"]["V_at_w_0.1D"]["value"].get<double>(), 764.25);
  EXPECT_EQ(json["quantities"]["V_at_w_0.1D"]["unit"], "N/m");
  EXPECT_EQ(json["timing"]["particle_steps_per_s"].get<double>(), 3.6e12);
  EXPECT_EQ(json["timing"]["particles"].get<int>(), 9000);
  EXPECT_EQ(json["timing"]["wall_s"].get<double>(), 12.5);
  EXPECT_EQ(json["timing"]["threads"].get<int>(), 2);
  EXPECT_EQ(json["timing"]["steps"].get<std::int64_t>(), 5'000'000'000);
  EXPECT_DOUBLE_EQ(json["timing"]["seconds_per_step"].get<double>(), 2.5e-9);
  EXPECT_EQ(json["timing"]["loops"][0]["label"], "move");
  EXPECT_EQ(json["checks"]["reached_the_end"], true);
  EXPECT_EQ(json["checks"]["energy_balance"].get<double>(), 0.01);
  EXPECT_EQ(json["text"]["title"], "a \"pipe\"");
}

TEST(Summary, of_finite_elements_counts_nodes_and_iterations_and_no_particles)
{
  Summary summary = sample_summary();
  summary.timing.counts = FemCounts{.nodes = 700, .iterations = 60};
  const auto timing = nlohmann::json::parse(summary.json())["timing"];
  EXPECT_EQ(timing["nodes"].get<int>(), 700);
  EXPECT_EQ(timing["iterations"].get<int>(), 60);
  EXPECT_EQ(timing["cells"].get<int>(), 800);
  EXPECT_EQ(timing["wall_s"].get<double>(), 12.5);
  EXPECT_EQ(timing["loops"].size(), 1u);
  for (const char* name : {"particle_steps_per_s", "particles"}) EXPECT_FALSE(timing.contains(name)) << name;
}

TEST(Summary, a_number_that_is_not_there_is_null_and_the_file_stays_json)
{
  Summary summary = sample_summary();
  summary.text.emplace_back("broken", "\xff");
  const auto json = nlohmann::json::parse(summary.json());
  EXPECT_TRUE(json["quantities"]["H_max"]["value"].is_null());
}

TEST(Summary, empty_has_all_its_parts)
{
  const auto json = nlohmann::json::parse(Summary{}.json());
  for (const char* part : {"quantities", "timing", "checks"}) EXPECT_TRUE(json[part].is_object()) << part;
}

TEST(Summary, quantities_keep_their_order)
{
  const std::string text = sample_summary().json();
  EXPECT_LT(text.find("V_at_w_0.1D"), text.find("H_max"));
}

}  // namespace
}  // namespace berm
