// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "bodies/rigid/rigid_body.hpp"
#include "io/vtu.hpp"

namespace berm::run_folder {

/// A rigid body's surface as points and flat cells, for pictures.
template <int dim>
struct RigidSurface {
  struct Cell {
    io::VtkCell type;
    std::vector<Index> points;
  };
  std::vector<Vec<dim>> points;  ///< m
  std::vector<Cell> cells;
};

/// A circle becomes a polygon of 128 points (in space: 128 quads along z from lower to upper) and, where it has turned, a line from its centre,
/// a polygon itself (in space: quads along z), a box a quad (hexahedron), a half-plane the
/// part of its line (polygon) inside the box from lower to upper: no cell where it misses the box.
template <int dim>
RigidSurface<dim> surface_of(const bodies::RigidShape<dim>& shape, const Vec<dim>& lower, const Vec<dim>& upper);

}  // namespace berm::run_folder
