// SPDX-License-Identifier: BSD-3-Clause
#include "cpt/profile.hpp"
#include "os/error.hpp"
#include "samples/error_of.hpp"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace berm::cpt::this_file {
namespace {

/// Rows each 0.1 m from 0.1 m on: net resistance and friction of clay, 20 s_u with F_r = 4 %, or of sand, 10 MPa with 0.5 %.
site::Sounding sounding(const std::vector<std::pair<int, bool>>& rows_of_sand)
{
  site::Sounding all;
  all.file = "trial.csv";
  for (const auto& [rows, sand] : rows_of_sand)
    for (int i = 0; i < rows; ++i) {
      all.depth.push_back(0.1 * static_cast<Real>(all.depth.size() + 1));
      all.q_t.push_back(sand ? 10e6 : 0.3e6);
      all.f_s.push_back(sand ? 50e3 : 12e3);
      all.rows = static_cast<Index>(all.depth.size());
    }
  return all;
}

TEST(CptProfile, finds_three_layers_where_they_were_put)
{
  // Clay to 2.05 m, sand to 4.05 m, clay below: limits half-way between the rows at 2.0 and 2.1, 4.0 and 4.1 m.
  const Profile profile = profile_of(sounding({{20, false}, {20, true}, {20, false}}), {});
  ASSERT_EQ(profile.rows.size(), 60U);
  ASSERT_GE(profile.layers.size(), 3U);
  bool first = false, second = false;
  for (std::size_t i = 1; i < profile.layers.size(); ++i) {
    const Layer &above = profile.layers[i - 1], &below = profile.layers[i];
    EXPECT_DOUBLE_EQ(above.base, below.top);
    EXPECT_EQ(above.last, below.first);
    if (std::abs(below.top - 2.05) < 1e-9) first = !above.sand() && below.sand();
    if (std::abs(below.top - 4.05) < 1e-9) second = above.sand() && !below.sand();
  }
  EXPECT_TRUE(first);
  EXPECT_TRUE(second);
}

TEST(CptProfile, finds_what_the_sounding_of_the_manual_was_made_of)
{
  // Clay to 2 m and below 5 m with s_u = 4 kPa + 1.5 kPa/m z, q_t = 14 s_u above 16 kN/m3 z. The unit weight found is up to 3 kN/m3 from 16,
  // s_u thus up to 3 z / 14 = 0.2 z kPa, and F_r in the same part. Sand: q_c = 8 MPa with a sine of 0.4 MPa over 3 m, whose mean is
  // 2 x 0.4 / (9 x 3) = 0.03 MPa at most, and 0.2 u_2 = 0.007 MPa.
  const Profile profile = profile_of(site::read_sounding(BERM_SOURCE_DIR "/examples/start/sounding.csv", ""), {.thinnest = 0.5});
  ASSERT_EQ(profile.layers.size(), 3U);
  EXPECT_NEAR(profile.layers[0].base, 2, 1e-9);
  EXPECT_NEAR(profile.layers[1].base, 5, 1e-9);
  EXPECT_TRUE(!profile.layers[0].sand() && profile.layers[1].sand() && !profile.layers[2].sand());
  EXPECT_NEAR(mean_of(profile, profile.layers[1], &Reading::q_t).value / 1e6, 8.007, 0.03);
  EXPECT_NEAR(mean_of(profile, profile.layers[2], &Reading::s_u).value / 1e3, 4 + 1.5 * 6.5, 0.2 * 6.5);
  EXPECT_NEAR(mean_of(profile, profile.layers[2], &Reading::F_r).value, 0.04, 0.2 * 6.5 / 13.75 * 0.04);
}

TEST(CptProfile, stress_is_the_sum_of_the_unit_weights)
{
  // Clay, R_f = 4 %, q_t = 3 p_a: gamma / gamma_w = 0.27 x 0.60206 + 0.36 x 0.47712 + 1.236 = 1.57032, at 1 m 15.405 kPa.
  const Profile profile = profile_of(sounding({{20, false}}), {});
  const Reading& row = profile.rows[9];
  EXPECT_NEAR(row.gamma / site::gamma_w, 1.57032, 1e-5);
  EXPECT_NEAR(row.sigma_v0, 15.405e3, 1);
  EXPECT_NEAR(row.effective_stress, 15.405e3 - 9.81e3, 1);
  EXPECT_NEAR(row.s_u, (300e3 - 15.405e3) / 14, 1);
  EXPECT_TRUE(std::isnan(row.phi) && std::isnan(row.E) && std::isnan(row.D_r));
}

TEST(CptProfile, a_thin_layer_joins_its_neighbour)
{
  const auto rows = sounding({{30, false}, {1, true}, {30, false}});
  const auto of_sand = [](const Profile& profile) {
    return std::count_if(profile.layers.begin(), profile.layers.end(), [](const Layer& layer) { return layer.sand() && layer.top > 2; });
  };
  EXPECT_EQ(of_sand(profile_of(rows, {.thinnest = 0})), 1);
  EXPECT_EQ(of_sand(profile_of(rows, {.thinnest = 0.2})), 0);
}

TEST(CptProfile, pore_pressure_ratio)
{
  site::Sounding rows = sounding({{20, false}});
  for (const Real z : rows.depth) rows.u_2.push_back(site::gamma_w * z + 100e3);
  const Profile profile = profile_of(rows, {});
  EXPECT_NEAR(profile.rows[9].B_q, 100e3 / (300e3 - 15.405e3), 1e-5);
}

TEST(CptProfile, needs_sleeve_friction)
{
  site::Sounding rows = sounding({{20, false}});
  rows.f_s.clear();
  EXPECT_NE(test::error_of<InputError>([&] { profile_of(rows, {}); }).find("it needs columns of depth, q_c or q_t, and f_s"),
            std::string::npos);
  rows.f_s.assign(20, 0);
  EXPECT_NE(test::error_of<InputError>([&] { profile_of(rows, {}); }).find("no row has a sleeve friction above 0"), std::string::npos);
}

TEST(CptProfile, tells_rows_without_index)
{
  site::Sounding rows = sounding({{20, false}});
  rows.f_s[5] = nan;
  const Profile profile = profile_of(rows, {});
  EXPECT_EQ(profile.rows.size(), 19U);
  EXPECT_NE(profile.doubts.back().find("without I_c, as f_s is not above 0 or the cone resistance not above the overburden: 1 rows"),
            std::string::npos);
}

}  // namespace
}  // namespace berm::cpt::this_file
