// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/structures/driven/quantities_test.cpp
#include "structures/driven/results.hpp"

#include "structures/driven/states.hpp"

#include <fmt/format.h>
#include <map>

namespace berm::driven {
namespace {

using run_folder::Quantity;
using Kind = run_folder::QuantityKind;

/// An answer, unless the input gives it.
Kind kind_of(bool given)
{
  return given ? Kind::prescribed : Kind::answer;
}

/// Takes results to quantities: every member that is there, each force and length with its dimensionless twin.
class Writer {
public:
  Writer(const BodyScale& scale, const std::map<std::string, std::string>& moving) : scale_(scale), moving_(moving) {}

  /// What follows is of this travel or state, and its names begin with that of a stage; "" = of the run.
  void of(const std::string& travel, const std::string& stage)
  {
    of_ = travel;
    prefix_ = stage.empty() ? "" : stage + ".";
  }
  bool force(const std::string& name, Real value, const char* meaning, Kind kind = Kind::answer)
  {
    const bool plane = scale_.dimension == 2;
    add(name, value, plane ? "N/m" : "N", meaning, kind);
    const Real unit = scale_.unit_weight * scale_.width * scale_.width;
    if (plane && unit > 0) add(name + "_over_gammaD2", value / unit, "1", meaning, Kind::ratio);
    return true;
  }
  bool length(const std::string& name, Real value, const char* meaning, Kind kind = Kind::answer)
  {
    add(name, value, "m", meaning, kind);
    add(name + "_over_D", value / scale_.width, "1", meaning, Kind::ratio);
    return true;
  }
  /// A length at the end of what it is of.
  bool end_length(const std::string& name, Real value, const char* meaning, Kind kind = Kind::answer)
  {
    const auto moving = moving_.find(of_);
    return length(name, value, (meaning + (moving == moving_.end() ? "" : "; " + moving->second)).c_str(), kind);
  }
  bool time(const std::string& name, Real value, const char* meaning)
  {
    add(name, value, "s", meaning, Kind::answer);
    return true;
  }
  bool ratio(const std::string& name, Real value, const char* meaning, Kind kind = Kind::answer)
  {
    add(name, value, "1", meaning, kind);
    return true;
  }
  template <class T, class Members>
  void optional(std::optional<T>& value, const Members& members)
  {
    if (value) members(*value);
  }
  template <class Point, class Parts, class Members>
  void each(std::vector<Point>& points, Real Point::*, const Parts&, const Members& members)
  {
    for (Point& point : points) members(point);
  }
  Real known(const char*) const { return 0; }

  std::vector<Quantity> list() && { return std::move(list_); }

private:
  void add(const std::string& name, Real value, const char* unit, const char* meaning, Kind kind)
  {
    list_.push_back({prefix_ + name, value, unit, meaning, kind, of_});
  }

  const BodyScale& scale_;
  const std::map<std::string, std::string>& moving_;
  std::string prefix_, of_;
  std::vector<Quantity> list_;
};

/// Takes quantities to results: every member whose name is among them.
class Reader {
public:
  Reader(const std::vector<Quantity>& quantities, Real diameter) : diameter_(diameter)
  {
    for (const Quantity& q : quantities) values_.emplace(q.name, q.value);
  }

  void of(const std::string&, const std::string& stage) { prefix_ = stage.empty() ? "" : stage + "."; }
  bool force(const std::string& name, Real& value, const char*, Kind = {}) { return take(name, value); }
  bool length(const std::string& name, Real& value, const char*, Kind = {}) { return take(name, value); }
  bool end_length(const std::string& name, Real& value, const char*, Kind = {}) { return take(name, value); }
  bool time(const std::string& name, Real& value, const char*) { return take(name, value); }
  bool ratio(const std::string& name, Real& value, const char*, Kind = {}) { return take(name, value); }
  template <class T, class Members>
  void optional(std::optional<T>& value, const Members& members)
  {
    T read{};
    if (members(read)) value = read;
  }
  template <class Point, class Parts, class Members>
  void each(std::vector<Point>& points, Real Point::*travel, const Parts& parts, const Members& members)
  {
    for (const Real part : parts()) {
      Point point{};
      point.*travel = part * diameter_;
      if (members(point)) points.push_back(point);
    }
  }
  Real known(const char* name) const
  {
    const auto found = values_.find(prefix_ + name);
    return found == values_.end() ? 0 : found->second;
  }

private:
  bool take(const std::string& name, Real& value)
  {
    const auto found = values_.find(prefix_ + name);
    if (found == values_.end()) return false;
    value = found->second;
    return true;
  }

