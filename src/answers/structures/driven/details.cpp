// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/report/expectations/claims_section_test.cpp
#include "structures/driven/details.hpp"

#include "formulas/f114.hpp"
#include "os/error.hpp"
#include "record/travel_curve.hpp"
#include "structures/driven/mechanism.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <map>
#include <memory>

namespace berm::driven {
namespace {

using record::TravelCurve;
using settings::StageKind;
using Frame = std::optional<std::size_t>;

/// A run with its curves, those of its first drag, and its frames.
class MeasuredRun {
public:
  explicit MeasuredRun(const record::RunRecord& record)
      : run(record),
        D(run.scale.width),
        weight(run.scale.unit_weight * D * D),
        half_(averaging_half(run.scale)),
        path_(path_of(run.history, run.stages)),
        V_(path_.push.w, path_.push.V),
        H_(path_.drag().travel, path_.drag().H),
        V_drag_(path_.drag().travel, path_.drag().V),
        w_(path_.drag().travel, path_.drag().w),
        frames_(run)
  {
  }

  const DrivenRun run;
  const Real D, weight;  ///< m; gamma' D^2, N/m

  /// Over a travel in m, freed from noise; NaN where the drag does not come so far.
  Real H(Real u) const { return at(H_, u); }
  Real V(Real u) const { return at(V_drag_, u); }
  Real w(Real u) const { return at(w_, u); }
  Real end_of_drag() const { return !H_.empty() && H_.end() > 0 ? H_.end() : nan; }
  Real w_at_begin() const { return w_.empty() ? nan : path_.drag().w.front(); }
  /// Where V of the push first reaches a force, and w of the drag an embedment, m; NaN where it does not.
  Real w_at_V(Real force) const { return first_travel(V_, force); }
  Real u_at_w(Real embedment) const { return first_travel(w_, embedment); }

  /// The frame that ends the push, where a drag follows.
  Frame end_of_push() const { return end_of_drag() > 0 ? frames_.last(StageKind::push) : Frame(); }
  Frame last_of_drag() const { return frames_.last(StageKind::drag); }
  Frame nearest_of_drag(Real BodyPlace::*quantity, Real value) const { return frames_.nearest(StageKind::drag, quantity, value); }
  const BodyPlace& place(std::size_t frame) const { return frames_.place(frame); }
  /// Of a frame against the first, and against the one before it. Both are kept. Throw RunError where a frame is damaged.
  const Heave& heave(std::size_t frame) const
  {
    const auto known = heaves_.find(frame);
    if (known != heaves_.end()) return known->second;
    return heaves_[frame] = heave_of(frames_.soil(0), frames_.soil(frame), run.record.bed_surface(), place(frame), D);
  }
  const Mechanism& mechanism(std::size_t frame) const
  {
    const auto known = mechanisms_.find(frame);
    if (known != mechanisms_.end()) return known->second;
    return mechanisms_[frame] =
               mechanism_of(frames_.soil(frame - 1), frames_.soil(frame), run.record.bed_surface(), place(frame - 1), place(frame), D);
  }

private:
  Real at(const TravelCurve& curve, Real s) const { return std::isnan(s) ? nan : curve.at(s, half_); }
  Real first_travel(const TravelCurve& curve, Real value) const
  {
    const TravelCurve smooth = curve.smoothed(half_);
    for (std::size_t k = 0; k < smooth.travel().size(); ++k)
      if (smooth.value()[k] >= value) return smooth.travel()[k];
    return nan;
  }

