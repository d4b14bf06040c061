// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/report/claims/claims_test.cpp
#include "report/claims/claim_observable.hpp"

#include "formulas/design_code.hpp"
#include "text/quantity_words.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::report {
namespace {

constexpr Real unknown = std::numeric_limits<Real>::quiet_NaN();
using Frame = std::optional<std::size_t>;

// In the order of ClaimObservable.
constexpr ObservableKind kinds[] = {{"V_at_w", ClaimUnit::force, ClaimUnit::length, true},
                                    {"w_at_V", ClaimUnit::length, ClaimUnit::force, true},
                                    {"w_of_push", ClaimUnit::length, ClaimUnit::none, false},
                                    {"H_at_u", ClaimUnit::force, ClaimUnit::length, true},
                                    {"V_at_u", ClaimUnit::force, ClaimUnit::length, true},
                                    {"w_at_u", ClaimUnit::length, ClaimUnit::length, true},
                                    {"H_at_w", ClaimUnit::force, ClaimUnit::length, true},
                                    {"V_in_drag_at_w", ClaimUnit::force, ClaimUnit::length, true},
                                    {"u_at_w", ClaimUnit::length, ClaimUnit::length, true},
                                    {"H_at_part", ClaimUnit::force, ClaimUnit::number, true},
                                    {"V_at_part", ClaimUnit::force, ClaimUnit::number, true},
                                    {"u_at_part", ClaimUnit::length, ClaimUnit::number, true},
                                    {"prototype_H_at_part", ClaimUnit::force, ClaimUnit::number, true},
                                    {"w_at_begin", ClaimUnit::length, ClaimUnit::none, false},
                                    {"sinking_at_u", ClaimUnit::length, ClaimUnit::length, true},
                                    {"sinking_after_u", ClaimUnit::length, ClaimUnit::length, true},
                                    {"heave_behind", ClaimUnit::length, ClaimUnit::none, false},
                                    {"heave_ahead", ClaimUnit::length, ClaimUnit::none, false},
                                    {"spread_heave", ClaimUnit::length, ClaimUnit::none, false},
                                    {"heave_over_spread", ClaimUnit::number, ClaimUnit::none, false},
                                    {"berm_at_u", ClaimUnit::area, ClaimUnit::length, true},
                                    {"berm_at_end", ClaimUnit::area, ClaimUnit::none, false},
                                    {"sheared_behind", ClaimUnit::number, ClaimUnit::length, false},
                                    {"shearing_reach", ClaimUnit::length, ClaimUnit::length, false},
                                    {"dragged", ClaimUnit::number, ClaimUnit::length, false},
                                    {"w_of_frame", ClaimUnit::length, ClaimUnit::length, false},
                                    {"quantity", ClaimUnit::number, ClaimUnit::none, false}};

/// The frame of the drag nearest to a depth that the drag comes to, or its last; empty also for the first frame of all, before which there is none.
Frame frame_of_drag(const TestRun& run, std::optional<Real> w)
{
  Frame frame;
  if (!w)
    frame = run.frames().last(problem::StageKind::drag);
  else if (run.has_drag() && run.u_where_w_is(*w * run.D))
    frame = run.frames().nearest(problem::StageKind::drag, &pipe::PipePlace::w, *w * run.D);
  return frame == 0 ? Frame{} : frame;
}

Real of_mechanism(ClaimObservable observable, std::optional<Real> at, const TestRun& run)
{
  const Frame frame = frame_of_drag(run, at);
  if (!frame) return unknown;
  if (observable == ClaimObservable::w_of_frame) return run.frames().place(*frame).w / run.D;
  const pipe::Mechanism& m = run.mechanism(*frame);
  return observable == ClaimObservable::sheared_behind ? m.behind : observable == ClaimObservable::dragged ? m.dragged : m.reach / run.D;
}

Real of_heave(ClaimObservable observable, const TestRun& run)
{
  const Frame frame = run.frames().last(problem::StageKind::push);
  if (!frame) return unknown;
  const Real w = run.frames().place(*frame).w, spread = formulas::f114_penetrated_area(run.D, w) / (3 * run.D);
  switch (observable) {
  case ClaimObservable::w_of_push:
    return w / run.D;
  case ClaimObservable::spread_heave:
    return spread / run.D;
  case ClaimObservable::heave_behind:
    return run.heave(*frame).behind / run.D;
  case ClaimObservable::heave_ahead:
    return run.heave(*frame).ahead / run.D;
  default:
    return std::min(run.heave(*frame).behind, run.heave(*frame).ahead) / spread;
  }
}

/// Where the frame nearest to u is the last one there is no berm to compare with that at the end.
Real of_berm(std::optional<Real> u, const TestRun& run)
{
  const Frame last = run.frames().last(problem::StageKind::drag);
  const Frame frame = u ? run.frames().nearest(problem::StageKind::drag, &pipe::PipePlace::u, *u * run.D) : last;
  if (!frame || (u && frame == last)) return unknown;
  return run.heave(*frame).berm / (run.D * run.D);
}

Real of_drag(ClaimObservable observable, Real at, const TestRun& run)
{
  const Real u = at * run.D, end = run.end_of_drag(), part = at * end;
  const auto where_w_is = [&](const auto& number) {
    const std::optional<Real> place = run.u_where_w_is(at * run.D);
    return place ? number(*place) : unknown;
  };
  switch (observable) {
  case ClaimObservable::H_at_u:
    return run.H(u);
  case ClaimObservable::V_at_u:
    return run.V(u);
  case ClaimObservable::w_at_u:
    return run.w(u) / run.D;
  case ClaimObservable::H_at_w:
    return where_w_is([&](Real s) { return run.H(s); });
  case ClaimObservable::V_in_drag_at_w:
    return where_w_is([&](Real s) { return run.V(s); });
  case ClaimObservable::u_at_w:
    return where_w_is([&](Real s) { return s / run.D; });
  case ClaimObservable::H_at_part:
    return run.H(part);
  case ClaimObservable::V_at_part:
    return run.V(part);
  case ClaimObservable::u_at_part:
    return part / run.D;
  case ClaimObservable::prototype_H_at_part:
    return run.H(part) * run.record.scale.gravity_level;
  case ClaimObservable::w_at_begin:
    return run.w_begin() / run.D;
  case ClaimObservable::sinking_at_u:
    return (run.w(u) - run.w_begin()) / run.D;
  default:
    return (run.w(end) - run.w(u)) / run.D;
  }
}

}  // namespace

