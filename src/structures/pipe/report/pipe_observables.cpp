// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/report/claims/claims_test.cpp
#include "structures/pipe/report/pipe_observables.hpp"

#include "record/travel_curve.hpp"
#include "structures/formulas/f114_vertical.hpp"
#include "structures/pipe/results/mechanism.hpp"

#include <algorithm>
#include <map>

namespace berm::pipe {
namespace {

using base::ObservableUnit;
using record::TravelCurve;

using Frame = std::optional<std::size_t>;

/// Lengths are in D, areas in D2, forces in N/m; u is counted from the begin of the drag.
const base::Observables kinds = {{"V_at_w", ObservableUnit::force, ObservableUnit::length, true},
                                 {"w_at_V", ObservableUnit::length, ObservableUnit::force, true},
                                 {"w_of_push", ObservableUnit::length, ObservableUnit::none, false},
                                 {"H_at_u", ObservableUnit::force, ObservableUnit::length, true},
                                 {"V_at_u", ObservableUnit::force, ObservableUnit::length, true},
                                 {"w_at_u", ObservableUnit::length, ObservableUnit::length, true},
                                 {"H_at_w", ObservableUnit::force, ObservableUnit::length, true},
                                 {"V_in_drag_at_w", ObservableUnit::force, ObservableUnit::length, true},
                                 {"u_at_w", ObservableUnit::length, ObservableUnit::length, true},
                                 {"H_at_part", ObservableUnit::force, ObservableUnit::number, true},
                                 {"V_at_part", ObservableUnit::force, ObservableUnit::number, true},
                                 {"u_at_part", ObservableUnit::length, ObservableUnit::number, true},
                                 {"prototype_H_at_part", ObservableUnit::force, ObservableUnit::number, true},
                                 {"w_at_begin", ObservableUnit::length, ObservableUnit::none, false},
                                 {"sinking_at_u", ObservableUnit::length, ObservableUnit::length, true},
                                 {"sinking_after_u", ObservableUnit::length, ObservableUnit::length, true},
                                 {"heave_behind", ObservableUnit::length, ObservableUnit::none, false},
                                 {"heave_ahead", ObservableUnit::length, ObservableUnit::none, false},
                                 {"spread_heave", ObservableUnit::length, ObservableUnit::none, false},
                                 {"heave_over_spread", ObservableUnit::number, ObservableUnit::none, false},
                                 {"berm_at_u", ObservableUnit::area, ObservableUnit::length, true},
                                 {"berm_at_end", ObservableUnit::area, ObservableUnit::none, false},
                                 {"sheared_behind", ObservableUnit::number, ObservableUnit::length, false},
                                 {"shearing_reach", ObservableUnit::length, ObservableUnit::length, false},
                                 {"dragged", ObservableUnit::number, ObservableUnit::length, false},
                                 {"w_of_frame", ObservableUnit::length, ObservableUnit::length, false}};

/// In the order of `kinds`.
enum class Word {
  V_at_w,     ///< of the push
  w_at_V,     ///< where V of the push first reaches a force
  w_of_push,  ///< in the last frame of the push
  H_at_u,     ///< of the drag
  V_at_u,
  w_at_u,
  H_at_w,  ///< of the drag, where w first reaches a depth
  V_in_drag_at_w,
  u_at_w,
  H_at_part,  ///< at a part of the drag: 1 is its end
  V_at_part,
  u_at_part,
  prototype_H_at_part,  ///< in the prototype
  w_at_begin,           ///< where the drag begins
  sinking_at_u,         ///< w less that at the begin of the drag
  sinking_after_u,      ///< w at the end of the drag less that at u
  heave_behind,         ///< rise of the surface beside the pipe at the end of the push
  heave_ahead,
  spread_heave,       ///< rise that the displaced soil would make, spread evenly over 1.5 D to both sides of the axis
  heave_over_spread,  ///< the smaller of the two over that
  berm_at_u,          ///< area of the soil above the surface ahead, in the frame nearest to u
  berm_at_end,
  sheared_behind,  ///< part of the shearing behind the pipe's centre, between two frames of the drag: where w is nearest to a depth, else the last
  shearing_reach,  ///< distance ahead within which nine tenths of the rest lie
  dragged,         ///< part of the heaped soil that moves along
  w_of_frame       ///< embedment in that frame
};

/// A run of a test with its curves, those of its first drag, and frames.
class MeasuredRun {
public:
  explicit MeasuredRun(const record::RunRecord& record)
      : run(record),
        D(run.scale.width),
        half_(averaging_half(run.scale)),
        path_(pipe_path(run.history, run.stages)),
        V_(path_.push.w, path_.push.V),
        H_(path_.drag().travel, path_.drag().H),
        V_drag_(path_.drag().travel, path_.drag().V),
        w_(path_.drag().travel, path_.drag().w),
        frames_(run)
  {
  }

