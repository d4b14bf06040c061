// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "problem/model.hpp"

namespace berm::problem {

/// Between two levels, m.
struct Slab {
  Real bottom, top;
};

/// Whether the box around a cell has a part in the slab of the box around the area of an earthwork.
template <int dim>
bool comes_near(const Model<dim>& model, const Earthwork<dim>& work, const Slab& slab, Index cell);

/// A slab of the area of an earthwork, without what rigid bodies take of it.
template <int dim>
struct WorkRegion {
  const Model<dim>& model;
  const Earthwork<dim>& work;
  Slab slab;
  std::vector<bodies::RigidShape<dim>> holes = {};

  /// How far a point is from the region, m, at least; negative inside: how far from its bounds, at least.
  Real distance(const Vec<dim>& x) const;
  bool holds(const Vec<dim>& x) const { return distance(x) <= 0; }
  /// Its volume within the mesh, m2 or m3 (around an axis m3 per radian), to about a hundredth of a cell at its bounds.
  Real volume() const;
  /// The part of a square (cube) of this section, m2 or m3, around a point that lies in it.
  Real fraction_within(const Vec<dim>& x, Real section) const;
};

/// The particles of all bodies, of all ranks, in and around the cells of a region; by cell.
template <int dim>
class SoilAround {
public:
  /// `first`: of the numbers that particles of the body of a fill have which came since it began.
  SoilAround(const State<dim>& state, const WorkRegion<dim>& region, std::int32_t first);

  /// Whether a particle of this section finds room at a point of a cell: away from all others, by a part of the width of the wider of the two (three quarters; a half of what came since the fill began, so that
  /// lifts find the points that the fill would have at once), and where less than nine tenths of the cells around are filled.
  bool has_room(Index cell, const Vec<dim>& x, Real section) const;
  /// How much of the region they take, m2 or m3 (around an axis m3 per radian): each particle as a square (cube).
  Real volume_in_region() const;

private:
  struct Neighbour {
    Index cell;
    Vec<dim> x;
    Real volume;
    bool came_since;
  };
  Real section_of(const Neighbour& p) const;
  auto first_in(Index cell) const;

  const WorkRegion<dim>& region_;
  const mesh::Mesh<dim>& mesh_;
  std::vector<Neighbour> all_;
};

}  // namespace berm::problem
