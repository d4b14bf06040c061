// SPDX-License-Identifier: BSD-3-Clause
#include "kernels/roofline_kernel.hpp"

#include "core/vector_unit.hpp"
#include "samples/sample_meshes.hpp"

#include <array>
#include <gtest/gtest.h>
#include <omp.h>
#include <string_view>

namespace berm::roofline::this_file {
namespace {

/// Cells of a box with the counts of particles in turn; 0: none.
template <int dim>
struct Filled {
  mesh::Mesh<dim> box = shaken_box<dim>();
  bodies::Particles<dim> particles{box, 20 * box.cell_count(), {}};

  explicit Filled(const std::vector<Index>& counts)
  {
    for (Index cell = 0; cell < box.cell_count(); ++cell)
      for (Index k = 0; k < counts[static_cast<std::size_t>(cell) % counts.size()]; ++k) {
        bodies::Particle<dim> p;
        p.id = particles.size();
        p.x = box.centroid(cell) + 0.01 * (k + 1) * (box.position[box.nodes[cell][k % dim]] - box.centroid(cell));
        p.v[0] = 0.1 * k;
        p.volume = box.volume(cell) / 20;
        p.mass = 1800 * p.volume;
        for (int c = 0; c < 3; ++c) p.stress[c] = -1e3;
        particles.insert(cell, p);
      }
    particles.sort_occupied();
  }
};

template <int dim>
void expect_lanes_as_they_lie()
{
  const int least = std::string_view(vector_unit()) == "baseline" ? 2 : lanes;  // of a part
  const std::vector<Index> counts{0, 1, 2, 4, 5, 8, 9, 12, 16};
  const Filled<dim> soil(counts);
  Index cells = 0, particles = 0, in_parts = 0;
  for (Index cell = 0; cell < soil.box.cell_count(); ++cell) {
    const Index count = counts[static_cast<std::size_t>(cell) % counts.size()];
    cells += count > 0 ? 1 : 0;
    particles += count;
    in_parts += (count + least - 1) / least * least;
  }
  const RooflineRun run = run_roofline_kernel(soil.box, soil.particles, 0);
  EXPECT_EQ(run.cells, cells);
  EXPECT_EQ(run.particles, particles);
  EXPECT_EQ(run.lanes, in_parts);
}

TEST(Kernel, has_the_particles_and_lanes_of_the_cells_as_they_lie)
{
  expect_lanes_as_they_lie<2>();
  expect_lanes_as_they_lie<3>();
}

TEST(Kernel, takes_twelve_lanes_for_nine_particles)
{
  if (std::string_view(vector_unit()) == "baseline") GTEST_SKIP() << "ten, in halves of blocks";
  const Filled<2> soil({9});
  const RooflineRun run = run_roofline_kernel(soil.box, soil.particles, 0);
  EXPECT_EQ(run.lanes * 9, run.particles * 12);
}

TEST(Kernel, steps_as_long_as_it_is_told_and_leaves_the_soil_as_it_was)
{
  const Filled<2> plane({9, 4});
  const Filled<3> space({8, 4});
  const auto expect = [](const RooflineRun& run, Real volume) {
    EXPECT_GE(run.wall_s, 0.02);
    EXPECT_GE(run.steps, 1);
    EXPECT_GT(run.particle_steps_per_s(), 0);
    EXPECT_NEAR(run.checksum, -1e3 * volume, 1 * volume) << "steps of 1e-15 s leave a stress that the soil bears";
  };
  const auto volume_of = [](const auto& soil) {
    Real volume = 0;
    soil.particles.visit([&](Index, Index b, int l) { volume += soil.particles.block(b).volume[l]; });
    return volume;
  };
  expect(run_roofline_kernel(plane.box, plane.particles, 0.02), volume_of(plane));
  expect(run_roofline_kernel(space.box, space.particles, 0.02), volume_of(space));
}

TEST(Kernel, of_one_state_is_the_same_for_any_number_of_threads)
{
  const Filled<2> plane({9, 4});
  const Filled<3> space({8, 4});
  const auto stress = [&](int threads) {
    omp_set_num_threads(threads);
    return std::array{run_roofline_kernel(plane.box, plane.particles, 0).checksum,
                      run_roofline_kernel(space.box, space.particles, 0).checksum};
  };
  const auto one = stress(1);
  EXPECT_EQ(stress(2), one);
  EXPECT_EQ(stress(3), one);
}

}  // namespace
}  // namespace berm::roofline::this_file
