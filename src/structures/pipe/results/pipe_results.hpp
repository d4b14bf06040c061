// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "run_folder/summary.hpp"
#include "structures/base/driven_body.hpp"

#include <optional>

namespace berm::pipe {

using base::BodyScale;

/// A point of a push.
struct PushPoint {
  Real w, V;  ///< m, N/m
};

/// V after a travel of a push that begins with the pipe in the bed.
struct TravelPoint {
  Real travel, V;  ///< m, N/m
};

/// A point of a drag; u counts from where it began.
struct DragPoint {
  Real u, w, H, V;  ///< m, m, N/m, N/m
};

/// The largest H of a drag, over the curve averaged to its very end.
struct DragPeak {
  Real u, H;  ///< m, N/m
};

/// Where results are taken, over D: V in the push at each multiple; after a travel of a push that begins with the pipe in the bed; in the drag.
constexpr Real push_spacing = 0.05;
constexpr Real travel_points[] = {0.0025, 0.005, 0.01, 0.02, 0.03};
constexpr Real drag_points[] = {0.1, 0.2, 0.3, 0.4, 0.5, 0.75, 1.0};

/// What of a pipe's run is worth a number of its own. A number that is not known is left out.
struct PipeResults {
  std::vector<PushPoint> push;        ///< at each 0.05 D
  std::optional<PushPoint> push_end;  ///< or where the run was stopped in it
  std::vector<TravelPoint> travel;
  std::vector<DragPoint> drag;                                                       ///< at some parts of D
  std::optional<DragPeak> drag_peak;                                                 ///< there is one of any drag that has begun
  std::optional<Real> V_noise, H_noise, V_rms_error_in_drag, second_impulse_over_V;  ///< bare numbers
  std::optional<Real> overlap_max, gap_mean;                                         ///< m
};

/// The results as summary.json tells them, each force and length with its dimensionless twin: forces over gamma' D^2 (suffix _over_gammaD2, in plane strain),
/// lengths over D (_over_D).
std::vector<run_folder::Quantity> quantities_of(const PipeResults& results, const BodyScale& scale);

/// The results that such quantities tell; what is not among them is left out.
PipeResults results_of(const std::vector<run_folder::Quantity>& quantities, const BodyScale& scale);

}  // namespace berm::pipe