  const PipeRun run;
  const Real D;

  /// N/m and m, freed from noise; NaN where the push or the drag does not come so far.
  Real V_of_push(Real w) const { return V_.at(w, half_); }
  Real H(Real u) const { return H_.at(u, half_); }
  Real V(Real u) const { return V_drag_.at(u, half_); }
  Real w(Real u) const { return w_.at(u, half_); }
  bool has_drag() const { return !H_.empty() && !w_.empty() && H_.end() > 0; }
  Real end_of_drag() const { return H_.end(); }
  /// The embedment with which the drag begins.
  Real w_begin() const { return path_.drag().w.front(); }

  /// Where in the push V first reaches a force, or in the drag w an embedment; empty where it does not.
  std::optional<Real> w_where_V_is(Real force) const { return first_travel(V_, force); }
  std::optional<Real> u_where_w_is(Real embedment) const { return first_travel(w_, embedment); }

  const PipeFrames& frames() const { return frames_; }
  /// Of a frame, against the first; of a frame, against the one before it. Both are kept. Throw RunError where a frame is damaged.
  const Heave& heave(std::size_t frame) const
  {
    const auto known = heaves_.find(frame);
    if (known != heaves_.end()) return known->second;
    return heaves_[frame] = heave_of(frames_.soil(0), frames_.soil(frame), run.record.bed_surface(), frames_.place(frame), D);
  }
  const Mechanism& mechanism(std::size_t frame) const
  {
    const auto known = mechanisms_.find(frame);
    if (known != mechanisms_.end()) return known->second;
    return mechanisms_[frame] = mechanism_of(frames_.soil(frame - 1), frames_.soil(frame), run.record.bed_surface(),
                                             frames_.place(frame - 1), frames_.place(frame), D);
  }

private:
  std::optional<Real> first_travel(const TravelCurve& curve, Real value) const
  {
    const TravelCurve smooth = curve.smoothed(half_);
    for (std::size_t k = 0; k < smooth.travel().size(); ++k)
      if (smooth.value()[k] >= value) return smooth.travel()[k];
    return std::nullopt;
  }

