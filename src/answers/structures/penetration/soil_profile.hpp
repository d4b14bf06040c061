// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "record/run_record.hpp"
#include "structures/base/driven_body.hpp"
#include "structures/base/kind.hpp"

namespace berm::penetration {

/// The soil at a depth before the body came.
struct SoilAt {
  Real strength;         ///< s_u, Pa, of soil without friction; NaN: it has some, or no strength of this form
  Real friction_angle;   ///< rad; NaN as above
  Real overburden;       ///< sigma_v0, Pa, compression positive
  Real anisotropy;       ///< Delta = (sigma_v0 - sigma_h0)/(2 s_u); NaN without s_u or k0
  Real rigidity_index;   ///< I_r = G/s_u; NaN without s_u
  Real unit_weight;      ///< N/m3
  Real interface_ratio;  ///< alpha: shear strength of the interface over s_u, 0 to 1; NaN: not known, as with friction
};

/// The soil that the main rigid body of a run touches, by depth.
class SoilProfile {
public:
  explicit SoilProfile(const record::RunRecord& run);

  /// `depth` (m) counts as embedment does.
  SoilAt at(Real depth) const;
  /// Growth of s_u with depth, Pa/m, over a length below a depth.
  Real growth(Real depth, Real length) const { return (at(depth + length).strength - at(depth).strength) / length; }
  /// Whether its strength varies.
  bool varies() const;

private:
  const record::RunRecord& run_;
  std::optional<settings::BodySoil> soil_;
  bodies::BodySettings body_{};
  Real gravity_ = 0;
};

/// The ends of the soil along x and below, m; infinite where they are not known.
struct Walls {
  Real left = -infinity, right = infinity, base = -infinity;
};

/// Of a mesh that berm makes. Of one of Gmsh only a wall through the middle of the body, a plane of symmetry, on one side of which the first frame has no soil.
Walls walls_of(const record::RunRecord& run, const base::BodyProfile& body);

/// In space, the part of a body around an axis at x and z (m) whose force the history has: 1, or 0.5 or 0.25 where walls of the soil go through that axis. Planes
/// that the case names as of symmetry take nothing: there the history has the force of the whole.
Real part_in_space(const record::RunRecord& run, const base::BodyProfile& body, Real z);

}  // namespace berm::penetration
