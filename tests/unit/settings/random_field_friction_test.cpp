// SPDX-License-Identifier: BSD-3-Clause
// Sand whose friction angle varies at random: what is refused, its distribution, and what particles and elements get of it.
#include "fem/fem_problem.hpp"
#include "material/mohr_coulomb.hpp"
#include "samples/random_footing.hpp"
#include "samples/temporary_folder.hpp"
#include "settings/safety.hpp"

#include <gtest/gtest.h>

namespace berm::settings::this_file {
namespace {

const RandomFooting footing = footing_on_random_sand(R"([random_field.phi]
material = "sand"
property = "friction_angle"
coefficient_of_variation = 0.3
correlation_length_x = "1 m"
correlation_length_depth = "0.5 m"
)");

const material::MohrCoulomb& law_of(const material::Material& material)
{
  return *material.get_if<material::MohrCoulomb>();
}

TEST(RandomFriction, is_refused_where_there_is_no_friction_angle_or_a_value_is_known)
{
  const std::pair<std::vector<std::string>, const char*> wrong[] = {
      {{"material.sand.friction_angle=0", "material.sand.dilation_angle=0"}, "has no property \"friction_angle\" that varies"},
      {{"random_field.phi.property=\"friction\""}, "did you mean \"friction_angle\""},
      {{"random_field.phi.sounding=[{x=0, depth=[1], value=[1]}]"}, "of a friction angle or density no values are taken"},
      {{"random_field.more={material=\"sand\", property=\"friction_angle\", coefficient_of_variation=0.1, correlation_length_x=1}"},
       "varies what [random_field.phi] varies"}};
  for (const auto& [overrides, says] : wrong)
    EXPECT_NE(footing.refusal(overrides).find(says), std::string::npos) << says << " is not in " << footing.refusal(overrides);
}

TEST(RandomFriction, has_the_mean_the_scatter_and_the_variance_of_means_of_a_lognormal_tangent)
{
  // A value in each of n realisations, and the mean of the logarithm over T = 2 theta. Four standard errors: V/sqrt(n) of the mean, sqrt((kurtosis - 1)/n) of the variance, whose kurtosis is
  // that of a lognormal variable with V = 0.3 (4.66), and sqrt(2/n) of the variance of a Gaussian mean. Classes a tenth of a deviation apart add 0.1^2/12 to the variance of the logarithm.
  constexpr int realisations = 2000, points = 40;
  Case c = footing.with({});
  RandomFieldSettings& field = c.random_field[0].second;
  field.correlation_length_x.reset();
  const Real tangent = std::tan(32 * degree), V = field.coefficient_of_variation, zeta = field.log_deviation(), theta = 0.5;
  Real sum = 0, squares = 0, of_means = 0;
  for (int seed = 1; seed <= realisations; ++seed) {
    field.seed = seed;
    BodySoil soil = soil_of(c, c.body[0].second);
    make_random_fields(soil, {0, 0}, {0, 1});
    const auto ratio = [&](Real depth) { return std::tan(law_of(soil.at("", SoilPlace{0, depth})).friction_angle) / tangent; };
    const Real here = ratio(0.3);
    sum += here / realisations;
    squares += std::pow(here - 1, 2) / realisations;
    Real mean = 0;
    for (int k = 0; k < points; ++k) mean += (std::log(ratio(2 * theta * (k + 0.5) / points)) + zeta * zeta / 2) / points;
    of_means += mean * mean / realisations;
  }
  EXPECT_NEAR(sum, 1, 4 * V / std::sqrt(realisations));
  EXPECT_NEAR(squares / (V * V), 1, 4 * std::sqrt(3.66 / realisations) + 0.002);
  const Real gamma = variance_function(Correlation::markov, theta, 2 * theta);
  EXPECT_NEAR(of_means / (zeta * zeta * gamma), 1, 4 * std::sqrt(2. / realisations) + 0.002);
}

TEST(RandomFriction, gives_elements_and_particles_the_same_sand)
{
  const TemporaryFolder folder;
  const Case by_elements = footing.with({});
  const fem::FemProblem elements = fem::build_fem(by_elements, ".", folder.path().string());
  const BodySoil& soil = elements.model.model.bodies[0].soil;
  EXPECT_NEAR(law_of(soil.at("", 0.5)).friction_angle, 32 * degree, 1e-12) << "without a place the mean";
  Case by_particles = by_elements;
  by_particles.method = Method::mpm;
  const problem::Problem<2> particles = problem::build<2>(by_particles, ".", folder.path().string());
  int compared = 0;
  Real least = infinity, largest = 0;
  particles.state.particles[0].visit([&](Index, Index b, int l) {
    const bodies::Particle<2> p = particles.state.particles[0].read(b, l);
    const material::MohrCoulomb& own = law_of(material_of(particles.model.bodies[0].soil, p.extra));
    const material::MohrCoulomb there = law_of(soil.at("", SoilPlace{p.x[0], -p.x[1]}));
    EXPECT_EQ(own.friction_angle, there.friction_angle);
    EXPECT_EQ(own.dilation_angle, std::min(20 * degree, own.friction_angle));
    least = std::min(least, own.friction_angle), largest = std::max(largest, own.friction_angle);
    ++compared;
  });
  EXPECT_GT(compared, 500);
  EXPECT_LT(least, 25 * degree);
  EXPECT_GT(largest, 40 * degree);
  EXPECT_EQ(law_of(elements.model.soil_at(3, 1)).friction_angle, law_of(soil.at("", elements.model.place[3][1])).friction_angle);
}

TEST(RandomFriction, is_divided_by_a_factor_of_safety)
{
  const auto tangent = [](const Case& c, const SoilPlace& place) {
    BodySoil soil = soil_of(c, c.body[0].second);
    make_random_fields(soil, {-2, 0}, {2, 2});
    return std::tan(law_of(soil.at("", place)).friction_angle);
  };
  const Case c = footing.with({});
  Case trial = c;
  trial.safety = SafetySettings{.factor = 1.5, .movement = {}};
  trial = with_reduced_strength(trial);
  for (const SoilPlace place : {SoilPlace{0.55, 0.52}, SoilPlace{-1, 1.3}})
    EXPECT_NEAR(tangent(c, place) / tangent(trial, place), 1.5, 1e-9);
}

}  // namespace
}  // namespace berm::settings::this_file
