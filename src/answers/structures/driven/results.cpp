// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/structures/driven/quantities_test.cpp
#include "structures/driven/results.hpp"

#include "structures/driven/answers.hpp"
#include "structures/driven/states.hpp"

#include <fmt/format.h>

namespace berm::driven {
namespace {

using run_folder::Quantity;
using Values = std::map<std::string, Real>;

/// What stands at a multiple of D: the place where the name says it.
template <class Point, class Rows, class Parts>
void take_points(std::vector<Point>& points, Real Point::*travel, const Rows& rows, const Parts& parts, const Values& values,
                 const std::string& prefix, Real D)
{
  for (const Real part : parts) {
    Point point{};
    point.*travel = part * D;
    bool there = true;
    for (const auto& row : rows) {
      const auto found = values.find(prefix + name_at(row.name, part));
      there = there && found != values.end();
      if (there) row.number.store(point, found->second);
    }
    if (there) points.push_back(point);
  }
}

/// The depths, over D, at which a push that ended there has V.
std::vector<Real> depths_to(Real end_over_D)
{
  std::vector<Real> parts;
  for (int k = 1; k * push_spacing <= end_over_D + push_spacing; ++k) parts.push_back(k * push_spacing);
  return parts;
}

/// "STAGE.": what the names of its numbers begin with.
std::string begin_of(const std::string& stage)
{
  return stage + ".";
}

}  // namespace

std::string name_at(const char* what, Real part)
{
  return what + base::AnswerList::ending_at(part);
}

std::vector<Quantity> quantities_of(const Results& results, const BodyScale& scale, const std::map<std::string, std::string>& moving)
{
  const Real D = scale.width;
  base::AnswerList list(scale.dimension);
  list.twins(scale.unit_weight * D * D, D);
  list.moving(moving);
  list.of("push", "");
  for (const PushPoint& point : results.push) list.at(point.w / D), list.add(depth_answers, point);
  list.at({});
  list.add(push_answers, results);
  for (const TravelPoint& point : results.travel) list.at(point.travel / D), list.add(travel_answers, point);
  list.at({});
  for (const DragResults& drag : results.drags) {
    list.of(drag.stage, results.prefix_of(drag));
    for (const DragPoint& point : drag.points) list.at(point.u / D), list.add(point_answers, point, drag);
    list.at({});
    list.add(drag_answers, drag);
  }
  for (const OtherPushResults& push : results.other_pushes) {
    list.of(push.stage, begin_of(push.stage));
    list.add(other_push_answers, push);
  }
  for (const UpliftResults& uplift : results.uplifts) {
    list.of(uplift.stage, begin_of(uplift.stage));
    list.add(uplift_answers, uplift);
  }
  for (const StateResults& state : results.states) {
    list.of(state.name, begin_of(state.name));
    list.add(state_answers, state);
  }
  list.of("", "");
  list.add(run_answers, results);
  return list.list();
}

Results results_of(const std::vector<Quantity>& quantities, const BodyScale& scale, const Stages& stages)
{
  Results results;
  const Real D = scale.width;
  if (!(D > 0)) return results;
  Values values;
  for (const Quantity& q : quantities) values.emplace(q.name, q.value);
  results.main = driven::main_drag(stages).value_or(0);

  base::take_answers(push_answers, values, "", results);
  take_points(results.push, &PushPoint::w, depth_answers, depths_to(results.push_end ? results.push_end->w / D : 0), values, "", D);
  take_points(results.travel, &TravelPoint::travel, travel_answers, travel_points, values, "", D);
  for (const Stage& stage : stages) {
    if (stage.kind == settings::StageKind::drag) {
      DragResults& drag = results.drags.emplace_back(DragResults{.stage = stage.name});
      take_points(drag.points, &DragPoint::u, point_answers, drag_points, values, results.prefix_of(drag), D);
      base::take_answers(drag_answers, values, results.prefix_of(drag), drag);
    }
    if (stage.kind == settings::StageKind::push)
      base::take_answers(other_push_answers, values, begin_of(stage.name),
                         results.other_pushes.emplace_back(OtherPushResults{stage.name, nan, nan}));
    if (stage.upwards)
      base::take_answers(uplift_answers, values, begin_of(stage.name), results.uplifts.emplace_back(UpliftResults{.stage = stage.name}));
  }
  for (const char* name : state_names)
    base::take_answers(state_answers, values, begin_of(name), results.states.emplace_back(StateResults{name, nan, nan}));
  base::take_answers(run_answers, values, "", results);
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
