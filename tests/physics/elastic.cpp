// SPDX-License-Identifier: BSD-3-Clause
// Elastic bodies whose motion is known in closed form, in triangles and in tetrahedra.
#include "simulate.hpp"

#include <gtest/gtest.h>

namespace berm::this_file {
namespace {

boundary::SupportSettings held(const char* boundary, std::vector<std::string> directions)
{
  return {boundary, std::move(directions)};
}

/// The period of a bar that vibrates in its first mode (fixed at x = 0, free at x = L) over the exact one, 4 L sqrt(rho / E).
template <int dim>
Real bar_period_ratio()
{
  constexpr Real length = 25, young_modulus = 100, density = 1, v0 = 0.1;
  std::vector<Real> size = {length, 1}, cells = {50, 2};
  bodies::InitialVelocity mode{{v0, 0}, {pi / (2 * length), 0}, 0};
  if (dim == 3) size.push_back(1), cells.push_back(2), mode.amplitude.push_back(0), mode.wave_number.push_back(0);
  settings::Case c = elastic_box(dim, size, cells, young_modulus, 0, density);
  // The mesh ends at the tip, so a moving tip needs room: the body fills the mesh but for one column of cells.
  std::get<mesh::BoxMesh>(c.mesh).size[0] += length / 50;
  std::get<mesh::BoxMesh>(c.mesh).cells[0] += 1;
  bodies::BlockSettings block;
  block.center = {length / 2, 0.5};
  block.size = {length, 1};
  if (dim == 3) block.center.push_back(0.5), block.size.push_back(1);
  block.spacing = 0.25;
  c.body[0].second.regions.clear();
  c.body[0].second.block = block;
  c.body[0].second.initial_velocity = {mode};
  c.support = {{"left", held("left", {"x"})}, {"bottom", held("bottom", {"y"})}, {"top", held("top", {"y"})}};
  if (dim == 3) c.support.emplace_back("front", held("front", {"z"})), c.support.emplace_back("back", held("back", {"z"}));

  // Zero crossings of the momentum: the first at a quarter of the period, the next at three quarters.
  Simulation<dim> run(c);
  std::vector<Real> crossings;
  Real before = mpm::sums_over(run.state().particles[0]).momentum[0], time_before = 0;
  run.run_until(12, [&] {
    const Real now = mpm::sums_over(run.state().particles[0]).momentum[0];
    if (before * now < 0) crossings.push_back(time_before + (run.state().time - time_before) * before / (before - now));
    before = now;
    time_before = run.state().time;
  });
  EXPECT_EQ(crossings.size(), 2u);
  return 2 * (crossings.at(1) - crossings.at(0)) / (4 * length * std::sqrt(density / young_modulus));
}

/// The displacement of a column's top under its own weight, over the exact one rho g L^2 / (2 E) (nu = 0).
template <int dim>
Real column_settlement_ratio()
{
  constexpr Real height = 1, young_modulus = 1e8, density = 1000, g = 10;
  std::vector<Real> size = {0.1, height}, cells = {2, 20};
  if (dim == 3) size.push_back(0.1), cells.push_back(2);
  settings::Case c = elastic_box(dim, size, cells, young_modulus, 0, density);
  c.gravity = {0, -g};
  c.support = {{"bottom", held("bottom", {"y"})}, {"left", held("left", {"x"})}, {"right", held("right", {"x"})}};
  if (dim == 3) {
    c.gravity.push_back(0);
    c.support.emplace_back("front", held("front", {"z"}));
    c.support.emplace_back("back", held("back", {"z"}));
  }
  c.body[0].second.damping = 0.3;
  Simulation<dim> run(c);
  const Real before = mpm::sums_over(run.state().particles[0]).moment[1];
  run.run_until(0.2);
  const auto after = mpm::sums_over(run.state().particles[0]);
  // The centre of mass settles by rho g L^2 / (3 E): the mean of u(y) = rho g (L y - y^2 / 2) / E.
  return (before - after.moment[1]) / after.mass / (density * g * height * height / (3 * young_modulus));
}

TEST(Bar, vibrates_with_its_first_period_in_triangles)
{
  EXPECT_NEAR(bar_period_ratio<2>(), 1, 0.005);
}
TEST(Bar, vibrates_with_its_first_period_in_tetrahedra)
{
  EXPECT_NEAR(bar_period_ratio<3>(), 1, 0.005);
}
TEST(Column, settles_under_its_own_weight_in_triangles)
{
  EXPECT_NEAR(column_settlement_ratio<2>(), 1, 0.001);
}
TEST(Column, settles_under_its_own_weight_in_tetrahedra)
{
  EXPECT_NEAR(column_settlement_ratio<3>(), 1, 0.001);
}

}  // namespace
}  // namespace berm::this_file
