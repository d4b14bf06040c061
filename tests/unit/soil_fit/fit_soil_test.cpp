// SPDX-License-Identifier: BSD-3-Clause
#include "sample_fits.hpp"
#include "soil_fit/fit_report.hpp"
#include "soil_fit/marks.hpp"

#include <gtest/gtest.h>

namespace berm::soil_fit::this_file {
namespace {

Real share_of(const FittedKey& key, Real truth)
{
  return (key.value - truth) / truth;
}

class Laws : public testing::TestWithParam<SampleLaw> {};

// Curves that the law itself has made are met where the search ends, to the tolerance of the search: no other values make them.
TEST_P(Laws, are_found_again_from_their_own_curves)
{
  const SampleLaw& law = GetParam();
  const FitCase c = fit_of(law);
  std::vector<MeasuredTest> tests = {test_from(c, law, 100e3), test_from(c, law, 300e3)};
  const FittedSoil soil = fit_soil(c, tests);
  for (const FittedKey& key : soil.keys) EXPECT_LT(std::abs(share_of(key, law.truth.at(key.free.key))), 0.01) << key.free.key;
  EXPECT_GT(soil.misfit_at_start, 0.05);
  EXPECT_LT(soil.misfit, 1e-3);
  std::mt19937_64 random(1);
  for (MeasuredTest& test : tests)
    add_noise(test, 0.01, random);  // errors and correlations are those of residuals, which exact curves do not leave
  const std::vector<std::string> what = doubts(fit_soil(c, tests));
  EXPECT_TRUE(what.empty()) << what.front();
}

INSTANTIATE_TEST_SUITE_P(All, Laws, testing::ValuesIn(sample_laws()), [](const auto& one) { return std::string(one.param.name); });

// A curve that is off as a whole counts as one row: with six tests, each with q off by its own 5 %, the error of the friction angle is that of six numbers, not of 400, and 95 % lie within 2.57 standard errors of
// them (t of five degrees of freedom) with their scatter about their own mean, over 5 and not 6. Fewer than 35 of 40 have a chance of 1 in 72.
TEST(StandardErrors, count_a_test_that_is_off_as_one)
{
  const SampleLaw& law = sample_laws()[0];
  const FitCase c = fit_of(law);
  constexpr int samples = 40;
  int inside = 0;
  std::mt19937_64 random(5);
  std::normal_distribution<Real> off(0, 0.05);
  for (int n = 0; n < samples; ++n) {
    std::vector<MeasuredTest> tests;
    for (const Real stress : {50e3, 100e3, 150e3, 200e3, 300e3, 400e3}) {
      MeasuredTest& test = tests.emplace_back(test_from(c, law, stress));
      const Real factor = 1 + off(random);
      for (Real& q : test.curves[0].values) q *= factor;
      add_noise(test, 0.005, random);
    }
    const FittedKey phi = fit_soil(c, tests).keys[1];
    inside += std::abs(phi.value - law.truth.at("friction_angle")) < 2.57 * std::sqrt(6. / 5) * phi.error;
  }
  EXPECT_GE(inside, 35);
}

// A key that begins in the middle of its bounds is found as any other.
TEST(Search, may_begin_in_the_middle_of_the_bounds)
{
  const SampleLaw& law = sample_laws()[0];
  const FitCase c = fit_of(law, {{"friction_angle", 32.5 * pi / 180}, {"young_modulus", 20e6}, {"dilation_angle", 7.5 * pi / 180}});
  for (const FittedKey& key : fit_soil(c, {test_from(c, law, 100e3), test_from(c, law, 300e3)}).keys)
    EXPECT_LT(std::abs(share_of(key, law.truth.at(key.free.key))), 0.01) << key.free.key;
}

TEST(Curves, that_say_nothing_are_left_out)
{
  const SampleLaw& law = sample_laws()[0];
  const FitCase c = fit_of(law);
  MeasuredTest test = test_from(c, law, 100e3), blank = test_from(c, law, 300e3);
  for (Real& x : blank.curves[1].values) x = nan;
  blank.curves[0].values[0] = nan;
  const FittedSoil soil = fit_soil(c, {test, blank});
  EXPECT_LT(soil.misfit, 1e-3);
  EXPECT_TRUE(doubts(soil).empty()) << doubts(soil).front();
  EXPECT_TRUE(std::isfinite(marks_measured(soil.tests[1]).friction_angle_peak));
}

TEST(WhatTestsDoNotTell, is_said)
{
  const SampleLaw& law = sample_laws()[0];
  const FitCase c = fit_of(law);
  MeasuredTest test = test_from(c, law, 100e3);
  test.curves.pop_back();  // without the volume nothing tells the dilation
  const std::vector<std::string> what = doubts(fit_soil(c, {test}));
  ASSERT_FALSE(what.empty());
  EXPECT_EQ(what.front(),
            "dilation_angle is not determined by these tests: keep it at a value that is known, and leave it out of [[free]]");
}

TEST(WhatTestsDoNotTell, is_said_of_keys_that_do_the_same)
{
  SampleLaw law = sample_laws()[0];
  const std::string free = std::string(law.free) + "[[free]]\nkey = \"cohesion\"\nfrom = \"0 kPa\"\nto = \"50 kPa\"\n";
  const std::string keys = std::string(law.keys) + "cohesion = \"5 kPa\"\n";
  law.free = free.c_str(), law.keys = keys.c_str();
  law.truth["cohesion"] = 10e3;
  const FitCase c = fit_of(law);
  const auto about_both = [](const std::string& doubt) {
    return doubt.starts_with("only a combination of friction_angle and cohesion is determined");
  };
  const auto doubts_of = [&](const std::vector<Real>& stresses) {
    std::mt19937_64 random(3);
    std::vector<MeasuredTest> tests;
    for (const Real stress : stresses) add_noise(tests.emplace_back(test_from(c, law, stress)), 0.005, random);
    return doubts(fit_soil(c, tests));
  };
  const std::vector<std::string> one = doubts_of({100e3, 110e3}), both = doubts_of({20e3, 400e3});
  EXPECT_TRUE(std::any_of(one.begin(), one.end(), about_both));
  EXPECT_FALSE(std::any_of(both.begin(), both.end(), about_both));
}

TEST(HeldOutTests, do_not_take_part)
{
  const SampleLaw& law = sample_laws()[0];
  const FitCase c = fit_of(law);
  MeasuredTest wrong = test_from(c, law, 300e3);
  for (Real& q : wrong.curves[0].values) q *= 2;
  wrong.held_out = true;
  const FittedSoil soil = fit_soil(c, {test_from(c, law, 100e3), wrong});
  EXPECT_LT(soil.misfit, 1e-3);
  Real squares = 0;
  for (const Real q : wrong.curves[0].values) squares += q * q / static_cast<Real>(wrong.rows());
  EXPECT_NEAR(soil.tests[1].rms[0], std::sqrt(squares) / 2, 1e-2 * std::sqrt(squares)) << "half of what is measured";
}

// (Kp - 1) sigma_3 at the peak; psi by d eps_v / d eps_1 = -2 sin(psi) / (1 - sin(psi)) of flow.
TEST(Marks, are_those_of_the_law)
{
  const SampleLaw& law = sample_laws()[0];
  const FitCase c = fit_of(law);
  const FittedSoil soil = fit_soil(c, {test_from(c, law, 100e3)});
  const Marks marks = marks_measured(soil.tests[0]);
  EXPECT_NEAR(marks.friction_angle_peak, 36 * pi / 180, 1e-6);
  EXPECT_NEAR(marks.dilation_angle_peak, 6 * pi / 180, 1e-4);
  EXPECT_NEAR(marks.E50, 18e6, 1e-3 * 18e6);
}

}  // namespace
}  // namespace berm::soil_fit::this_file
