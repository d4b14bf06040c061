// SPDX-License-Identifier: BSD-3-Clause
#include "samples/critical_state_soils.hpp"
#include "samples/sample_case.hpp"

#include <gtest/gtest.h>

namespace berm::problem::this_file {
namespace {

/// The box of pipe_over_box() filled with Cam clay up to its surface, 1 m, under gravity.
settings::Case bed_of_clay(Real k0)
{
  settings::Case c = pipe_over_box({stage_of(settings::StageKind::free)});
  c.gravity = {0, -10};
  c.material = {{"solid", sample_cam_clay()}};
  bodies::BlockSettings block;
  block.center = {1, 0.5};
  block.size = {2, 1};
  block.spacing = 0.1;
  c.body[0].second.regions.clear();
  c.body[0].second.block = block;
  c.body[0].second.k0 = k0;
  c.support = {{"base", {"bottom", {"x", "y"}}}, {"left", {"left", {"x"}}}, {"right", {"right", {"x"}}}};
  return c;
}

/// Whether each particle has the state of soil at rest under its own stress.
void expect_states_at_rest(const Problem<2>& problem)
{
  const bodies::Particles<2>& particles = problem.state.particles[0];
  int count = 0;
  Real least = infinity, most = 0;
  particles.visit([&](Index, Index b, int l) {
    const bodies::Particle<2> p = particles.read(b, l);
    Real expected = 0;
    initial_state(material_of(problem.model.bodies[0].soil, p.extra), {{p.stress[0], p.stress[1], p.stress[2], p.stress[3]}}, &expected);
    ASSERT_EQ(p.extra[0], expected);
    least = std::min(least, expected), most = std::max(most, expected);
    ++count;
  });
  EXPECT_GT(count, 100);
  EXPECT_GT(most, 3 * least) << "deeper clay was consolidated under more";
}

TEST(BuildLawState, particles_get_the_state_of_soil_at_rest_under_their_stress)
{
  expect_states_at_rest(build<2>(bed_of_clay(0.7), ".", "."));
}

TEST(BuildLawState, particles_of_several_materials_get_that_of_their_own)
{
  settings::Case c = bed_of_clay(0.7);
  material::ModifiedCamClay old = sample_cam_clay();
  old.overconsolidation_ratio = 4;
  c.material.push_back({"old", old});
  bodies::SoilLayerSettings layer;
  layer.top = 0.5;
  layer.material = "old";
  c.body[0].second.soil_layer = {layer};
  expect_states_at_rest(build<2>(c, ".", "."));
}

TEST(BuildLawState, gravity_loading_gives_it_after_its_own_stress)
{
  settings::Case c = bed_of_clay(0.7);
  c.initial_state = settings::InitialState::gravity_loading;
  expect_states_at_rest(build<2>(c, ".", "."));
}

}  // namespace
}  // namespace berm::problem::this_file
