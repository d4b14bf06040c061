// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "record/run_record.hpp"
#include "record/travel_curve.hpp"
#include "structures/base/driven_body.hpp"
#include "structures/base/kind.hpp"

namespace berm::lateral {

/// A body that stands in the seabed and is loaded along it, by row of the stages that do so; the first row is that before them. Forces and moments are those that
/// load it, in balance with the soil: inertia and, of a leaning body, its own weight are left out.
struct LateralPath {
  std::vector<Index> rows;   ///< of the history; empty where nothing loads it sideways
  std::vector<Real> u;       ///< m, along the load, of the point of its axis that was at the seabed
  std::vector<Real> tilt;    ///< rad, its top along the load
  std::vector<Real> H, M;    ///< N along the load; N m about its axis at the seabed, with the sign of H above the seabed
  std::vector<Real> height;  ///< m above the seabed, where the line of the load cuts its axis
  Real length = nan;         ///< m, in the seabed when the load begins
  /// m above the seabed at the start: where the case has the load act on a body that may turn; NaN: it names no such point.
  Real point_height = nan;
  Real direction = 0;  ///< +1 or -1: of the load along the axis in which u and H of the history count; 0: it goes across

  bool empty() const { return rows.empty(); }
};

LateralPath lateral_path(const record::RunRecord& run);

/// How it stands at the end, and the largest H: freed from noise over a twentieth of the way, 0.01 D at most.
struct LateralResults {
  Real H = nan, M = nan, u = nan, tilt = nan;  ///< at the end, as of the path
  Real height = nan;                           ///< m, of the load: that of the case, else that at the end
  Real u_load = nan;                           ///< m, there
  Real pivot = nan;                            ///< m below the seabed, the point of the axis that stayed
  Real max_H = nan, u_at_max = nan;            ///< N, m
};

/// A run as one of a body that is loaded sideways. The record must outlive it.
class LateralRun {
public:
  explicit LateralRun(const record::RunRecord& run, std::size_t number_on_page = 0);

  const record::RunRecord& record;
  std::size_t number;  ///< on the page, which gives its colour
  LateralPath path;
  Real width = nan;     ///< D, m
  Real strength = nan;  ///< Pa, s_u of soil without friction, the mean over its length in the seabed; NaN: of other soil

  bool empty() const { return path.empty(); }
  const LateralResults& results() const { return results_; }
  /// H over the largest u so far, and the same freed from noise; N.
  const record::TravelCurve& H_curve() const { return H_; }
  /// Undrained strength at a depth below the seabed, Pa; NaN of soil with friction.
  Real strength_at(Real depth) const;
  /// H (N) and tilt (rad) at a displacement u at the seabed (m); NaN beyond the way.
  Real H_at(Real u) const { return H_.empty() ? nan : H_.at(u, half_); }
  Real tilt_at(Real u) const { return H_.empty() ? nan : record::TravelCurve(path.u, path.tilt).at(u, half_); }
  /// H over s_u D L.
  Real over_strength(Real H) const { return H / (strength * width * path.length); }
  Real half() const { return half_; }

private:
  void take_results();

  record::TravelCurve H_;
  Real half_ = 0;
  LateralResults results_;
};

using LateralRuns = std::vector<LateralRun>;

}  // namespace berm::lateral
