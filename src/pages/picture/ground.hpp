// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "mesh/mesh.hpp"
#include "picture/sketch.hpp"

namespace berm::picture {

/// A material of a body, which has one colour.
struct SoilKind {
  std::string body, material;
  settings::Case const* settings;
};

/// A convex part of a cell and what fills it.
struct Piece {
  Points corners;
  Index kind;  ///< of Ground::kinds, or none: no soil at the start
};

/// A side of a cell at the border of the mesh.
struct Side {
  Vec<2> from, to, outward;
};

/// The sides that a support holds.
struct HeldSides {
  std::string words;  ///< "x, y fixed"; where water flows also whether it crosses
  std::string boundary;
  int directions;  ///< bit 0: x, bit 1: y
  std::vector<Side> sides;
};

/// A point of soil that a traction loads, and where it is pulled to.
struct LoadedSpot {
  std::string traction;
  Vec<2> at, along;
};

/// The mesh and the soil on it as a run finds them.
struct Ground {
  std::vector<SoilKind> kinds;  ///< of the bodies that fill regions first, in the order of the case; blocks and disks too
  std::vector<Piece> pieces;
  std::vector<Side> surface;  ///< between soil and no soil
  std::vector<HeldSides> held;
  std::vector<LoadedSpot> loaded;
  Vec<2> lower, upper;  ///< of the mesh, m
  Index cells = 0;      ///< 0: the pieces are those of regions
};

/// `bed`: the surface, from which layers count. Throws KeyError where a name of the case refers to nothing in the mesh.
Ground ground_of(const settings::Case& c, const mesh::Mesh<2>& mesh, const problem::Ground& bed);
/// The same without a mesh, as far as the case tells: regions of a bed and of a box, no loads; of a mesh from a file its surface alone.
Ground ground_of(const settings::Case& c, const Sketch& sketch);

/// The first kind of a body: of a block or disk all of it.
Index kind_of(const Ground& ground, const std::string& body);
/// The kind of a material of a body; where it is equal to the first one, that.
Index kind_of(const Ground& ground, const std::string& body, const std::string& material);

}  // namespace berm::picture
