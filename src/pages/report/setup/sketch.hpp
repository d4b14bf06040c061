// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "problem/ground.hpp"

namespace berm::report {

/// A rectangle of the plane, m.
struct Extent {
  Vec<2> lower, upper;

  Vec<2> size() const { return upper - lower; }
};

/// The smallest that holds both.
Extent around(const Extent& a, const Extent& b);

using bodies::CornersOutline, bodies::DiskOutline, bodies::Outline, bodies::PlaneOutline;

/// The smallest extent that holds an outline; of a half-plane its point.
Extent extent_of(const Outline& outline);
/// The part of a half-plane inside an extent, corner by corner; none where it misses it.
std::vector<Vec<2>> part_inside(const PlaneOutline& plane, const Extent& extent);

struct NamedOutline {
  std::string name;
  Outline outline;
};

/// A part of the bed that is filled with soil, without a part inside it.
struct FilledPart {
  Extent part;
  std::optional<Extent> hole;
};

/// A boundary that is held, from end to end.
struct HeldEdge {
  Vec<2> from, to, outward;
  bool wholly;        ///< in all directions of the plane
  std::string words;  ///< "x, y fixed"
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

/// What a case looks like at its start in the plane x-y, and where its rigid bodies are driven: all that can be told without its mesh.
struct Sketch {
  Extent domain;               ///< of the mesh; around the bodies where its outline is not known
  bool domain_known = false;   ///< whether the outline of the mesh is known
  std::optional<Extent> fine;  ///< zone of fine cells
  std::vector<FilledPart> filled;
  std::string filled_by;  ///< name of the body that fills the bed
  std::vector<NamedOutline> bodies, rigid_bodies;
  std::optional<Real> surface;              ///< level of the bed's surface
  problem::Ground ground;                   ///< instead, where that is not level
  std::vector<std::vector<Vec<2>>> uneven;  ///< of such a bed that berm makes: outlines of its soil, of all of the mesh, of the fine zone
  std::vector<HeldEdge> held;
  std::vector<PathStep> path;
  std::vector<Flight> flights;
  Vec<2> gravity = Vec<2>::Zero();  ///< m/s2
  std::vector<std::string> notes;   ///< what cannot be drawn, in words
};

/// `ground`: that of the run, where more is known of it than the case says.
Sketch sketch_of(const problem::Case& settings, const problem::Ground& ground);
inline Sketch sketch_of(const problem::Case& settings)
{
  return sketch_of(settings, problem::ground_of(settings));
}

}  // namespace berm::report
