// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/structures/driven/results/quantities_test.cpp
#include "structures/driven/results/results.hpp"

#include <fmt/format.h>
#include <map>

namespace berm::driven {
namespace {

using run_folder::Quantity;

/// Takes results to quantities: every member that is there, each force and length with its dimensionless twin.
class Writer {
public:
  explicit Writer(const BodyScale& scale) : scale_(scale) {}

  /// What follows is of a stage; "" = of the run.
  void of_stage(const std::string& stage) { prefix_ = stage.empty() ? "" : stage + "."; }
  bool force(const std::string& number, Real value, const char* meaning)
  {
    const std::string name = prefix_ + number;
    const bool plane = scale_.dimension == 2;
    list_.push_back({name, value, plane ? "N/m" : "N", meaning});
    const Real unit = scale_.unit_weight * scale_.width * scale_.width;
    if (plane && unit > 0) list_.push_back({name + "_over_gammaD2", value / unit, "1", meaning});
    return true;
  }
  bool length(const std::string& number, Real value, const char* meaning)
  {
    const std::string name = prefix_ + number;
    list_.push_back({name, value, "m", meaning});
    list_.push_back({name + "_over_D", value / scale_.width, "1", meaning});
    return true;
  }
  bool ratio(const std::string& name, Real value, const char* meaning)
  {
    list_.push_back({prefix_ + name, value, "1", meaning});
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
  const BodyScale& scale_;
  std::string prefix_;
  std::vector<Quantity> list_;
};

/// Takes quantities to results: every member whose name is among them.
class Reader {
public:
  Reader(const std::vector<Quantity>& quantities, Real diameter) : diameter_(diameter)
  {
    for (const Quantity& q : quantities) values_.emplace(q.name, q.value);
  }

  void of_stage(const std::string& stage) { prefix_ = stage.empty() ? "" : stage + "."; }
  bool force(const std::string& name, Real& value, const char*) { return take(name, value); }
  bool length(const std::string& name, Real& value, const char*) { return take(name, value); }
  bool ratio(const std::string& name, Real& value, const char*) { return take(name, value); }
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
    return v.force("V_end_of_push", p.V, "vertical reaction at the end of the push") &&
           v.length("w_end_of_push", p.w, "embedment at the end of the push");
  });
  v.optional(r.V_noise, [&](Real& value) { return v.ratio("V_noise", value, "noise of V in the push over its mean"); });
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
        const bool there = v.force(name_at("H_at_u", p.u / D), p.H, "horizontal resistance in the drag at a displacement") &&
                           v.length(name_at("w_at_u", p.u / D), p.w, "embedment in the drag at a displacement") &&
                           v.ratio(name_at("H_over_V_at_u", p.u / D), ratio, "H over V in the drag at a displacement");
        p.V = p.H / ratio;
        return there;
      });
  v.optional(r.H_noise, [&](Real& value) { return v.ratio("H_noise", value, "noise of H in the drag over its mean"); });
  v.optional(r.largest, [&](DragPeak& p) {
    return v.force("H_max", p.H, "largest horizontal resistance of the drag") && v.length("u_at_H_max", p.u, "displacement at which it is");
  });
  v.optional(r.breakout, [&](DragPeak& p) {
    return v.force("H_breakout", p.H, "horizontal resistance at breakout, its first peak") &&
           v.length("u_at_breakout", p.u, "displacement at breakout");
  });
  v.optional(r.end, [&](DragPoint& p) {
    return v.force("H_end_of_drag", p.H, "mean horizontal resistance over the end of the drag") &&
           v.force("V_end_of_drag", p.V, "mean vertical reaction over the end of the drag") &&
           v.length("u_end_of_drag", p.u, "travel of the drag") && v.length("w_end_of_drag", p.w, "embedment at the end of the drag");
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
  v.optional(r.residual,
             [&](Real& value) { return v.force("H_residual", value, "horizontal resistance that stays at the end of the drag"); });
  v.optional(r.V, [&](Real& value) { return v.force("V_in_drag", value, "mean vertical reaction in the drag"); });
  v.optional(r.over_penetration,
             [&](Real& value) { return v.ratio("over_penetration", value, "largest V of the push over the mean V of the drag"); });
  v.optional(r.V_rms_error, [&](Real& value) {
    return v.ratio("V_rms_error_in_drag", value, "root mean square of V in the drag less what is held, over that");
  });
}

template <class Visitor>
void describe(Visitor& v, Results& r, Real D)
{
  describe_push(v, r, D);
  for (std::size_t k = 0; k < r.drags.size(); ++k) {
    v.of_stage(k == 0 ? "" : r.drags[k].stage);
    describe_drag(v, r.drags[k], D);
  }
  for (OtherPushResults& push : r.other_pushes) {
    v.of_stage(push.stage);
    v.force("V_end", push.V, "vertical reaction at the end of the stage");
    v.length("w_end", push.w, "embedment at the end of the stage");
  }
  v.of_stage("");
  v.optional(r.second_impulse_over_V,
             [&](Real& value) { return v.ratio("second_impulse_over_V", value, "second contact correction in the push over V"); });
  v.optional(r.overlap_max, [&](Real& value) { return v.length("overlap_max", value, "deepest overlap of soil and body"); });
  v.optional(r.gap_mean, [&](Real& value) { return v.length("gap_mean", value, "mean gap between soil and body"); });
}

}  // namespace

std::string name_at(const char* what, Real part)
{
  return fmt::format("{}_{:g}D", what, part);
}

std::vector<Quantity> quantities_of(const Results& results, const BodyScale& scale)
{
  Writer writer(scale);
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
  }
  Reader reader(quantities, scale.width);
  describe(reader, results, scale.width);
  std::erase_if(results.drags, [](const DragResults& drag) { return !drag.largest; });
  std::erase_if(results.other_pushes, [](const OtherPushResults& push) { return std::isnan(push.V); });
  return results;
}

const DragResults& Results::drag() const
{
  static const DragResults none_yet{};
  return drags.empty() ? none_yet : drags.front();
}

}  // namespace berm::driven
