// SPDX-License-Identifier: BSD-3-Clause
#include "run_folder/frame_maker.hpp"

#include "bodies/fill.hpp"
#include "material/linear_elastic.hpp"
#include "material/mohr_coulomb.hpp"
#include "mesh/box.hpp"
#include "mpm/step.hpp"
#include "samples/frame_particles.hpp"

#include <gtest/gtest.h>
#include <map>

namespace berm::run_folder::this_file {
namespace {

/// A square of 0.2 m in the middle of a box of 0.4 m with 16 x 16 squares: cells of nine particles, or two halves that are two bodies.
problem::Problem<2> block_in_box(int bodies = 1)
{
  problem::Problem<2> problem{};
  problem.model.mesh = make_box<2>(mesh::BoxMesh{.lower = {-0.2, -0.2}, .size = {0.4, 0.4}, .cells = {16, 16}});
  material::LinearElastic solid;
  solid.density = 1000;
  solid.young_modulus = 1e6;
  problem.model.bodies.assign(bodies, {"body", settings::soil_of_one(solid), {}});
  for (int b = 0; b < bodies; ++b) {
    bodies::BlockSettings block;
    block.center = {bodies == 1 ? 0 : -0.05 + 0.1 * b, 0};
    block.size = {0.2 / bodies, 0.2};
    block.spacing = 0.025 / 4;
    bodies::BodySettings body;
    body.block = block;
    problem.state.particles.push_back(fill<2>(problem.model.mesh, "block", body, {1000, 0, 0}));
  }
  return problem;
}

/// Takes all particles of a body to where `place` says, and to the cells that hold them there.
template <class Place>
void take_to(problem::Problem<2>& problem, std::size_t body, const Place& place)
{
  bodies::Particles<2>& particles = problem.state.particles[body];
  std::vector<bodies::Particle<2>> all;
  for (Index cell = 0; cell < problem.model.mesh.cell_count(); ++cell)
    while (particles.count_in(cell) > 0) all.push_back(particles.take(cell, 0));
  for (bodies::Particle<2>& p : all) {
    p.x = place(p);
    particles.insert(locate(problem.model.mesh, p.x, 0).cell, p);
  }
}

void expect_strain(const Frame<2>& frame, Real deviatoric, Real increment, Real tolerance)
{
  for (const FrameParticle<2>& f : particles_of(frame)) {
    ASSERT_NEAR(f.strain.deviatoric, deviatoric, tolerance) << f.particle.id;
    ASSERT_NEAR(f.strain.volumetric, 0, tolerance) << f.particle.id;
    ASSERT_NEAR(f.strain_increment, increment, tolerance) << f.particle.id;
  }
}

// Places of 0.2 m have an error of 3e-17 m, over distances of a particle's spacing and more: 1e-13 leaves room for sums of some dozen.
constexpr Real rounding = 1e-13;

TEST(FrameMaker, a_block_that_moves_and_turns_has_no_strain)
{
  problem::Problem<2> problem = block_in_box();
  FrameMaker<2> maker(problem.model, problem.state);
  take_to(problem, 0, [](const bodies::Particle<2>& p) { return Vec<2>(p.x + Vec<2>(0.03, -0.02)); });
  expect_strain(maker.make(problem.state), 0, 0, rounding);
  take_to(problem, 0, [](const bodies::Particle<2>& p) { return Vec<2>(-p.x[1], p.x[0]); });
  const Frame<2> frame = maker.make(problem.state);
  expect_strain(frame, 0, 0, rounding);
  EXPECT_GT(particles_of(frame)[0].displacement.norm(), 0.1);
}

TEST(FrameMaker, a_sheared_block_has_the_strain_of_the_whole_shear_and_of_that_since_the_frame_before)
{
  problem::Problem<2> problem = block_in_box();
  FrameMaker<2> maker(problem.model, problem.state);
  const auto exact = [](Real gamma) { return 2 / std::sqrt(3.) * std::asinh(gamma / 2); };
  const auto shear = [&](Real gamma) {
    take_to(problem, 0, [&](const bodies::Particle<2>& p) { return Vec<2>(p.x[0] + gamma * p.x[1], p.x[1]); });
  };
  shear(0.5);
  expect_strain(maker.make(problem.state), exact(0.5), exact(0.5), rounding);
  shear(0.25);
  expect_strain(maker.make(problem.state), exact(0.75), exact(0.25), rounding);
  shear(-0.75);  // back: the whole shear is none, though all has sheared by 1.5
  expect_strain(maker.make(problem.state), 0, exact(0.75), rounding);
}

/// Numbers that are written, then read.
struct Kept : Archive {
  bool reading = false;
  std::map<std::string, std::vector<Real>> numbers;

