// SPDX-License-Identifier: BSD-3-Clause
#include "bodies/particles.hpp"

#include "bodies/particle_fields.hpp"
#include "core/lazy_memory.hpp"
#include "core/select.hpp"
#include "material/material.hpp"

#include <algorithm>
#include <stdexcept>

namespace berm::bodies {

static_assert(material::Laws::max_state <= Particle<2>::max_extra && material::Laws::max_state <= Particle<3>::max_extra,
              "a law keeps more numbers than a particle has room for");

template <int dim>
Particles<dim>::Particles(const mesh::Mesh<dim>& mesh, Index max, const std::vector<FieldInfo>& extra)
    : head_(CellField<Index>::zeros(mesh.cell_count())),
      count_(CellField<Index>::zeros(mesh.cell_count()))
{
  for (const FieldInfo& info : extra) {
    extra_fields_.push_back({info, extra_size_});
    extra_size_ += info.components;
    if ((info.travel & with_particle) == 0) throw std::logic_error("the field " + info.name + " does not travel with its particle");
  }
  if (extra_size_ > Particle<dim>::max_extra) throw std::logic_error("the extra fields are too many numbers for a Particle");
  // A cell wastes less than one block, so this many blocks are never exceeded.
  const std::size_t max_blocks = static_cast<std::size_t>(max / lanes) + std::min(max, mesh.cell_count()) + 1;
  blocks_.reserve(max_blocks);
  extra_.reserve(max_blocks * extra_size_);
  // At least as many as if all cells were full.
  const auto min_blocks = static_cast<std::size_t>(max / lanes);
  ask_for_huge_pages(blocks_.data(), min_blocks * sizeof(Block<dim>));
  ask_for_huge_pages(extra_.data(), min_blocks * extra_size_ * sizeof(StoredLanes));
  occupied_.reserve(std::min(max, mesh.cell_count()));
}

template <int dim>
Index Particles<dim>::free_block(const Vec<dim>& x)
{
  Index b = free_;
  if (b != none) {
    free_ = blocks_[b].next;
    blocks_[b] = Block<dim>{};
    std::fill_n(extra(b), extra_size_, Lanes{});
  } else {
    b = static_cast<Index>(blocks_.size());
    blocks_.push_back(Block<dim>{});
    extra_.resize(extra_.size() + extra_size_, StoredLanes{});
  }
  Block<dim>& block = blocks_[b];
  for (int d = 0; d < dim; ++d) block.x[d] = all_lanes(x[d]);
  std::fill_n(block.id, lanes, none);
  block.next = none;
  return b;
}

template <int dim>
Index Particles<dim>::block_at(Index cell, Index index) const
{
  Index b = head_[cell];
  for (; index >= lanes; index -= lanes) b = blocks_[b].next;
  return b;
}

template <int dim>
void Particles<dim>::write(Index b, int l, const Particle<dim>& p)
{
  Block<dim>& block = blocks_[b];
  for_each_component<dim>([&](const auto& field, int component) { field.of(block, component)[l] = field.of(p, component); });
  for (int k = 0; k < extra_size_; ++k) extra(b)[k][l] = p.extra[k];
}

template <int dim>
Particle<dim> Particles<dim>::read(Index b, int l) const
{
  const Block<dim>& block = blocks_[b];
  Particle<dim> p;
  for_each_component<dim>([&](const auto& field, int component) { field.of(p, component) = field.of(block, component)[l]; });
  for (int k = 0; k < extra_size_; ++k) p.extra[k] = extra(b)[k][l];
  return p;
}

template <int dim>
void Particles<dim>::insert(Index cell, const Particle<dim>& particle)
{
  const Index index = count_[cell]++;
  ++size_;
  changed_ = changed_ || index == 0;
  Index b;
  if (index % lanes != 0) {
    b = block_at(cell, index);
  } else {
    b = free_block(particle.x);
    if (index == 0)
      head_[cell] = b;
    else
      blocks_[block_at(cell, index - 1)].next = b;
  }
  write(b, index % lanes, particle);
}

template <int dim>
Particle<dim> Particles<dim>::take(Index cell, Index index)
{
  const Index last = --count_[cell];
  --size_;
  changed_ = changed_ || last == 0;
  const Index b = block_at(cell, index), last_block = block_at(cell, last);
  const Particle<dim> taken = read(b, index % lanes);
  if (index != last) write(b, index % lanes, read(last_block, last % lanes));
  Particle<dim> nothing;
  nothing.x = taken.x;
  write(last_block, last % lanes, nothing);
  if (last % lanes == 0) {  // the last block is empty now
    if (last > 0) blocks_[block_at(cell, last - 1)].next = none;
    blocks_[last_block].next = free_;
    free_ = last_block;
  }
  return taken;
}

template <int dim>
bool Particles<dim>::sort_occupied()
{
  if (!changed_) return false;
  changed_ = false;
  select(
      "change cells: occupied", count_.size(), [&](Index cell) { return count_[cell] > 0; }, occupied_);
  return true;
}

template class Particles<2>;
template class Particles<3>;

}  // namespace berm::bodies
