// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "fem/newton.hpp"
#include "fem/space_assembly.hpp"

namespace berm::fem {

/// Newton's iteration in space, as Newton does it, with rigid bodies tied to their nodes: their six movements are unknowns beside those of the free nodes.
class SpaceNewton {
public:
  explicit SpaceNewton(const SpaceModel& model);

  /// Looks for the change of displacement that brings equilibrium; `change` is the guess at first. The state stays as it is; assembly() holds what was found.
  IncrementEnd find_equilibrium(const SpaceState& begin, const ElementLoads<3>& loads, Real viscosity, std::vector<Real>& change);

  /// Bytes that the iteration takes beside what it has had since it was made.
  Real memory_to_come() const { return solver_.memory(); }

  SpaceAssembly& assembly() { return assembly_; }
  const SpaceAssembly& assembly() const { return assembly_; }

private:
  bool set_step(const ElementLoads<3>& loads, const std::vector<Real>& change);
  Real slope() const;

  const SpaceModel& model_;
  SpaceAssembly assembly_;
  DirectSolver solver_;
  std::vector<Real> entries_, step_;
};

}  // namespace berm::fem
