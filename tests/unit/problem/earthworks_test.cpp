// SPDX-License-Identifier: BSD-3-Clause
#include "problem/earthworks.hpp"

#include "mesh/seabed.hpp"
#include "os/error.hpp"
#include "samples/sample_case.hpp"
#include "samples/temporary_folder.hpp"

#include <gtest/gtest.h>
#include <set>

namespace berm::problem::this_file {
namespace {

/// A box of 2 m x 2 m whose lower half is an elastic block; what is above it is filled or taken out in the second of two stages.
settings::Case half_full()
{
  settings::Case c = pipe_over_box({stage_of(settings::StageKind::geostatic, "before"), stage_of(settings::StageKind::free, "works")});
  c.rigid.clear();
  c.gravity = {0, -10};
  std::get<mesh::BoxMesh>(c.mesh).cells = {8, 8};
  material::LinearElastic heavy;
  heavy.density = 2000;
  heavy.young_modulus = 2e6;
  c.material.emplace_back("heavy", heavy);
  bodies::BodySettings& body = c.body[0].second;
  body.regions.clear();
  body.block = bodies::BlockSettings{{1, 0.5}, {2, 1}, 0, 0.25 / 3};
  return c;
}

/// Over all particles of a body.
struct Sums {
  Real mass = 0, kinetic = 0;
  Vec<2> momentum = Vec<2>::Zero();
};

Sums sums_over(const bodies::Particles<2>& particles)
{
  Sums sums;
  particles.visit([&](Index, Index b, int l) {
    const bodies::Particle<2> p = particles.read(b, l);
    sums.mass += p.mass;
    sums.kinetic += p.mass * p.v.squaredNorm() / 2;
    sums.momentum += p.mass * p.v;
  });
  return sums;
}

template <class Settings>
Settings rectangle(const char* name, Real left, Real right, Real bottom, Real top)
{
  Settings work;
  work.name = name;
  work.stage = "works";
  work.area = {{left, right, right, left}, {bottom, bottom, top, top}};
  return work;
}

bodies::FillSettings fill_of(Real left, Real right, Real bottom, Real top)
{
  auto fill = rectangle<bodies::FillSettings>("fill", left, right, bottom, top);
  fill.material = "heavy";
  return fill;
}

bodies::ExcavationSettings excavation_of(Real left, Real right, Real bottom, Real top)
{
  return rectangle<bodies::ExcavationSettings>("cut", left, right, bottom, top);
}

Real round_off(Real size)
{
  return 1e-12 * size;
}

/// The problem in its second stage.
Problem<2> at_works(const settings::Case& c)
{
  const TemporaryFolder folder;
  Problem<2> problem = build<2>(c, ".", folder.path().string());
  problem.state.stage.index = 1;
  begin_stage(problem.model, problem.state);
  return problem;
}

TEST(Earthworks, fill_places_the_mass_of_its_area_at_rest)
{
  settings::Case c = half_full();
  c.body[0].second.fill = {fill_of(0.5, 1.5, 1, 1.75)};
  Problem<2> problem = at_works(c);
  State<2>& state = problem.state;
  const Sums before = sums_over(state.particles[0]);
  ASSERT_TRUE(carry_out_earthworks(problem.model, state));
  const Sums after = sums_over(state.particles[0]);
  // 4 x 3 squares of the mesh with two triangles of nine particles each.
  EXPECT_EQ(state.earthworks[0].particles, 4 * 3 * 2 * 9);
  EXPECT_NEAR(state.earthworks[0].volume, 0.75, round_off(1));
  EXPECT_NEAR(state.earthworks[0].mass, 1500, round_off(1500));
  EXPECT_NEAR(after.mass - before.mass, 1500, round_off(3500));
  EXPECT_EQ(after.momentum, before.momentum);
  EXPECT_FALSE(carry_out_earthworks(problem.model, state)) << "once is enough";
}

TEST(Earthworks, nothing_happens_before_its_stage)
{
  settings::Case c = half_full();
  c.body[0].second.fill = {fill_of(0, 2, 1, 2)};
  Problem<2> problem = build<2>(c, ".", ".");
  EXPECT_FALSE(carry_out_earthworks(problem.model, problem.state));
}

TEST(Earthworks, fill_leaves_out_soil_that_is_there)
{
  settings::Case c = half_full();
  c.body[0].second.fill = {fill_of(0, 2, 0.25, 1.5)};
  Problem<2> problem = at_works(c);
  carry_out_earthworks(problem.model, problem.state);
  EXPECT_NEAR(problem.state.earthworks[0].volume, 1, round_off(1)) << "half a metre above the soil";
  std::set<std::int32_t> numbers;
  problem.state.particles[0].visit([&](Index, Index b, int l) { numbers.insert(problem.state.particles[0].block(b).id[l]); });
  EXPECT_EQ(numbers.size(), static_cast<std::size_t>(problem.state.particles[0].size()));
  EXPECT_EQ(*numbers.begin(), 0);
  EXPECT_EQ(*numbers.rbegin() + 1, problem.state.numbered[0]);
}

TEST(Earthworks, fill_leaves_out_rigid_bodies)
{
  settings::Case c = half_full();
  bodies::RigidSettings pipe;
  pipe.shape = bodies::CircleSettings{{1, 1.5}, 0.6};
  c.rigid = {{"pipe", pipe}};
  c.body[0].second.fill = {fill_of(0, 2, 1, 2)};
  Problem<2> problem = at_works(c);
  carry_out_earthworks(problem.model, problem.state);
  problem.state.particles[0].visit([&](Index, Index b, int l) {
    const Vec<2> x = problem.state.particles[0].read(b, l).x;
    EXPECT_GE((x - Vec<2>(1, 1.5)).norm(), 0.3);
  });
  EXPECT_NEAR(problem.state.earthworks[0].volume, 2 - pi * 0.09, 0.01 * (2 - pi * 0.09)) << "particles at the rim make up for what it cuts";
}

TEST(Earthworks, lifts_come_from_the_bottom_up_over_the_duration_with_stress_of_their_own_weight)
{
  settings::Case c = half_full();
  bodies::FillSettings fill = fill_of(0, 2, 1, 2);
  fill.lifts = 2;
  fill.duration = 4;
  fill.k0 = 0.4;
  c.body[0].second.fill = {fill};
  Problem<2> problem = at_works(c);
  State<2>& state = problem.state;
  const auto highest = [&] {
    Real top = 0;
    state.particles[0].visit([&](Index, Index b, int l) { top = std::max(top, state.particles[0].block(b).x[1][l]); });
    return top;
  };
  ASSERT_TRUE(carry_out_earthworks(problem.model, state));
  EXPECT_NEAR(highest(), 1.5, 0.05);
  state.particles[0].visit([&](Index, Index b, int l) {
    const bodies::Particle<2> p = state.particles[0].read(b, l);
    if (p.x[1] < 1) return;
    const Real vertical = -2000 * 10 * (1.5 - p.x[1]);
    EXPECT_NEAR(p.stress[1], vertical, 1e-8);
    EXPECT_NEAR(p.stress[0], 0.4 * vertical, 1e-8);
    EXPECT_NEAR(p.stress[2], 0.4 * vertical, 1e-8);
  });
  state.time = 1.9;
  EXPECT_FALSE(carry_out_earthworks(problem.model, state));
  state.time = 2.1;
  ASSERT_TRUE(carry_out_earthworks(problem.model, state));
  EXPECT_NEAR(highest(), 2, 0.05);
  EXPECT_NEAR(state.earthworks[0].mass, 4000, round_off(4000));
}

TEST(Earthworks, lifts_left_when_the_stage_ends_follow_at_once)
{
  settings::Case c = half_full();
  c.stage.push_back(stage_of(settings::StageKind::free, "later"));
  bodies::FillSettings fill = fill_of(0, 2, 1, 2);
  fill.lifts = 10;
  fill.duration = 1000;
  c.body[0].second.fill = {fill};
  Problem<2> problem = at_works(c);
  carry_out_earthworks(problem.model, problem.state);
  EXPECT_EQ(problem.state.earthworks[0].lifts, 1);
  problem.state.stage.index = 2;
  carry_out_earthworks(problem.model, problem.state);
  EXPECT_EQ(problem.state.earthworks[0].lifts, 10);
}

TEST(Earthworks, excavation_tells_what_it_takes_along)
{
  settings::Case c = half_full();
  c.body[0].second.initial_velocity = {{{0.3, -0.2}, {}, 0}};
  c.body[0].second.excavation = {excavation_of(0.6, 1.1, 0.4, 1.2)};
  Problem<2> problem = at_works(c);
  State<2>& state = problem.state;
  const Sums before = sums_over(state.particles[0]);
  ASSERT_TRUE(carry_out_earthworks(problem.model, state));
  const Sums after = sums_over(state.particles[0]);
  const EarthworkState<2>& cut = state.earthworks[0];
  EXPECT_GT(cut.particles, 20);
  EXPECT_NEAR(before.mass - after.mass, cut.mass, round_off(2000));
  EXPECT_NEAR((before.momentum - after.momentum - cut.momentum).norm(), 0, round_off(1000));
  EXPECT_NEAR(before.kinetic - after.kinetic, cut.kinetic, round_off(1000));
  state.particles[0].visit([&](Index, Index b, int l) {
    const Vec<2> x = state.particles[0].read(b, l).x;
    EXPECT_FALSE(0.6 < x[0] && x[0] < 1.1 && 0.4 < x[1]);
  });
}

TEST(Earthworks, what_is_taken_out_and_filled_in_one_stage_is_replaced)
{
  settings::Case c = half_full();
  c.body[0].second.excavation = {excavation_of(0, 1, 0.5, 1)};
  c.body[0].second.fill = {fill_of(0, 1, 0.5, 1)};
  Problem<2> problem = at_works(c);
  const Real before = sums_over(problem.state.particles[0]).mass;
  carry_out_earthworks(problem.model, problem.state);
  EXPECT_NEAR(sums_over(problem.state.particles[0]).mass - before, 0.5 * (2000 - 1000), round_off(2000));
}

TEST(Earthworks, particles_of_a_fill_have_its_material)
{
  settings::Case c = half_full();
  c.body[0].second.fill = {fill_of(0, 2, 1, 2)};
  Problem<2> problem = at_works(c);
  carry_out_earthworks(problem.model, problem.state);
  const settings::BodySoil& soil = problem.model.bodies[0].soil;
  problem.state.particles[0].visit([&](Index, Index b, int l) {
    const bodies::Particle<2> p = problem.state.particles[0].read(b, l);
    EXPECT_EQ(density(material_of(soil, p.extra)), p.x[1] > 1 ? 2000 : 1000);
  });
  EXPECT_EQ(problem.model.bodies[0].waves.fastest, settings::waves_of(soil.materials[0]).fastest) << "1000 m/s2 x 1e6 Pa and twice both";
}

TEST(Earthworks, fill_outside_the_mesh_is_refused)
{
  settings::Case c = half_full();
  c.body[0].second.fill = {fill_of(5, 6, 1, 2)};
  EXPECT_THROW(build<2>(c, ".", "."), KeyError);
  c.body[0].second.fill.insert(c.body[0].second.fill.begin(), fill_of(0, 1, 1, 2));
  EXPECT_THROW(build<2>(c, ".", "."), KeyError) << "also behind one that is inside";
}

TEST(Earthworks, fill_above_the_mesh_is_refused)
{
  settings::Case c = half_full();
  c.body[0].second.fill = {fill_of(0, 1, 1, 2.5)};
  EXPECT_THROW(build<2>(c, ".", "."), KeyError);
}

/// The mass of a fill after all its lifts, and what its area has room for. `top`: of the bed.
struct Filled {
  Real mass, room;
};
Filled filled(settings::Case c, int lifts, Real bottom, Real top)
{
  bodies::FillSettings fill = fill_of(-0.1, 2.1, bottom, top);
  fill.lifts = lifts;
  fill.duration = lifts;
  c.body[0].second.fill = {fill};
  Problem<2> problem = at_works(c);
  for (int k = 0; k < lifts; ++k) {
    problem.state.time = k + 0.5;
    carry_out_earthworks(problem.model, problem.state);
  }
  const EarthworkState<2>& done = problem.state.earthworks[0];
  EXPECT_EQ(done.lifts, lifts);
  return {done.mass, mass_of_room(problem.model, problem.model.earthworks[0], done)};
}

/// Particles of a lift are left as they are where they hold its volume to this part.
constexpr Real a_hundredth = 0.01;

TEST(Earthworks, fill_has_its_mass_in_any_number_of_lifts_on_any_mesh)
{
  for (const mesh::BoxPattern pattern : {mesh::BoxPattern::diagonal, mesh::BoxPattern::criss_cross})
    for (const int cells : {8, 13, 20}) {
      settings::Case c = half_full();
      std::get<mesh::BoxMesh>(c.mesh).pattern = pattern;
      std::get<mesh::BoxMesh>(c.mesh).cells = {static_cast<Real>(cells), static_cast<Real>(cells)};
      for (const int lifts : {1, 2, 3, 5, 7, 10}) {
        const Filled found = filled(c, lifts, 0.9, 1.53);
        EXPECT_NEAR(found.mass, 2000 * 2 * 0.53, a_hundredth * 2120) << cells << " cells, " << lifts << " lifts";
        EXPECT_NEAR(found.room, 2000 * 2 * 0.53, a_hundredth * 2120) << cells << " cells, " << lifts << " lifts";
      }
    }
}

TEST(Earthworks, fill_has_its_mass_around_an_axis)
{
  settings::Case c = half_full();
  c.geometry = settings::Geometry::axisymmetric;
  for (const int lifts : {1, 5, 10})
    EXPECT_NEAR(filled(c, lifts, 0.9, 1.53).mass, 2000 * 0.53 * 2, a_hundredth * 2120) << lifts << " lifts, per radian: R2 / 2 = 2";
}

TEST(Earthworks, fill_has_its_mass_on_triangles_of_gmsh_with_few_particles)
{
  settings::Case c = half_full();
  mesh::SeabedMesh bed;
  bed.length = 2;
  bed.left = 0;
  bed.depth = 1;
  bed.headroom = 1;
  bed.near_size = 0.1;
  bed.near_left = 0.5;
  bed.near_right = 1.5;
  bed.near_depth = 0.3;
  bed.near_height = 0.6;
  c.mesh = bed;
  c.surface = 0;
  c.body[0].second.block.reset();
  c.body[0].second.regions = {"near", "bed"};
  c.body[0].second.particles_per_cell = 4;
  for (const int lifts : {1, 4, 9})
    EXPECT_NEAR(filled(c, lifts, -0.2, 0.43).mass, 2000 * 2 * 0.43, a_hundredth * 1720) << lifts << " lifts";
}

TEST(Earthworks, fill_has_the_stress_of_its_own_weight_whatever_its_particles_hold)
{
  settings::Case c = half_full();
  bodies::FillSettings fill = fill_of(0, 2, 1, 1.13);
  fill.k0 = 0.5;
  c.body[0].second.fill = {fill};
  Problem<2> problem = at_works(c);
  carry_out_earthworks(problem.model, problem.state);
  EXPECT_NEAR(problem.state.earthworks[0].mass, 2000 * 0.26, a_hundredth * 520);
  problem.state.particles[0].visit([&](Index, Index b, int l) {
    const bodies::Particle<2> p = problem.state.particles[0].read(b, l);
    if (p.x[1] < 1) return;
    EXPECT_NEAR(p.stress[1], -2000 * 10 * (1.13 - p.x[1]), 1e-8);
    EXPECT_NEAR(p.mass, 2000 * p.volume, 1e-9);
  });
}

TEST(Earthworks, lifts_thinner_than_a_row_of_particles_lack_mass_and_say_so)
{
  const Filled found = filled(half_full(), 40, 1, 1.27);
  EXPECT_NEAR(found.room, 2000 * 2 * 0.27, a_hundredth * 1080);
  EXPECT_LE(found.mass, found.room * (1 + a_hundredth));
}

}  // namespace
}  // namespace berm::problem::this_file
