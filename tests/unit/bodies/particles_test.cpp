// SPDX-License-Identifier: BSD-3-Clause
#include "bodies/particles.hpp"

#include "samples/sample_meshes.hpp"

#include <gtest/gtest.h>
#include <omp.h>
#include <random>
#include <rapidcheck/gtest.h>
#include <set>
#include <tuple>

namespace berm::bodies::this_file {
namespace {

/// Fields of so many numbers.
std::vector<FieldInfo> extra_fields(int count)
{
  std::vector<FieldInfo> fields;
  for (int k = 0; k < count; ++k) fields.push_back({"extra_" + std::to_string(k), "", ""});
  return fields;
}

/// A particle whose every number tells which one it is.
template <int dim>
Particle<dim> particle_number(std::int32_t id, int extra_size)
{
  Particle<dim> p;
  p.id = id;
  p.mass = id + 0.125;
  p.volume = id + 0.25;
  p.deviatoric_strain = id + 0.5;
  for (int d = 0; d < dim; ++d) p.x[d] = id + 0.01 * d, p.v[d] = -id - 0.01 * d;
  for (int k = 0; k < tensor_size<dim>; ++k) p.stress[k] = id + 0.001 * k;
  for (int k = 0; k < extra_size; ++k) p.extra[k] = id + 0.3 + k;
  return p;
}

template <int dim>
bool same(const Particle<dim>& a, const Particle<dim>& b)
{
  return a.id == b.id && a.mass == b.mass && a.volume == b.volume && a.deviatoric_strain == b.deviatoric_strain && a.x == b.x &&
         a.v == b.v && std::equal(a.stress.c, a.stress.c + tensor_size<dim>, b.stress.c) &&
         std::equal(a.extra, a.extra + Particle<dim>::max_extra, b.extra);
}

/// What Particles promises, in the simplest form: a list of particles for each cell.
template <int dim>
struct Expected {
  std::vector<std::vector<Particle<dim>>> cells;

