// SPDX-License-Identifier: BSD-3-Clause
#include "bodies/particles.hpp"

#include "bodies/particle_fields.hpp"
#include "core/for_each_run.hpp"
#include "material/material.hpp"
#include "os/lazy_memory.hpp"

#include <algorithm>
#include <stdexcept>

namespace berm::bodies {

static_assert(material::max_state <= Particle<2>::max_extra && material::max_state <= Particle<3>::max_extra,
              "a law keeps more numbers than a particle has room for");

template <int dim>
Particles<dim>::Particles(const mesh::Mesh<dim>& mesh, Index max, const std::vector<FieldInfo>& extra)
    : head_(CellField<Index>::zeros(mesh.cell_count())),
      count_(CellField<Index>::zeros(mesh.cell_count())),
      chunk_bounds_(mesh.cell_chunks)
{
  for (const FieldInfo& info : extra) {
    extra_fields_.push_back({info, extra_size_});
    extra_size_ += info.components;
    if ((info.travel & with_particle) == 0) throw std::logic_error("the field " + info.name + " does not travel with its particle");
  }
  if (extra_size_ > Particle<dim>::max_extra) throw std::logic_error("the extra fields are too many numbers for a Particle");
  // A cell wastes less than one block, so this many blocks are never exceeded.
  // At least as many are used as if all cells were full.
  make_room(static_cast<std::size_t>(max / lanes) + std::min(max, mesh.cell_count()) + 1, static_cast<std::size_t>(max / lanes));
  active_.reserve(std::min(max, mesh.cell_count()));
}

/// For at most max_blocks blocks, of which min_blocks will be used.
template <int dim>
void Particles<dim>::make_room(std::size_t max_blocks, std::size_t min_blocks)
{
  blocks_.reserve(max_blocks);
  extra_.reserve(max_blocks * extra_size_);
  ask_for_huge_pages(blocks_.data(), min_blocks * sizeof(Block<dim>));
  ask_for_huge_pages(extra_.data(), min_blocks * extra_size_ * sizeof(StoredLanes));
}

template <int dim>
void Transit<dim>::reserve(std::size_t count)
{
  particle.reserve(count);
  index.reserve(count);
  block.reserve(count);
  order.reserve(count);
}

template <int dim>
Index Particles<dim>::free_block()
{
  const Index b = free_;
  if (b != none) {
    free_ = blocks_[b].next;
    return b;
  }
  blocks_.push_back(Block<dim>{});
  extra_.resize(extra_.size() + extra_size_, StoredLanes{});
  return static_cast<Index>(blocks_.size()) - 1;
}

template <int dim>
void Particles<dim>::give_back(Index b)
{
  blocks_[b].next = free_;
  free_ = b;
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

/// new_block is the block that the particle begins, or none.
template <int dim>
void Particles<dim>::put_at(Index cell, Index index, Index new_block, const Particle<dim>& particle)
{
  if (new_block == none) {
    write(block_at(cell, index), index % lanes, particle);
    return;
  }
  Block<dim>& block = blocks_[new_block];
  block = Block<dim>{};
  std::fill_n(extra(new_block), extra_size_, Lanes{});
  for (int d = 0; d < dim; ++d) block.x[d] = all_lanes(particle.x[d]);
  std::fill_n(block.id, lanes, none);
  block.next = none;
  (index == 0 ? head_[cell] : blocks_[block_at(cell, index - 1)].next) = new_block;
  write(new_block, 0, particle);
}

template <int dim>
void Particles<dim>::insert(Index cell, const Particle<dim>& particle)
{
  const Index index = count_[cell]++;
  ++size_;
  changed_ = changed_ || index == 0;
  put_at(cell, index, index % lanes == 0 ? free_block() : none, particle);
}

/// emptied_block is the cell's last block where nothing is left in it, or none.
template <int dim>
Particle<dim> Particles<dim>::take_from(Index cell, Index index, Index& emptied_block)
{
  const Index last = --count_[cell];
  const Index b = block_at(cell, index), last_block = block_at(cell, last);
  const Particle<dim> taken = read(b, index % lanes);
  if (index != last) write(b, index % lanes, read(last_block, last % lanes));
  Particle<dim> nothing;
  nothing.x = taken.x;
  write(last_block, last % lanes, nothing);
  emptied_block = last % lanes == 0 ? last_block : none;
  if (emptied_block != none && last > 0) blocks_[block_at(cell, last - 1)].next = none;
  return taken;
}

template <int dim>
Particle<dim> Particles<dim>::take(Index cell, Index index)
{
  Index emptied = none;
  const Particle<dim> taken = take_from(cell, index, emptied);
  --size_;
  changed_ = changed_ || count_[cell] == 0;
  if (emptied != none) give_back(emptied);
  return taken;
}

template <int dim>
void Particles<dim>::take_out(const std::vector<CellChange>& changes, Transit<dim>& transit)
{
  const auto count = static_cast<Index>(changes.size());
  transit.particle.resize(changes.size());
  transit.block.resize(changes.size());
  for_each_run(
      count, [&](Index a, Index b) { return changes[a].from == changes[b].from; },
      [&](Index first, Index end) {  // the last first: taking a particle moves only ones that were behind it
        for (Index m = end; m-- > first;) transit.particle[m] = take_from(changes[m].from, changes[m].index, transit.block[m]);
      });
  // Which blocks are free depends on the order of all changes.
  for (Index m = count; m-- > 0;) {
    changed_ = changed_ || count_[changes[m].from] == 0;
    if (transit.block[m] != none) give_back(transit.block[m]);
  }
  size_ -= count;
}

template <int dim>
void Particles<dim>::put_in(const std::vector<CellChange>& changes, Transit<dim>& transit)
{
  const auto count = static_cast<Index>(changes.size());
  size_ += count;
  transit.index.resize(changes.size());
  transit.block.resize(changes.size());
  transit.order.resize(changes.size());
  for (Index m = 0; m < count; ++m) {
    const Index index = transit.index[m] = count_[changes[m].to]++;
    changed_ = changed_ || index == 0;
    transit.block[m] = index % lanes == 0 ? free_block() : none;
    transit.order[m] = m;
  }
  const auto to = [&](Index k) { return changes[transit.order[k]].to; };
  std::sort(transit.order.begin(), transit.order.end(),
            [&](Index a, Index b) { return std::pair(changes[a].to, a) < std::pair(changes[b].to, b); });
  for_each_run(
      count, [&](Index a, Index b) { return to(a) == to(b); },
      [&](Index first, Index end) {
        for (Index k = first; k < end; ++k) {
          const Index m = transit.order[k];
          put_at(changes[m].to, transit.index[m], transit.block[m], transit.particle[m]);
        }
      });
}

template <int dim>
bool Particles<dim>::sort_occupied()
{
  if (!changed_) return false;
  changed_ = false;
  const auto is_occupied = [&](Index cell) { return count_[cell] > 0; };
  if (!inactive_) {
    select("change cells: occupied", chunk_bounds_, is_occupied, active_, active_chunks_);
    return true;
  }
  select("change cells: occupied", chunk_bounds_, is_occupied, occupied_, chunks_);
  select(
      "change cells: occupied", chunk_bounds_, [&](Index cell) { return count_[cell] > 0 && (*inactive_)[cell] == 0; }, active_,
      active_chunks_);
  return true;
}

template <int dim>
void Particles<dim>::set_inactive(std::shared_ptr<const CellField<std::uint8_t>> inactive)
{
  inactive_ = std::move(inactive);
  changed_ = true;
  sort_occupied();
}

template struct Transit<2>;
template struct Transit<3>;
template class Particles<2>;
template class Particles<3>;

}  // namespace berm::bodies
