// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "structures/pipe/mechanism.hpp"
#include "structures/pipe/travel_curve.hpp"

#include <map>

namespace berm::report {

/// A run of a test with its curves and frames.
class TestRun {
public:
  explicit TestRun(const pipe::RunRecord& run)
      : record(run),
        D(run.scale.diameter),
        half_(averaging_half(run.scale)),
        path_(pipe_path(run.history, run.stages)),
        V_(path_.w, path_.V),
        H_(path_.drag_u, path_.drag_H),
        V_drag_(path_.drag_u, path_.drag_V),
        w_(path_.drag_u, path_.drag_w),
        frames_(run)
  {
  }

  const pipe::RunRecord& record;
  const Real D;

  /// N/m and m, freed from noise; NaN where the push or the drag does not come so far.
  Real V_of_push(Real w) const { return V_.at(w, half_); }
  Real H(Real u) const { return H_.at(u, half_); }
  Real V(Real u) const { return V_drag_.at(u, half_); }
  Real w(Real u) const { return w_.at(u, half_); }
  bool has_drag() const { return !H_.empty() && !w_.empty() && H_.end() > 0; }
  Real end_of_drag() const { return H_.end(); }
  /// The embedment with which the drag begins.
  Real w_begin() const { return path_.drag_w.front(); }

  /// Where in the push V first reaches a force, or in the drag w an embedment; empty where it does not.
  std::optional<Real> w_where_V_is(Real force) const { return first_travel(V_, force); }
  std::optional<Real> u_where_w_is(Real embedment) const { return first_travel(w_, embedment); }

  const pipe::PipeFrames& frames() const { return frames_; }
  /// Of a frame, against the first; of a frame, against the one before it. Both are kept. Throw RunError where a frame is damaged.
  const pipe::Heave& heave(std::size_t frame) const
  {
    const auto known = heaves_.find(frame);
    if (known != heaves_.end()) return known->second;
    return heaves_[frame] = heave_of(frames_.soil(0), frames_.soil(frame), record.settings.surface, frames_.place(frame), D);
  }
  const pipe::Mechanism& mechanism(std::size_t frame) const
  {
    const auto known = mechanisms_.find(frame);
    if (known != mechanisms_.end()) return known->second;
    return mechanisms_[frame] = mechanism_of(frames_.soil(frame - 1), frames_.soil(frame), record.settings.surface,
                                             frames_.place(frame - 1), frames_.place(frame), D);
  }

private:
  std::optional<Real> first_travel(const pipe::TravelCurve& curve, Real value) const
  {
    const pipe::TravelCurve smooth = curve.smoothed(half_);
    for (std::size_t k = 0; k < smooth.travel().size(); ++k)
      if (smooth.value()[k] >= value) return smooth.travel()[k];
    return std::nullopt;
  }

  Real half_;
  pipe::PipePath path_;
  pipe::TravelCurve V_, H_, V_drag_, w_;
  pipe::PipeFrames frames_;
  mutable std::map<std::size_t, pipe::Heave> heaves_;
  mutable std::map<std::size_t, pipe::Mechanism> mechanisms_;
};

using TestRuns = std::vector<TestRun>;

}  // namespace berm::report
