// SPDX-License-Identifier: BSD-3-Clause
// Water that flows through the pores: waves, consolidation, and the limits of no and of all drainage.
#include "simulate.hpp"

#include <Eigen/Cholesky>

#include <gtest/gtest.h>

namespace berm::this_file {
namespace {

constexpr Real young_modulus = 10e6, poisson_ratio = 0.3, height = 1, load = 10e3;
constexpr Real skeleton = young_modulus * (1 - poisson_ratio) / ((1 + poisson_ratio) * (1 - 2 * poisson_ratio));

/// A saturated column of 1 m on an impermeable base under a load that grows in 2 ms, its top open.
template <int dim>
settings::Case column(int cells, material::PoreWater water)
{
  const Real h = height / cells;
  std::vector<Real> size(dim, h), count(dim, 1);
  size[1] = height, count[1] = cells;
  settings::Case c = elastic_box(dim, size, count, young_modulus, poisson_ratio, 1990);
  c.material[0].second.get<material::LinearElastic>().water = water;
  c.body[0].second.particles_per_cell = dim == 2 ? 9 : 8;
  c.support = {{"left", {"left", {"x"}}}, {"right", {"right", {"x"}}}, {"bottom", {"bottom", {"y"}}}};
  if (dim == 3) c.support.push_back({"back", {"back", {"z"}}}), c.support.push_back({"front", {"front", {"z"}}});
  boundary::TractionSettings traction;
  traction.boundary = "top";
  traction.stress = std::vector<Real>(dim, 0);
  traction.stress[1] = -load;
  traction.ramp = 2e-3;
  c.traction = {{"load", traction}};
  return c;
}

material::PoreWater flowing(Real permeability, Real bulk_modulus = 100e6)
{
  material::PoreWater water;
  water.drainage = material::Drainage::consolidation;
  water.bulk_modulus = bulk_modulus;
  water.porosity = 0.4;
  water.permeability = permeability;
  return water;
}

/// Mean excess pore pressure between two heights, Pa.
template <int dim>
Real pressure_between(Simulation<dim>& run, Real low, Real high)
{
  const int place = pore_pressure_index(run.model().bodies[0].soil.materials.front());
  Real sum = 0, count = 0;
  const bodies::Particles<dim>& particles = run.state().particles[0];
  particles.visit([&](Index, Index b, int l) {
    const Real y = particles.block(b).x[1][l];
    if (y > low && y < high) sum += particles.state(b)[place][l], count += 1;
  });
  return sum / count;
}

template <class Geometry>
class Consolidation : public testing::Test {
};
using Geometries = testing::Types<std::integral_constant<int, 2>, std::integral_constant<int, 3>>;
TYPED_TEST_SUITE(Consolidation, Geometries);

// Pressures of Biot's equations, by Laplace transform: 9723 Pa at 4 ms, 16025 at 7.5 and 7456 at 10 in the middle, 18123 at 5 ms and 3844 at 10 at the base. A mesh
// of 40 cells has a tenth of a wave's rise time between cells: 5 % of the largest.
TYPED_TEST(Consolidation, a_sudden_load_makes_both_waves_of_Biot)
{
  constexpr int dim = TypeParam::value, cells = 40;
  constexpr Real tolerance = 0.05 * 18123;
  Simulation<dim> run(column<dim>(cells, flowing(1e-3)));
  const auto middle = [&] { return pressure_between(run, 0.48, 0.52); };
  const auto base = [&] { return pressure_between(run, 0, 0.025); };
  run.run_until(4e-3);
  EXPECT_NEAR(middle(), 9723, tolerance);
  run.run_until(5e-3);
  EXPECT_NEAR(base(), 18123, tolerance);
  run.run_until(7.5e-3);
  EXPECT_NEAR(middle(), 16025, tolerance);
  run.run_until(10e-3);
  EXPECT_NEAR(middle(), 7456, tolerance);
  EXPECT_NEAR(base(), 3844, tolerance);
  EXPECT_LT(mpm::momentum_error(run.state()), 1e-12);
}

// Explicit drag would limit the time step to 2 k (1 / n - rho_w / rho) / g, 4e-9 s here at the least permeability. The triangles of the squares have a height of
// h / sqrt(2), and the fast wave runs 399.7 m/s.
TEST(Consolidation, no_permeability_limits_the_time_step)
{
  for (const Real permeability : {1e-8, 1e-6, 1e-4, 1e-2, 1.}) {
    settings::Case c = column<2>(20, flowing(permeability));
    c.mpm.courant = 0.9;
    Simulation<2> run(c);
    run.run_until(0.1);
    const Real bound = 4 * load;  // waves double the load, and again where they meet
    EXPECT_LT(std::abs(pressure_between(run, 0, 1)), bound) << permeability;
    EXPECT_NEAR(run.state().dt / (0.05 / std::sqrt(2.) / 399.7), 0.9, 0.02);
  }
}

// Water that hardly drags is not damped by itself. Local damping of the soil stirs waves from node to node, which must not take energy from one another that
// neither has lost: they would grow to twice the load in 0.6 s. Waves of the column lose three quarters of their pressure in a tenth of that time.
TEST(Consolidation, water_that_hardly_drags_comes_to_rest_with_the_soil)
{
  settings::Case c = column<2>(20, flowing(1));
  c.mpm.courant = 0.9;
  c.body[0].second.damping = 0.3;
  Simulation<2> run(c);
  run.run_until(0.6);
  EXPECT_LT(std::abs(pressure_between(run, 0, 0.5)), 1e-3 * load);
}

/// Root of the mean square of what is left of the pressures of the particles, Pa, after a parabola of both coordinates has been fitted to each 3 x 3 squares of
/// the size h that lie below a height: what changes from cell to cell.
Real pressure_from_cell_to_cell(Simulation<2>& run, Real h, int squares, int rows)
{
  const int place = pore_pressure_index(run.model().bodies[0].soil.materials.front());
  Real sum = 0;
  Index count = 0;
  for (int row = 1; row + 1 < rows; ++row)
    for (int column = 1; column + 1 < squares; ++column) {
      Eigen::Matrix<Real, 6, 6> A = Eigen::Matrix<Real, 6, 6>::Zero();
      Eigen::Vector<Real, 6> b = Eigen::Vector<Real, 6>::Zero();
      Real square = 0;
      Index n = 0;
      const bodies::Particles<2>& particles = run.state().particles[0];
      particles.visit([&](Index, Index block, int l) {
        const Real x = particles.block(block).x[0][l] / h - column - 0.5, y = particles.block(block).x[1][l] / h - row - 0.5;
        if (std::abs(x) > 1.5 || std::abs(y) > 1.5) return;
        const Real p = particles.state(block)[place][l];
        const Eigen::Vector<Real, 6> terms(1, x, y, x * x, x * y, y * y);
        A += terms * terms.transpose(), b += p * terms, square += p * p, ++n;
      });
      sum += square - b.dot(A.ldlt().solve(b));
      count += n;
    }
  return std::sqrt(sum / count);
}

// The harshest case: soil that is as good as undrained under a load on half of its surface, which has come to rest. A checkerboard would be as large as the
// pressure; 2 % of the load is what waves leave.
TEST(Consolidation, pressure_has_no_checkerboard)
{
  constexpr int squares = 20;
  settings::Case c = elastic_box(2, {1, 1}, {squares, squares}, young_modulus, poisson_ratio, 1990);
  c.material[0].second.get<material::LinearElastic>().water = flowing(1e-8, 2.2e9);
  c.body[0].second.particles_per_cell = 9;
  c.body[0].second.damping = 0.5;
  c.support = {{"left", {"left", {"x"}}}, {"right", {"right", {"x"}}}, {"bottom", {"bottom", {"y"}}}};
  boundary::TractionSettings traction;
  traction.boundary = "top";
  traction.stress = std::vector<Real>{0, -load};
  traction.x_range = std::vector<Real>{0, 0.5};
  c.traction = {{"load", traction}};
  Simulation<2> run(c);
  run.run_until(0.03);
  EXPECT_LT(pressure_from_cell_to_cell(run, 1. / squares, squares, squares - 4), 0.02 * load);
}

/// 1 - p/p_max at the base of a layer whose load grows in a time and stays, so long after it begins (Terzaghi): the pressure of each part of the load falls on its own,
/// p ~ sum (2 / M) sin(M) (exp(-M^2 c (t - ramp)) - exp(-M^2 c t)) / (M^2 c ramp), M = pi/2, 3 pi/2 ..., c = c_v / H^2.
Real degree_at_base(Real c, Real ramp, Real t)
{
  const auto pressure = [&](Real time) {
    Real sum = 0;
    for (int m = 0; m < 100; ++m) {
      const Real M = (m + 0.5) * pi, rate = M * M * c;
      sum += (m % 2 == 0 ? 2 : -2) / M * (std::exp(-rate * (time - ramp)) - std::exp(-rate * time)) / (rate * ramp);
    }
    return sum;
  };
  return 1 - pressure(t) / pressure(ramp);
}

// The column swings with a period of 22 ms. A load within a third of that sends waves nearly as high as itself through it, which hardly fall without damping; the largest pressure of single
// steps would end the stage at once. 2 % of the time: half a cell of the height, and what a period less than a fiftieth of this time leaves of waves.
TEST(Consolidation, of_a_given_degree_ends_a_stage_after_the_time_of_Terzaghi_whatever_waves_do)
{
  constexpr Real permeability = 3e-4, n_over_K = 0.4 / 20e6;
  const Real c = permeability / (material::unit_weight_of_water * (1 / skeleton + n_over_K)) / (height * height);
  struct Load {
    Real ramp, damping;
  };
  for (const auto& [ramp, damping] : {Load{7e-3, 0.3}, {0.2, 0.3}, {20e-3, 0}}) {
    settings::Case column_case = column<2>(20, flowing(permeability, 20e6));
    column_case.body[0].second.damping = damping;
    column_case.traction[0].second.ramp = ramp;
    column_case.stage[0].until.time = ramp;
    settings::StageSettings rest = column_case.stage[0];
    rest.name = "rest";
    rest.until.time.reset();
    rest.until.consolidation = 0.5;
    column_case.stage.push_back(rest);
    Simulation<2> run(column_case);
    run.run_until(ramp);
    ++run.state().stage.index;
    begin_stage(run.model(), run.state());
    while (!stage_ended(run.model(), run.state()) && run.state().time < 3) step(run.model(), run.state(), run.workspace);
    const Real t = run.state().time;
    EXPECT_GE(degree_of_consolidation(run.state().stage), 0.5);
    EXPECT_GT(degree_at_base(c, ramp, 1.02 * t), 0.5) << "ramp " << ramp << ", damping " << damping << ", " << t;
    EXPECT_LT(degree_at_base(c, ramp, 0.98 * t), 0.5) << "ramp " << ramp << ", damping " << damping << ", " << t;
  }
}

TEST(Consolidation, of_soil_that_is_hardly_permeable_is_that_of_undrained_soil)
{
  material::PoreWater undrained;
  undrained.bulk_modulus = 100e6;
  undrained.porosity = 0.4;
  Simulation<2> closed(column<2>(20, undrained)), tight(column<2>(20, flowing(1e-11)));
  for (Simulation<2>* run : {&closed, &tight}) run->run_until(8e-3);
  EXPECT_NEAR(pressure_between(tight, 0, 0.5) / pressure_between(closed, 0, 0.5), 1, 0.03) << "the time steps differ";
}

/// The flux, m/s, at the base of a column that has consolidated for 5 ms.
Real flux_at_base(bool drained)
{
  settings::Case c = column<2>(20, flowing(1e-3));
  for (auto& [name, support] : c.support) support.drained = drained && name == "bottom";
  Simulation<2> run(c);
  run.run_until(5e-3);
  Real largest = 0;
  for (const Index node : run.model().mesh.boundary_nodes[run.model().mesh.find_boundary("bottom")])
    largest = std::max(largest, run.state().flux[0][node].norm());
  return largest;
}

TEST(Consolidation, water_crosses_drained_supports_alone)
{
  EXPECT_EQ(flux_at_base(false), 0);
  EXPECT_GT(flux_at_base(true), 1e-3);
}

/// A column under a plate that is pressed on it by a force that grows to the load in 2 ms; the base is open where the plate is closed.
settings::Case column_under_plate(int cells, bool drained, Real top = height)
{
  settings::Case c = column<2>(cells, flowing(1e-3));
  c.traction.clear();
  c.surface = top;
  for (auto& [name, support] : c.support) support.drained = !drained && name == "bottom";
  c.body[0].second.damping = 0.3;
  bodies::RigidSettings plate;
  bodies::HalfPlaneSettings half;
  half.point = {0, top}, half.normal = {0, -1};
  plate.shape = half;
  plate.mass = 10;
  c.rigid = {{"plate", plate}};
  contact::ContactSettings skin;
  skin.body = "body";
  skin.rigid = "plate";
  skin.friction_angle = 20 * degree;
  skin.drained = drained;
  c.contact = {{"skin", skin}};
  settings::StageSettings& stage = c.stage[0];
  stage.kind = settings::StageKind::push;
  stage.force = load * height / cells;
  stage.ramp = 2e-3;
  return c;
}

/// The largest flux through the plate, m/s, in 10 ms.
Real flux_through_plate(bool drained)
{
  Simulation<2> run(column_under_plate(20, drained));
  Real largest = 0;
  run.run_until(10e-3, [&] {
    for (const Index node : run.model().mesh.boundary_nodes[run.model().mesh.find_boundary("top")])
      largest = std::max(largest, std::abs(run.state().flux[0][node][1]));
  });
  return largest;
}

TEST(Consolidation, water_crosses_drained_rigid_bodies_alone)
{
  EXPECT_LT(flux_through_plate(false), 1e-15);  // rounding, for pressures that do not change along the plate
  EXPECT_GT(flux_through_plate(true), 1e-3);
}

/// Terzaghi's pressure at the closed end of a layer of this thickness, Pa, of water that is not stiff without end: at t after the load.
Real terzaghi(const material::PoreWater& water, Real thickness, Real t)
{
  const Real n_over_K = *water.porosity / *water.bulk_modulus;
  const Real c_v = *water.permeability / (9810 * (1 / skeleton + n_over_K)), T = c_v * t / (thickness * thickness);
  Real sum = 0;
  for (int m = 0; m < 20; ++m) {
    const Real wave = (m + 0.5) * pi;
    sum += (m % 2 == 0 ? 2 : -2) / wave * std::exp(-wave * wave * T);
  }
  return sum * load / (1 + skeleton * n_over_K);
}

// The water of the cells that a closed body touches leaves them on their other side, and none is lost to it, whether it is on the nodes, or cuts the cells. Half a
// cell of the open base is 2.5 % of T, 1.8 % of what is left of the pressure; 1 % is the swinging of the column.
TEST(Consolidation, water_below_a_closed_plate_leaves_at_the_base)
{
  constexpr int cells = 40;
  const material::PoreWater water = flowing(1e-3);
  for (const Real cut : {0., 0.4, 0.8}) {
    const Real top = height * (1 - cut / cells);
    Simulation<2> run(column_under_plate(cells, false, top));
    run.run_until(0.19);
    Real sum = 0;
    int count = 0;
    run.run_until(0.21, [&] { sum += pressure_between(run, top - height / cells, top), ++count; });
    const Real exact = terzaghi(water, top, 0.2 - 1e-3);
    EXPECT_NEAR(sum / count, exact, 0.03 * exact) << cut;
  }
}

// Of Terzaghi's layer at T = 0.13, when nine tenths of the pressure are left at its base. The mean over 20 ms: 1 % is the swinging of the column.
TEST(Consolidation, an_open_plate_rests_on_the_skeleton_alone)
{
  constexpr int cells = 20;
  Simulation<2> run(column_under_plate(cells, true));
  run.run_until(0.09);
  const auto impulse = [&] { return run.state().ledger.contact_sums[0].effective_impulse; };
  const Real before = impulse(), begin = run.state().time;
  run.run_until(0.11);
  EXPECT_NEAR((impulse() - before) / (run.state().time - begin), load * height / cells, 0.01 * load * height / cells);
  EXPECT_GT(pressure_between(run, 0, 0.05), 0.8 * load);
}

TEST(Consolidation, speed_of_the_fast_wave_is_the_larger_root)
{
  EXPECT_NEAR(material::fast_wave_speed(skeleton, 250e6, 1990, 0.4), 399.7, 0.1);
  EXPECT_NEAR(material::fast_wave_speed(skeleton, 2.2e9 / 0.4, 1990, 0.4), 1857, 1);
}

TEST(Consolidation, permeability_follows_the_porosity_where_it_is_asked_to)
{
  material::Hydraulics water{1e-4, 0.5, true};
  EXPECT_NEAR(water.porosity_at(1.25), 0.6, 1e-15);
  EXPECT_NEAR(water.permeability_at(0.6) / 1e-4, 0.216 / 0.16 / 0.5, 1e-12);
  EXPECT_EQ(water.porosity_at(0.1), 0.05) << "bounded";
  water.kozeny_carman = false;
  EXPECT_EQ(water.permeability_at(0.6), 1e-4);
}

}  // namespace
}  // namespace berm::this_file