  Real diameter_;
  std::string prefix_;
  std::map<std::string, Real> values_;
};

// The one description of the results: names and meanings, both ways.

template <class Visitor>
void describe_push(Visitor& v, Results& r, Real D)
{
  const auto spaced = [&] {
    std::vector<Real> parts;
    for (int k = 1; k * push_spacing <= v.known("w_end_of_push") / D + push_spacing; ++k) parts.push_back(k * push_spacing);
    return parts;
  };
  v.each(r.push, &PushPoint::w, spaced,
         [&](PushPoint& p) { return v.force(name_at("V_at_w", p.w / D), p.V, "vertical reaction in the push at an embedment"); });
  v.optional(r.push_end, [&](PushPoint& p) {
    return v.force("V_end_of_push", p.V, "vertical reaction at the end of the push", kind_of(r.push_given.V)) &&
           v.end_length("w_end_of_push", p.w, "embedment at the end of the push", kind_of(r.push_given.w));
  });
  v.optional(r.V_noise,
             [&](Real& value) { return v.ratio("V_noise", value, "noise of V in the push over the mean of |V|", Kind::quality); });
  v.each(
      r.travel, &TravelPoint::travel, [] { return std::vector<Real>(std::begin(travel_points), std::end(travel_points)); },
      [&](TravelPoint& p) {
        return v.force(name_at("V_at_travel", p.travel / D), p.V, "vertical reaction after a travel of a push in the bed");
      });
}

template <class Visitor>
void describe_drag(Visitor& v, DragResults& r, Real D)
{
  v.each(
      r.points, &DragPoint::u, [] { return std::vector<Real>(std::begin(drag_points), std::end(drag_points)); },
      [&](DragPoint& p) {
        Real ratio = p.H / p.V;
        const bool there =
            v.force(name_at("H_at_u", p.u / D), p.H, "horizontal resistance in the drag at a displacement", kind_of(r.given.H)) &&
            v.length(name_at("w_at_u", p.u / D), p.w, "embedment in the drag at a displacement", kind_of(r.given.w_always)) &&
            v.ratio(name_at("H_over_V_at_u", p.u / D), ratio, "H over V in the drag at a displacement");
        p.V = p.H / ratio;
        return there;
      });
  v.optional(r.H_noise,
             [&](Real& value) { return v.ratio("H_noise", value, "noise of H in the drag over the mean of |H|", Kind::quality); });
  v.optional(r.largest, [&](DragPeak& p) {
    return v.force("H_max", p.H, "largest horizontal resistance of the drag", kind_of(r.given.H)) &&
           v.length("u_at_H_max", p.u, "displacement at which it is");
  });
  v.optional(r.breakout, [&](DragPeak& p) {
    return v.force("H_breakout", p.H, "horizontal resistance at breakout, its first peak") &&
           v.length("u_at_breakout", p.u, "displacement at breakout");
  });
  v.optional(r.onset, [&](Real& value) {
    return v.force("H_onset", value,
                   "horizontal resistance at which it begins to slide, where H has no peak: H over u = 0.1 to 0.5 D, led back to u = 0");
  });
  v.optional(r.end, [&](DragPoint& p) {
    return v.force("H_end_of_drag", p.H, "mean horizontal resistance over the end of the drag", kind_of(r.given.H)) &&
           v.force("V_end_of_drag", p.V, "mean vertical reaction over the end of the drag", kind_of(r.given.V_always)) &&
           v.end_length("u_end_of_drag", p.u, "travel of the drag", kind_of(r.given.u)) &&
           v.end_length("w_end_of_drag", p.w, "embedment at the end of the drag", kind_of(r.given.w_always));
  });
  v.optional(r.moved, [&](Displacements& m) {
    const bool there = v.length("u_largest", m.u_largest, "largest displacement from where the stage began, along x") &&
                       v.end_length("u_end", m.u_end, "displacement that stays at the end of the stage, along x") &&
                       v.length("w_largest", m.w_largest, "largest embedment in the stage") &&
                       v.end_length("w_end", m.w_end, "embedment at the end of the stage") &&
                       v.length("u_largest_half_cycle", m.largest_half_cycle, "largest way between two turns of the body") &&
                       v.ratio("half_cycles", m.half_cycles, "ways between two turns of the body, of at least 0.01 D", Kind::quality);
    v.optional(m.time_half_D,
               [&](Real& t) { return v.time("time_to_0.5D", t, "time of the load history until the body is 0.5 D from where it began"); });
    v.optional(m.time_D,
               [&](Real& t) { return v.time("time_to_1D", t, "time of the load history until the body is 1 D from where it began"); });
    v.optional(m.time_scale, [&](Real& scale) {
      return v.ratio("time_scale", scale, "time of the run over that of the load history", Kind::prescribed);
    });
    return there;
  });
  v.optional(r.berm_height, [&](Real& value) { return v.length("berm_height", value, "height of the berm ahead at the end of the drag"); });
  v.optional(r.berm_distance,
             [&](Real& value) { return v.length("berm_distance", value, "distance of the top of that berm from the axis of the pipe"); });
  v.optional(r.remoulded_depth, [&](Real& value) {
    return v.length("remoulded_depth", value,
                    "depth below the invert to which clay has lost half of what remoulding takes, at the end of the drag");
  });
  v.optional(r.remoulded_area, [&](Real& value) {
    return v.ratio("remoulded_area_over_D2", value, "area of the clay that has lost half of what remoulding takes, over D^2");
  });
  v.optional(r.residual, [&](Real& value) { return v.force("H_residual", value, "residual horizontal resistance: the plateau of H"); });
  v.optional(r.berm,
             [&](Real& value) { return v.force("H_berm", value, "horizontal resistance against the berm at the end of the drag"); });
  v.optional(r.V,
             [&](Real& value) { return v.force("V_in_drag", value, "mean vertical reaction in the drag", kind_of(r.given.V_always)); });
  v.optional(r.over_penetration,
             [&](Real& value) { return v.ratio("over_penetration", value, "largest V of the push over the mean V of the drag"); });
  v.optional(r.V_rms_error, [&](Real& value) {
    return v.ratio("V_rms_error_in_drag", value, "root mean square of V in the drag less what is held, over that", Kind::quality);
  });
}

template <class Visitor>
void describe_uplift(Visitor& v, UpliftResults& r)
{
  v.force("R_max", r.largest.H, "largest uplift resistance: the force of the soil against the lift");
  v.length("travel_at_R_max", r.largest.u, "travel upwards at which it is");
  v.length("travel_at_half_R_max", r.half_travel, "travel upwards at which half of it is mobilised");
  v.length("w_begin", r.w_begin, "embedment from which the body is lifted");
  v.optional(r.end, [&](DragPoint& p) {
    return v.force("R_end", p.H, "mean uplift resistance over the end of the lift") &&
           v.length("travel_end", p.u, "travel upwards in the stage");
  });
}

template <class Visitor>
void describe_states(Visitor& v, std::vector<StateResults>& states)
{
  for (StateResults& state : states) {
    v.of(state.name, state.name);
    v.force("V", state.V, "vertical force in this state", kind_of(state.V_given));
    v.end_length("w", state.w, "embedment in this state");
  }
}

template <class Visitor>
void describe(Visitor& v, Results& r, Real D)
{
  v.of("push", "");
  describe_push(v, r, D);
  for (DragResults& drag : r.drags) {
    v.of(drag.stage, &drag == &r.drags.front() ? "" : drag.stage);
    describe_drag(v, drag, D);
  }
  for (OtherPushResults& push : r.other_pushes) {
    v.of(push.stage, push.stage);
    v.force("V_end", push.V, "vertical reaction in the last row of the stage", kind_of(push.given.V));
    v.end_length("w_end", push.w, "embedment at the end of the stage", kind_of(push.given.w));
  }
  for (UpliftResults& uplift : r.uplifts) {
    v.of(uplift.stage, uplift.stage);
    describe_uplift(v, uplift);
  }
  describe_states(v, r.states);
  v.of("", "");
  v.optional(r.second_impulse_over_V, [&](Real& value) {
    return v.ratio("second_impulse_over_V", value, "second contact correction in the push over V", Kind::quality);
  });
  v.optional(r.overlap_max, [&](Real& value) { return v.length("overlap_max", value, "deepest overlap of soil and body", Kind::quality); });
  v.optional(r.gap_mean, [&](Real& value) { return v.length("gap_mean", value, "mean gap between soil and body", Kind::quality); });
}

}  // namespace

std::string name_at(const char* what, Real part)
{
  return fmt::format("{}_{:g}D", what, part);
}

std::vector<Quantity> quantities_of(const Results& results, const BodyScale& scale, const std::map<std::string, std::string>& moving)
{
  Writer writer(scale, moving);
  Results copy = results;
  describe(writer, copy, scale.width);
  return std::move(writer).list();
}

Results results_of(const std::vector<Quantity>& quantities, const BodyScale& scale, const Stages& stages)
{
  Results results;
  if (!(scale.width > 0)) return results;
  const Real absent = nan;
  for (const Stage& stage : stages) {
    if (stage.kind == problem::StageKind::drag) results.drags.push_back({.stage = stage.name});
    if (stage.kind == problem::StageKind::push) results.other_pushes.push_back({stage.name, absent, absent});
    if (stage.upwards) results.uplifts.push_back({.stage = stage.name});
  }
  for (const char* name : state_names) results.states.push_back({name, absent, absent});
  results.main = driven::main_drag(stages).value_or(0);
  Reader reader(quantities, scale.width);
  describe(reader, results, scale.width);
  std::erase_if(results.drags, [](const DragResults& drag) { return !drag.largest && !drag.moved; });
  std::erase_if(results.uplifts, [](const UpliftResults& uplift) { return std::isnan(uplift.largest.H); });
  std::erase_if(results.states, [](const StateResults& state) { return std::isnan(state.w); });
  std::erase_if(results.other_pushes, [](const OtherPushResults& push) { return std::isnan(push.V); });
  return results;
}

namespace {

const DragResults& drag_or_none(const std::vector<DragResults>& drags, std::size_t number)
{
  static const DragResults none_yet{};
  return number < drags.size() ? drags[number] : none_yet;
}

}  // namespace

const DragResults& Results::drag() const
{
  return drag_or_none(drags, 0);
}

const DragResults& Results::main_drag() const
{
  return drag_or_none(drags, main);
}

std::string Results::prefix_of(const DragResults& drag) const
{
  return drags.empty() || drag.stage == drags.front().stage ? "" : drag.stage + ".";
}

}  // namespace berm::driven
