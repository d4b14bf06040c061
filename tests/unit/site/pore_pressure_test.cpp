// SPDX-License-Identifier: BSD-3-Clause
// Pore pressures that no soil has: that of the water above, single readings, another unit.
#include "site/pore_pressure.hpp"

#include "os/error.hpp"

#include <gtest/gtest.h>

namespace berm::site::this_file {
namespace {

/// 0.1, 0.2, ... m in soft clay: q_c = 30 kPa + 30 kPa/m z, u_2 = 25 kPa/m z and more.
struct Made {
  std::vector<Real> depth, q_c, u_2;
  std::vector<std::string> notes;

  explicit Made(Real more, Real first = 0.1)
  {
    for (int n = 0; n < 30; ++n) {
      depth.push_back(first + 0.1 * n);
      q_c.push_back(30e3 + 30e3 * depth.back());
      u_2.push_back(25e3 * depth.back() + more);
    }
  }
  void judge() { make_plausible("made.gef", depth, q_c, 0.8, u_2, notes); }
};

TEST(PorePressure, of_soft_clay_stays_as_it_is)
{
  Made made(0);
  const std::vector<Real> before = made.u_2;
  made.judge();
  EXPECT_EQ(made.u_2, before);
  EXPECT_TRUE(made.notes.empty());
}

TEST(PorePressure, loses_that_of_the_water_above_the_seabed)
{
  Made made(8e6);
  made.judge();
  // What the soil adds at 0.1 m, 25 kPa/m less 9.81 kPa/m, goes with it.
  EXPECT_NEAR(made.u_2[20], 25e3 * 2.1 - (25e3 - gamma_w) * 0.1, 1);
  ASSERT_EQ(made.notes.size(), 1u);
  EXPECT_NE(made.notes[0].find("the pressure of some 816 m of water"), std::string::npos) << made.notes[0];
}

TEST(PorePressure, with_that_of_water_is_refused_where_the_test_begins_deep)
{
  EXPECT_THROW(Made(8e6, 1.7).judge(), InputError);
}

TEST(PorePressure, of_the_water_above_in_q_t_of_the_file_is_doubted)
{
  const Made absolute(8e6), usual(0);
  std::vector<Real> q_t;
  for (std::size_t i = 0; i < absolute.q_c.size(); ++i) q_t.push_back(absolute.q_c[i] + 0.2 * absolute.u_2[i]);
  EXPECT_NE(doubt_of_given(absolute.depth, absolute.q_c, q_t, absolute.u_2).find("leave out its column"), std::string::npos);
  EXPECT_EQ(doubt_of_given(absolute.depth, absolute.q_c, absolute.q_c, absolute.u_2), "");
  EXPECT_EQ(doubt_of_given(usual.depth, usual.q_c, q_t, usual.u_2), "");
}

TEST(PorePressure, of_another_unit_is_refused)
{
  Made made(0);
  for (Real& u : made.u_2) u *= 1000;
  EXPECT_THROW(made.judge(), InputError);
}

TEST(PorePressure, of_single_rows_that_no_soil_has_is_done_without)
{
  Made made(0);
  made.u_2[10] = 2e6;
  made.judge();
  EXPECT_TRUE(std::isnan(made.u_2[10]));
  EXPECT_EQ(made.notes.size(), 1u);
}

}  // namespace
}  // namespace berm::site::this_file