const ObservableKind& kind_of(ClaimObservable observable)
{
  return kinds[static_cast<std::size_t>(observable)];
}

const std::vector<const char*>& observable_words()
{
  static const std::vector<const char*> words = [] {
    std::vector<const char*> all;
    for (const ObservableKind& kind : kinds) all.push_back(kind.word);
    return all;
  }();
  return words;
}

const char* unit_of(ClaimUnit unit)
{
  return unit == ClaimUnit::force ? "N/m" : "";
}

std::string words_of(ClaimUnit unit, Real value)
{
  switch (unit) {
  case ClaimUnit::length:
    return fmt::format("{:.3g} D", value);
  case ClaimUnit::area:
    return fmt::format("{:.3g} D²", value);
  case ClaimUnit::force:
    return text::force_words(value, 2);
  default:
    return fmt::format("{:.2g}", value);
  }
}

Real evaluate(ClaimObservable observable, std::optional<Real> at, const std::string& quantity, const TestRun& run)
{
  switch (observable) {
  case ClaimObservable::V_at_w:
    return run.V_of_push(*at * run.D);
  case ClaimObservable::w_at_V: {
    const std::optional<Real> w = run.w_where_V_is(*at);
    return w ? *w / run.D : unknown;
  }
  case ClaimObservable::w_of_push:
  case ClaimObservable::heave_behind:
  case ClaimObservable::heave_ahead:
  case ClaimObservable::spread_heave:
  case ClaimObservable::heave_over_spread:
    return of_heave(observable, run);
  case ClaimObservable::berm_at_u:
  case ClaimObservable::berm_at_end:
    return of_berm(at, run);
  case ClaimObservable::sheared_behind:
  case ClaimObservable::shearing_reach:
  case ClaimObservable::dragged:
  case ClaimObservable::w_of_frame:
    return of_mechanism(observable, at, run);
  case ClaimObservable::quantity: {
    const run_folder::Quantity* found = run.record.quantity(quantity);
    return found == nullptr ? unknown : found->value;
  }
  default:
    return run.has_drag() ? of_drag(observable, at.value_or(0), run) : unknown;
  }
}

}  // namespace berm::report
