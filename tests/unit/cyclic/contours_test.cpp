// SPDX-License-Identifier: BSD-3-Clause
#include "cyclic/contours.hpp"
#include "os/error.hpp"
#include "sample_contours.hpp"
#include "samples/error_of.hpp"

#include <gtest/gtest.h>

namespace berm::cyclic::this_file {
namespace {

TEST(Contours, are_linear_in_log_N_and_in_the_average_stress)
{
  const Real part = std::log10(3);
  EXPECT_NEAR(Contours(drammen(), 0.25).stress(0, 300), 0.677 + part * (0.524 - 0.677), 1e-12);
  EXPECT_NEAR(Contours(drammen(), 0.75 + 1e-12).stress(0, 10), 0.444, 1e-9) << "rounding of a load over a capacity";
  EXPECT_NEAR(Contours(drammen(), 0.375).stress(0, 10), (0.893 + 0.76) / 2, 1e-12);
  EXPECT_NEAR(Contours(drammen(), 0.375).stress(0, 300), (0.677 + part * (0.524 - 0.677) + 0.516 + part * (0.395 - 0.516)) / 2, 1e-12);
}

TEST(Contours, give_a_power_law_at_their_points_and_between_contours)
{
  const PowerLaw law;
  const Contours contours(law.table(1), 0);
  for (const Real n : {1., 10., 100., 1000.})
    for (const Real strain : {0.005, 0.007, 0.02, 0.03, 0.1, 0.15})
      EXPECT_NEAR(contours.strain(law.stress(strain, n), n) / strain, 1, 1e-9) << strain << " after " << n;
}

TEST(Contours, are_off_a_power_law_between_their_points_by_no_more_than_their_chords)
{
  const PowerLaw law;
  for (const int points : {1, 2, 4}) {
    const Contours contours(law.table(points), 0);
    const Real off = law.error_of_stress(points);  // of tau, so of gamma b times as much, less
    Real most = 0;
    for (Real n = 1; n < 9999; n *= 1.37)
      for (const Real strain : {0.006, 0.02, 0.05, 0.14}) {
        const Real error = std::log(contours.strain(law.stress(strain, n), n) / strain);
        EXPECT_LE(error, 1e-9) << strain << " after " << n;
        EXPECT_GE(error, -law.b * off) << strain << " after " << n;
        most = std::max(most, -error);
      }
    EXPECT_GT(most, 0.8 * law.b * off) << "the bound is that of the middle of a chord, where some of these are";
  }
}

TEST(Contours, tell_the_cycles_that_make_a_strain)
{
  const Contours contours(PowerLaw().table(3), 0);
  for (const Real stress : {0.2, 0.35, 0.5, 0.7})
    for (const Real n : {0.3, 2., 30., 35.}) EXPECT_NEAR(contours.cycles(stress, contours.strain(stress, n)) / n, 1, 1e-9) << stress;
  EXPECT_NEAR(contours.cycles(0.2, 0.1) / contours.last(), 1, 1e-12) << "more than the table has";
}

TEST(Contours, share_the_strain_of_their_first_cycles_and_of_the_lowest_contour)
{
  const Contours one(drammen(), 0);
  EXPECT_NEAR(one.strain(0.5, 4), 0.15 * 0.5 / 0.924 * 0.4, 1e-12);
  EXPECT_NEAR(one.cycles(0.5, 0.15 * 0.5 / 0.924 * 0.4), 4, 1e-9);
  EXPECT_NEAR(one.strain(0.3, 100), 0.15 * 0.3 / 0.692, 1e-12);
  EXPECT_EQ(one.strain(0.93, 10), infinity);
}

TEST(Contours, that_are_level_make_no_strain_and_count_their_cycles)
{
  const Contours contours({{0.15, {{0, {{1, 1}, {10, 0.5}, {100, 0.5}, {1000, 0.4}}}}}}, 0);
  EXPECT_NEAR(contours.cycles(0.25, 0.075), 100, 1e-6);
}

TEST(Contours, refuse_what_the_table_does_not_have)
{
  const auto fault = [](const ContourTable& table, Real average) { return test::error_of<InputError>([&] { Contours(table, average); }); };
  EXPECT_EQ(fault(drammen(), 0.8), "the average stress is 0.8 s_u, and the contour of 0.15 is known from 0 to 0.75 s_u");
  ContourTable crossing = PowerLaw().table(1);
  crossing[0.01][0][2].stress = 0.1;
  EXPECT_EQ(fault(crossing, 0), "at an average stress of 0 s_u and N = 100 the contour of 0.01 is not above that of 0.005");
  EXPECT_EQ(fault({{0.15, {{0, {{1, 0.9}, {10, 0.5}}}}}, {0.03, {{0, {{10, 0.4}, {100, 0.3}}}}}}, 0),
            "there is no range of cycles in which all contours are known at this average stress");
  EXPECT_EQ(fault({{0.15, {{1, {{1, 0}, {10, 0}}}}}}, 1), "at an average stress of 1 s_u and N = 1 the contour of 0.15 is not above 0");
}

}  // namespace
}  // namespace berm::cyclic::this_file