  bool reads() const override { return reading; }
  void refuse(const std::string& why) const override { throw RunError(why); }
  template <class List>
  void take(const std::string& path, List& values)
  {
    if (reading)
      values.assign(numbers.at(path).begin(), numbers.at(path).end());
    else
      numbers[path].assign(values.begin(), values.end());
  }
  void list(const std::string& path, std::vector<Real>& values) override { take(path, values); }
  void list(const std::string& path, std::vector<Index>& values) override { take(path, values); }
  void list(const std::string& path, std::vector<BigIndex>& values) override { take(path, values); }
  void list(const std::string&, std::string&) override {}
};

TEST(FrameMaker, counts_displacements_and_strains_from_where_it_is_told_to_and_still_does_once_it_is_resumed)
{
  problem::Problem<2> problem = block_in_box();
  problem.model.stages.resize(2);
  problem.model.stages[1].name = "load", problem.model.stages[1].zero_displacements = true;
  FrameMaker<2> maker(problem.model, problem.state), resumed(problem.model, problem.state);
  const auto shear = [&](Real gamma) {
    take_to(problem, 0, [&](const bodies::Particle<2>& p) { return Vec<2>(p.x[0] + gamma * p.x[1], p.x[1]); });
  };
  const auto exact = [](Real gamma) { return 2 / std::sqrt(3.) * std::asinh(gamma / 2); };
  shear(0.5);
  const Frame<2> before = maker.make(problem.state);
  expect_strain(before, exact(0.5), exact(0.5), rounding);
  maker.zero_displacements(problem.state);
  shear(0.25);
  Kept kept;
  maker.archive(kept, false);
  kept.reading = true;
  resumed.archive(kept, false);
  for (FrameMaker<2>* each : {&maker, &resumed}) {
    const Frame<2> after = each->make(problem.state);
    expect_strain(after, exact(0.25), exact(0.25), rounding);
    for (const FrameParticle<2>& f : particles_of(after)) {
      EXPECT_NEAR(f.displacement[0], 0.25 * f.particle.x[1], rounding);
      EXPECT_EQ(f.displacement[1], 0);
    }
    EXPECT_EQ(after.field("displacement").info.label, "displacement since stage \"load\" began");
  }
}

TEST(FrameMaker, bodies_that_slide_past_each_other_have_no_strain)
{
  problem::Problem<2> problem = block_in_box(2);
  FrameMaker<2> maker(problem.model, problem.state);
  take_to(problem, 1, [](const bodies::Particle<2>& p) { return Vec<2>(p.x + Vec<2>(0, 0.07)); });
  expect_strain(maker.make(problem.state), 0, 0, rounding);
}

TEST(FrameMaker, grains_that_are_thrown_leave_finite_numbers_and_the_soil_away_from_them_without_strain)
{
  problem::Problem<2> problem = block_in_box();
  FrameMaker<2> maker(problem.model, problem.state);
  const Vec<2> corner(-0.1, 0.1), there(0.15, 0.15);
  const auto close = [&](const FrameParticle<2>& f) {
    return (f.particle.x - f.displacement - corner).cwiseAbs().maxCoeff() < 3 * 0.025 || (f.particle.x - there).norm() < 0.05;
  };
  std::int32_t thrown = none;
  for (int frames = 0; frames < 2; ++frames) {
    take_to(problem, 0, [&](const bodies::Particle<2>& p) {
      if (thrown == none && (p.x - corner).norm() < 0.025) thrown = p.id;
      return p.id == thrown ? Vec<2>(there + 1e-3 * frames * Vec<2>::Ones()) : p.x;
    });
    for (const FrameParticle<2>& f : particles_of(maker.make(problem.state))) {
      EXPECT_TRUE(std::isfinite(f.strain.deviatoric) && std::isfinite(f.strain.volumetric) && std::isfinite(f.strain_increment));
      if (f.particle.id == thrown) {
        EXPECT_GT(f.strain.deviatoric, 0.1);
        EXPECT_EQ(f.strain_increment, 0);  // a grain alone
      } else if (!close(f)) {
        EXPECT_NEAR(f.strain.deviatoric, 0, rounding);
        EXPECT_NEAR(f.strain_increment, 0, rounding);
      }
    }
  }
  ASSERT_NE(thrown, none);
}

/// A bed of sand, 0.4 m wide and 0.2 m deep, at rest under its weight.
settings::Case bed_at_rest()
{
  settings::Case c;
  c.gravity = {0, -10};
  c.mesh = mesh::BoxMesh{.lower = {-0.2, -0.2}, .size = {0.4, 0.4}, .cells = {16, 16}};
  material::MohrCoulomb sand;
  sand.density = 1600;
  sand.young_modulus = 1e7;
  sand.poisson_ratio = 0.3;
  sand.friction_angle = 0.6;
  c.material = {{"sand", sand}};
  bodies::BodySettings bed;
  bed.material = "sand";
  bodies::BlockSettings block;
  block.center = {0, -0.1};
  block.size = {0.4, 0.2};
  block.spacing = 0.025 / 4;
  bed.block = block;
  bed.k0 = 0.43;
  c.body = {{"bed", bed}};
  for (const char* side : {"left", "right", "bottom"}) {
    boundary::SupportSettings support;
    support.boundary = side;
    support.fixed = {side == std::string("bottom") ? "y" : "x"};
    c.support.emplace_back(side, support);
  }
  settings::StageSettings stage;
  stage.until.time = 10;
  c.stage = {stage};
  return c;
}

// Particles whose lattice does not fit the mesh make the bed ring for long, and sum up strain. Strained it is by no more than its weight can: rho g H/E = 3.2e-4
// at the bottom of an elastic bed, twice that where it is put on at once. 1e-3 leaves room for the cell at the surface.
TEST(FrameMaker, a_bed_at_rest_has_no_strain_however_long_it_rests)
{
  const settings::Case c = bed_at_rest();
  problem::Problem<2> problem = problem::build(c, make_mesh<2>(c.mesh, ".", "."));
  FrameMaker<2> maker(problem.model, problem.state);
  mpm::Workspace<2> workspace(problem.model, problem.state);
  for (int frames = 0; frames < 4; ++frames) {
    for (int n = 0; n < 1500; ++n) step(problem.model, problem.state, workspace);
    Real max = 0, max_increment = 0;
    for (const FrameParticle<2>& f : particles_of(maker.make(problem.state))) {
      max = std::max(max, f.strain.deviatoric);
      max_increment = std::max(max_increment, f.strain_increment);
    }
    EXPECT_LT(max, 1e-3);
    EXPECT_LT(max_increment, 1e-3);
  }
}

TEST(FrameMaker, shows_pore_pressure_and_effective_stress_where_a_body_is_undrained)
{
  problem::Problem<2> problem = block_in_box(2);
  material::LinearElastic wet = problem.model.bodies[1].soil.materials.front().get<material::LinearElastic>();
  wet.water.emplace();
  problem.model.bodies[1].soil = settings::soil_of_one(wet);
  bodies::BlockSettings block;
  block.center = {0.05, 0};
  block.size = {0.1, 0.2};
  block.spacing = 0.025 / 4;
  bodies::BodySettings body;
  body.block = block;
  problem.state.particles[1] = fill<2>(problem.model.mesh, "block", body, {1000, 0, 0, particle_extra(problem.model.bodies[1].soil)});
  for (bodies::Particles<2>& particles : problem.state.particles)
    particles.visit([&](Index, Index b, int l) {
      for (int k = 0; k < 3; ++k) particles.block(b).stress[k][l] = -5e3 - 1e3 * k;
      if (particles.extra_size() > 0) particles.extra(b)[0][l] = 2e3;
    });
  problem.model.surface = 0.2;
  problem.model.gravity = {0, -10};
  FrameMaker<2> maker(problem.model, problem.state);
  const Frame<2> frame = maker.make(problem.state);
  const Real unit_weight = density(problem.model.bodies[1].soil.materials.front()) * problem.model.gravity.norm();
  ASSERT_GT(unit_weight, 0);
  for (std::size_t k = 0; k < frame.points.size(); ++k) {
    EXPECT_NEAR(frame.field("pore_pressure_ratio").at(k), frame.body[k] == 1 ? 2e3 / (unit_weight * (0.2 - frame.points[k][1])) : 0, 1e-12);
    const Real water = frame.body[k] == 1 ? 2e3 : 0;
    EXPECT_EQ(frame.field("excess_pore_pressure").at(k), water);
    EXPECT_DOUBLE_EQ(frame.field("effective_stress").at(k, 1), -6e3 + water);
    EXPECT_DOUBLE_EQ(frame.field("mean_effective_stress").at(k), -6e3 + water);
    EXPECT_DOUBLE_EQ(frame.field("mean_stress").at(k), -6e3);
  }
  problem.model.bodies.pop_back();
  problem.state.particles.pop_back();
  FrameMaker<2> of_drained(problem.model, problem.state);
  EXPECT_EQ(find_field(of_drained.make(problem.state).fields, "effective_stress"), nullptr);
}

// The shape functions are linear: sums of four products of numbers up to 1 have an error of 1e-15.
TEST(FrameMaker, shows_the_flux_of_the_water_at_the_particles)
{
  problem::Problem<2> problem = block_in_box();
  material::LinearElastic soil;
  soil.density = 1000;
  soil.young_modulus = 1e6;
  soil.water.emplace().drainage = material::Drainage::consolidation;
  soil.water->porosity = 0.4;
  soil.water->permeability = 1e-5;
  FrameMaker<2> dry(problem.model, problem.state);
  EXPECT_EQ(find_field(dry.make(problem.state).fields, "water_flux"), nullptr);
  problem.model.bodies[0].soil = settings::soil_of_one(soil);
  const auto flux = [](const Vec<2>& x) { return Vec<2>(1 + 2 * x[0] - x[1], -0.5 * x[0] + 3 * x[1]); };
  problem.state.flux = {NodeField<Vec<2>>::zeros(problem.model.mesh.node_count())};
  for (Index node = 0; node < problem.model.mesh.node_count(); ++node)
    problem.state.flux[0][node] = flux(problem.model.mesh.position[node]);
  const Frame<2> frame = FrameMaker<2>(problem.model, problem.state).make(problem.state);
  const FieldValues<Real>& shown = frame.field("water_flux");
  EXPECT_EQ(shown.info.unit, "m/s");
  for (std::size_t k = 0; k < frame.points.size(); ++k)
    for (int d = 0; d < 2; ++d) EXPECT_NEAR(shown.at(k, d), flux(frame.points[k])[d], 1e-14);
}

}  // namespace
}  // namespace berm::run_folder::this_file
