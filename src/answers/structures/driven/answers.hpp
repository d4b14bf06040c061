// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "structures/base/answer.hpp"
#include "structures/driven/path.hpp"
#include "structures/driven/results.hpp"

#include <array>

// The answers of a driven body, a row each. A new one is a member of its results, its row here, and where it is found (results/quantities.cpp).

namespace berm::driven {

template <class Of>
using Answer = base::Answer<Of, Stage>;
using base::number;
using run_folder::QuantityKind;
using enum base::AnswerUnit;

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

/// Of a push, at multiples of D: NAME_0.35D.
inline constexpr std::array depth_answers = {
    Answer<PushPoint>{"V_at_w", force, "vertical reaction in the push at an embedment", number<PushPoint, &PushPoint::V>}};
inline constexpr std::array travel_answers = {Answer<TravelPoint>{
    "V_at_travel", force, "vertical reaction after a travel of a push in the bed", number<TravelPoint, &TravelPoint::V>}};

/// Of the way down.
inline constexpr std::array push_answers = {Answer<Results>{.name = "V_end_of_push",
                                                            .unit = force,
                                                            .meaning = "vertical reaction at the end of the push",
                                                            .number = number<Results, &Results::push_end, &PushPoint::V>,
                                                            .given = [](const Results& r) { return r.push_given.V; }},
                                            Answer<Results>{.name = "w_end_of_push",
                                                            .unit = length,
                                                            .meaning = "embedment at the end of the push",
                                                            .number = number<Results, &Results::push_end, &PushPoint::w>,
                                                            .given = [](const Results& r) { return r.push_given.w; },
                                                            .at_end = true},
                                            Answer<Results>{"V_noise", ratio, "noise of V in the push over the mean of |V|",
                                                            number<Results, &Results::V_noise>, QuantityKind::quality}};

/// A row at multiples of D in a drag; what the drag is given is the drag's.
struct PointAnswer {
  const char* name;
  base::AnswerUnit unit;
  const char* meaning;
  base::Access<DragPoint> number;
  bool (*given)(const DragResults&);
  QuantityKind kind = QuantityKind::answer;
};
inline constexpr std::array point_answers = {
    PointAnswer{"H_at_u", force, "horizontal resistance in the drag at a displacement", number<DragPoint, &DragPoint::H>,
                [](const DragResults& r) { return r.given.H; }},
    PointAnswer{"w_at_u", length, "embedment in the drag at a displacement", number<DragPoint, &DragPoint::w>,
                [](const DragResults& r) { return r.given.w_always; }},
    PointAnswer{"H_over_V_at_u",
                ratio,
                "H over V in the drag at a displacement",
                {[](const DragPoint&) { return true; }, [](const DragPoint& p) { return p.H / p.V; },
                 [](DragPoint& p, Real H_over_V) { p.V = p.H / H_over_V; }},
                [](const DragResults&) { return false; }}};

template <auto... Path>
constexpr base::Access<DragResults> of_drag = number<DragResults, Path...>;

inline constexpr std::array drag_answers = {
    Answer<DragResults>{.name = "H_noise",
                        .unit = ratio,
                        .meaning = "noise of H in the drag over the mean of |H|",
                        .number = of_drag<&DragResults::H_noise>,
                        .kind = QuantityKind::quality,
                        .known = resists},
    Answer<DragResults>{.name = "H_max",
                        .unit = force,
                        .meaning = "largest horizontal resistance of the drag",
                        .number = of_drag<&DragResults::largest, &DragPeak::H>,
                        .given = [](const DragResults& r) { return r.given.H; },
                        .known = resists},
    Answer<DragResults>{.name = "u_at_H_max",
                        .unit = length,
                        .meaning = "displacement at which it is",
                        .number = of_drag<&DragResults::largest, &DragPeak::u>,
                        .known = resists},
    Answer<DragResults>{.name = "H_breakout",
                        .unit = force,
                        .meaning = "horizontal resistance at breakout, its first peak",
                        .number = of_drag<&DragResults::breakout, &DragPeak::H>,
                        .known = by_velocity},
    Answer<DragResults>{.name = "u_at_breakout",
                        .unit = length,
                        .meaning = "displacement at breakout",
                        .number = of_drag<&DragResults::breakout, &DragPeak::u>,
                        .known = by_velocity},
    Answer<DragResults>{
        .name = "H_onset",
        .unit = force,
        .meaning = "horizontal resistance at which it begins to slide, where H has no peak: H over u = 0.1 to 0.5 D, extrapolated to u = 0",
        .number = of_drag<&DragResults::onset>,
        .known = by_velocity},
    Answer<DragResults>{.name = "H_end_of_drag",
                        .unit = force,
                        .meaning = "mean horizontal resistance over the end of the drag",
                        .number = of_drag<&DragResults::end, &DragPoint::H>,
                        .given = [](const DragResults& r) { return r.given.H; }},
    Answer<DragResults>{.name = "V_end_of_drag",
                        .unit = force,
                        .meaning = "mean vertical reaction over the end of the drag",
                        .number = of_drag<&DragResults::end, &DragPoint::V>,
                        .given = [](const DragResults& r) { return r.given.V_always; }},
    Answer<DragResults>{.name = "u_end_of_drag",
                        .unit = length,
                        .meaning = "travel of the drag",
                        .number = of_drag<&DragResults::end, &DragPoint::u>,
                        .given = [](const DragResults& r) { return r.given.u; },
                        .at_end = true},
    Answer<DragResults>{.name = "w_end_of_drag",
                        .unit = length,
                        .meaning = "embedment at the end of the drag",
                        .number = of_drag<&DragResults::end, &DragPoint::w>,
                        .given = [](const DragResults& r) { return r.given.w_always; },
                        .at_end = true},
    Answer<DragResults>{.name = "u_largest",
                        .unit = length,
                        .meaning = "largest displacement from the start of the stage, along x",
                        .number = of_drag<&DragResults::moved, &Displacements::u_largest>,
                        .known = by_force},
    Answer<DragResults>{.name = "u_end",
                        .unit = length,
                        .meaning = "residual displacement at the end of the stage, along x",
                        .number = of_drag<&DragResults::moved, &Displacements::u_end>,
                        .known = by_force,
                        .at_end = true},
    Answer<DragResults>{.name = "w_largest",
                        .unit = length,
                        .meaning = "largest embedment in the stage",
                        .number = of_drag<&DragResults::moved, &Displacements::w_largest>,
                        .known = by_force},
    Answer<DragResults>{.name = "w_end",
                        .unit = length,
                        .meaning = "embedment at the end of the stage",
                        .number = of_drag<&DragResults::moved, &Displacements::w_end>,
                        .known = by_force,
                        .at_end = true},
    Answer<DragResults>{.name = "u_largest_half_cycle",
                        .unit = length,
                        .meaning = "largest travel between two reversals of the body",
                        .number = of_drag<&DragResults::moved, &Displacements::largest_half_cycle>,
                        .known = by_force},
    Answer<DragResults>{.name = "half_cycles",
                        .unit = ratio,
                        .meaning = "number of half cycles: travels of at least 0.01 D between two reversals of the body",
                        .number = of_drag<&DragResults::moved, &Displacements::half_cycles>,
                        .kind = QuantityKind::quality,
                        .known = by_force},
    Answer<DragResults>{.name = "time_to_0.5D",
                        .unit = time,
                        .meaning = "time of the load history until the body is 0.5 D from its start",
                        .number = of_drag<&DragResults::moved, &Displacements::time_half_D>,
                        .known = by_force},
    Answer<DragResults>{.name = "time_to_1D",
                        .unit = time,
                        .meaning = "time of the load history until the body is 1 D from its start",
                        .number = of_drag<&DragResults::moved, &Displacements::time_D>,
                        .known = by_force},
    Answer<DragResults>{.name = "time_scale",
                        .unit = ratio,
                        .meaning = "time of the run over that of the load history",
                        .number = of_drag<&DragResults::moved, &Displacements::time_scale>,
                        .kind = QuantityKind::prescribed,
                        .known = [](const Stage& stage) { return stage.by_force && stage.varies; }},
    Answer<DragResults>{"berm_height", length, "height of the berm ahead at the end of the drag", of_drag<&DragResults::berm_height>},
    Answer<DragResults>{"berm_distance", length, "distance of the crest of that berm from the axis of the pipe",
                        of_drag<&DragResults::berm_distance>},
    Answer<DragResults>{
        "remoulded_depth", length,
        "depth below the invert to which clay has lost half of the strength that full remoulding takes, at the end of the drag",
        of_drag<&DragResults::remoulded_depth>},
    Answer<DragResults>{"remoulded_area_over_D2", ratio,
                        "area of the clay that has lost half of the strength that full remoulding takes, over D^2",
                        of_drag<&DragResults::remoulded_area>},
    Answer<DragResults>{.name = "H_residual",
                        .unit = force,
                        .meaning = "residual horizontal resistance: the plateau of H",
                        .number = of_drag<&DragResults::residual>,
                        .known = by_velocity},
    Answer<DragResults>{.name = "H_berm",
                        .unit = force,
                        .meaning = "horizontal resistance against the berm at the end of the drag",
                        .number = of_drag<&DragResults::berm>,
                        .known = by_velocity},
    Answer<DragResults>{.name = "V_in_drag",
                        .unit = force,
                        .meaning = "mean vertical reaction in the drag",
                        .number = of_drag<&DragResults::V>,
                        .given = [](const DragResults& r) { return r.given.V_always; }},
    Answer<DragResults>{.name = "over_penetration",
                        .unit = ratio,
                        .meaning = "largest V of the push over the mean V of the drag",
                        .number = of_drag<&DragResults::over_penetration>,
                        .known = resists},
    Answer<DragResults>{.name = "V_rms_error_in_drag",
                        .unit = ratio,
                        .meaning = "root mean square of V in the drag less the held force, over the held force",
                        .number = of_drag<&DragResults::V_rms_error>,
                        .kind = QuantityKind::quality,
                        .known = [](const Stage& stage) { return stage.holds_V; }},
};

inline constexpr std::array other_push_answers = {
    Answer<OtherPushResults>{.name = "V_end",
                             .unit = force,
                             .meaning = "vertical reaction in the last row of the stage",
                             .number = number<OtherPushResults, &OtherPushResults::V>,
                             .given = [](const OtherPushResults& push) { return push.given.V; }},
    Answer<OtherPushResults>{.name = "w_end",
                             .unit = length,
                             .meaning = "embedment at the end of the stage",
                             .number = number<OtherPushResults, &OtherPushResults::w>,
                             .given = [](const OtherPushResults& push) { return push.given.w; },
                             .at_end = true}};

inline constexpr std::array uplift_answers = {
    Answer<UpliftResults>{"R_max", force, "largest uplift resistance: the force of the soil against the lift",
                          number<UpliftResults, &UpliftResults::largest, &DragPeak::H>},
    Answer<UpliftResults>{"travel_at_R_max", length, "travel upwards at which it is",
                          number<UpliftResults, &UpliftResults::largest, &DragPeak::u>},
    Answer<UpliftResults>{"travel_at_half_R_max", length, "travel upwards at which half of it is mobilised",
                          number<UpliftResults, &UpliftResults::half_travel>},
    Answer<UpliftResults>{"w_begin", length, "embedment from which the body is lifted", number<UpliftResults, &UpliftResults::w_begin>},
    Answer<UpliftResults>{"R_end", force, "mean uplift resistance over the end of the lift",
                          number<UpliftResults, &UpliftResults::end, &DragPoint::H>},
    Answer<UpliftResults>{"travel_end", length, "travel upwards in the stage", number<UpliftResults, &UpliftResults::end, &DragPoint::u>}};

inline constexpr std::array state_answers = {Answer<StateResults>{.name = "V",
                                                                  .unit = force,
                                                                  .meaning = "vertical force in this state",
                                                                  .number = number<StateResults, &StateResults::V>,
                                                                  .given = [](const StateResults& state) { return state.V_given; }},
                                             Answer<StateResults>{.name = "w",
                                                                  .unit = length,
                                                                  .meaning = "embedment in this state",
                                                                  .number = number<StateResults, &StateResults::w>,
                                                                  .at_end = true}};

/// Of pushes and drags together.
inline constexpr std::array run_answers = {
    Answer<Results>{"second_impulse_over_V", ratio, "second contact correction in the push over V",
                    number<Results, &Results::second_impulse_over_V>, QuantityKind::quality},
    Answer<Results>{"overlap_max", length, "deepest overlap of soil and body", number<Results, &Results::overlap_max>,
                    QuantityKind::quality},
    Answer<Results>{"gap_mean", length, "mean gap between soil and body", number<Results, &Results::gap_mean>, QuantityKind::quality}};

}  // namespace berm::driven
