// SPDX-License-Identifier: BSD-3-Clause
#include "cyclic/storm.hpp"
#include "os/error.hpp"
#include "sample_contours.hpp"
#include "samples/error_of.hpp"

#include <algorithm>
#include <gtest/gtest.h>

namespace berm::cyclic::this_file {
namespace {

const std::vector<Parcel> storm = {{400, 0.3}, {150, 0.45}, {50, 0.6}, {15, 0.75}, {4, 0.9}, {1, 1}};  // over the largest

/// Of gamma = scale tau^b N^c: n cycles of tau make the strain of n (tau/tau_max)^(b/c) cycles of the largest, so that N_eq is their sum. `each`: what it is multiplied by from a parcel to the next.
Real sum_of(const PowerLaw& law, Real each = 1)
{
  Real sum = 0;
  for (const Parcel& parcel : storm) sum = sum * each + parcel.cycles * std::pow(parcel.stress, law.b / law.c);
  return sum;
}

constexpr std::size_t highest = 3;

TEST(Storm, of_one_parcel_has_the_strength_of_its_contour)
{
  const StormStrength found = strength_in(Contours(drammen(), 0), {{100, 0.5}}, 0);
  EXPECT_NEAR(found.stress, 0.692, 1e-9);
  EXPECT_NEAR(found.multiplier, 0.692 / 0.5, 1e-9);
  EXPECT_NEAR(found.equivalent_cycles, 100, 1e-6);
  EXPECT_NEAR(found.given_cycles, 100, 1e-6);
  EXPECT_FALSE(found.given.fails);
}

/// Chords give N too large by a factor from 1 to exp(E), E = b/c times their error of tau: at the end of a parcel N is divided by one such factor, at the begin of the next one multiplied by
/// another. The strength is that of N_eq on a chord: off by its error and c/b times that of log N_eq.
TEST(Storm, on_contours_of_a_power_law_has_its_closed_form_to_the_error_of_the_chords)
{
  const PowerLaw law;
  const Real exact = sum_of(law), strength = law.stress(0.15, exact);
  for (const int points : {1, 2, 4, 16}) {
    const StormStrength found = strength_in(Contours(law.table(points), 0), storm, highest);
    const Real off = law.error_of_stress(points), each = std::exp(law.b / law.c * off);
    EXPECT_LE(found.equivalent_cycles, sum_of(law, each) + 1e-6) << points;
    EXPECT_GE(found.equivalent_cycles, sum_of(law, 1 / each) - 1e-6) << points;
    EXPECT_LE(std::abs(std::log(found.stress / strength)), off + law.c / law.b * std::log(sum_of(law, each) / exact)) << points;
    EXPECT_EQ(found.multiplier, found.stress) << points;
  }
}

TEST(Storm, on_contours_of_a_power_law_is_the_same_in_any_order)
{
  const Contours contours(PowerLaw().table(16), 0);
  const std::vector<Parcel> turned = {{20, 0.8}, {30, 0.7}, {3, 1}, {10, 0.9}};
  std::vector<Parcel> sorted = turned;
  std::sort(sorted.begin(), sorted.end(), [](const Parcel& a, const Parcel& b) { return a.stress < b.stress; });
  const StormStrength any = strength_in(contours, turned, highest), rising = strength_in(contours, sorted, highest);
  EXPECT_NEAR(any.equivalent_cycles / rising.equivalent_cycles, 1, 0.0026) << "the bounds of both add up to 0.26 %";
}

TEST(Storm, of_one_form_has_one_strength_whatever_its_loads)
{
  const Contours contours(PowerLaw().table(4), 0);
  std::vector<Parcel> half = storm;
  for (Parcel& parcel : half) parcel.stress /= 2;
  const StormStrength a = strength_in(contours, storm, highest), b = strength_in(contours, half, highest);
  EXPECT_NEAR(a.stress, b.stress, 1e-9);
  EXPECT_NEAR(2 * a.multiplier, b.multiplier, 1e-9);
}

/// By hand, on lines of the form of the one contour, tau_f(N) = 0.893, 0.677, 0.524 at 10, 100, 1000: 300 cycles of 0.6 T: tau_f(300) = 0.677 - 0.153 log 3 = 0.6040. As much strain as
/// cycles of 0.8 T with tau_f(N) = 0.6040 0.8/0.6 = 0.8053: log N = 1.4058, N = 25.5; 60 more: 85.5, tau_f = 0.6917. Of T: tau_f(N) = 0.8647, N = 13.5; 12 more: 25.5, tau_f = 0.8051.
TEST(Storm, on_the_contour_of_drammen_clay_is_that_of_a_calculation_by_hand)
{
  const StormStrength found = strength_in(Contours(drammen(), 0.25), {{300, 0.36}, {60, 0.48}, {12, 0.6}}, 0);
  EXPECT_NEAR(found.equivalent_cycles, 25.5, 0.1);
  EXPECT_NEAR(found.stress, 0.8051, 1e-4);
  const std::vector<ParcelPath>& path = found.failing.parcels;
  ASSERT_EQ(path.size(), 3u);
  EXPECT_NEAR(path[1].begin, 25.5, 0.1);
  EXPECT_NEAR(path[1].end, 85.5, 0.1);
  EXPECT_NEAR(path[2].begin, 13.5, 0.1);
  EXPECT_TRUE(found.failing.fails);
}

TEST(Storm, that_fails_says_in_which_cycle)
{
  const PowerLaw law;
  const Contours contours(law.table(16), 0);
  const StormPath path = follow(contours, {{10, 0.3}, {100, 0.9}, {1, 1}}, highest);
  EXPECT_TRUE(path.fails);
  ASSERT_EQ(path.parcels.size(), 2u);
  EXPECT_NEAR(path.parcels[1].end / law.cycles(0.9, 0.15), 1, 0.01);
  EXPECT_EQ(path.parcels[1].strain, 0.15);
  EXPECT_EQ(follow(contours, {{5, 1.3}}, highest).parcels[0].end, 0) << "in the first cycle";
}

TEST(Storm, may_fail_at_a_contour_that_is_not_the_highest)
{
  const PowerLaw law;
  const Contours contours(law.table(4), 0);
  EXPECT_NEAR(strength_in(contours, {{10, 0.4}}, 2).stress, law.stress(0.03, 10), 1e-9);
}

TEST(Storm, beyond_the_table_is_refused_with_what_lacks)
{
  const auto fault = [](const ContourTable& table, const std::vector<Parcel>& parcels) {
    return test::error_of<InputError>([&] { strength_in(Contours(table, 0), parcels, table.size() - 1); });
  };
  EXPECT_EQ(fault(drammen(), {{2000, 0.3}}),
            "parcel 1, 2000 cycles of 0.3 s_u, ends at N = 2000, and the contours at N = 1000: give them to more cycles");
  EXPECT_EQ(fault(drammen(), {{2, 0.5}}), "with 1.848 times the loads parcel 1, 2 cycles of 0.924 s_u, reaches the contour of failure, "
                                          "0.924 s_u, before N = 10, where the contours begin: give them from N = 1");
  EXPECT_EQ(fault(drammen(), {{2, 0.95}, {20, 0.95}}), "parcel 1, 2 cycles of 0.95 s_u, reaches the contour of failure, 0.924 s_u, before "
                                                       "N = 10, where the contours begin: give them from N = 1");
  EXPECT_NE(fault(PowerLaw().table(2), {{20, 0.6}, {20, 0.2}}).find("or order = \"ascending\": the parcels before it made more strain"),
            std::string::npos);
}

}  // namespace
}  // namespace berm::cyclic::this_file
