// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "run_folder/history.hpp"
#include "structures/pipe/results/pipe_results.hpp"

namespace berm::pipe {

/// The stages of a pipe's run by what they do, in the order in which they ran. A name stands for one kind only.
struct PipeStages {
  std::vector<std::string> push, drag;
  std::optional<Real> held_force;  ///< N/m, V that the drag is to hold; without it the mean of V over the drag
};

/// The pushes and the drags of a history, as columns.
struct PipePath {
  std::vector<Real> w, V;                            ///< of the push, by row: m, N/m
  std::vector<Real> drag_u, drag_w, drag_H, drag_V;  ///< of the drag; u counts from where it began (always positive): m, m, N/m, N/m
  std::vector<Index> push_rows, drag_rows;           ///< of the history
  Real u_begin = 0;                                  ///< m, u where the drag began
};

/// Takes push and drag out of a history. The row before the first of the drag is where the drag begins, and is its first.
PipePath pipe_path(const run_folder::History& history, const PipeStages& stages);

/// What a run gives that pushes a pipe into the bed and drags it, as far as it came.
PipeResults pipe_results(const run_folder::History& history, const BodyScale& scale, const PipeStages& stages);

/// The same as quantities (quantities_of):
///   V_at_w_{0.05,0.1,...}D, V_end_of_push, w_end_of_push;
///   V_at_travel_{0.0025,0.005,0.01,0.02,0.03}D of a push that begins with the pipe in the bed (0.02 D or deeper), with the travel from there;
///   H, w and H_over_V _at_u_{0.1,0.2,0.3,0.4,0.5,0.75,1.0}D, with u from the begin of the drag;
///   H_max and u_at_H_max, of the drag to its very end;
///   V_rms_error_in_drag, the root mean square of (V - held)/held over the rows of the drag;
///   V_noise and H_noise, the standard deviation of the force about its moving mean (as below) over the mean of the force: of V in the push from
///   w = 0.02 D on, of H in the drag from u = 0.1 D on; not where rows are farther than 0.005 D apart, too few to tell a mean from noise, and not where the scale says that there is none;
///   second_impulse_over_V, the mean of second_impulse_N_m in the push over that of V, and overlap_max and gap_mean (over push and drag), where the
///   history has them.
/// Forces (N/m) come once more over gamma' D^2 (suffix _over_gammaD2), lengths (m) over D (_over_D). Forces and w are taken from the straight
/// line fitted over +-0.01 D of travel, +- a quarter of the travel for V_at_travel where that is less (TravelCurve::at), or between two rows where there is no
/// noise.
std::vector<run_folder::Quantity> pipe_quantities(const run_folder::History& history, const BodyScale& scale, const PipeStages& stages);

/// The same as a table for people: model, dimensionless, and prototype (force per metre and length times the gravity level) where the model has
/// one.
std::string key_results_table(const std::vector<run_folder::Quantity>& quantities, const BodyScale& scale);

}  // namespace berm::pipe
