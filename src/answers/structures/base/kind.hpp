// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "settings/case.hpp"

namespace berm::base {

/// The part of a rigid body that meets the soil first, from its outline in the plane x-y, whose axis is the middle of the body.
struct BodyProfile {
  Real width = 0;            ///< D, m, where it is widest
  Real height = 0;           ///< m
  Real shoulder = 0;         ///< m above its lowest point: the lowest level at which it has its full width; 0 of a flat base, D/2 of a disk
  Real left = 0, right = 0;  ///< m, its ends along x at the start
  bool conical = false;      ///< straight from a point on its axis to the shoulder, with an apex angle of 120 degrees at most
  bool disk = false;
  Real bore = 0;        ///< m, radius that a ring, a skirt or an open pile leaves free about its axis; 0: it is closed
  Real lid = infinity;  ///< m above its lowest point: where something closes that; infinite without it

  Real wall() const { return width / 2 - bore; }  ///< m, thickness, where it leaves a bore

  /// Between its two sides, rad.
  Real apex_angle() const { return 2 * std::atan2(width / 2, shoulder); }
};

/// Of a shape with corners or a disk; empty for a half-plane. Of a ring both halves.
std::optional<BodyProfile> body_profile(const bodies::RigidShapeSettings& shape);

/// Whether a stage pushes the main rigid body of a case down.
bool is_pushed_down(const settings::Case& c);

/// Whether a stage moves a body along the bed: a drag, or a drive along an axis that is not up. Of cases in space.
bool goes_sideways(const settings::Case& c, const settings::StageSettings& stage);

/// Whether the main rigid body of a case in space, a pile, a skirt or one that the input does not name, is round from above, stands deeper than D/2 in the bed,
/// and a stage moves it along the bed.
bool is_loaded_sideways(const settings::Case& c);

/// The word of the structure that the main rigid body of a case is: what the input names, else
///   other     no push or drag moves it, and it is not loaded sideways (is_loaded_sideways), or it has no width;
///   cone      around an axis (in space a profile), pushed down: conical;
///   ball      a circle on the axis, or a sphere, pushed down;
///   skirt     around an axis (in space a profile), pushed down or loaded sideways: open below, the opening deeper than the wall is thick by 2 or more;
///   pile      around an axis (in space a profile, or a cylinder that stands), pushed down: none of these, and higher than 2 D; loaded sideways: no skirt;
///   footing   pushed down: all others but disks;
///   t_bar     a circle in plane strain that a push drives down and whose top is deeper than D below the surface at the start;
///   pipe      all others.
/// Never automatic. An anchor and a T-bar that begins at the surface look like other bodies: they are named.
std::string kind_of(const settings::Case& c);

}  // namespace berm::base
