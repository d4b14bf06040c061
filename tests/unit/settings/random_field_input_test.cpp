// SPDX-License-Identifier: BSD-3-Clause
// Random fields of a case: what is refused, and what particles and elements get of them.
#include "fem/fem_problem.hpp"
#include "material/clay.hpp"
#include "samples/random_footing.hpp"
#include "samples/temporary_folder.hpp"
#include "settings/safety.hpp"

#include <gtest/gtest.h>

namespace berm::settings::this_file {
namespace {

/// Clay whose strength is 10 kPa and 2 kPa/m.
const RandomFooting footing{R"([material.clay]
law = "clay"
density = "1800 kg/m^3"
rigidity_index = 100
poisson_ratio = 0.49
undrained_strength = "10 kPa"
undrained_strength_gradient = "2 kPa/m"
[random_field.su]
material = "clay"
property = "undrained_strength"
coefficient_of_variation = 0.4
correlation_length_x = "2 m"
correlation_length_depth = "1 m"
[[random_field.su.sounding]]
x = "0.55 m"
depth = ["0.52 m", "1.02 m"]
value = ["20 kPa", "9 kPa"]
[body.soil]
material = "clay"
regions = ["near", "bed"]
)",
                            "friction_angle = 0\nadhesion_factor = 0.5\n"};

TEST(RandomFieldInput, is_refused_where_it_makes_no_field)
{
  const std::pair<std::vector<std::string>, const char*> wrong[] = {
      {{"random_field.su.material=\"silt\""}, "silt"},
      {{"random_field.su.property=\"cohesion\""}, "has no property \"cohesion\" that varies from place to place"},
      {{"random_field.su.correlation_length_z=\"1 m\""}, "correlation_length_z: is for geometry = \"space\""},
      {{"random_field.su.sounding=[{x=0, depth=[1, 0.5], value=[1, 1]}]"}, "each depth must be larger than the one before"},
      {{"random_field.su.sounding=[{x=0, depth=[1], value=[1, 1]}]"}, "needs a value for each of the 1 depths, and has 2"},
      {{"random_field.su.coefficient_of_variation=0"}, "coefficient_of_variation"},
      {{"random_field.more={material=\"clay\", property=\"undrained_strength\", coefficient_of_variation=0.1, correlation_length_x=1}"},
       "varies what [random_field.su] varies"},
      {{"random_field.more={material=\"clay\", property=\"young_modulus\", coefficient_of_variation=0.1}"},
       "needs a correlation_length_x, correlation_length_depth or both"}};
  for (const auto& [overrides, says] : wrong)
    EXPECT_NE(footing.refusal(overrides).find(says), std::string::npos) << says << " is not in " << footing.refusal(overrides);
  EXPECT_EQ(footing.refusal({}), "");
}

TEST(RandomFieldInput, gives_elements_and_particles_the_same_soil_which_meets_its_sounding)
{
  const TemporaryFolder folder;
  const Case by_elements = footing.with({});
  const fem::FemProblem elements = fem::build_fem(by_elements, ".", folder.path().string());
  const BodySoil& soil = elements.model.model.bodies[0].soil;
  ASSERT_EQ(soil.fields.size(), 1u);
  for (const auto& [depth, strength] : {std::pair(0.52, 20e3), std::pair(1.02, 9e3)}) {
    const material::Material there = soil.at("", SoilPlace{0.55, depth});
    EXPECT_NEAR(local_values(there)[0] / strength, 1, 1e-7);
    EXPECT_NEAR(local_values(there)[1] / (2 * 1.49 * 100 * strength), 1, 1e-7) << "the rigidity index stays";
  }
  EXPECT_NEAR(local_values(soil.at("", 0.5))[0], 11e3, 1e-9) << "without a place the mean";
  Case by_particles = by_elements;
  by_particles.method = Method::mpm;
  const problem::Problem<2> particles = problem::build<2>(by_particles, ".", folder.path().string());
  int compared = 0;
  particles.state.particles[0].visit([&](Index, Index b, int l) {
    const bodies::Particle<2> p = particles.state.particles[0].read(b, l);
    const SoilPlace place{p.x[0], -p.x[1]};
    EXPECT_EQ(p.extra[3], local_values(soil.at("", place))[0]);
    EXPECT_EQ(p.extra[4], local_values(soil.at("", place))[1]);
    ++compared;
  });
  EXPECT_GT(compared, 500);
  const std::vector<Real> here = local_values(elements.model.soil_at(3, 1));
  EXPECT_EQ(here[0], local_values(soil.at("", elements.model.place[3][1]))[0]);
  bool adhesion_varies = false;
  for (const fem::FemContactPoint& point : elements.model.contact) {
    const Vec<2>& x = elements.model.mesh.position[point.node];
    EXPECT_NEAR(point.adhesion, 0.5 * local_values(soil.at("", SoilPlace{x[0], -x[1]}))[0], 1e-6);
    adhesion_varies = adhesion_varies || std::abs(point.adhesion - elements.model.contact.front().adhesion) > 10;
  }
  EXPECT_TRUE(adhesion_varies);
}

TEST(RandomFieldInput, has_the_mean_and_the_scatter_of_the_case)
{
  // One value in each of 2000 realisations. Standard errors: V/sqrt(n) of the mean, and of the variance sqrt((kurtosis - 1)/n), kurtosis of a lognormal variable with V = 0.4: w = 1 + V^2,
  // w^4 + 2 w^3 + 3 w^2 - 3 = 5.97. Four of each.
  constexpr int realisations = 2000;
  Case c = footing.with({});
  c.random_field[0].second.sounding.clear();
  c.random_field[0].second.correlation_length_x.reset();
  Real sum = 0, squares = 0;
  for (int seed = 1; seed <= realisations; ++seed) {
    c.random_field[0].second.seed = seed;
    BodySoil soil = soil_of(c, c.body[0].second);
    make_random_fields(soil, {0, 0}, {0, 1});
    const Real over_mean = local_values(soil.at("", SoilPlace{0, 0.5}))[0] / 11e3;
    sum += over_mean / realisations;
    squares += std::pow(over_mean - 1, 2) / realisations;
  }
  EXPECT_NEAR(sum, 1, 4 * 0.4 / std::sqrt(realisations));
  EXPECT_NEAR(squares / 0.16, 1, 4 * std::sqrt(4.97 / realisations));
}

TEST(RandomFieldInput, of_equal_materials_leaves_each_its_own)
{
  Case c = footing.with({"material.other={law=\"clay\", density=\"1800 kg/m^3\", rigidity_index=100, poisson_ratio=0.49, "
                         "undrained_strength=\"10 kPa\", undrained_strength_gradient=\"2 kPa/m\"}",
                         "body.soil.soil_layer=[{top=1, material=\"other\"}]"});
  c.random_field[0].second.sounding.clear();
  BodySoil soil = soil_of(c, c.body[0].second);
  ASSERT_EQ(soil.materials.size(), 2u);
  make_random_fields(soil, {0, 0}, {2, 2});
  EXPECT_EQ(local_values(soil.at("", SoilPlace{1, 1.5}))[0], 13e3);
  EXPECT_NE(local_values(soil.at("", SoilPlace{1, 0.5}))[0], 11e3);
}

TEST(RandomFieldInput, of_soil_with_a_factor_of_safety_is_divided_with_its_sounding)
{
  const auto strength = [](const Case& c, const SoilPlace& place) {
    BodySoil soil = soil_of(c, c.body[0].second);
    make_random_fields(soil, {-2, 0}, {2, 2});
    return local_values(soil.at("", place))[0];
  };
  const Case c = footing.with({});
  Case trial = c;
  trial.safety = SafetySettings{.factor = 2, .movement = {}};
  trial = with_reduced_strength(trial);
  for (const SoilPlace place : {SoilPlace{0.55, 0.52}, SoilPlace{-1, 1.3}})
    EXPECT_NEAR(strength(trial, place) / strength(c, place), 0.5, 1e-9);
}

TEST(RandomFieldInput, is_of_no_cost_where_there_is_none)
{
  Case c = footing.with({});
  c.random_field.clear();
  const BodySoil soil = soil_of(c, c.body[0].second);
  EXPECT_EQ(local_values(soil.at("", SoilPlace{3, 0.7})), local_values(soil.at("", 0.7)));
  c.material[0].second.get_if<material::Clay>()->undrained_strength_gradient = 0;
  EXPECT_FALSE(varies(soil_of(c, c.body[0].second)));
}

}  // namespace
}  // namespace berm::settings::this_file
