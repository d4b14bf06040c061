// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "formulas/formula.hpp"
#include "structures/lateral/lateral_run.hpp"

#include <functional>

namespace berm::lateral {

/// How a design code or a published method has the soil of a run hold its pile. Depths z below the seabed (m), displacements y (m) and tilt (rad) along the load; empty where it has none.
struct CodeMethod {
  std::string name, column;                               ///< column of tables: "api"
  std::string choices;                                    ///< that it makes beyond the soil of the case
  std::function<formulas::Formula(Real z, Real y)> p;     ///< N/m
  std::function<formulas::Formula(Real z, Real tilt)> m;  ///< N m/m
  std::function<formulas::Formula(Real y)> base_H;        ///< N
  std::function<formulas::Formula(Real tilt)> base_M;     ///< N m
};

/// Those that apply to the soil beside the pile of a run: in clay, or in sand.
std::vector<CodeMethod> code_methods(const LateralRun& run);

/// A rigid pile whose point of load is displaced.
struct RigidPile {
  Real H = nan;        ///< N
  Real pivot = nan;    ///< m below the seabed; NaN where it does not tilt
  bool valid = false;  ///< all formulas are in their ranges
};

/// By a method: the tilt at which the moment of the soil about the point of load, `height` above the seabed, vanishes. `u`: displacement of that point; infinite: the largest H.
RigidPile rigid_pile(const CodeMethod& method, Real length, Real height, Real u);

}  // namespace berm::lateral
