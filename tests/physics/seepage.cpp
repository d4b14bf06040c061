// SPDX-License-Identifier: BSD-3-Clause
// Water that a head drives up through a column, against Darcy and Terzaghi.
#include "simulate.hpp"

#include <gtest/gtest.h>

namespace berm::this_file {
namespace {

constexpr Real young_modulus = 10e6, poisson_ratio = 0.3, height = 1, bulk_modulus = 160e6, porosity = 0.4, head = 0.5;
constexpr Real skeleton = young_modulus * (1 - poisson_ratio) / ((1 + poisson_ratio) * (1 - 2 * poisson_ratio));
constexpr Real outside = material::unit_weight_of_water * head;
/// T = 1 takes 0.75 s with the one, 15 periods of the skeleton's slowest wave, and ten times that with the other, beside which waves are over at once.
constexpr Real fast = 1e-3, slow = 1e-4;
constexpr Real c_v_of(Real permeability)
{
  return permeability / (material::unit_weight_of_water * (1 / skeleton + porosity / bulk_modulus));
}
constexpr Real until_steady = height * height / c_v_of(fast);
constexpr Real weight = 1000, gravity = 9.81;  // kg/m3 in water, m/s2
constexpr int cells = 20;

/// A saturated column, open at its top and, under a head, at its base.
template <int dim>
settings::Case column(Real permeability = fast)
{
  const Real h = height / cells;
  std::vector<Real> size(dim, h), count(dim, 1);
  size[1] = height, count[1] = cells;
  settings::Case c = elastic_box(dim, size, count, young_modulus, poisson_ratio, weight);
  auto& law = c.material[0].second.get<material::LinearElastic>();
  law.inertia_density = 2000;
  law.water.emplace();
  law.water->drainage = material::Drainage::consolidation;
  law.water->bulk_modulus = bulk_modulus;
  law.water->porosity = porosity;
  law.water->permeability = permeability;
  c.body[0].second.particles_per_cell = dim == 2 ? 9 : 8;
  c.body[0].second.damping = 0.3;
  boundary::SupportSettings base{"bottom", {"y"}};
  base.drained = true;
  base.head = head;
  base.ramp = 5e-3;
  c.support = {{"left", {"left", {"x"}}}, {"right", {"right", {"x"}}}, {"base", base}};
  if (dim == 3) c.support.push_back({"back", {"back", {"z"}}}), c.support.push_back({"front", {"front", {"z"}}});
  return c;
}

/// Excess pore pressure of both ends open, one under a head since t = 0, at a height and T = c_v t/H^2, Pa: Terzaghi's series.
Real exact_pressure(Real y, Real T)
{
  Real p = 1 - y / height;
  for (int n = 1; n < 100; ++n) p -= 2 / (n * pi) * std::sin(n * pi * y / height) * std::exp(-n * n * pi * pi * T);
  return outside * p;
}

/// The largest difference of the pressures of the cells from these, Pa. Those of a cell are levelled, and are taken in its middle.
template <int dim, class Exact>
Real pressure_error(Simulation<dim>& run, const Exact& exact)
{
  const int place = pore_pressure_index(run.model().bodies[0].soil.materials.front());
  std::vector<Real> sum(cells, 0), count(cells, 0), y(cells, 0);
  const bodies::Particles<dim>& particles = run.state().particles[0];
  particles.visit([&](Index, Index b, int l) {
    const auto row = static_cast<std::size_t>(particles.block(b).x[1][l] / height * cells);
    sum[row] += particles.state(b)[place][l], count[row] += 1, y[row] += particles.block(b).x[1][l];
  });
  Real error = 0;
  for (std::size_t k = 0; k < cells; ++k) error = std::max(error, std::abs(sum[k] / count[k] - exact(y[k] / count[k])));
  return error;
}

/// Mean flux upwards of the nodes, m/s, and its largest difference from that.
template <int dim>
std::pair<Real, Real> flux_of(Simulation<dim>& run)
{
  Real sum = 0, error = 0;
  const NodeField<Vec<dim>>& flux = run.state().flux[0];
  for (Index node = 0; node < flux.size(); ++node) sum += flux[node][1] / flux.size();
  for (Index node = 0; node < flux.size(); ++node) error = std::max(error, std::abs(flux[node][1] - sum));
  return {sum, error};
}

template <class Geometry>
class Seepage : public testing::Test {
};
using Geometries = testing::Types<std::integral_constant<int, 2>, std::integral_constant<int, 3>>;
TYPED_TEST_SUITE(Seepage, Geometries);

// A linear pressure drives Darcy's flux at each node (decision 0050), so that the steady state has no error of its own: what is left is the transient, e^(-pi^2 T) of
// T = 1, and strains of 2e-4, by which the porosity and so the permeability may change. In tetrahedra, of which a node has 1 to 6 to its sides, it does so on the mean
// of the three directions: single nodes have another flux, and that of all is some percent off.
TYPED_TEST(Seepage, in_the_end_is_Darcys)
{
  constexpr int dim = TypeParam::value;
  Simulation<dim> run(column<dim>());
  run.run_until(until_steady);
  EXPECT_LT(pressure_error(run, [](Real y) { return outside * (1 - y / height); }), 0.005 * outside);
  const auto [flux, error] = flux_of(run);
  const Real exact = fast * head / height;
  EXPECT_NEAR(flux, exact, (dim == 2 ? 0.005 : 0.05) * exact);
  EXPECT_LT(dim == 2 ? error : 0, 0.01 * exact);
  EXPECT_LT(mpm::momentum_error(run.state()), 1e-12);
}

// T = 0.05 and 0.2: where the pressure has come there are 5 to 9 of the 20 cells, and that in the middle of a cell is that of its patch, which smears by a quarter of
// h^2 p'' at most, 1 % at T = 0.05. The head has a ramp of T = 0.0007, half of which it is late. 2 % in all.
TYPED_TEST(Seepage, after_a_step_of_head_comes_as_Terzaghi_says)
{
  constexpr int dim = TypeParam::value;
  Simulation<dim> run(column<dim>(slow));
  for (const Real T : {0.05, 0.2}) {
    run.run_until(T * height * height / c_v_of(slow));
    EXPECT_LT(pressure_error(run, [&](Real y) { return exact_pressure(y, T); }), 0.02 * outside) << T;
  }
}

// The skeleton is relieved by p: u = integral of p / M, in the end gamma_w h H / (2 M). Particles of the uppermost row stand for the surface but for a third of a cell.
TEST(SeepageHeave, is_that_of_the_skeleton_that_is_relieved)
{
  Simulation<2> run(column<2>());
  const auto top_of = [&] {
    Real top = -infinity;
    run.state().particles[0].visit([&](Index, Index b, int l) { top = std::max(top, run.state().particles[0].block(b).x[1][l]); });
    return top;
  };
  const Real begin = top_of();
  run.run_until(until_steady);
  const Real heave = outside * height / (2 * skeleton);
  EXPECT_NEAR(top_of() - begin, heave, 0.01 * heave);
}

// (gamma' - i gamma_w) z of effective stress, and the weight on the base whatever the head.
TEST(SeepageWeight, of_the_soil_is_less_by_the_gradient)
{
  settings::Case c = column<2>();
  c.gravity = {0, -gravity};
  c.surface = height;
  c.body[0].second.k0 = poisson_ratio / (1 - poisson_ratio);
  c.output.support_reactions = true;
  Simulation<2> run(c);
  run.run_until(until_steady);
  const Real gradient = head / height, submerged = weight * gravity;
  const int place = pore_pressure_index(run.model().bodies[0].soil.materials.front());
  const bodies::Particles<2>& particles = run.state().particles[0];
  Real error = 0;
  particles.visit([&](Index, Index b, int l) {
    const bodies::Particle<2> p = particles.read(b, l);
    const Real depth = height - p.x[1], effective = -p.stress[1] - particles.state(b)[place][l];
    error = std::max(error, std::abs(effective - (submerged - gradient * material::unit_weight_of_water) * depth));
  });
  EXPECT_LT(error, submerged * height / cells) << "the pressure of a cell is the same in all of it: half a cell of both";
  const Vec<2> before = run.state().ledger.support_impulses[2];
  const Real begin = run.state().time;
  run.run_until(begin + 0.02);
  const Real reaction = (run.state().ledger.support_impulses[2] - before)[1] / (run.state().time - begin),
             exact = submerged * height * height / cells;
  EXPECT_NEAR(reaction, exact, 0.005 * exact);
}

/// The excess pore pressure of the first head at the present time, Pa.
Real pressure_of_head(const Simulation<2>& run)
{
  Real pressure = nan;
  const problem::State<2>& state = run.problem.state;
  boundary::for_each_of<boundary::Head<2>>(run.problem.model.conditions, [&](std::size_t number, const auto& row, const auto& head) {
    if (number == 0) pressure = acting_fraction(row, state.heads[0], state.time) * head.pressure;
  });
  return pressure;
}

TEST(SeepageInStages, comes_and_goes_over_its_ramp_with_the_stages_of_its_support)
{
  settings::Case c = column<2>();
  c.stage.push_back(c.stage.front());
  c.stage[0].name = "still", c.stage[1].name = "flood";
  boundary::SupportSettings still = c.support[2].second;
  still.head.reset(), still.ramp = 0, still.stages = {"still"};
  c.support[2].second.stages = {"flood"};
  c.support.emplace_back("still_base", still);
  Simulation<2> run(c);
  ASSERT_EQ(count_of<boundary::Head<2>>(run.model().conditions), 1u);
  run.run_until(0.01);
  EXPECT_EQ(pressure_of_head(run), 0);
  EXPECT_LT(pressure_error(run, [](Real) { return 0; }), 1e-9);
  run.state().stage.index = 1;
  begin_stage(run.model(), run.state());
  const Real begin = run.state().time;
  run.run_until(begin + 2.5e-3);
  EXPECT_NEAR(pressure_of_head(run), outside * (run.state().time - begin) / 5e-3, 1e-9 * outside);
  run.run_until(begin + 0.02);
  EXPECT_EQ(pressure_of_head(run), outside);
  EXPECT_GT(pressure_error(run, [](Real) { return 0; }), 0.5 * outside);
  run.state().stage.index = 0;
  begin_stage(run.model(), run.state());
  run.run_until(run.state().time + 6e-3);
  EXPECT_EQ(pressure_of_head(run), 0) << "gone with the stage";
}

}  // namespace
}  // namespace berm::this_file