  Real half_;
  PipePath path_;
  TravelCurve V_, H_, V_drag_, w_;
  PipeFrames frames_;
  mutable std::map<std::size_t, Heave> heaves_;
  mutable std::map<std::size_t, Mechanism> mechanisms_;
};

/// The frame of the drag nearest to a depth that the drag comes to, or its last; empty also for the first frame of all, before which there is none.
Frame frame_of_drag(const MeasuredRun& run, std::optional<Real> w)
{
  Frame frame;
  if (!w)
    frame = run.frames().last(problem::StageKind::drag);
  else if (run.has_drag() && run.u_where_w_is(*w * run.D))
    frame = run.frames().nearest(problem::StageKind::drag, &PipePlace::w, *w * run.D);
  return frame == 0 ? Frame{} : frame;
}

Real of_mechanism(Word word, std::optional<Real> at, const MeasuredRun& run)
{
  const Frame frame = frame_of_drag(run, at);
  if (!frame) return nan;
  if (word == Word::w_of_frame) return run.frames().place(*frame).w / run.D;
  const Mechanism& m = run.mechanism(*frame);
  return word == Word::sheared_behind ? m.behind : word == Word::dragged ? m.dragged : m.reach / run.D;
}

Real of_heave(Word word, const MeasuredRun& run)
{
  const Frame frame = run.frames().last(problem::StageKind::push);
  if (!frame) return nan;
  const Real w = run.frames().place(*frame).w, spread = formulas::f114_penetrated_area(run.D, w) / (3 * run.D);
  switch (word) {
  case Word::w_of_push:
    return w / run.D;
  case Word::spread_heave:
    return spread / run.D;
  case Word::heave_behind:
    return run.heave(*frame).behind / run.D;
  case Word::heave_ahead:
    return run.heave(*frame).ahead / run.D;
  default:
    return std::min(run.heave(*frame).behind, run.heave(*frame).ahead) / spread;
  }
}

/// Where the frame nearest to u is the last one there is no berm to compare with that at the end.
Real of_berm(std::optional<Real> u, const MeasuredRun& run)
{
  const Frame last = run.frames().last(problem::StageKind::drag);
  const Frame frame = u ? run.frames().nearest(problem::StageKind::drag, &PipePlace::u, *u * run.D) : last;
  if (!frame || (u && frame == last)) return nan;
  return run.heave(*frame).berm / (run.D * run.D);
}

Real of_drag(Word word, Real at, const MeasuredRun& run)
{
  const Real u = at * run.D, end = run.end_of_drag(), part = at * end;
  const auto where_w_is = [&](const auto& number) {
    const std::optional<Real> place = run.u_where_w_is(at * run.D);
    return place ? number(*place) : nan;
  };
  switch (word) {
  case Word::H_at_u:
    return run.H(u);
  case Word::V_at_u:
    return run.V(u);
  case Word::w_at_u:
    return run.w(u) / run.D;
  case Word::H_at_w:
    return where_w_is([&](Real s) { return run.H(s); });
  case Word::V_in_drag_at_w:
    return where_w_is([&](Real s) { return run.V(s); });
  case Word::u_at_w:
    return where_w_is([&](Real s) { return s / run.D; });
  case Word::H_at_part:
    return run.H(part);
  case Word::V_at_part:
    return run.V(part);
  case Word::u_at_part:
    return part / run.D;
  case Word::prototype_H_at_part:
    return run.H(part) * run.run.scale.gravity_level;
  case Word::w_at_begin:
    return run.w_begin() / run.D;
  case Word::sinking_at_u:
    return (run.w(u) - run.w_begin()) / run.D;
  default:
    return (run.w(end) - run.w(u)) / run.D;
  }
}

Real evaluate(Word word, std::optional<Real> at, const MeasuredRun& run)
{
  switch (word) {
  case Word::V_at_w:
    return run.V_of_push(*at * run.D);
  case Word::w_at_V: {
    const std::optional<Real> w = run.w_where_V_is(*at);
    return w ? *w / run.D : nan;
  }
  case Word::w_of_push:
  case Word::heave_behind:
  case Word::heave_ahead:
  case Word::spread_heave:
  case Word::heave_over_spread:
    return of_heave(word, run);
  case Word::berm_at_u:
  case Word::berm_at_end:
    return of_berm(at, run);
  case Word::sheared_behind:
  case Word::shearing_reach:
  case Word::dragged:
  case Word::w_of_frame:
    return of_mechanism(word, at, run);
  default:
    return run.has_drag() ? of_drag(word, at.value_or(0), run) : nan;
  }
}

/// The run of a pipe as claims look at it.
class ObservedPipe : public base::ObservedRun {
public:
  explicit ObservedPipe(const record::RunRecord& run) : run_(run) {}

  Real value(const std::string& word, std::optional<Real> at) const override
  {
    const auto found = std::find_if(kinds.begin(), kinds.end(), [&](const base::Observable& kind) { return word == kind.word; });
    return found == kinds.end() ? nan : evaluate(static_cast<Word>(found - kinds.begin()), at, run_);
  }
  std::optional<Real> begin_of_drag() const override { return run_.has_drag() ? std::optional(run_.w_begin() / run_.D) : std::nullopt; }
  bool drag_reaches(Real displacement) const override { return run_.has_drag() && run_.end_of_drag() >= displacement * run_.D; }

private:
  MeasuredRun run_;
};

}  // namespace

const base::Observables& pipe_observables()
{
  return kinds;
}

std::unique_ptr<base::ObservedRun> observed_pipe(const record::RunRecord& run)
{
  return std::make_unique<ObservedPipe>(run);
}

}  // namespace berm::pipe
