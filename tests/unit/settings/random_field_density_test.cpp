// SPDX-License-Identifier: BSD-3-Clause
// Soil whose density varies at random: its weight, the vertical stress below it, and what particles and elements get of it.
#include "fem/fem_problem.hpp"
#include "material/mohr_coulomb.hpp"
#include "samples/random_footing.hpp"
#include "samples/temporary_folder.hpp"

#include <gtest/gtest.h>

namespace berm::settings::this_file {
namespace {

const RandomFooting footing = footing_on_random_sand(R"([random_field.gamma]
material = "sand"
property = "density"
coefficient_of_variation = 0.1
correlation_length_x = "1 m"
correlation_length_depth = "0.5 m"
)");

Case footing_with(std::vector<std::string> overrides = {})
{
  overrides.emplace_back("gravity=[0, -9.81]");
  return footing.with(overrides);
}

BodySoil drawn_soil(const Case& c)
{
  BodySoil soil = soil_of(c, c.body[0].second);
  make_random_fields(soil, {-2, 0}, {2, 2});
  return soil;
}

TEST(RandomDensity, is_refused_where_values_are_given_or_the_word_is_another)
{
  const std::pair<std::vector<std::string>, const char*> wrong[] = {
      {{"random_field.gamma.property=\"submerged_unit_weight\""}, "(allowed: cohesion, young_modulus, friction_angle, density)"},
      {{"random_field.gamma.sounding=[{x=0, depth=[1], value=[1]}]"}, "of a friction angle or density no values are taken"}};
  for (const auto& [overrides, says] : wrong)
    EXPECT_NE(footing.refusal(overrides).find(says), std::string::npos) << says << " is not in " << footing.refusal(overrides);
}

TEST(RandomDensity, has_the_mean_and_scatter_of_the_case_and_a_stress_that_scatters_as_a_mean_of_it)
{
  // Four standard errors, V/sqrt(n) and sqrt((kurtosis - 1)/n) with the kurtosis 3.16 of a lognormal variable with V = 0.1. The variance of the mean of density over T is V^2 gamma(T) but for
  // V^2/2, half a per cent; classes a tenth of a deviation apart add 0.1^2/12.
  constexpr int realisations = 2000;
  Case c = footing_with();
  RandomFieldSettings& field = c.random_field[0].second;
  field.correlation_length_x.reset();
  const Real V = field.coefficient_of_variation, theta = 0.5, T = 1;
  Real sum = 0, squares = 0, sum_above = 0, squares_above = 0;
  for (int seed = 1; seed <= realisations; ++seed) {
    field.seed = seed;
    const BodySoil soil = drawn_soil(c);
    const Real here = density(soil.at("", SoilPlace{0, 0.3})) / 900, above = soil.vertical_stress("", SoilPlace{0, T}) / (900 * 9.81 * T);
    sum += here / realisations, squares += std::pow(here - 1, 2) / realisations;
    sum_above += above / realisations, squares_above += std::pow(above - 1, 2) / realisations;
  }
  const Real reduction = variance_function(Correlation::markov, theta, T), error = 4 * std::sqrt(2.16 / realisations);
  EXPECT_NEAR(sum, 1, 4 * V / std::sqrt(realisations));
  EXPECT_NEAR(squares / (V * V), 1, error + 0.002);
  EXPECT_NEAR(sum_above, 1, 4 * V * std::sqrt(reduction / realisations));
  EXPECT_NEAR(squares_above / (V * V * reduction), 1, error + 0.007);
}

TEST(RandomDensity, gives_elements_and_particles_the_same_weight_and_stress)
{
  const TemporaryFolder folder;
  const Case by_elements = footing_with();
  const fem::FemProblem elements = fem::build_fem(by_elements, ".", folder.path().string());
  const BodySoil& soil = elements.model.model.bodies[0].soil;
  // A sum over a thousand steps: a cell of the field, 25 mm, that a step cuts adds at most (rho - mean) of a step.
  const auto weight_above = [&](const SoilPlace& place) {
    constexpr int steps = 1000;
    Real sum = 0;
    for (int k = 0; k < steps; ++k) sum += density(soil.at("", SoilPlace{place.x, place.depth * (k + 0.5) / steps}));
    return sum * place.depth / steps * soil.gravity;
  };
  EXPECT_EQ(density(soil.at("", 0.5)), 900) << "without a place the mean";
  for (const SoilPlace place : {SoilPlace{0.3, 0.7}, SoilPlace{-1.2, 1.9}})
    EXPECT_NEAR(soil.vertical_stress("", place) / weight_above(place), 1, 1e-3);
  for (const Index cell : {3, 40}) {
    const SoilPlace& place = elements.model.place[cell][1];
    EXPECT_EQ(elements.model.density[cell][1], density(soil.at("", place)));
    EXPECT_NEAR(elements.state.points[cell][1].stress[1] / -soil.vertical_stress("", place), 1, 1e-12);
  }
  Case by_particles = by_elements;
  by_particles.method = Method::mpm;
  const problem::Problem<2> particles = problem::build<2>(by_particles, ".", folder.path().string());
  Real least = infinity, largest = 0;
  particles.state.particles[0].visit([&](Index, Index b, int l) {
    const bodies::Particle<2> p = particles.state.particles[0].read(b, l);
    const SoilPlace place{p.x[0], -p.x[1]};
    const Real here = density(soil.at("", place));
    EXPECT_NEAR(p.mass / p.volume, here * 1900 / 900, 1e-9 * here);
    EXPECT_NEAR(inertia_density(material_of(particles.model.bodies[0].soil, p.extra)), p.mass / p.volume, 1e-9 * here);
    EXPECT_NEAR(p.stress[1] / -soil.vertical_stress("", place), 1, 1e-12);
    EXPECT_NEAR(p.stress[0] / p.stress[1], 0.5, 1e-12);
    least = std::min(least, here), largest = std::max(largest, here);
  });
  EXPECT_LT(least, 0.8 * 900);
  EXPECT_GT(largest, 1.2 * 900);
}

TEST(RandomDensity, varies_in_its_own_layer_alone)
{
  const Case c = footing_with({"material.crust={law=\"mohr_coulomb\", density=\"500 kg/m^3\", inertia_density=1055.555555556, "
                               "young_modulus=1e7, poisson_ratio=0.3, cohesion=1000, friction_angle=0.5}",
                               "body.soil.material=\"crust\"", "body.soil.soil_layer=[{top=1, material=\"sand\"}]"});
  const BodySoil soil = drawn_soil(c);
  EXPECT_EQ(soil.mass_above("", SoilPlace{0.4, 0.8}), 500 * 0.8);
  EXPECT_NE(soil.mass_above("", SoilPlace{0.4, 1.8}), 500 * 1. + 900 * 0.8);
  const Real crossing = soil.mass_above("", SoilPlace{0.4, 1 + 1e-6}) - soil.mass_above("", SoilPlace{0.4, 1});
  EXPECT_NEAR(crossing / (1e-6 * density(soil.at("", SoilPlace{0.4, 1 + 5e-7}))), 1, 1e-6) << "the weight grows by the soil that is there";
}

TEST(RandomDensity, may_vary_with_the_friction_angle_each_by_its_own_field)
{
  const std::string phi =
      "random_field.phi={material=\"sand\", property=\"friction_angle\", coefficient_of_variation=0.2, correlation_length_x=\"0.7 m\"}";
  const BodySoil both = drawn_soil(footing_with({phi})), by_weight = drawn_soil(footing_with());
  const auto friction = [](const BodySoil& soil, const SoilPlace& place) {
    return soil.at("", place).get_if<material::MohrCoulomb>()->friction_angle;
  };
  Case alone = footing_with({phi});
  alone.random_field.erase(alone.random_field.begin());
  const BodySoil by_friction = drawn_soil(alone);
  for (const SoilPlace place : {SoilPlace{0.3, 0.7}, SoilPlace{-1.2, 1.9}, SoilPlace{1.4, 0.1}}) {
    EXPECT_EQ(density(both.at("", place)), density(by_weight.at("", place)));
    EXPECT_EQ(friction(both, place), friction(by_friction, place));
  }
}

}  // namespace
}  // namespace berm::settings::this_file
