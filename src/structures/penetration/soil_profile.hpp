// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "record/run_record.hpp"
#include "structures/base/driven_body.hpp"

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
  std::optional<problem::BodySoil> soil_;
  bodies::BodySettings body_{};
  Real gravity_ = 0;
};

}  // namespace berm::penetration
