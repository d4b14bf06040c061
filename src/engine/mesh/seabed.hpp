// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/describe.hpp"
#include "mesh/ground_line.hpp"

#include <filesystem>
#include <iosfwd>
#include <string>
#include <vector>

namespace berm::mesh {

/// A trench across the plane, cut into the bed: a level bottom (or one along the slope of the bed) and two straight sides.
struct Trench {
  Real depth = 0;       ///< m below the bed beside it
  Real width = 0;       ///< m, of its bottom
  Real side_slope = 0;  ///< rad from the bed beside it
  Real center = 0;      ///< x, m
};

/// A step of the bed: at its foot begins a straight face, and beyond it the bed is higher or lower.
struct Step {
  Real height = 0;      ///< m; less than 0: the bed is lower beyond the face
  Real position = 0;    ///< x where the face begins, m
  Real face_slope = 0;  ///< rad
};

enum class SeabedPattern { unstructured, lattice };

/// The mesh of a bed with free space above it, fine around the path of a pipe that starts at x = 0. The bed's surface is y = 0. In metres:
///
///     top     +-----------------------------------+  y = headroom
///             |           +------+                |  y = near_height
///             | headroom  |      |                |
///     surface +--+--------+======+-------------+--+  y = 0
///             |  |  bed   | near |             |  |
///     left    |  |        +------+             |  |  right         near: near_left < x < near_right, -near_depth < y < 0
///             |  +-----------------------------+  |
///             |              layer                |
///     base    +-----------------------------------+  y = -depth
///
/// The fine zone may begin at the left wall, near_left = left, which then has no layer.
///
/// Regions "near", "bed", "layer" (where there is one), "headroom"; boundaries "left", "right", "base", "top" and "surface", which lies within the mesh. The size of the cells is near_size
/// in the fine zone (up to near_height above the surface) and min(near_size + growth * distance, far_size) at a distance from it.
///
/// With a slope all lines that are level above ascend along x with it, so that y = 0 is the surface at x = 0 and the bed has its depth everywhere. With a trench
/// or a step the surface follows it (y = 0 is the bed beside the trench, or before the step), the fine zone reaches from near_depth below the lowest to near_height above the highest
/// surface in it, and depth and headroom count from y = 0.
struct SeabedMesh {
  Real length = 0;
  Real depth = 0;
  Real headroom = 0;
  std::optional<Real> left;  ///< from x = 0 to the left wall; empty: length / 2
  Real near_size = 0;
  Real near_left = 0;   ///< x, negative left of the pipe's start
  Real near_right = 0;  ///< x
  Real near_depth = 0;
  Real near_height = 0;
  Real growth = 0.15;
  std::optional<Real> far_size;  ///< empty: not limited
  SeabedPattern pattern = SeabedPattern::unstructured;
  Real layer = 0;  ///< thickness of the layer along walls and base, and maximum size of a cell; 0: no layer
  Real slope = 0;  ///< rad, of the surface: positive ascends along x
  std::optional<Trench> trench = {};
  std::optional<Step> step = {};
  // In space, along z: the walls are at z = -back and width - back.
  std::optional<Real> width = {};                       ///< empty: the bed is plane
  std::optional<Real> back = {};                        ///< from z = 0 to the back wall; empty: width / 2
  std::optional<Real> near_back = {}, near_front = {};  ///< z of the fine zone

  bool in_space() const { return width.has_value(); }
};

void describe(Describe& d, Trench& trench);
void describe(Describe& d, Step& step);
void describe(Describe& d, SeabedMesh& seabed);

/// The surface of the bed, from wall to wall; without corners where it is level.
GroundLine ground_of(const SeabedMesh& seabed);

/// The surface without the trench: that from which the soil was laid down.
GroundLine ground_before_trench(const SeabedMesh& seabed);

/// The fine zone: its lower and upper end are those at x = 0 of lines along the slope.
struct FineZone {
  Real left, right, lower, upper;
};
FineZone fine_zone_of(const SeabedMesh& seabed);

/// The bed with its defaults: x of the walls, and maximum size of a cell, m.
struct SeabedLayout {
  Real left, right, far_size;
};
SeabedLayout layout_of(const SeabedMesh& seabed);

/// Throws InputError where the lengths are inconsistent.
void check(const SeabedMesh& seabed);

/// The size of a cell, m, as a formula of x and y that Gmsh evaluates.
std::string size_formula(const SeabedMesh& seabed);

/// Ends a geometry for Gmsh, in the file at `path`: the size of a cell, the smallest of these formulas of x and y (m, each less than a thousand characters, which is as many as Gmsh takes), and settings for well
/// shaped triangles, the same at every run. Throws RunError where the file could not be written.
void end_geometry(std::ofstream& out, const std::vector<std::string>& sizes, const std::filesystem::path& path);

/// Estimated number of cells; in space their exact number (mesh/spatial_seabed.hpp). In the plane the integral of 1 / (area of an equilateral triangle of the local size), and a tenth, by which
/// those of Gmsh are smaller.
Real expected_cells(const SeabedMesh& seabed);
/// Meshes with more cells are refused.
constexpr Real max_seabed_cells = 2e7;

/// Writes the geometry for the gmsh program. Throws InputError where the lengths are inconsistent, RunError where it cannot
/// write.
void write_geo(const SeabedMesh& seabed, const std::filesystem::path& path);

}  // namespace berm::mesh
