// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/bodies/pack_particles_test.cpp
#include "bodies/particles.hpp"

#include "core/bytes.hpp"

namespace berm::bodies {
namespace {

/// A cell's particles in a pack: this, its blocks, then their extra fields.
struct PackedCell {
  Index cell, count;
};

}  // namespace

template <int dim>
void Particles<dim>::pack(Index first, Index end, std::vector<std::byte>& bytes) const
{
  const std::vector<Index>& cells = occupied();
  for (auto cell = std::lower_bound(cells.begin(), cells.end(), first); cell != cells.end() && *cell < end; ++cell) {
    const PackedCell packed{*cell, count_[*cell]};
    put_bytes(bytes, &packed, 1);
    const auto for_blocks = [&](const auto& visit) {
      Index b = head_[*cell];
      for (Index k = blocks_for(packed.count); k > 0; --k, b = blocks_[b].next) visit(b);
    };
    for_blocks([&](Index b) { put_bytes(bytes, &blocks_[b], 1); });
    for_blocks([&](Index b) { put_bytes(bytes, extra(b), static_cast<std::size_t>(extra_size_)); });
  }
}

template <int dim>
void Particles<dim>::unpack(const std::vector<std::byte>& bytes)
{
  const std::byte* const end = bytes.data() + bytes.size();
  const std::size_t bytes_of_block = sizeof(Block<dim>) + static_cast<std::size_t>(extra_size_) * sizeof(Lanes);
  std::vector<Index> cells, counts;
  size_ = 0;
  for (const std::byte* at = bytes.data(); at != end;) {
    PackedCell packed{};
    at = get_bytes(at, &packed, 1) + static_cast<std::size_t>(blocks_for(packed.count)) * bytes_of_block;
    cells.push_back(packed.cell);
    counts.push_back(packed.count);
    size_ += packed.count;
  }
  lay_out(cells, counts);
  const std::byte* at = bytes.data();
  for (const Index cell : cells) {
    at += sizeof(PackedCell);
    const Index first = head_[cell], behind = first + blocks_for(count_[cell]);
    for (Index b = first; b < behind; ++b) {
      const Index next = blocks_[b].next;
      at = get_bytes(at, &blocks_[b], 1);
      blocks_[b].next = next;
    }
    for (Index b = first; b < behind; ++b) at = get_bytes(at, extra(b), static_cast<std::size_t>(extra_size_));
  }
}

template void Particles<2>::pack(Index, Index, std::vector<std::byte>&) const;
template void Particles<2>::unpack(const std::vector<std::byte>&);
template void Particles<3>::pack(Index, Index, std::vector<std::byte>&) const;
template void Particles<3>::unpack(const std::vector<std::byte>&);

}  // namespace berm::bodies
