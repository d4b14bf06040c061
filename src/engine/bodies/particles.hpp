// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/archive.hpp"
#include "core/chunks.hpp"
#include "core/field_info.hpp"
#include "core/lane_parts.hpp"
#include "mesh/mesh.hpp"

#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace berm::bodies {

/// Four particles of one cell (fields: bodies/particle_fields.hpp). Lanes beyond the cell's count are empty: mass, volume
/// and stress zero, a finite position.
template <int dim>
struct alignas(32) Block {
  Lanes x[dim];                    ///< position, m
  Lanes v[dim];                    ///< velocity, m/s
  Lanes stress[tensor_size<dim>];  ///< Pa, tension positive; components as in SymTensor
  Lanes volume;                    ///< m2 (per metre run) or m3
  Lanes mass;                      ///< kg/m or kg
  Lanes deviatoric_strain;         ///< accumulated equivalent deviatoric strain
  std::int32_t id[lanes];          ///< 0 ... count - 1, permanent
  Index next;                      ///< the cell's next block, or none
};

/// How many blocks so many particles of a cell have.
constexpr Index blocks_for(Index count)
{
  return (count + lanes - 1) / lanes;
}

/// One particle by itself: in transit between cells, or read for output.
template <int dim>
struct Particle {
  static constexpr int max_extra = 36;  ///< numbers of extra fields per particle

  Vec<dim> x = Vec<dim>::Zero(), v = Vec<dim>::Zero();
  SymTensor<dim> stress{};
  Real volume = 0, mass = 0, deviatoric_strain = 0;
  Real extra[max_extra] = {};
  std::int32_t id = none;
};

/// A particle that changes its cell: its place, and the cell that it goes to.
struct CellChange {
  Index from, index, to;
};

/// Work arrays of Particles::take_out and put_in, one entry a change.
template <int dim>
struct Transit {
  std::vector<Particle<dim>> particle;
  std::vector<Index> index;  ///< in the new cell
  std::vector<Index> block;  ///< that the change empties, then that it begins; or none
  std::vector<Index> order;  ///< of the changes by the new cell

  void reserve(std::size_t count);
};

/// A field of some bodies' particles only, such as the state variables of a law.
struct ExtraField {
  FieldInfo info;
  int offset;  ///< of its first number among the extra numbers of a particle
};

/// A block of the chain of a cell.
template <class B>
struct CellBlock {
  B& block;
  Index index;  ///< of the block
  int count;    ///< of its lanes that hold a particle: the first ones
};

/// The chain of blocks of a cell, to go over: for (const auto& [p, b, count] : particles.blocks_in(cell)).
template <class B>
class CellBlocks {
public:
  struct End {};
  class Iterator {
  public:
    Iterator(B* blocks, Index first, Index left) : blocks_(blocks), index_(first), left_(left) {}
    CellBlock<B> operator*() const { return {blocks_[index_], index_, left_ < lanes ? left_ : lanes}; }
    Iterator& operator++()
    {
      index_ = blocks_[index_].next;
      left_ -= lanes;
      return *this;
    }
    bool operator!=(End) const { return left_ > 0; }

  private:
    B* blocks_;
    Index index_, left_;
  };

  CellBlocks(B* blocks, Index first, Index count) : begin_(blocks, first, count) {}
  Iterator begin() const { return begin_; }
  End end() const { return {}; }

private:
  Iterator begin_;
};

/// The particles of one body, sorted by cell: each cell owns a chain of blocks, all full but the last. Memory is reserved once; particles that
/// change cell allocate nothing.
template <int dim>
class Particles {
public:
  Particles() = default;
  /// Allocates for `max` particles anywhere in the mesh, each with these extra fields; the law's state variables come first.
  /// Throws std::logic_error where they exceed Particle::max_extra numbers, or one does not move with its particle.
  Particles(const mesh::Mesh<dim>& mesh, Index max, const std::vector<FieldInfo>& extra);

  Index size() const { return size_; }
  const std::vector<ExtraField>& extra_fields() const { return extra_fields_; }
  /// Numbers of all extra fields per particle.
  int extra_size() const { return extra_size_; }

  Index count_in(Index cell) const { return count_[cell]; }
  Index first_block(Index cell) const { return count_[cell] > 0 ? head_[cell] : none; }
  CellBlocks<Block<dim>> blocks_in(Index cell) { return {blocks_.data(), head_[cell], count_[cell]}; }
  CellBlocks<const Block<dim>> blocks_in(Index cell) const { return {blocks_.data(), head_[cell], count_[cell]}; }
  /// Blocks that have been in use so far; some may be empty now.
  Index block_count() const { return static_cast<Index>(blocks_.size()); }
  Block<dim>& block(Index b) { return blocks_[b]; }
  const Block<dim>& block(Index b) const { return blocks_[b]; }
  /// The extra fields of block b: extra_size() Lanes.
  Lanes* extra(Index b) { return reinterpret_cast<Lanes*>(extra_.data() + static_cast<std::size_t>(b) * extra_size_); }
  const Lanes* extra(Index b) const { return reinterpret_cast<const Lanes*>(extra_.data() + static_cast<std::size_t>(b) * extra_size_); }
  /// The law's state variables of block b: the first of its extra fields.
  Lanes* state(Index b) { return extra(b); }
  const Lanes* state(Index b) const { return extra(b); }