  Index blocks() const
  {
    Index count = 0;
    for (const auto& list : cells) count += static_cast<Index>((list.size() + lanes - 1) / lanes);
    return count;
  }
  Index size() const
  {
    Index count = 0;
    for (const auto& list : cells) count += static_cast<Index>(list.size());
    return count;
  }
};

/// Each cell's chain holds the expected particles in their order; lanes without a particle weigh nothing. Gives the largest block in use.
template <int dim>
Index expect_same(const Particles<dim>& particles, const Expected<dim>& expected)
{
  std::set<Index> used;
  RC_ASSERT(particles.size() == expected.size());
  for (Index cell = 0; cell < static_cast<Index>(expected.cells.size()); ++cell) {
    const auto& list = expected.cells[cell];
    RC_ASSERT(particles.count_in(cell) == static_cast<Index>(list.size()));
    Index b = particles.first_block(cell);
    for (std::size_t first = 0; first < list.size(); first += lanes, b = particles.block(b).next) {
      RC_ASSERT(b != none);
      RC_ASSERT(used.insert(b).second);
      const Block<dim>& block = particles.block(b);
      for (int l = 0; l < lanes; ++l) {
        if (first + l < list.size()) {
          RC_ASSERT(same(particles.read(b, l), list[first + l]));
          continue;
        }
        RC_ASSERT(block.mass[l] == 0 && block.volume[l] == 0 && block.id[l] == none);
        for (int k = 0; k < tensor_size<dim>; ++k) RC_ASSERT(block.stress[k][l] == 0);
        for (int d = 0; d < dim; ++d) RC_ASSERT(std::isfinite(block.x[d][l]) && std::isfinite(block.v[d][l]));
      }
    }
    RC_ASSERT(b == none);
  }
  return used.empty() ? none : *used.rbegin();
}

template <int dim>
void behaves_like_a_list_for_each_cell()
{
  constexpr Index max = 60;
  const auto mesh = make_box<dim>(sample_box<dim>());
  const int extra_size = *rc::gen::inRange(0, Particle<dim>::max_extra + 1);
  const Index cells = 5;  // few, so that chains of several blocks are common
  Particles<dim> particles(mesh, max, extra_fields(extra_size));
  Expected<dim> expected;
  expected.cells.resize(mesh.cell_count());
  const Block<dim>* memory = nullptr;
  const Lanes* state_memory = nullptr;
  Index peak = 0, largest_block = none;
  std::int32_t next_id = 0;

  const auto actions =
      *rc::gen::container<std::vector<std::pair<int, int>>>(rc::gen::pair(rc::gen::inRange(0, 100), rc::gen::inRange(0, 1000)));
  for (const auto& [action, number] : actions) {
    // The cells spread over the mesh, in an order that is not theirs.
    const Index cell = (3 - number % cells + cells) * 7 % mesh.cell_count();
    auto& list = expected.cells[cell];
    if (action < 60 && expected.size() < max) {
      for (int repeat = 0; repeat < 1 + action % 9 && expected.size() < max; ++repeat) {
        const auto p = particle_number<dim>(next_id++, extra_size);
        particles.insert(cell, p);
        list.push_back(p);
      }
    } else if (!list.empty()) {
      const std::size_t place = number / cells % list.size();
      const auto taken = particles.take(cell, static_cast<Index>(place));
      RC_ASSERT(same(taken, list[place]));
      list[place] = list.back();
      list.pop_back();
    }
    if (memory == nullptr && particles.size() > 0) memory = &particles.block(0), state_memory = particles.state(0);
    peak = std::max(peak, expected.blocks());
    largest_block = std::max(largest_block, expect_same(particles, expected));
  }

  if (memory != nullptr) {
    RC_ASSERT(memory == &particles.block(0));  // no growth beyond what was reserved
    RC_ASSERT(state_memory == particles.state(0));
  }
  RC_ASSERT(largest_block < peak);  // a freed block is used before a new one

  std::vector<Index> occupied;
  std::vector<Particle<dim>> in_order;
  for (Index cell = 0; cell < mesh.cell_count(); ++cell) {
    const auto& list = expected.cells[cell];
    if (!list.empty()) occupied.push_back(cell);
    in_order.insert(in_order.end(), list.begin(), list.end());
  }
  particles.sort_occupied();
  RC_ASSERT(particles.occupied() == occupied);
  RC_ASSERT(!particles.sort_occupied());
  std::size_t visited = 0;
  particles.visit([&](Index, Index b, int l) { RC_ASSERT(same(particles.read(b, l), in_order.at(visited++))); });
  RC_ASSERT(visited == in_order.size());
}

RC_GTEST_PROP(Particles, behave_like_a_list_for_each_cell_in_triangles, ())
{
  behaves_like_a_list_for_each_cell<2>();
}
RC_GTEST_PROP(Particles, behave_like_a_list_for_each_cell_in_tetrahedra, ())
{
  behaves_like_a_list_for_each_cell<3>();
}

TEST(Particles, never_need_more_memory_than_was_reserved_wherever_they_gather)
{
  // The worst case for blocks: as many cells as possible with one particle beyond full blocks.
  const auto mesh = make_box<2>(sample_box<2>());
  for (const Index max : {1, 8, 9, 56, 57, 200}) {
    Particles<2> particles(mesh, max, extra_fields(1));
    particles.insert(0, particle_number<2>(0, 1));
    const Block<2>* memory = &particles.block(0);
    for (Index k = 1; k < max; ++k) particles.insert(k % std::min(max, mesh.cell_count()), particle_number<2>(k, 1));
    EXPECT_EQ(memory, &particles.block(0)) << max;
    for (Index cell = 1; cell < mesh.cell_count(); ++cell)
      while (particles.count_in(cell) > 0) particles.insert(0, particles.take(cell, 0));
    EXPECT_EQ(memory, &particles.block(0)) << max;
    EXPECT_EQ(particles.size(), max);
  }
}

/// Particles by cell, in order, and the blocks that they are in.
std::vector<std::tuple<Index, Index, std::int32_t>> places(const Particles<2>& particles)
{
  std::vector<std::tuple<Index, Index, std::int32_t>> all;
  particles.visit([&](Index cell, Index b, int l) { all.emplace_back(cell, b, particles.block(b).id[l]); });
  return all;
}

TEST(Particles, that_change_cells_together_come_where_they_come_one_by_one)
{
  const auto mesh = make_box<2>(sample_box<2>());
  constexpr Index count = 2000;
  for (const int threads : {1, 2, 3}) {
    omp_set_num_threads(threads);
    Particles<2> together(mesh, count, extra_fields(2)), one_by_one(mesh, count, extra_fields(2));
    std::mt19937 random(7);
    const auto some_cell = [&] { return static_cast<Index>(random() % mesh.cell_count()); };
    for (std::int32_t id = 0; id < count; ++id) {
      const Index cell = some_cell();
      together.insert(cell, particle_number<2>(id, 2));
      one_by_one.insert(cell, particle_number<2>(id, 2));
    }
    Transit<2> transit;
    // From nearly none to nearly all; a third go to one cell, and all leave another.
    for (const unsigned per_thousand : {5u, 300u, 990u}) {
      std::vector<CellChange> changes;
      for (Index cell = 0; cell < mesh.cell_count(); ++cell)
        for (Index index = 0; index < together.count_in(cell); ++index)
          if (cell == 20 || random() % 1000 < per_thousand) changes.push_back({cell, index, random() % 3 == 0 ? 7 : some_cell()});
      ASSERT_GT(changes.size(), 5u);
      together.take_out(changes, transit);
      together.put_in(changes, transit);
      std::vector<Particle<2>> taken(changes.size());
      for (std::size_t m = changes.size(); m-- > 0;) taken[m] = one_by_one.take(changes[m].from, changes[m].index);
      for (std::size_t m = 0; m < changes.size(); ++m) one_by_one.insert(changes[m].to, taken[m]);
      EXPECT_EQ(together.sort_occupied(), one_by_one.sort_occupied());
      ASSERT_EQ(together.occupied(), one_by_one.occupied());
      ASSERT_EQ(places(together), places(one_by_one));
      together.visit(
          [&](Index, Index b, int l) { ASSERT_TRUE(same(together.read(b, l), particle_number<2>(together.block(b).id[l], 2))); });
    }
    EXPECT_EQ(together.size(), count);
  }
}

TEST(Particles, tell_whether_the_occupied_cells_changed)
{
  const auto mesh = make_box<2>(sample_box<2>());
  Particles<2> particles(mesh, 10, {});
  EXPECT_FALSE(particles.sort_occupied());
  particles.insert(4, particle_number<2>(0, 0));
  particles.insert(2, particle_number<2>(1, 0));
  EXPECT_TRUE(particles.sort_occupied());
  EXPECT_EQ(particles.occupied(), (std::vector<Index>{2, 4}));
  particles.insert(4, particle_number<2>(2, 0));
  EXPECT_FALSE(particles.sort_occupied());
  particles.take(2, 0);
  EXPECT_TRUE(particles.sort_occupied());
  EXPECT_EQ(particles.occupied(), std::vector<Index>{4});
}

}  // namespace
}  // namespace berm::bodies::this_file
