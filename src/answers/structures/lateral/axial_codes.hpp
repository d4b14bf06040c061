// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "formulas/formula.hpp"
#include "structures/lateral/lateral_run.hpp"

namespace berm::lateral {

/// The axial resistance of a run's pile by API RP 2GEO: the run itself has none unless a stage pushes it along its axis.
struct AxialCode {
  struct Slice {
    Real z;               ///< m below the seabed, of its middle
    Real thickness;       ///< m
    formulas::Formula t;  ///< N/m, the largest friction per metre of depth, of the outer face
  };
  std::vector<Slice> shaft;
  formulas::Formula base{nan, {}, false};  ///< N, the largest of a closed base
  bool closed = true;                      ///< of an open one there is no Q
  bool clay = true;
  Real diameter = nan;  ///< m

  /// N, over all slices.
  Real shaft_force() const;
  /// Parts that a displacement (m) mobilises.
  Real friction_share(Real displacement) const;
  Real base_share(Real displacement) const;
};

/// Empty where the soil beside it is neither clay nor sand with friction on the pile.
std::optional<AxialCode> axial_code(const LateralRun& run);

/// t by depth and Q as a table of the page; "" where there is none.
std::string axial_table(const LateralRun& run, const std::string& id);

}  // namespace berm::lateral
