// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "formulas/pipe_in_clay.hpp"
#include "formulas/pipe_in_sand.hpp"
#include "record/run_record.hpp"
#include "settings/body_soil.hpp"
#include "settings/case.hpp"
#include "structures/base/little_cohesion.hpp"

#include <variant>

namespace berm::pipe {

/// Sand around a pipe, without cohesion or with a little of it, which formulas leave out.
struct SandAround {
  static constexpr Real max_cohesion = 0.1;  ///< of gamma' D

  Real diameter, unit_weight;                            ///< m, N/m3
  Real friction_angle, dilation_angle, interface_angle;  ///< rad
  Real cohesion = 0;                                     ///< Pa

  /// Whether formulas without cohesion hold.
  bool has_little_cohesion() const { return base::has_little_cohesion(cohesion, friction_angle, unit_weight, diameter); }

  formulas::PipeInSand at(Real embedment) const { return {diameter, embedment, unit_weight, friction_angle, interface_angle}; }
};

/// Clay without friction around a pipe.
struct ClayAround {
  Real diameter, unit_weight;  ///< m, N/m3, 0 = weightless
  settings::BodySoil soil;
  Real adhesion;             ///< Pa, infinite where the pipe sticks, NaN where the interface has friction
  Real above = 0;            ///< m, depth in the soil from which embedment counts: in a trench that of the trench
  Real adhesion_factor = 0;  ///< adhesion over s_u wherever the pipe is, instead of `adhesion`
  bool suction = false;      ///< the interface carries tension: the clay behind the pipe pulls

  /// With the strength at the invert. Its growth is that of the law, or where layers or a profile differ that over a diameter below the invert.
  formulas::PipeInClay at(Real embedment) const;
};

/// Why no formula applies, in words.
struct NoFormula {
  std::string why;
};

using PipeSoil = std::variant<SandAround, ClayAround, NoFormula>;

/// The soil that touches the pipe of a run as published formulas want it. Where the contact sticks, delta of sand is phi and clay has all of s_u.
PipeSoil pipe_soil(const record::RunRecord& run);

}  // namespace berm::pipe
