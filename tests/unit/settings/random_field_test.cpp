// SPDX-License-Identifier: BSD-3-Clause
#include "settings/random_field.hpp"

#include "os/error.hpp"
#include "samples/error_of.hpp"

#include <gtest/gtest.h>
#include <omp.h>

namespace berm::settings::this_file {
namespace {

/// All statistics below are compared at so many standard errors of a sample of this size, chosen beforehand: one comparison in 16,000 would miss by chance.
constexpr Real errors = 4;
constexpr int realisations = 4000;

RandomFieldSettings field_of(std::optional<Real> along_x, std::optional<Real> along_depth, int seed = 1)
{
  RandomFieldSettings field;
  field.coefficient_of_variation = 0.5;
  field.correlation_length_x = along_x;
  field.correlation_length_depth = along_depth;
  field.seed = seed;
  return field;
}

/// Mean of f(realisation) over all seeds.
template <class F>
Real mean_over_seeds(RandomFieldSettings field, const SoilPlace& upper, const F& f)
{
  Real sum = 0;
  for (int seed = 1; seed <= realisations; ++seed) {
    field.seed = seed;
    sum += f(RandomField(field, "random_field.su", {}, upper));
  }
  return sum / realisations;
}

/// By hand, of Simpson's rule for 2/T^2 times the integral of (T - tau) rho(tau).
Real variance_by_integration(Correlation correlation, Real theta, Real length)
{
  constexpr int parts = 2000;
  Real sum = 0;
  for (int k = 0; k <= parts; ++k) {
    const Real tau = length * k / parts;
    const Real rho = correlation == Correlation::markov ? std::exp(-2 * tau / theta) : std::exp(-pi * tau * tau / theta / theta);
    sum += (k == 0 || k == parts ? 1 : k % 2 == 1 ? 4 : 2) * (length - tau) * rho;
  }
  return 2 / (length * length) * sum * length / parts / 3;
}

TEST(RandomField, variance_function_is_the_integral_of_the_correlation)
{
  for (const Correlation correlation : {Correlation::markov, Correlation::gaussian})
    for (const Real length : {0.01, 0.3, 1., 4., 30.})
      EXPECT_NEAR(variance_function(correlation, 0.8, length), variance_by_integration(correlation, 0.8, length), 1e-7) << length;
  EXPECT_EQ(variance_function(Correlation::markov, 0.8, 0), 1);
}

TEST(RandomField, covariance_of_means_adds_up_to_the_variance_of_their_mean)
{
  // The mean over 7 neighbours of 0.3 m is that over 2.1 m: both from the variance function, by two ways.
  for (const Correlation correlation : {Correlation::markov, Correlation::gaussian}) {
    Real sum = 0;
    for (int a = 0; a < 7; ++a)
      for (int b = 0; b < 7; ++b) sum += covariance_of_means(correlation, 0.8, 0.3, 0.3 * std::abs(a - b));
    EXPECT_NEAR(sum / 49, variance_function(correlation, 0.8, 2.1), 1e-12);
  }
}

TEST(RandomField, weights_give_the_covariance_to_a_millionth)
{
  // The sums of products of the weights are the covariance of what is drawn, without any sample.
  for (const auto& [correlation, averaging, cell] :
       {std::tuple(Correlation::markov, 0., 0.05), std::tuple(Correlation::gaussian, 0., 0.05), std::tuple(Correlation::markov, 0.4, 0.4),
        std::tuple(Correlation::markov, 3., 3.), std::tuple(Correlation::gaussian, 0.2, 0.2)}) {
    const auto reach = static_cast<Index>((correlation == Correlation::markov ? 7 : 2.5) / cell) + 2;
    std::vector<Real> covariance;
    for (Index j = 0; j <= 2 * reach; ++j) covariance.push_back(covariance_of_means(correlation, 1, averaging, j * cell));
    const std::vector<Real> w = symmetric_root(covariance, reach);
    ASSERT_EQ(w.size(), 2 * static_cast<std::size_t>(reach) + 1);
    for (std::size_t lag = 0; lag < w.size(); ++lag) {
      Real sum = 0;
      for (std::size_t m = 0; m + lag < w.size(); ++m) sum += w[m] * w[m + lag];
      EXPECT_NEAR(sum, covariance[lag], 1e-6) << cell << " " << lag;
    }
  }
}

TEST(RandomField, mean_over_a_length_varies_as_vanmarcke_says)
{
  // The variance of a variance of normal numbers over its square is 2/n.
  RandomFieldSettings field = field_of(1, {});
  field.averaging_length = 0.1;
  for (const int cells : {1, 5, 20, 60}) {
    const Real variance = mean_over_seeds(field, {0.1 * (cells - 0.5)}, [&](const RandomField& z) {
      Real sum = 0;
      for (int k = 0; k < cells; ++k) sum += z.at({0.1 * (k + 0.5)});
      return sum * sum / cells / cells;
    });
    const Real exact = variance_function(Correlation::markov, 1, 0.1 * cells);
    EXPECT_NEAR(variance / exact, 1, errors * std::sqrt(2. / realisations)) << cells;
  }
}

TEST(RandomField, is_standard_normal_at_a_point_and_correlated_by_both_distances)
{
  // Points of cells of a twentieth: 0.5 and 1 along x (theta = 2), 0.3 along the depth (theta = 1). Of two numbers with the correlation r that of a sample has the error (1 + r^2)^1/2 / n^1/2 of its mean
  // product.
  RandomFieldSettings field = field_of(2, 1);
  constexpr int draws = 1000;
  const std::pair<SoilPlace, Real> pairs[] = {
      {{0.01, 0.01}, 1.}, {{0.51, 0.01}, std::exp(-0.5)}, {{0.01, 0.31}, std::exp(-0.6)}, {{1.01, 0.31}, std::exp(-1.6)}};
  Real products[std::size(pairs)] = {}, mean = 0, fourth = 0;
  for (field.seed = 1; field.seed <= draws; ++field.seed) {
    const RandomField z(field, "random_field.su", {}, {1.01, 0.31});
    const Real at = z.at({0.01, 0.01});
    mean += at / draws;
    fourth += std::pow(at, 4) / draws;
    for (std::size_t k = 0; k < std::size(pairs); ++k) products[k] += at * z.at(pairs[k].first) / draws;
  }
  for (std::size_t k = 0; k < std::size(pairs); ++k)
    EXPECT_NEAR(products[k], pairs[k].second, errors * std::sqrt((1 + pairs[k].second * pairs[k].second) / draws)) << k;
  EXPECT_NEAR(mean, 0, errors / std::sqrt(draws));
  EXPECT_NEAR(fourth, 3, errors * std::sqrt(96. / draws));  // the variance of the fourth power is 105 - 9
}

TEST(RandomField, depends_on_seed_name_and_place_alone)
{
  RandomFieldSettings field = field_of(3, 1);
  field.correlation_length_z = 2;
  field.averaging_length = 0.5;
  const int threads = omp_get_max_threads();
  const RandomField whole(field, "random_field.su", {-4, 0, -2}, {5, 6, 3});
  omp_set_num_threads(threads == 1 ? 3 : 1);
  const RandomField part(field, "random_field.su", {1, 2, 0}, {2, 4, 1.5});
  omp_set_num_threads(threads);
  for (const Real x : {1.01, 1.6, 2.})
    for (const Real depth : {2., 3.3, 4.})
      for (const Real z : {0., 0.7, 1.4}) EXPECT_EQ(whole.at({x, depth, z}), part.at({x, depth, z}));
  EXPECT_EQ(part.at({-100, 3, 0.7}), part.at({1, 3, 0.7}));
  field.seed = 2;
  EXPECT_NE(RandomField(field, "random_field.su", {1, 2, 0}, {2, 4, 1.5}).at({1, 3}), part.at({1, 3}));
  field.seed = 1;
  EXPECT_NE(RandomField(field, "random_field.e", {1, 2, 0}, {2, 4, 1.5}).at({1, 3}), part.at({1, 3}));
}

TEST(RandomField, of_two_names_or_seeds_are_independent)
{
  const Real product = mean_over_seeds(field_of(1, {}), {0.01}, [](const RandomField& z) {
    static Real before = 0;
    const Real now = z.at({0.01});
    const Real both = now * before;
    before = now;
    return both;
  });
  EXPECT_NEAR(product, 0, errors / std::sqrt(realisations));
}

TEST(RandomField, meets_what_is_known_and_is_free_far_from_it)
{
  const std::vector<RandomField::Known> known = {{{0.31, 0.22}, 1.5}, {{0.31, 0.87}, -0.4}, {{1.44, 0.5}, 0.3}};
  RandomFieldSettings field = field_of(1, 0.5);
  for (const Correlation correlation : {Correlation::markov, Correlation::gaussian}) {
    field.correlation = correlation;
    for (field.seed = 1; field.seed <= 3; ++field.seed) {
      const RandomField free(field, "random_field.su", {}, {8, 2});
      const RandomField met(field, "random_field.su", {}, {8, 2}, known);
      for (const auto& [place, score] : known) EXPECT_NEAR(met.at(place), score, 1e-8);
      // Six correlation lengths away what is known has weights of exp(-12).
      EXPECT_NEAR(met.at({7.9, 1}), free.at({7.9, 1}), 1e-4);
      EXPECT_NE(met.at({0.4, 0.22}), free.at({0.4, 0.22}));
    }
  }
}

TEST(RandomField, near_a_known_value_has_the_mean_and_the_variance_of_kriging)
{
  // One known value at lag tau: mean r z and variance 1 - r^2, r = exp(-2 tau/theta).
  RandomFieldSettings field = field_of(1, {});
  Real sum = 0, squares = 0;
  const Real r = std::exp(-2 * 0.3), score = 2;
  for (field.seed = 1; field.seed <= realisations; ++field.seed) {
    const Real z = RandomField(field, "random_field.su", {}, {1}, {{{0.51}, score}}).at({0.81}) - r * score;
    sum += z, squares += z * z;
  }
  const Real variance = 1 - r * r;
  EXPECT_NEAR(sum / realisations, 0, errors * std::sqrt(variance / realisations));
  EXPECT_NEAR(squares / realisations / variance, 1, errors * std::sqrt(2. / realisations));
}

TEST(RandomField, takes_the_mean_of_what_is_known_in_one_cell)
{
  EXPECT_NEAR(RandomField(field_of(1, {}), "random_field.su", {}, {2}, {{{0.501}, 1}, {{0.502}, 2}}).at({0.51}), 1.5, 1e-8);
}

TEST(RandomField, refuses_what_it_cannot_meet)
{
  const auto message_of = [](const RandomFieldSettings& field, const std::vector<RandomField::Known>& known, Real size = 2) {
    try {
      const RandomField z(field, "random_field.su", {}, {size, 2}, known);
    } catch (const KeyError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_NE(message_of(field_of(1, 1), {{{5, 0}, 1}}).find("random_field.su.sounding: x = 5 m, 0 m deep, lies outside the mesh"),
            std::string::npos);
  RandomFieldSettings smooth = field_of(1, 1);
  smooth.correlation = Correlation::gaussian;
  std::vector<RandomField::Known> rough;
  for (int k = 0; k < 20; ++k) rough.push_back({{0.05 * k + 0.01, 0.1}, k % 2 == 0 ? 1. : -1.});
  EXPECT_NE(message_of(smooth, rough).find("contradict the correlation"), std::string::npos);
  EXPECT_EQ(message_of(field_of(1, 1), rough), "");
  EXPECT_NE(message_of(field_of(1e-3, 1e-3), {}).find("random_field.su.averaging_length"), std::string::npos);
  const auto far_off = [] { RandomField(field_of(1e-2, 1), "random_field.su", {6.1e6, 0}, {6.1e6 + 1, 2}); };
  EXPECT_NE(test::error_of<KeyError>(far_off).find("place the origin of x and z near the mesh"), std::string::npos);
}

}  // namespace
}  // namespace berm::settings::this_file
