// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/simulation/checkpoints_state_test.cpp
#include "bodies/particle_fields.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::bodies {
namespace {

/// The blocks of all cells, cell after cell, each cell's in their order.
template <int dim>
std::vector<Index> blocks_in_order(const Particles<dim>& particles)
{
  std::vector<Index> order;
  for (const Index cell : particles.occupied())
    for (const auto& block : particles.blocks_in(cell)) order.push_back(block.index);
  return order;
}

/// One number of every lane, empty lanes included. numbers_of(b) points to those of block b.
template <class T, class NumbersOf>
void keep_lanes(Archive& k, const std::string& name, const std::vector<Index>& order, const NumbersOf& numbers_of)
{
  std::vector<T> all(order.size() * lanes);
  if (!k.reads())
    for (std::size_t n = 0; n < order.size(); ++n)
      std::copy_n(numbers_of(order[n]), lanes, all.begin() + static_cast<std::ptrdiff_t>(n) * lanes);
  k.fixed(name, all);
  if (k.reads())
    for (std::size_t n = 0; n < order.size(); ++n)
      std::copy_n(all.begin() + static_cast<std::ptrdiff_t>(n) * lanes, lanes, numbers_of(order[n]));
}

/// Whether the lanes with a particle hold numbers from 0 to `end` - 1, each at most once.
template <int dim>
bool have_numbers_below(Index end, const Particles<dim>& particles)
{
  std::vector<bool> seen(static_cast<std::size_t>(end), false);
  bool valid = true;
  particles.visit([&](Index, Index b, int l) {
    const std::int32_t id = particles.block(b).id[l];
    valid = valid && id >= 0 && id < end && !seen[static_cast<std::size_t>(id)];
    if (valid) seen[static_cast<std::size_t>(id)] = true;
  });
  return valid;
}

}  // namespace

template <int dim>
void Particles<dim>::lay_out(const std::vector<Index>& cells, const std::vector<Index>& counts)
{
  head_ = CellField<Index>::zeros(head_.size());
  count_ = CellField<Index>::zeros(count_.size());
  const std::size_t room = blocks_.capacity();
  std::size_t used = 0;
  for (const Index count : counts) used += static_cast<std::size_t>(blocks_for(count));
  decltype(blocks_)().swap(blocks_);  // memory that was written to goes back to the system
  decltype(extra_)().swap(extra_);
  make_room(std::max(room, used), used);
  free_ = none;
  for (std::size_t c = 0; c < cells.size(); ++c) {
    count_[cells[c]] = counts[c];
    head_[cells[c]] = static_cast<Index>(blocks_.size());
    for (Index left = counts[c]; left > 0; left -= lanes) {
      blocks_.push_back(Block<dim>{});
      blocks_.back().next = left > lanes ? static_cast<Index>(blocks_.size()) : none;
    }
  }
  extra_.resize(blocks_.size() * static_cast<std::size_t>(extra_size_), StoredLanes{});
  changed_ = true;
  sort_occupied();
}

template <int dim>
void Particles<dim>::archive(Archive& k, std::optional<Index> numbered)
{
  std::vector<Index> cells = occupied(), counts;
  for (const Index cell : cells) counts.push_back(count_[cell]);
  k("cells", cells);
  k("counts", counts);
  if (k.reads()) {
    BigIndex total = 0;
    bool valid = counts.size() == cells.size();
    for (std::size_t c = 0; valid && c < cells.size(); ++c) {
      valid = cells[c] > (c > 0 ? cells[c - 1] : -1) && cells[c] < count_.size() && counts[c] > 0;
      total += counts[c];
    }
    if (!valid || (numbered ? total > *numbered : total != size_))
      k.refuse(fmt::format("it does not have the {} particles of this body in cells of this mesh", numbered.value_or(size_)));
    size_ = static_cast<Index>(total);
    lay_out(cells, counts);
  }
  const std::vector<Index> order = blocks_in_order(*this);
  for_each_component<dim>([&](const auto& field, int component) {
    using Number = typename std::decay_t<decltype(field)>::Number;
    const FieldInfo info = field.info();
    if (info.goes(to_checkpoint))
      keep_lanes<Number>(k, component_name(info, component, dim), order,
                         [&](Index b) { return reinterpret_cast<Number*>(&field.of(blocks_[b], component)); });
  });
  for (const ExtraField& field : extra_fields_)
    for (int component = 0; component < field.info.components; ++component)
      if (field.info.goes(to_checkpoint))
        keep_lanes<Real>(k, component_name(field.info, component, dim), order,
                         [&](Index b) { return reinterpret_cast<Real*>(extra(b) + field.offset + component); });
  const Index end = numbered.value_or(size_);
  if (k.reads() && !have_numbers_below(end, *this)) k.refuse(fmt::format("its particles are not numbered from 0 to {}", end - 1));
}

template void Particles<2>::archive(Archive&, std::optional<Index>);
template void Particles<3>::archive(Archive&, std::optional<Index>);

}  // namespace berm::bodies
