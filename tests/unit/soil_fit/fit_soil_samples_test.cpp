// SPDX-License-Identifier: BSD-3-Clause
#include "sample_fits.hpp"
#include "soil_fit/passages.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace berm::soil_fit::this_file {
namespace {

constexpr int samples = 100;

/// What the samples say of one key.
struct Scatter {
  int inside = 0, near = 0;
  Real largest = 0, squares = 0, errors = 0;
};

/// Fits tests with noise of 3 % of the largest of each curve, again and again, and prints a row of a table for each key: run with --gtest_filter='*Samples*'.
std::map<std::string, Scatter> scatter_of(const std::string& name, const FitCase& c, const std::vector<MeasuredTest>& exact,
                                          const Values& truth)
{
  constexpr Real near = 0.05;
  std::map<std::string, Scatter> all;
  std::mt19937_64 random(7);
  for (int n = 0; n < samples; ++n) {
    std::vector<MeasuredTest> tests = exact;
    for (MeasuredTest& test : tests) add_noise(test, 0.03, random);
    for (const FittedKey& key : fit_soil(c, tests).keys) {
      const Real off = std::abs(key.value / truth.at(key.free.key) - 1), error = key.error / truth.at(key.free.key);
      Scatter& scatter = all[key.free.key];
      scatter.inside += off < 1.96 * error;
      scatter.near += off < near;
      scatter.largest = std::max(scatter.largest, off);
      scatter.squares += off * off, scatter.errors += error;
    }
  }
  for (const auto& [key, scatter] : all)
    fmt::print("| {} | `{}` | {:.1f} % | {:.1f} % | {:.1f} % | {} | {} |\n", name, key, 100 * scatter.errors / samples,
               100 * std::sqrt(scatter.squares / samples), 100 * scatter.largest, scatter.near, scatter.inside);
  return all;
}

/// With the truth within 1.96 standard errors in 95 of 100 on average, fewer than 87 have a chance of 1 in 2100 for each key (binomial), 1 in 80 over all of 26; where a key scatters 1.2 times as
/// much as its standard error says, it is 90 on average. Fewer than 90 would have 1 in 87 for each key, one in four over all. Tests are so many that they tell each key to a standard error of
/// 2.5 %: then 95 of 100 lie within 5 %.
void expect_within_errors(const std::map<std::string, Scatter>& all)
{
  for (const auto& [key, scatter] : all) {
    EXPECT_GE(scatter.inside, 87) << key;
    EXPECT_GE(scatter.near, 87) << key;
  }
}

class Samples : public testing::TestWithParam<SampleLaw> {};

TEST_P(Samples, with_noise_scatter_by_the_standard_errors)
{
  const SampleLaw& law = GetParam();
  const FitCase c = fit_of(law, law.truth);  // that it is found from elsewhere, too, fit_soil_test.cpp shows
  std::vector<MeasuredTest> tests;
  const std::vector<Real> stresses =
      law.drained ? std::vector<Real>{100e3, 300e3} : std::vector<Real>{100e3, 150e3, 200e3, 250e3, 300e3, 400e3};
  for (const Real stress : stresses) tests.push_back(test_from(c, law, stress));  // of undrained ones a curve each
  expect_within_errors(scatter_of(law.name, c, tests, law.truth));
}

const auto name_of_law = [](const testing::TestParamInfo<SampleLaw>& one) { return std::string(one.param.name); };
// The first is Mohr-Coulomb's; the others, minutes all together, are of the long set (tests/CMakeLists.txt).
INSTANTIATE_TEST_SUITE_P(Quick, Samples, testing::Values(sample_laws().front()), name_of_law);
INSTANTIATE_TEST_SUITE_P(Long, Samples, testing::ValuesIn(sample_laws().begin() + 1, sample_laws().end()), name_of_law);

// Four T-bar tests of 20 passages, noise on the mean of each passage: 3 % of the first is 12 % of remoulded clay's.
TEST(PenetrometerSamples, with_noise_scatter_by_the_standard_errors)
{
  const FitCase c = read_fit_text("case.toml",
                                  "starts = 1\n[material.clay]\nlaw = \"clay\"\ndensity = 600\nrigidity_index = 100\npoisson_ratio = "
                                  "0.49\nundrained_strength = \"8 kPa\"\nsensitivity = 3\nductility = 15\n"
                                  "[[free]]\nkey = \"undrained_strength\"\nfrom = \"1 kPa\"\nto = \"100 kPa\"\n[[free]]\nkey = "
                                  "\"sensitivity\"\nfrom = 1.5\nto = 20\n[[free]]\nkey = \"ductility\"\nfrom = 5\nto = 90\n"
                                  "[[measured]]\nname = \"none\"\nfile = \"none.csv\"\nkind = \"t_bar\"\ndiameter = \"40 mm\"\n",
                                  ".");
  const Values truth = {{"undrained_strength", 10e3}, {"sensitivity", 5}, {"ductility", 20}};
  MeasuredTest test;
  test.passages = Passages{"t_bar", TBar{}, 2.25, 2, 2.5};
  for (int k = 1; k <= 20; ++k) test.driven.push_back(k);
  test.curves = {{Compared::resistance, resistances(test, material_with(c, truth))}};
  std::vector<MeasuredTest> tests(4, test);
  for (std::size_t k = 0; k < tests.size(); ++k) tests[k].name = fmt::format("T{}", k + 1);
  const auto all = scatter_of("clay, T-bar", c, tests, truth);
  for (const auto& [key, scatter] : all) EXPECT_GE(scatter.inside, 87) << key;
}

}  // namespace
}  // namespace berm::soil_fit::this_file
