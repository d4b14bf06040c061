// SPDX-License-Identifier: BSD-3-Clause
// Around an axis: strain, force and their work, masses and areas, the axis itself, and Lamé's tube.
#include "mpm/internal_forces.hpp"
#include "mpm/move.hpp"
#include "mpm/quadrature.hpp"
#include "pipe_in_sand.hpp"

#include <gtest/gtest.h>

namespace berm::this_file {
namespace {

constexpr Real round_off = 1e-12;

/// An elastic ring (or cylinder) of the radii `inner` to `outer` around the axis, as high as its mesh.
settings::Case elastic_ring(Real inner, Real outer, Real height, Real cells_along_r, Real cells_along_z)
{
  settings::Case c = elastic_box(2, {outer - inner, height}, {cells_along_r, cells_along_z}, 1e6, 0.3, 1000);
  std::get<mesh::BoxMesh>(c.mesh).lower = {inner, 0};
  c.geometry = settings::Geometry::axisymmetric;
  return c;
}

/// The same with particles that have wandered: each by up to `by` of a cell, and each with another volume.
void scatter(Simulation<2>& run, Real by)
{
  const mesh::Mesh<2>& mesh = run.model().mesh;
  bodies::Particles<2>& particles = run.state().particles[0];
  int n = 0;
  particles.visit([&](Index cell, Index b, int l) {
    bodies::Block<2>& block = particles.block(b);
    const Vec<2> middle = mesh.centroid(cell);
    for (int d = 0; d < 2; ++d) block.x[d][l] += by * std::sin(1. + 7 * n + 3 * d) * (middle[d] - block.x[d][l]);
    block.volume[l] *= 1 + 0.1 * std::sin(2. + 5 * n++);
  });
  mpm::sum_moments(mesh, particles, run.workspace.grids[0]);
}

TEST(Axisymmetry, gives_particles_the_volume_and_mass_of_a_radian)
{
  const Simulation<2> run(elastic_ring(0, 2, 3, 6, 8));
  Real volume = 0, mass = 0;
  for (const auto& p : all_particles(run.problem.state)) volume += p.volume, mass += p.mass;
  EXPECT_NEAR(volume, 2 * 2 / 2. * 3, 1e-12);  // the subdivided triangles' centroids integrate the radius exactly
  EXPECT_NEAR(mass, 1000 * volume, 1e-9);
}

TEST(Axisymmetry, strains_exactly_where_the_radial_velocity_is_proportional_to_the_radius)
{
  for (const Real scattered : {0., 0.5}) {
    settings::Case c = elastic_ring(0, 1, 1, 4, 4);
    Simulation<2> run(c);
    if (scattered > 0) scatter(run, scattered);
    mpm::BodyGrid<2>& grid = run.workspace.grids[0];
    problem::State<2>& state = run.state();
    state.dt = 1e-6;
    mpm::gather_mass_and_momentum(run.model().mesh, grid);
    mpm::prepare_cells(run.model(), state.particles[0], state.dt, grid);
    for (const Index i : grid.nodes)
      grid.mapped_velocity[i] = Vec<2>(3 * run.model().mesh.position[i][0], -run.model().mesh.position[i][1]);
    mpm::sum_volume_changes(run.model().mesh, state.particles[0], state.dt, grid);
    mpm::move_and_strain(run.model(), state, run.workspace, 0);
    const Real G = 1e6 / 2.6, K = 1e6 / (3 * 0.4), dilation = 5e-6, expected[] = {3e-6, -1e-6, 3e-6};
    for (const auto& p : all_particles(state)) {
      for (int k = 0; k < 3; ++k) EXPECT_NEAR(p.stress[k], K * dilation + 2 * G * (expected[k] - dilation / 3), 1e-9) << k;
      EXPECT_NEAR(p.stress[3], 0, 1e-9);
    }
  }
}

TEST(Axisymmetry, uniform_stress_leaves_no_force_at_inner_nodes)
{
  for (const Real scattered : {0., 0.5})
    for (const bool projected : {true, false}) {
      settings::Case c = elastic_ring(0, 1, 1, 8, 8);
      c.body[0].second.initial_stress = {-1e5, -3e5, -1e5};
      c.mpm.volumetric_projection = projected;
      Simulation<2> run(c);
      if (scattered > 0) scatter(run, scattered);
      const mesh::Mesh<2>& mesh = run.model().mesh;
      mpm::BodyGrid<2>& grid = run.workspace.grids[0];
      mpm::gather_mass_and_momentum(mesh, grid);
      mpm::prepare_cells(run.model(), run.state().particles[0], 0, grid);
      mpm::spread_internal_forces(run.model(), run.state().particles[0], 0, grid);
      const Real h = 1 / 8.;
      int inner = 0;
      for (const Index i : grid.nodes) {
        const Vec<2>& x = mesh.position[i];
        const Real margin =
            scattered > 0 ? 1.5 * h : 0.5 * h;  // where particles have wandered, cells at the surface stand for their particles
        if (x[0] > 1 - margin || x[1] < margin || x[1] > 1 - margin) continue;
        Vec<2> force = Vec<2>::Zero();
        for (Index e = mesh.first_entry[i]; e < mesh.first_entry[i + 1]; ++e)
          force += Eigen::Map<const Vec<2>>(grid.at(mesh.entries[e]).sum);
        EXPECT_NEAR(x[0] > 0 ? force[0] : 0, 0, 1e-9 * 3e5) << x.transpose() << " " << scattered << " " << projected;
        EXPECT_NEAR(force[1], 0, 1e-9 * 3e5) << x.transpose() << " " << scattered << " " << projected;
        ++inner;
      }
      EXPECT_GT(inner, 20);
    }
}

/// A cylinder of soil whose lower half a heavy load crushes: momentum, energy and bits.
settings::Case pushed_soil()
{
  settings::Case c = pipe_in_sand();
  c.geometry = settings::Geometry::axisymmetric;
  std::get<mesh::BoxMesh>(c.mesh).cells = {30, 15};
  c.rigid[0].second.shape = bodies::CircleSettings{{0, 0.05}, 0.02};
  c.contact[0].second.adhesion = 500;
  c.stage.resize(1);
  return c;
}

TEST(Axisymmetry, vertical_momentum_is_what_gravity_contact_supports_and_damping_gave)
{
  Simulation<2> run(pushed_soil());
  take_steps(run, 500);
  EXPECT_LT(mpm::momentum_error(run.state(), run.model().mesh.metric), round_off);
  EXPECT_LT(run.state().ledger.totals.contact_impulse[1], 0);
  EXPECT_EQ(run.state().rigid_bodies[0].reaction[0], 0);
}

TEST(Axisymmetry, the_axis_neither_moves_nor_is_crossed)
{
  Simulation<2> run(pushed_soil());
  take_steps(run, 500);
  Real nearest = infinity;
  for (const auto& p : all_particles(run.state())) nearest = std::min(nearest, p.x[0]);
  EXPECT_GT(nearest, 0);
  for (const Index i : run.workspace.grids[0].nodes) {
    const bool on_axis = run.model().mesh.position[i][0] == 0;
    EXPECT_EQ(on_axis ? run.workspace.grids[0].mapped_velocity[i][0] : 0, 0);
  }
}

TEST(Axisymmetry, work_of_a_push_is_kept)
{
  settings::Case c = pushed_soil();
  Simulation<2> run(c);
  const Real first = mpm::sums_over(run.state().particles[0]).kinetic;
  Real largest = 0, error = 0;
  for (int n = 0; n < 60; ++n) {
    take_steps(run, 10);
    const problem::Totals<2>& t = run.state().ledger.totals;
    largest = std::max(largest, std::abs(t.external));
    error = std::max(error, std::abs(mpm::sums_over(run.state().particles[0]).kinetic - first + t.internal + t.damping + t.filter +
                                     t.friction - t.external));
  }
  EXPECT_LT(error / largest, 0.01);
}

TEST(Axisymmetry, threads_do_not_change_one_bit)
{
  const auto state_with = [](int threads) {
    const int before = omp_get_max_threads();
    omp_set_num_threads(threads);
    Simulation<2> run(pushed_soil());
    take_steps(run, 200);
    omp_set_num_threads(before);
    return run.state();
  };
  const problem::State<2> one = state_with(1), three = state_with(3);
  const auto a = all_particles(one), b = all_particles(three);
  for (std::size_t k = 0; k < a.size(); ++k) {
    ASSERT_EQ(a[k].x, b[k].x);
    ASSERT_EQ(a[k].v, b[k].v);
    ASSERT_EQ(a[k].volume, b[k].volume);
    ASSERT_TRUE(std::equal(a[k].stress.c, a[k].stress.c + 4, b[k].stress.c));
  }
  EXPECT_EQ(one.ledger.contact_sums[0].impulse, three.ledger.contact_sums[0].impulse);
  EXPECT_EQ(one.ledger.totals.internal, three.ledger.totals.internal);
}

// Lamé: a tube under the pressure p inside, plane along its axis, u(r) = p a^2 / (E (b^2 - a^2)) (1 + nu) ((1 - 2 nu) r + b^2 / r). With constant strains in
// cells of a tenth of the wall the energy, so the displacement at the load, is within 1 %.
TEST(Axisymmetry, a_tube_under_pressure_widens_as_lame_found)
{
  const Real a = 1, b = 2, p = 1000, E = 1e6, nu = 0.3;
  settings::Case c = elastic_ring(a, b, 0.1, 10, 1);
  boundary::TractionSettings pressure;
  pressure.boundary = "left";
  pressure.pressure = p;
  pressure.ramp = 0.02;
  c.traction = {{"pressure", pressure}};
  c.body[0].second.damping = 0.7;
  c.support = {{"base", {"bottom", {"y"}}}, {"top", {"top", {"y"}}}};
  c.mesh = std::get<mesh::BoxMesh>(c.mesh);
  Simulation<2> run(c);
  const problem::State<2> first = run.state();
  run.run_until(4);
  const auto u_at = [&](Real r) { return p * a * a / (E * (b * b - a * a)) * (1 + nu) * ((1 - 2 * nu) * r + b * b / r); };
  const auto before = all_particles(first), now = all_particles(run.state());
  for (std::size_t k = 0; k < now.size(); ++k)
    EXPECT_NEAR((now[k].x[0] - before[k].x[0]) / u_at(before[k].x[0]), 1, 0.01) << before[k].x[0];
  EXPECT_NEAR(mpm::sums_over(run.state().particles[0]).kinetic, 0, 1e-6);
}

}  // namespace
}  // namespace berm::this_file