  /// Calls visit(part) for each part of a cell's particles (core/lane_parts.hpp).
  template <class Visit>
  [[gnu::always_inline]] void parts(Index cell, const Visit& visit) const
  {
    for_each_part(
        head_[cell], count_[cell], [&](Index b) { return blocks_[b].next; }, visit);
  }

  /// Prefetches the first three blocks of the cell four entries after active()[c]: the processor cannot predict the
  /// addresses of cells with different numbers of blocks (docs/performance.md).
  [[gnu::always_inline]] void prefetch_after(Index c) const
  {
    constexpr std::size_t ahead = 4;
    if (c + ahead >= active_.size()) return;
    const auto* bytes = reinterpret_cast<const char*>(&blocks_[head_[active_[c + ahead]]]);
    prefetch_lines(bytes, std::make_index_sequence<3 * sizeof(Block<dim>) / cache_line>());
  }

  /// Cells that hold particles, ascending. sort_occupied() brings it up to date, and active(), and is true where it changed.
  const std::vector<Index>& occupied() const { return inactive_ ? occupied_ : active_; }
  /// The chunks of occupied().
  const Chunks& chunks() const { return inactive_ ? chunks_ : active_chunks_; }
  /// Those of occupied() that are not inactive: the cells that a step goes over.
  const std::vector<Index>& active() const { return active_; }
  /// The chunks of active().
  const Chunks& active_chunks() const { return active_chunks_; }
  bool sort_occupied();

  /// Which cells of the mesh are inactive (1): steps leave them out. Null: none is.
  void set_inactive(std::shared_ptr<const CellField<std::uint8_t>> inactive);
  /// Whether any cell is inactive; whether this one is.
  bool some_inactive() const { return inactive_ != nullptr; }
  bool is_inactive(Index cell) const { return inactive_ != nullptr && (*inactive_)[cell] != 0; }
  /// Whether a cell is one of active().
  bool is_active(Index cell) const { return count_[cell] > 0 && !is_inactive(cell); }

  void insert(Index cell, const Particle<dim>& particle);
  /// Removes the particle with this index (0 ... count - 1) from a cell; the cell's last particle gets its index.
  Particle<dim> take(Index cell, Index index);
  /// Takes the particles of all changes, sorted by `from` and `index`, out of their cells, in parallel, as take() from the last to the first would. Allocates
  /// nothing where `transit` has room.
  void take_out(const std::vector<CellChange>& changes, Transit<dim>& transit);
  /// Puts the particles of all changes into their cells, in parallel, as insert() from the first to the last would. `to` is a cell, never none.
  void put_in(const std::vector<CellChange>& changes, Transit<dim>& transit);
  Particle<dim> read(Index block, int lane) const;
  /// The particle with this index in a cell.
  Particle<dim> read_at(Index cell, Index index) const { return read(block_at(cell, index), index % lanes); }

  /// Appends the bytes of all particles of cells from `first` to before `end`, with their lanes.
  void pack(Index first, Index end, std::vector<std::byte>& bytes) const;
  /// Replaces all particles by those that were packed, cells ascending, end to end.
  void unpack(const std::vector<std::byte>& bytes);

  /// All particles with their cells, blocks and lanes, on which sums depend to the last bit. Reading replaces the particles
  /// by as many others, with the numbers 0 ... size() - 1; where soil comes and goes by any that have different numbers below `numbered`.
  void archive(Archive& k, std::optional<Index> numbered = {});

  /// Calls visit(cell, block index, lane) for each particle, cell by cell in ascending order.
  template <class Visit>
  void visit(const Visit& visit) const
  {
    for (Index cell : occupied())
      for (const auto& [block, b, count] : blocks_in(cell))
        for (int l = 0; l < count; ++l) visit(cell, b, l);
  }

private:
  static constexpr std::size_t cache_line = 64;  // bytes

  /// Unrolled: a loop would take as long as it saves.
  template <std::size_t... line>
  [[gnu::always_inline]] static void prefetch_lines(const char* bytes, std::index_sequence<line...>)
  {
    (__builtin_prefetch(bytes + line * cache_line), ...);
  }

  void make_room(std::size_t max_blocks, std::size_t min_blocks);
  void lay_out(const std::vector<Index>& cells, const std::vector<Index>& counts);
  Index free_block();
  void give_back(Index block);
  Particle<dim> take_from(Index cell, Index index, Index& emptied_block);
  void put_at(Index cell, Index index, Index new_block, const Particle<dim>& particle);
  void write(Index block, int lane, const Particle<dim>& particle);
  Index block_at(Index cell, Index index) const;

  std::vector<Block<dim>, LazyZeroAllocator<Block<dim>>> blocks_;
  std::vector<StoredLanes, LazyZeroAllocator<StoredLanes>> extra_;
  CellField<Index> head_, count_;  ///< not written, and so without memory, where there never was a particle
  std::shared_ptr<const CellField<std::uint8_t>> inactive_;
  std::vector<Index> active_, occupied_;  ///< the second only where some cells are inactive
  Chunks active_chunks_, chunks_;
  std::vector<Index> chunk_bounds_;  ///< of the mesh's cells
  Index free_ = none;                ///< chain of free blocks
  Index size_ = 0;
  std::vector<ExtraField> extra_fields_;
  int extra_size_ = 0;
  bool changed_ = false;  ///< a cell became occupied or empty since sort_occupied()
};

}  // namespace berm::bodies
