// SPDX-License-Identifier: BSD-3-Clause
#include "beam/assembly.hpp"

#include "samples/rough_numbers.hpp"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace berm::beam::this_file {
namespace {

/// A line with a shape, springs in all directions and both planes.
Line rich_line()
{
  Line line = straight_line({0, 1, 2.5, 4, 4.7}, {7e4, 3e6, 300, 200, 1500, 0.2}, {Plane::lateral, Plane::vertical});
  set_shape(
      line, Plane::lateral, [](Real x) { return 0.1 * std::sin(x); }, [](Real x) { return 0.1 * std::cos(x); });
  line.damping = {0.4, 5};
  const std::vector<Real> lengths = lengths_of_nodes(line);
  add_springs(line, Direction::axial, friction(800, 1e-3), lengths);
  add_springs(line, Direction::lateral, PlasticSpring{{{{0.01, 700}, {0.5, 900}}}}, lengths);
  add_springs(line, Direction::vertical, OneSidedSpring{1e5}, lengths);
  line.held[3] = 1;
  return line;
}

// The tangent is what Newton's iteration converges with: each column against central differences of the residual. Forces are some 1e5 N and steps 1e-6, so that eight digits are left.
TEST(Assembly, has_the_derivative_of_the_residual_as_its_tangent)
{
  const Line line = rich_line();
  const State state = state_of(line);
  Loads loads = no_loads(line);
  std::fill(loads.constrained_force.begin(), loads.constrained_force.end(), 5e4);
  std::fill(loads.impedance.begin(), loads.impedance.end(), 300);
  const TimeTerms terms = {40, 8};
  Work work(line);
  const std::vector<Real> numbers = small_numbers(line.freedoms());
  for (Index i = 0; i < line.freedoms(); ++i) work.displacement[i] = 0.03 * numbers[i], work.predicted[i] = 0.01 * numbers[i];
  const std::vector<Real> at = work.displacement;
  const auto residual = [&](Index column, Real change) {
    work.displacement = at;
    work.displacement[column] += change;
    assemble(line, state, loads, terms, work);
    return work.residual;
  };
  for (Index j = 0; j < line.freedoms(); ++j) {
    constexpr Real step = 1e-6;
    const std::vector<Real> more = residual(j, step), less = residual(j, -step);
    work.displacement = at;
    assemble(line, state, loads, terms, work);
    BandMatrix tangent = work.tangent;
    ASSERT_NE(tangent.factorize(), none);
    // K^-1 (dr/dd_j) is the unit vector j.
    std::vector<Real> column(line.freedoms());
    for (Index i = 0; i < line.freedoms(); ++i) column[i] = (more[i] - less[i]) / (2 * step);
    if (line.held[j] != 0) continue;
    tangent.solve(column);
    for (Index i = 0; i < line.freedoms(); ++i) EXPECT_NEAR(column[i], i == j ? 1 : 0, 1e-5) << "freedoms " << i << " and " << j;
  }
}

// Displacements of a rigid line along itself and across cost nothing; nor does a small rotation, but for its square.
TEST(Assembly, of_a_line_that_only_moves_has_no_forces)
{
  const Line line = straight_line({0, 1, 2.5, 4}, {7e4, 3e6, 300, 200, 1500, 0.2}, {Plane::lateral, Plane::vertical});
  const State state = state_of(line);
  Work work(line);
  for (Index i = 0; i < line.nodes(); ++i) {
    work.displacement[line.axial(i)] = 0.3;
    work.displacement[line.across(Plane::lateral, i)] = 0.2 + 1e-6 * line.x[i],
                                                  work.displacement[line.across(Plane::lateral, i) + 1] = 1e-6;
    work.displacement[line.across(Plane::vertical, i)] = -0.7;
  }
  assemble(line, state, no_loads(line), {}, work);
  for (const Real force : work.residual) EXPECT_NEAR(force, 0, 1e-5);
}

TEST(Membrane, strain_is_the_mean_of_the_stretch_and_half_the_squared_slope)
{
  const Line line = straight_line({0, 2}, {1, 1e6, 1, 1, 0, 0.1}, {Plane::lateral});
  std::vector<Real> d(line.freedoms());
  d[line.axial(1)] = 2e-3;
  d[line.across(Plane::lateral, 1)] = 0.2, d[line.across(Plane::lateral, 0) + 1] = d[line.across(Plane::lateral, 1) + 1] = 0.1;
  const ElementNow now = membrane(line, 0, d, 500);
  EXPECT_NEAR(now.strain, 1e-3 + 0.1 * 0.1 / 2, 1e-12);
  EXPECT_NEAR(now.force, 1e6 * now.strain - 500, 1e-6);
}

}  // namespace
}  // namespace berm::beam::this_file
