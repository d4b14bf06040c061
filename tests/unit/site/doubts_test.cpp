// SPDX-License-Identifier: BSD-3-Clause
// What of a sounding is doubted or refused, each by a sounding that has it and nothing else.
#include "site/doubts.hpp"

#include "os/error.hpp"
#include "samples/error_of.hpp"

#include <functional>
#include <gtest/gtest.h>

namespace berm::site::this_file {
namespace {

constexpr Real weight = 6e3;

/// From `first` to 3 m by 0.05 m, with a resistance and a sleeve friction over the depth.
Sounding made(const std::function<Real(Real)>& q_t, Real friction_ratio = 0, Real first = 0.05)
{
  Sounding sounding;
  sounding.file = "made.csv";
  for (Real z = first; z < 3.01; z += 0.05) {
    sounding.depth.push_back(z);
    sounding.q_t.push_back(q_t(z));
    if (friction_ratio > 0) sounding.f_s.push_back(friction_ratio * (q_t(z) - (weight + gamma_w) * z));
  }
  sounding.rows = static_cast<Index>(sounding.depth.size());
  return sounding;
}

/// s_u of 2 kPa + 1.5 kPa/m z with N_kt = 14.
Real soft(Real z)
{
  return 14 * (2e3 + 1.5e3 * z) + (weight + gamma_w) * z;
}

std::string all(const std::vector<std::string>& doubts)
{
  std::string text;
  for (const std::string& doubt : doubts) text += doubt + "\n";
  return text;
}

std::string of_clay(const Sounding& sounding)
{
  return all(doubts_of_clay(sounding, undrained_strength(sounding, weight, 14), weight));
}
std::string of_sand(const Sounding& sounding)
{
  return all(doubts_of_sand(sounding, friction_angle(sounding, 9e3, Correlation::kulhawy_mayne), 9e3));
}
std::string refusal(const std::function<void()>& act)
{
  return test::error_of<InputError>(act);
}

TEST(Diagnostics, there_are_none_of_soft_clay_and_of_medium_sand)
{
  EXPECT_EQ(all(doubts_of_rows(made(soft), 3)), "");
  EXPECT_EQ(of_clay(made(soft, 0.03)), "");
  EXPECT_EQ(of_sand(made([](Real z) { return 3e6 * std::sqrt(z); }, 0.006)), "");
}

TEST(Diagnostics, name_rows_left_out_and_gaps_at_the_seabed_between_readings_and_below)
{
  Sounding many = made(soft);
  many.rows += 10;
  EXPECT_EQ(all(doubts_of_rows(many, 3)), "10 of 70 rows are left out: check the file\n");
  many.rows -= 5;
  EXPECT_EQ(all(doubts_of_rows(many, 3)), "") << "5 of 65";
  EXPECT_NE(all(doubts_of_rows(made(soft, 0, 1.7), 3)).find("the first reading is at 1.70 m: the strength from the seabed to there"),
            std::string::npos);
  EXPECT_EQ(all(doubts_of_rows(made(soft, 0, 0.1), 3)), "") << "as many logs begin";
  Sounding gap = made(soft);
  gap.depth.erase(gap.depth.begin() + 20, gap.depth.begin() + 30);
  gap.q_t.erase(gap.q_t.begin() + 20, gap.q_t.begin() + 30);
  gap.rows -= 10;
  EXPECT_NE(all(doubts_of_rows(gap, 3)).find("no readings from 1.00 to 1.55 m"), std::string::npos) << all(doubts_of_rows(gap, 3));
  EXPECT_NE(all(doubts_of_rows(made(soft), 8)).find("the sounding ends at 3.00 m with 60 readings, and the bed is 8 m deep"),
            std::string::npos);
}

TEST(Diagnostics, of_clay_name_strength_that_is_that_of_sand_or_of_another_unit)
{
  EXPECT_NE(of_clay(made([](Real z) { return 3 * soft(z) + 1.2e6; })).find("this kind is for clay below 100 kPa"), std::string::npos);
  EXPECT_NE(of_clay(made(soft, 0.004)).find("the mean friction ratio is 0.4 %"), std::string::npos);
  EXPECT_NE(of_clay(made([](Real z) { return 14 * 60e3 + (weight + gamma_w) * z; })).find("more than 5 times the effective overburden"),
            std::string::npos);
  const Sounding sand = made([](Real z) { return 3e6 * std::sqrt(z); }, 0.006);
  EXPECT_NE(refusal([&] { of_clay(sand); }).find("this is sand: the mean friction ratio is 0.6 %"), std::string::npos);
  const Sounding in_kpa = made([](Real z) { return 1000 * soft(z); });
  EXPECT_NE(refusal([&] { of_clay(in_kpa); }).find("no clay has more than 1 MPa: is the cone resistance in kPa under the unit MPa"),
            std::string::npos);
}

TEST(Diagnostics, of_clay_name_a_lens_and_layers_without_strength)
{
  const std::string lens = of_clay(made([](Real z) { return z > 1.2 && z < 1.4 ? 1e6 : soft(z); }));
  EXPECT_NE(lens.find("a lens of sand"), std::string::npos) << lens;
  EXPECT_EQ(of_clay(made([](Real z) { return z < 0.3 ? 5 * soft(z) : soft(z); })), "") << "a crust is no lens";
  const std::string without = of_clay(made([](Real z) { return z < 0.08 ? 0 : soft(z); }));
  EXPECT_NE(without.find("not more than the overburden at 0.05 m: left out"), std::string::npos) << without;
}

TEST(Diagnostics, of_sand_name_clay_another_unit_and_the_end_of_the_correlation)
{
  EXPECT_NE(of_sand(made([](Real z) { return 3e6 * std::sqrt(z); }, 0.05)).find("is it clay"), std::string::npos);
  EXPECT_NE(of_sand(made([](Real z) { return 20e6 * std::sqrt(z); })).find("written as 45 deg"), std::string::npos);
  EXPECT_NE(refusal([] { of_sand(made([](Real) { return 60e6; })); }).find("in kPa under the unit MPa"), std::string::npos);
}

}  // namespace
}  // namespace berm::site::this_file
