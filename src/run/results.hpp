// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "output/frames.hpp"
#include "output/run_folder.hpp"
#include "run/simulate.hpp"

namespace berm {

/// What a run found out about itself.
struct RunOutcome {
  bool finished;
  Real equilibrium;                ///< out-of-balance force over weight at the end of the geostatic stage; NaN without one
  Real energy_error;               ///< largest, over the largest work
  std::optional<Real> held_force;  ///< N/m, V that the first drag holds
};

/// Reads the history back and writes what follows from it: summary.json, curves, pictures; prints the key results and the time by loop.
template <int dim>
void write_results(const RunRequest& request, const RunFolder& folder, const Model<dim>& model, const State<dim>& state,
                   const FrameWriter<dim>& frames, const RunOutcome& outcome, const RunTiming& timing);

}  // namespace berm
