// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "structures/base/answer.hpp"
#include "structures/driven/path.hpp"
#include "structures/driven/results.hpp"

// The answers of a driven body, a row each. A new one is a member of its results, its row here, and where it is found (quantities.cpp).

namespace berm::driven {

template <class Of>
using Answer = base::Answer<Of, Stage>;
using base::number;
using enum base::AnswerUnit;
using run_folder::QuantityKind::answer, run_folder::QuantityKind::quality, run_folder::QuantityKind::prescribed;

/// A drag without a load history: the soil resists it.
inline bool resists(const Stage& stage)
{
  return !stage.varies;
}
/// A drag whose velocity is given: its resistance is the answer.
inline bool by_velocity(const Stage& stage)
{
  return !stage.varies && !stage.by_force;
}
inline bool by_force(const Stage& stage)
{
  return stage.by_force;
}

/// What a drag is given all along, or H where it ends.
inline bool given_H(const DragResults& drag)
{
  return drag.given.H;
}
inline bool given_V(const DragResults& drag)
{
  return drag.given.V_always;
}
inline bool given_w(const DragResults& drag)
{
  return drag.given.w_always;
}

/// Of a push, at multiples of D: NAME_0.35D.
inline constexpr Answer<PushPoint> depth_answers[] = {
    {"V_at_w", force, "vertical reaction in the push at an embedment", number<PushPoint, &PushPoint::V>},
};
inline constexpr Answer<TravelPoint> travel_answers[] = {
    {"V_at_travel", force, "vertical reaction after a travel of a push in the bed", number<TravelPoint, &TravelPoint::V>},
};

/// Of the way down.
inline constexpr Answer<Results> push_answers[] = {
    {"V_end_of_push", force, "vertical reaction at the end of the push", number<Results, &Results::push_end, &PushPoint::V>, answer,
     [](const Results& r) { return r.push_given.V; }},
    {"w_end_of_push", length, "embedment at the end of the push", number<Results, &Results::push_end, &PushPoint::w>, answer,
     [](const Results& r) { return r.push_given.w; }, nullptr, true},
    {"V_noise", ratio, "noise of V in the push divided by the mean of |V|", number<Results, &Results::V_noise>, quality},
};

/// At multiples of D in a drag; what the drag is given is the drag's.
inline constexpr base::Answer<DragPoint, Stage, DragResults> point_answers[] = {
    {"H_at_u", force, "horizontal resistance in the drag at a displacement", number<DragPoint, &DragPoint::H>, answer, given_H},
    {"w_at_u", length, "embedment in the drag at a displacement", number<DragPoint, &DragPoint::w>, answer, given_w},
    {"H_over_V_at_u",
     ratio,
     "H over V in the drag at a displacement",
     {[](const DragPoint&) { return true; }, [](const DragPoint& p) { return p.H / p.V; },
      [](DragPoint& p, Real over_V) { p.V = p.H / over_V; }}},
};

template <auto... Path>
constexpr base::Access<DragResults> of_drag = number<DragResults, Path...>;

inline constexpr Answer<DragResults> drag_answers[] = {
    {"H_noise", ratio, "noise of H in the drag divided by the mean of |H|", of_drag<&DragResults::H_noise>, quality, nullptr, resists},
    {"H_max", force, "largest horizontal resistance of the drag", of_drag<&DragResults::largest, &DragPeak::H>, answer, given_H, resists},
    {"u_at_H_max", length, "displacement at which it is", of_drag<&DragResults::largest, &DragPeak::u>, answer, nullptr, resists},
    {"H_breakout", force, "horizontal resistance at breakout, its first peak", of_drag<&DragResults::breakout, &DragPeak::H>, answer,
     nullptr, by_velocity},
    {"u_at_breakout", length, "displacement at breakout", of_drag<&DragResults::breakout, &DragPeak::u>, answer, nullptr, by_velocity},
    {"H_onset", force,
     "horizontal resistance at which it begins to slide, where H has no peak: H over u = 0.1 to 0.5 D, extrapolated to u = 0",
     of_drag<&DragResults::onset>, answer, nullptr, by_velocity},
    {"H_end_of_drag", force, "mean horizontal resistance over the end of the drag", of_drag<&DragResults::end, &DragPoint::H>, answer,
     given_H},
    {"V_end_of_drag", force, "mean vertical reaction over the end of the drag", of_drag<&DragResults::end, &DragPoint::V>, answer, given_V},
    {"u_end_of_drag", length, "travel of the drag", of_drag<&DragResults::end, &DragPoint::u>, answer,
     [](const DragResults& r) { return r.given.u; }, nullptr, true},
    {"w_end_of_drag", length, "embedment at the end of the drag", of_drag<&DragResults::end, &DragPoint::w>, answer, given_w, nullptr,
     true},
    Answer<DragResults>{"u_largest", length, "largest displacement from the start of the stage, along x",
                        of_drag<&DragResults::moved, &Displacements::u_largest>, answer, nullptr, by_force}
        .headed({"largest u"}),
    Answer<DragResults>{"u_end", length, "residual displacement at the end of the stage, along x",
                        of_drag<&DragResults::moved, &Displacements::u_end>, answer, nullptr, by_force, true}
        .headed({"u at the end"}),
    Answer<DragResults>{"w_largest", length, "largest embedment in the stage", of_drag<&DragResults::moved, &Displacements::w_largest>,
                        answer, nullptr, by_force}
        .headed({"largest w"}),
    {"w_end", length, "embedment at the end of the stage", of_drag<&DragResults::moved, &Displacements::w_end>, answer, nullptr, by_force,
     true},
    Answer<DragResults>{"u_largest_half_cycle", length, "largest travel between two reversals of the body",
                        of_drag<&DragResults::moved, &Displacements::largest_half_cycle>, answer, nullptr, by_force}
        .headed({"largest half cycle"}),
    Answer<DragResults>{"half_cycles", ratio, "number of half cycles: travels of at least 0.01 D between two reversals of the body",
                        of_drag<&DragResults::moved, &Displacements::half_cycles>, quality, nullptr, by_force}
        .headed({.words = "half cycles", .whole = true}),
    Answer<DragResults>{"time_to_0.5D", time, "time of the load history until the body is 0.5 D from its start",
                        of_drag<&DragResults::moved, &Displacements::time_half_D>, answer, nullptr, by_force}
        .headed({.words = "u = 0.5 D after, s of the record", .missing = "never"}),
    Answer<DragResults>{"time_to_1D", time, "time of the load history until the body is 1 D from its start",
                        of_drag<&DragResults::moved, &Displacements::time_D>, answer, nullptr, by_force}
        .headed({.words = "u = 1 D after, s of the record", .missing = "never"}),
    {"time_scale", ratio, "time of the run divided by that of the load history", of_drag<&DragResults::moved, &Displacements::time_scale>,
     prescribed, nullptr, [](const Stage& stage) { return stage.by_force && stage.varies; }},
    {"berm_height", length, "height of the berm ahead at the end of the drag", of_drag<&DragResults::berm_height>},
    {"berm_distance", length, "distance of the crest of that berm from the axis of the pipe", of_drag<&DragResults::berm_distance>},
    {"remoulded_depth", length,
     "depth below the invert to which clay has lost half of the strength that full remoulding takes, at the end of the drag",
     of_drag<&DragResults::remoulded_depth>},
    {"remoulded_area_over_D2", ratio, "area of the clay that has lost half of the strength that full remoulding takes, over D^2",
     of_drag<&DragResults::remoulded_area>},
    {"H_residual", force, "residual horizontal resistance: the plateau of H", of_drag<&DragResults::residual>, answer, nullptr,
     by_velocity},
    {"H_berm", force, "horizontal resistance against the berm at the end of the drag", of_drag<&DragResults::berm>, answer, nullptr,
     by_velocity},
    {"V_in_drag", force, "mean vertical reaction in the drag", of_drag<&DragResults::V>, answer, given_V},
    {"over_penetration", ratio, "largest V of the push divided by the mean V of the drag", of_drag<&DragResults::over_penetration>, answer,
     nullptr, resists},
    {"V_rms_error_in_drag", ratio, "root mean square of V in the drag less the held force, over the held force",
     of_drag<&DragResults::V_rms_error>, quality, nullptr, [](const Stage& stage) { return stage.holds_V; }},
};

inline constexpr Answer<OtherPushResults> other_push_answers[] = {
    {"V_end", force, "vertical reaction in the last row of the stage", number<OtherPushResults, &OtherPushResults::V>, answer,
     [](const OtherPushResults& push) { return push.given.V; }},
    {"w_end", length, "embedment at the end of the stage", number<OtherPushResults, &OtherPushResults::w>, answer,
     [](const OtherPushResults& push) { return push.given.w; }, nullptr, true},
};

template <auto... Path>
constexpr base::Access<UpliftResults> of_uplift = number<UpliftResults, Path...>;

inline constexpr Answer<UpliftResults> uplift_answers[] = {
    Answer<UpliftResults>{"R_max", force, "largest uplift resistance: the force of the soil against the lift",
                          of_uplift<&UpliftResults::largest, &DragPeak::H>}
        .headed({"R<sub>max</sub>"}),
    Answer<UpliftResults>{"travel_at_R_max", length, "travel upwards at which it is", of_uplift<&UpliftResults::largest, &DragPeak::u>}
        .headed({"after"}),
    Answer<UpliftResults>{"travel_at_half_R_max", length, "travel upwards at which half of it is mobilised",
                          of_uplift<&UpliftResults::half_travel>}
        .headed({"half of it at"}),
    Answer<UpliftResults>{"w_begin", length, "embedment from which the body is lifted", of_uplift<&UpliftResults::w_begin>}.headed(
        {"w at the start"}),
    Answer<UpliftResults>{"R_end", force, "mean uplift resistance over the end of the lift", of_uplift<&UpliftResults::end, &DragPoint::H>}
        .headed({"R at the end"}),
    {"travel_end", length, "travel upwards in the stage", of_uplift<&UpliftResults::end, &DragPoint::u>},
};

inline constexpr Answer<StateResults> state_answers[] = {
    {"V", force, "vertical force in this state", number<StateResults, &StateResults::V>, answer,
     [](const StateResults& state) { return state.V_given; }},
    {"w", length, "embedment in this state", number<StateResults, &StateResults::w>, answer, nullptr, nullptr, true},
};

/// Of pushes and drags together.
inline constexpr Answer<Results> run_answers[] = {
    {"second_impulse_over_V", ratio, "second contact correction in the push over V", number<Results, &Results::second_impulse_over_V>,
     quality},
    {"overlap_max", length, "deepest overlap of soil and body", number<Results, &Results::overlap_max>, quality},
    {"gap_mean", length, "mean gap between soil and body", number<Results, &Results::gap_mean>, quality},
};

}  // namespace berm::driven
