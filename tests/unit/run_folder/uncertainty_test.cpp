// SPDX-License-Identifier: BSD-3-Clause
#include "run_folder/uncertainty.hpp"

#include "os/error.hpp"
#include "run_folder/summary_file.hpp"
#include "samples/run_to_write.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace berm::run_folder::this_file {
namespace {

constexpr Real nan = std::numeric_limits<Real>::quiet_NaN();

Uncertainty sample()
{
  Uncertainty u;
  u.quantities = {{"V_at_w_0.1D", "N/m", {808.25, 715.5, 61.125, 1.25, 46, 14, 1, 5.5}}};
  u.curves = {{"V_w", {0, 0.001}, {nan, 1.5}, {nan, 2.5}}};
  u.runs = {{"cells_1.4", 1.4, 1, 12.5}};
  u.without = {{"H_residual", "cells_2 has no such number"}};
  u.left_out = {"speed: the strength of the soil depends on it"};
  u.grains = {2.2, {0.1e-3, 0.5e-3}, {{"V_at_w_0.1D", "N/m", 820, {690.5, nan}}}};
  return u;
}

/// A run folder with a summary.
struct Place {
  TemporaryFolder folder;
  Place()
  {
    Summary summary;
    summary.quantities = {{"V_at_w_0.1D", 808.25, "N/m"}, {"H_max", nan, "N/m"}};
    summary.timing = {.wall_s = 1, .threads = 1, .cells = 1, .steps = 1, .counts = MpmCounts{1}, .loops = {}};
    summary.write(file());
  }
  std::filesystem::path file() const { return folder.path() / "summary.json"; }
};

TEST(Uncertainty, comes_back_from_the_summary_as_it_was)
{
  const Place place;
  add_to_summary(place.folder.path(), sample());
  const std::optional<Uncertainty> read = read_summary(place.folder.path())->uncertainty;
  ASSERT_TRUE(read);
  EXPECT_EQ(json_of(*read).dump(), json_of(sample()).dump());
  ASSERT_NE(read->find("V_at_w_0.1D"), nullptr);
  const Band band = *read->find("V_at_w_0.1D");
  EXPECT_EQ(band.converged, 715.5);
  EXPECT_EQ(band.half_width, 61.125);
  EXPECT_EQ(band.order, 1.25);
  EXPECT_EQ(band.speed, 5.5);
  EXPECT_TRUE(std::isnan(read->curves.at(0).low.at(0)));
  EXPECT_EQ(read->find("H_max"), nullptr);
  EXPECT_EQ(read->grains.numbers.at(0).with.at(0), 690.5);
}

TEST(Uncertainty, of_an_earlier_version_has_no_order)
{
  auto json = json_of(sample());
  json["quantities"]["V_at_w_0.1D"].erase("order");
  EXPECT_TRUE(std::isnan(uncertainty_of(json).find("V_at_w_0.1D")->order));
}

TEST(Uncertainty, leaves_the_rest_of_the_summary_as_it_was)
{
  const Place place;
  const auto before = nlohmann::ordered_json::parse(content_of(place.file()));
  add_to_summary(place.folder.path(), sample());
  add_to_summary(place.folder.path(), sample());
  auto after = nlohmann::ordered_json::parse(content_of(place.file()));
  EXPECT_EQ(after.erase("uncertainty"), 1u);
  EXPECT_EQ(after.dump(), before.dump());
}

TEST(Uncertainty, that_is_missing_says_why)
{
  const Place place;
  Uncertainty none;
  none.missing = "the run cells_2 failed: no memory";
  add_to_summary(place.folder.path(), none);
  EXPECT_EQ(read_summary(place.folder.path())->uncertainty->missing, none.missing);
}

TEST(Uncertainty, of_a_summary_without_it_is_not_there)
{
  const Place place;
  EXPECT_FALSE(read_summary(place.folder.path())->uncertainty);
}

TEST(Uncertainty, that_is_damaged_is_refused)
{
  const auto refused = [](const char* pointer, const nlohmann::ordered_json& instead) {
    nlohmann::ordered_json json = json_of(sample());
    json[nlohmann::ordered_json::json_pointer(pointer)] = instead;
    try {
      uncertainty_of(json);
    } catch (const RunError& error) {
      return std::string(error.what()).find("is damaged") == 0;
    }
    return false;
  };
  EXPECT_TRUE(refused("/quantities", 1));
  EXPECT_TRUE(refused("/quantities/V_at_w_0.1D/converged", "much"));
  EXPECT_TRUE(refused("/quantities/V_at_w_0.1D/parts", nullptr));
  EXPECT_TRUE(refused("/curves/0/low", nlohmann::ordered_json::array({1})));
  EXPECT_TRUE(refused("/left_out", "speed"));
  EXPECT_TRUE(refused("/runs/0/name", 3));
  EXPECT_TRUE(refused("/grains/d50_m", nlohmann::ordered_json::array({1e-4})));
  EXPECT_TRUE(refused("/grains/quantities/V_at_w_0.1D/unit", nullptr));
  EXPECT_FALSE(refused("/runs/0/wall_s", nullptr)) << "a number that was not finite";
}

}  // namespace
}  // namespace berm::run_folder::this_file
