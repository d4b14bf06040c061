// SPDX-License-Identifier: BSD-3-Clause
#include "settings/body_soil.hpp"

#include "material/mohr_coulomb.hpp"
#include "os/error.hpp"
#include "samples/sample_case.hpp"

#include <gtest/gtest.h>

namespace berm::problem::this_file {
namespace {

material::MohrCoulomb clay_of(Real strength, Real density = 1500)
{
  material::MohrCoulomb law;
  law.density = density;
  law.young_modulus = 500 * strength;
  law.poisson_ratio = 0.45;
  law.cohesion = strength;
  return law;
}

/// A box of 2 m with the surface at y = 2 m: soft clay, from 0.5 m down stiff clay, from 1.25 m down soft clay again under another name.
settings::Case layered()
{
  settings::Case c = pipe_over_box({stage_of(settings::StageKind::geostatic)});
  c.surface = 2;
  c.material = {{"soft", clay_of(1e3)}, {"stiff", clay_of(5e3, 2000)}, {"also_soft", clay_of(1e3)}};
  c.rigid.clear();
  bodies::BodySettings& body = c.body[0].second;
  body.material = "soft";
  body.soil_layer = {{0.5, "stiff"}, {1.25, "also_soft"}};
  return c;
}

TEST(BodySoil, has_each_material_once_and_knows_it_by_depth)
{
  const settings::BodySoil soil = soil_of(layered(), layered().body[0].second);
  ASSERT_EQ(soil.materials.size(), 2u);
  EXPECT_TRUE(varies(soil));
  const std::pair<Real, Index> expected[] = {{-1, 0}, {0.49, 0}, {0.5, 1}, {1.24, 1}, {1.25, 0}, {9, 0}};
  for (const auto& [depth, number] : expected) EXPECT_EQ(soil.material_index_at("box", depth), number) << depth;
  EXPECT_NEAR(soil.mass_above("box", 1.5), 0.5 * 1500 + 0.75 * 2000 + 0.25 * 1500, 1e-9);
}

TEST(BodySoil, of_equal_layers_is_that_of_one_material)
{
  settings::Case c = layered();
  c.material[1].second = clay_of(1e3);
  const settings::BodySoil soil = soil_of(c, c.body[0].second);
  EXPECT_EQ(soil.materials.size(), 1u);
  EXPECT_FALSE(varies(soil));
  EXPECT_TRUE(local_fields(soil).empty());
}

TEST(BodySoil, takes_materials_of_regions)
{
  settings::Case c = layered();
  bodies::BodySettings& body = c.body[0].second;
  body.soil_layer.clear();
  body.regions = {"box", "pit"};
  body.region_material = {{"pit", "stiff"}};
  const settings::BodySoil soil = soil_of(c, body);
  EXPECT_EQ(soil.material_index_at("box", 3), 0);
  EXPECT_EQ(soil.material_index_at("pit", 3), 1);
  EXPECT_EQ(soil.mass_above("pit", 3), 3 * 2000);
}

TEST(Build, gives_each_particle_mass_strength_stiffness_and_stress_of_its_layer)
{
  settings::Case c = layered();
  c.gravity = {0, -10};
  c.body[0].second.k0 = 0.5;
  auto* stiff = c.material[1].second.get_if<material::MohrCoulomb>();
  stiff->cohesion_gradient = 2e3;
  const Problem<2> problem = build<2>(c, mesh::make_box<2>(std::get<mesh::BoxMesh>(c.mesh)));
  const bodies::Particles<2>& particles = problem.state.particles[0];
  ASSERT_EQ(particles.extra_size(), 4);  // opening; cohesion, Young's modulus, number
  int in_stiff = 0;
  particles.visit([&](Index, Index b, int l) {
    const bodies::Particle<2> p = particles.read(b, l);
    const Real depth = 2 - p.x[1];
    const bool stiffer = depth >= 0.5 && depth < 1.25;
    in_stiff += stiffer;
    EXPECT_DOUBLE_EQ(p.mass, p.volume * (stiffer ? 2000 : 1500));
    EXPECT_DOUBLE_EQ(p.extra[1], stiffer ? 5e3 + 2e3 * depth : 1e3);
    EXPECT_DOUBLE_EQ(p.extra[2], stiffer ? 2.5e6 : 5e5);
    EXPECT_EQ(p.extra[3], stiffer ? 1 : 0);
    const Real above = depth < 0.5 ? 1500 * depth : stiffer ? 750 + 2000 * (depth - 0.5) : 2250 + 1500 * (depth - 1.25);
    EXPECT_NEAR(p.stress[1], -10 * above, 1e-9 * 1e5);
    EXPECT_NEAR(p.stress[0], -5 * above, 1e-9 * 1e5);
  });
  EXPECT_GT(in_stiff, 50);
  const settings::SoilWaves& waves = problem.model.bodies[0].waves;
  EXPECT_DOUBLE_EQ(waves.fastest, settings::waves_of(c.material[1].second).fastest);
  EXPECT_DOUBLE_EQ(waves.slowest, settings::waves_of(c.material[0].second).slowest);
  EXPECT_EQ(waves.min_density, 1500);
}

/// The box with strengths by the vertical stress: OCR over depth above, POP from 0.5 m down.
settings::Case by_stress()
{
  settings::Case c = layered();
  c.gravity = {0, -10};
  auto &above = *c.material[0].second.get_if<material::MohrCoulomb>(), &below = *c.material[1].second.get_if<material::MohrCoulomb>();
  above.cohesion = below.cohesion = 0;
  above.shansep = material::Shansep{.ratio = 0.25, .exponent = 0.8, .ocr = {}, .pop = {}};
  above.profile.depth = {0, 0.25};
  above.profile.ocr = {5, 3};
  below.shansep = material::Shansep{.ratio = 0.3, .exponent = 0.7, .ocr = {}, .pop = 12e3};
  c.body[0].second.soil_layer = {{0.5, "stiff"}};
  return c;
}

TEST(Build, gives_each_particle_the_strength_by_the_vertical_stress_that_the_soil_above_makes)
{
  const settings::Case c = by_stress();
  const Problem<2> problem = build<2>(c, mesh::make_box<2>(std::get<mesh::BoxMesh>(c.mesh)));
  const bodies::Particles<2>& particles = problem.state.particles[0];
  int above = 0, below = 0;
  particles.visit([&](Index, Index b, int l) {
    const bodies::Particle<2> p = particles.read(b, l);
    const Real depth = 2 - p.x[1];
    if (depth < 0.5) {
      const Real ocr = depth < 0.25 ? 5 - 8 * depth : 3;
      EXPECT_NEAR(p.extra[1], 0.25 * 15e3 * depth * std::pow(ocr, 0.8), 1e-9 * 1e4);
      ++above;
    } else {
      const Real stress = 7.5e3 + 20e3 * (depth - 0.5);
      EXPECT_NEAR(p.extra[1], 0.3 * stress * std::pow((stress + 12e3) / stress, 0.7), 1e-9 * 1e4);
      ++below;
    }
  });
  EXPECT_GT(above, 50);
  EXPECT_GT(below, 50);
}

TEST(BodySoil, of_a_stress_that_is_the_same_everywhere_has_the_strength_by_it)
{
  settings::Case c = by_stress();
  c.body[0].second.initial_stress = {-10e3, -20e3, -10e3};
  const settings::BodySoil soil = soil_of(c, c.body[0].second);
  for (const Real depth : {0., 0.4, 3.})
    EXPECT_DOUBLE_EQ(strength_at_rest(soil.at("box", depth))->cohesion,
                     depth < 0.5 ? 5e3 * std::pow(depth == 0 ? 5 : 3, 0.8) : 6e3 * std::pow(1.6, 0.7));
}

TEST(Build, refuses_soil_whose_strength_is_negative_where_the_body_reaches)
{
  settings::Case c = layered();
  c.body[0].second.soil_layer.clear();
  c.material[0].second.get_if<material::MohrCoulomb>()->cohesion_gradient = -800;  // nothing is left at 1.25 m
  try {
    build<2>(c, mesh::make_box<2>(std::get<mesh::BoxMesh>(c.mesh)));
    FAIL() << "it was accepted";
  } catch (const InputError& error) {
    for (const char* part : {"material.soft.cohesion_gradient: ", "below the surface", "[body.bed]"})
      EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
  }
  c.body[0].second.soil_layer = {{1, "stiff"}};
  EXPECT_NO_THROW(build<2>(c, mesh::make_box<2>(std::get<mesh::BoxMesh>(c.mesh))));
}

}  // namespace
}  // namespace berm::problem::this_file
