// SPDX-License-Identifier: BSD-3-Clause
#include "bodies/particles.hpp"

#include "core/lazy_memory.hpp"

#include <algorithm>

namespace berm::bodies {

template <int dim>
Particles<dim>::Particles(const mesh::Mesh<dim>& mesh, Index max, int state_size)
    : head_(CellField<Index>::zeros(mesh.cell_count())),
      count_(CellField<Index>::zeros(mesh.cell_count())),
      state_size_(state_size)
{
  // A cell wastes less than one block, so this many blocks are never exceeded.
  const std::size_t max_blocks = static_cast<std::size_t>(max / lanes) + std::min(max, mesh.cell_count()) + 1;
  blocks_.reserve(max_blocks);
  state_.reserve(max_blocks * state_size);
  // At the least as many as there would be if all were full.
  const auto min_blocks = static_cast<std::size_t>(max / lanes);
  ask_for_huge_pages(blocks_.data(), min_blocks * sizeof(Block<dim>));
  ask_for_huge_pages(state_.data(), min_blocks * state_size * sizeof(StoredLanes));
  occupied_.reserve(std::min(max, mesh.cell_count()));
}

template <int dim>
Index Particles<dim>::free_block(const Vec<dim>& x)
{
  Index b = free_;
  if (b != none) {
    free_ = blocks_[b].next;
    blocks_[b] = Block<dim>{};
    std::fill_n(state(b), state_size_, Lanes{});
  } else {
    b = static_cast<Index>(blocks_.size());
    blocks_.push_back(Block<dim>{});
    state_.resize(state_.size() + state_size_, StoredLanes{});
  }
  Block<dim>& block = blocks_[b];
  for (int d = 0; d < dim; ++d) block.x[d] = all_lanes(x[d]);
  std::fill_n(block.id, lanes, none);
  block.next = none;
  return b;
}

template <int dim>
Index Particles<dim>::block_at(Index cell, Index place) const
{
  Index b = head_[cell];
  for (; place >= lanes; place -= lanes) b = blocks_[b].next;
  return b;
}

template <int dim>
void Particles<dim>::write(Index b, int l, const Particle<dim>& p)
{
  Block<dim>& block = blocks_[b];
  for (int d = 0; d < dim; ++d) block.x[d][l] = p.x[d], block.v[d][l] = p.v[d];
  for (int k = 0; k < tensor_size<dim>; ++k) block.stress[k][l] = p.stress[k];
  block.volume[l] = p.volume;
  block.mass[l] = p.mass;
  block.deviatoric_strain[l] = p.deviatoric_strain;
  block.id[l] = p.id;
  for (int k = 0; k < state_size_; ++k) state(b)[k][l] = p.state[k];
}

template <int dim>
Particle<dim> Particles<dim>::read(Index b, int l) const
{
  const Block<dim>& block = blocks_[b];
  Particle<dim> p;
  for (int d = 0; d < dim; ++d) p.x[d] = block.x[d][l], p.v[d] = block.v[d][l];
  for (int k = 0; k < tensor_size<dim>; ++k) p.stress[k] = block.stress[k][l];
  p.volume = block.volume[l];
  p.mass = block.mass[l];
  p.deviatoric_strain = block.deviatoric_strain[l];
  p.id = block.id[l];
  for (int k = 0; k < state_size_; ++k) p.state[k] = state(b)[k][l];
  return p;
}

template <int dim>
void Particles<dim>::insert(Index cell, const Particle<dim>& particle)
{
  const Index place = count_[cell]++;
  ++size_;
  changed_ = changed_ || place == 0;
  Index b;
  if (place % lanes != 0) {
    b = block_at(cell, place);
  } else {
    b = free_block(particle.x);
    if (place == 0)
      head_[cell] = b;
    else
      blocks_[block_at(cell, place - 1)].next = b;
  }
  write(b, place % lanes, particle);
}

template <int dim>
Particle<dim> Particles<dim>::take(Index cell, Index place)
{
  const Index last = --count_[cell];
  --size_;
  changed_ = changed_ || last == 0;
  const Index b = block_at(cell, place), last_block = block_at(cell, last);
  const Particle<dim> taken = read(b, place % lanes);
  if (place != last) write(b, place % lanes, read(last_block, last % lanes));
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
  occupied_.clear();
  for (Index cell = 0; cell < count_.size(); ++cell)
    if (count_[cell] > 0) occupied_.push_back(cell);
  return true;
}

template class Particles<2>;
template class Particles<3>;

}  // namespace berm::bodies
