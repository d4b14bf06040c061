// SPDX-License-Identifier: BSD-3-Clause
#include "beam/stations.hpp"

#include "beam/state.hpp"
#include "os/error.hpp"
#include "samples/rough_numbers.hpp"

#include <gtest/gtest.h>
#include <numeric>

namespace berm::beam::this_file {
namespace {

Line sample_line()
{
  return straight_line({0, 0.7, 1.9, 3, 5, 8, 9, 13, 20}, {1, 1, 1, 1, 1, 1}, {Plane::lateral, Plane::vertical});
}
const std::vector<Real> places = {0, 2.4, 2.6, 7, 12.5};

TEST(Stations, share_the_line_between_the_first_and_the_last)
{
  const Line line = sample_line();
  const Stations stations(line, places);
  const std::vector<Real> expected = {1.2, 1.3, 2.3, 4.95, 2.75};
  for (std::size_t k = 0; k < places.size(); ++k) EXPECT_NEAR(stations.lengths()[k], expected[k], 1e-12);
  std::vector<Real> of_nodes(static_cast<std::size_t>(line.nodes()), 0);
  stations.add_to_nodes(std::vector<Real>(places.size(), 1), of_nodes);
  EXPECT_NEAR(std::accumulate(of_nodes.begin(), of_nodes.end(), 0.), 12.5, 1e-12);
  EXPECT_NEAR(of_nodes[4], 2.5, 1e-12) << "a node between two stations has its whole length from them";
  EXPECT_EQ(of_nodes[8], 0);
}

// sum F v of the nodes = sum H v int phi of the stations, to round-off.
TEST(Stations, give_the_nodes_the_power_that_they_take)
{
  const Line line = sample_line();
  const Stations stations(line, places);
  State state = state_of(line);
  state.velocity = small_numbers(line.freedoms());
  for (const Direction direction : {Direction::axial, Direction::lateral, Direction::vertical}) {
    const std::vector<Real> per_metre = {3, -1, 4, 1, -5};
    Loads loads = no_loads(line);
    stations.add_forces(line, direction, per_metre, loads);
    std::vector<Real> velocities(places.size());
    stations.means(line, direction, state.velocity, velocities);
    Real of_nodes = 0, of_stations = 0;
    for (Index i = 0; i < line.freedoms(); ++i) of_nodes += loads.force[i] * state.velocity[i];
    for (std::size_t k = 0; k < places.size(); ++k) of_stations += per_metre[k] * stations.lengths()[k] * velocities[k];
    EXPECT_NEAR(of_nodes, of_stations, 1e-12 * std::abs(of_nodes));
    EXPECT_NE(of_nodes, 0);
  }
}

TEST(Stations, see_the_velocity_of_a_line_that_moves_as_one)
{
  const Line line = sample_line();
  const Stations stations(line, places);
  State state = state_of(line);
  for (Index i = 0; i < line.nodes(); ++i) state.velocity[line.across(Plane::lateral, i)] = 0.3;
  std::vector<Real> velocities(places.size());
  stations.means(line, Direction::lateral, state.velocity, velocities);
  for (const Real v : velocities) EXPECT_NEAR(v, 0.3, 1e-12);
  Loads loads = no_loads(line);
  stations.add_impedances(line, Direction::lateral, {2, 2, 2, 2, 2}, loads);
  EXPECT_NEAR(std::accumulate(loads.impedance.begin(), loads.impedance.end(), 0.), 2 * 12.5, 1e-12);
}

TEST(Stations, off_the_line_or_out_of_order_are_refused)
{
  const Line line = sample_line();
  EXPECT_THROW(Stations(line, {0, 21}), InputError);
  EXPECT_THROW(Stations(line, {3, 3}), InputError);
  EXPECT_THROW(Stations(line, {3}), InputError);
  EXPECT_THROW(Stations(line, {0, nan}), InputError);
}

}  // namespace
}  // namespace berm::beam::this_file
