// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/fields.hpp"
#include "core/ranks.hpp"
#include "mesh/patches.hpp"

namespace berm::mpm {

/// The cells of other ranks that share a node with a cell of this one, or with one that is in a patch with it: their sums over particles come from their
/// owners. Empty where one process has all.
struct Halo {
  struct Side {
    std::vector<Index> inner;  ///< cells of this rank that the other one needs, ascending
    std::vector<Index> sent;   ///< those of them with particles
    std::vector<Index> got;    ///< cells of the other rank with particles
  };
  std::vector<Side> sides;  ///< by the rank that a letter goes to
  std::vector<Messenger::Letter> letters;
  std::vector<Index> outer;             ///< all cells of the halo, ascending
  std::vector<Index> partners;          ///< those of them that are in a patch with a cell of this rank
  NodeField<std::uint8_t> is_complete;  ///< 1: all cells around the node are of this rank or among `outer`

  bool divided() const { return !is_complete.empty(); }

  /// Sends what pack(side, bytes) appends to each side, then calls unpack(side, bytes) for each.
  template <class Pack, class Unpack>
  void exchange(const Pack& pack, const Unpack& unpack)
  {
    for (std::size_t s = 0; s < sides.size(); ++s) {
      letters[s].out.clear();
      pack(sides[s], letters[s].out);
    }
    Ranks::of_run().messenger()->exchange(letters);
    for (std::size_t s = 0; s < sides.size(); ++s) unpack(sides[s], letters[s].in);
  }
};

/// The halo of this rank where the cells are divided among several, or an empty one.
template <int dim>
Halo make_halo(const mesh::Mesh<dim>& mesh, const mesh::Patches& patches);

}  // namespace berm::mpm
