// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "picture/convex.hpp"
#include "problem/ground.hpp"

namespace berm::picture {

/// A rectangle of the plane, m.
struct Extent {
  Vec<2> lower, upper;

  Vec<2> size() const { return upper - lower; }
};

/// Its corners, from the lower left one.
Points corners_of(const Extent& extent);
/// The smallest that holds both.
Extent around(const Extent& a, const Extent& b);

using bodies::CornersOutline, bodies::DiskOutline, bodies::Outline, bodies::PlaneOutline;

/// The smallest extent that holds an outline; of a half-plane its point.
Extent extent_of(const Outline& outline);
/// The part of a half-plane inside an extent, corner by corner; none where it misses it.
Points part_inside(const PlaneOutline& plane, const Extent& extent);

struct NamedOutline {
  std::string name;
  Outline outline;
};

/// A straight part of the way of a driven rigid body.
struct PathStep {
  int stage;        ///< its place among the stages
  int rigid;        ///< its place among the rigid bodies
  Vec<2> from, to;  ///< of the body's centre
  bool known;       ///< how far it goes; else `to` only shows the direction
};

/// A body that starts with a velocity.
struct Flight {
  std::string name;
  Vec<2> at, velocity;  ///< its middle, m; m/s
};

/// Where a stage places or takes out soil.
struct EarthworkSketch {
  std::string body, material;  ///< material "": it takes soil out
  std::string words;
  Outline outline;
};

/// What a case looks like at its start in the plane x-y, and where its rigid bodies are driven: all that can be told without its mesh.
struct Sketch {
  Extent domain;         ///< of the mesh; around the bodies where its outline is not known
  Points outline, fine;  ///< of the mesh and of its zone of fine cells, from the lower left corner; none where not known
  std::vector<NamedOutline> bodies, rigid_bodies;
  std::vector<EarthworkSketch> earthworks;
  std::optional<Real> surface;  ///< level of the bed's surface
  problem::Ground ground;       ///< instead, where that is not level
  std::vector<PathStep> path;
  std::vector<Flight> flights;
  Vec<2> gravity = Vec<2>::Zero();  ///< m/s2
  std::vector<std::string> notes;   ///< what cannot be drawn, in words
};

/// `ground`: that of the run, where more is known of it than the case says.
Sketch sketch_of(const settings::Case& settings, const problem::Ground& ground);
inline Sketch sketch_of(const settings::Case& settings)
{
  return sketch_of(settings, problem::ground_of(settings));
}

}  // namespace berm::picture
