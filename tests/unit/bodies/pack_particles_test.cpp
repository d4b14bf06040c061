// SPDX-License-Identifier: BSD-3-Clause
#include "bodies/particles.hpp"
#include "samples/sample_meshes.hpp"

#include <gtest/gtest.h>
#include <random>

namespace berm::bodies::this_file {
namespace {

template <int dim>
Particles<dim> some_particles(const mesh::Mesh<dim>& mesh, Index count)
{
  Particles<dim> particles(mesh, count, {{"number", "a number", "", 2, with_particle}});
  std::mt19937 random(11);
  for (std::int32_t id = 0; id < count; ++id) {
    Particle<dim> p;
    p.id = id;
    p.mass = 1 + id;
    p.x.setConstant(0.25 * id);
    p.extra[1] = 7 * id;
    particles.insert(static_cast<Index>(random() % 5) * (mesh.cell_count() / 5), p);
  }
  particles.take(0, 0);  // a lane that held one is not as one that never did
  particles.sort_occupied();
  return particles;
}

template <int dim>
void expect_same(const Particles<dim>& a, const Particles<dim>& b)
{
  ASSERT_EQ(a.occupied(), b.occupied());
  ASSERT_EQ(a.chunks().begin, b.chunks().begin);
  EXPECT_EQ(a.size(), b.size());
  for (const Index cell : a.occupied()) {
    ASSERT_EQ(a.count_in(cell), b.count_in(cell));
    Index of_a = a.first_block(cell), of_b = b.first_block(cell);
    for (Index left = a.count_in(cell); left > 0; left -= lanes, of_a = a.block(of_a).next, of_b = b.block(of_b).next) {
      EXPECT_EQ(std::memcmp(&a.block(of_a), &b.block(of_b), offsetof(Block<dim>, next)), 0);
      EXPECT_EQ(std::memcmp(a.extra(of_a), b.extra(of_b), static_cast<std::size_t>(a.extra_size()) * sizeof(Lanes)), 0);
    }
  }
}

template <int dim>
void comes_back()
{
  const auto mesh = make_box<dim>(sample_box<dim>());
  const Particles<dim> all = some_particles(mesh, 60);
  const Index border = mesh.cell_count() / 2;
  std::vector<std::byte> low, high;
  all.pack(0, border, low);
  all.pack(border, mesh.cell_count(), high);
  Particles<dim> part = all, whole = all;
  part.unpack(low);
  EXPECT_GT(part.size(), 0);
  EXPECT_LT(part.size(), all.size());
  EXPECT_LT(part.occupied().back(), border);
  low.insert(low.end(), high.begin(), high.end());
  whole.unpack(low);
  expect_same(whole, all);
  whole.unpack({});
  EXPECT_EQ(whole.size(), 0);
  EXPECT_TRUE(whole.occupied().empty());
}

TEST(PackedParticles, come_back_lane_by_lane_in_triangles)
{
  comes_back<2>();
}
TEST(PackedParticles, come_back_lane_by_lane_in_tetrahedra)
{
  comes_back<3>();
}

TEST(PackedParticles, can_be_changed_as_before)
{
  const auto mesh = make_box<2>(sample_box<2>());
  Particles<2> particles = some_particles(mesh, 60);
  std::vector<std::byte> bytes;
  particles.pack(0, mesh.cell_count(), bytes);
  particles.unpack(bytes);
  const Particle<2> taken = particles.take(0, 0);
  particles.insert(1, taken);
  EXPECT_TRUE(particles.sort_occupied());
  EXPECT_EQ(particles.read_at(1, 0).id, taken.id);
  EXPECT_EQ(particles.size(), 59);
}

}  // namespace
}  // namespace berm::bodies::this_file
