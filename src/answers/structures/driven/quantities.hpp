// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "record/run_record.hpp"
#include "run_folder/history.hpp"
#include "run_folder/summary.hpp"
#include "structures/driven/results.hpp"

namespace berm::driven {

/// What a run gives that pushes a pipe into the bed and drags it, as far as it came; by the names of quantities_of: of the push, the way down before the first drag, without what unloads:
///   V_at_w_{0.05,0.1,...}D, V_end_of_push, w_end_of_push;
///   V_at_travel_{0.0025,0.005,0.01,0.02,0.03}D of a push that begins with the pipe in the bed (0.02 D or deeper), with the travel from there;
///   V_noise, the standard deviation of V about its moving mean (as below) over the mean of |V|, from 0.02 D after where the push began in the soil.
/// Of each drag, u counted along it from where it began:
///   H, w and H_over_V _at_u_{0.1,...,1,1.5,2,3,4,5,6,8,10}D; H_max and u_at_H_max, of the drag to its very end;
///   H_breakout, u_at_breakout, or H_onset, H_residual and H_berm (results/resistance.hpp); H, V, u and w _end_of_drag;
///   V_in_drag, the mean of V once it is what it shall be, over_penetration, the largest V of the push over that, and where a force is held
///   V_rms_error_in_drag, the root mean square of (V - held)/held;
///   H_noise, as V_noise, from u = 0.1 D on. (berm_height and berm_distance are of the frames: take_berms.)
/// Noise is not told where rows are farther than 0.005 D apart, too few to tell a mean from noise, nor where the scale says that there is none.
/// Of a drag by force how far it moves the body (Displacements), and where the force varies no resistance: it is given.
/// Of a push that unloads, lifts, or follows a drag: V_end and w_end; of a lift that the soil resists also its uplift resistance. Of the run: second_impulse_over_V, the mean of second_impulse_N_m in the push over
/// that of V, and overlap_max and gap_mean (over pushes and drags), where the history has them.
/// Forces (N/m) come once more over gamma' D^2 (suffix _over_gammaD2), lengths (m) over D (_over_D). Forces and w are taken from the straight
/// line fitted over +-0.01 D of travel, +- a quarter of the travel for V_at_travel where that is less (TravelCurve::at), or between two rows where there is no
/// noise.
Results results_from(const run_folder::History& history, const BodyScale& scale, const Stages& stages);

/// V where the way down ends, N/m: the limit of force that ended it, else that of the line fitted there.
Real V_at_end(const PushPath& push, const run_folder::History& history, const Stages& stages, const BodyScale& scale);

/// Moments of the soil on the driven body in space about its centre, N m, averaged as V is: Mx_end_of_push, ... at the end of the way down, Mx_end_of_drag, ... at that of
/// the first drag. Components below a thousandth of V D (H D) are noise and left out; in the plane and around an axis there are none.
std::vector<run_folder::Quantity> moments_in_space(const record::RunRecord& run);

}  // namespace berm::driven