  Real half_;
  Path path_;
  TravelCurve V_, H_, V_drag_, w_;
  BodyFrames frames_;
  mutable std::map<std::size_t, Heave> heaves_;
  mutable std::map<std::size_t, Mechanism> mechanisms_;
};

/// Of the end of the push; rises are over D.
Real risen(const MeasuredRun& r, Real Heave::*side)
{
  const Frame frame = r.end_of_push();
  return frame ? r.heave(*frame).*side / r.D : nan;
}

/// The rise that the displaced soil would make, spread evenly over 1.5 D to both sides of the axis.
Real spread_rise(const MeasuredRun& r)
{
  const Frame frame = r.end_of_push();
  return frame ? formulas::f114_penetrated_area(r.D, r.place(*frame).w) / (3 * r.D * r.D) : nan;
}

/// In the frame nearest to u; where that is the last one, there is no berm to compare with that at the end.
Real berm_at(const MeasuredRun& r, Real u)
{
  const Frame frame = r.nearest_of_drag(&BodyPlace::u, u * r.D);
  return frame && frame != r.last_of_drag() ? r.heave(*frame).berm / (r.D * r.D) : nan;
}

Real berm_at_end(const MeasuredRun& r)
{
  const Frame frame = r.last_of_drag();
  return frame ? r.heave(*frame).berm / (r.D * r.D) : nan;
}

/// The frame of the drag nearest to a depth that the drag comes to, or (NaN) its last; empty also for the first frame of all, before which there is none.
Frame frame_of_drag(const MeasuredRun& r, Real w)
{
  const Frame frame = std::isnan(w)                   ? r.last_of_drag()
                      : std::isnan(r.u_at_w(w * r.D)) ? Frame()
                                                      : r.nearest_of_drag(&BodyPlace::w, w * r.D);
  return frame == 0 ? Frame() : frame;
}

template <class Take>
Real of_mechanism(const MeasuredRun& r, Real w, const Take& take)
{
  const Frame frame = frame_of_drag(r, w);
  return frame ? take(r.mechanism(*frame)) : nan;
}

Real w_of_frame(const MeasuredRun& r, Real w)
{
  const Frame frame = frame_of_drag(r, w);
  return frame ? r.place(*frame).w / r.D : nan;
}

enum class Place { none, may_have, must_have };

struct Detail {
  const char *name, *unit;
  Place place;
  Real (*take)(const MeasuredRun& r, Real at);
};

const Detail details[] = {
    {"w_at_V", "1", Place::must_have, [](const MeasuredRun& r, Real V) { return r.w_at_V(V) / r.D; }},
    {"H_at_w", "N/m", Place::must_have, [](const MeasuredRun& r, Real w) { return r.H(r.u_at_w(w * r.D)); }},
    {"H_at_w_over_gammaD2", "1", Place::must_have, [](const MeasuredRun& r, Real w) { return r.H(r.u_at_w(w * r.D)) / r.weight; }},
    {"V_in_drag_at_w_over_gammaD2", "1", Place::must_have, [](const MeasuredRun& r, Real w) { return r.V(r.u_at_w(w * r.D)) / r.weight; }},
    {"u_at_w", "1", Place::must_have, [](const MeasuredRun& r, Real w) { return r.u_at_w(w * r.D) / r.D; }},
    {"H_at_part", "N/m", Place::must_have, [](const MeasuredRun& r, Real part) { return r.H(part * r.end_of_drag()); }},
    {"V_at_u_over_gammaD2", "1", Place::must_have, [](const MeasuredRun& r, Real u) { return r.V(u * r.D) / r.weight; }},
    {"sinking_at_u", "1", Place::must_have, [](const MeasuredRun& r, Real u) { return (r.w(u * r.D) - r.w_at_begin()) / r.D; }},
    {"sinking_after_u", "1", Place::must_have, [](const MeasuredRun& r, Real u) { return (r.w(r.end_of_drag()) - r.w(u * r.D)) / r.D; }},
    {"heave_behind", "1", Place::none, [](const MeasuredRun& r, Real) { return risen(r, &Heave::behind); }},
    {"heave_ahead", "1", Place::none, [](const MeasuredRun& r, Real) { return risen(r, &Heave::ahead); }},
    {"spread_heave", "1", Place::none, [](const MeasuredRun& r, Real) { return spread_rise(r); }},
    {"heave_over_spread", "1", Place::none,
     [](const MeasuredRun& r, Real) { return std::min(risen(r, &Heave::behind), risen(r, &Heave::ahead)) / spread_rise(r); }},
    {"berm_at_u", "1", Place::must_have, [](const MeasuredRun& r, Real u) { return berm_at(r, u); }},
    {"berm_at_end", "1", Place::none, [](const MeasuredRun& r, Real) { return berm_at_end(r); }},
    {"sheared_behind", "1", Place::may_have,
     [](const MeasuredRun& r, Real w) { return of_mechanism(r, w, [](const Mechanism& m) { return m.behind; }); }},
    {"shearing_reach", "1", Place::may_have,
     [](const MeasuredRun& r, Real w) { return of_mechanism(r, w, [&](const Mechanism& m) { return m.reach / r.D; }); }},
    {"dragged", "1", Place::may_have,
     [](const MeasuredRun& r, Real w) {
       return of_mechanism(r, w, [](const Mechanism& m) { return std::isnan(m.dragged) ? 0 : m.dragged; });
     }},
    {"w_of_frame", "1", Place::may_have, w_of_frame}};

}  // namespace

std::vector<std::string> detail_names()
{
  std::vector<std::string> all;
  for (const Detail& detail : details) all.emplace_back(detail.name);
  return all;
}

base::RunDetails details_of(const record::RunRecord& record)
{
  const auto run = std::make_shared<const MeasuredRun>(record);
  return {detail_names(), [run](const std::string& name, std::optional<Real> at) -> std::optional<run_folder::Quantity> {
            const Detail* const found =
                std::find_if(std::begin(details), std::end(details), [&](const Detail& d) { return name == d.name; });
            if (found == std::end(details)) return {};
            if (at.has_value() ? found->place == Place::none : found->place == Place::must_have)
              throw InputError(fmt::format("{} {}", name, at ? "is not taken at a position: leave out at" : "needs at, its position"));
            return run_folder::Quantity{name, found->take(*run, at.value_or(nan)), found->unit};
          }};
}

}  // namespace berm::driven
