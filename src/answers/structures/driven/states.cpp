// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/structures/driven/states_test.cpp
#include "structures/driven/states.hpp"

#include "structures/base/soil_words.hpp"
#include "structures/driven/quantities.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numeric>

namespace berm::driven {
namespace {

using settings::StageRole;

constexpr Real last_part = 0.05;           // of the time of a stage
constexpr Real tolerance_of_force = 0.15;  // of a force that is given: how far the soil's may be from it

/// The state in a row: forces are means over the end of the stage that the row is of.
State state_at(const run_folder::History& h, Index row, std::string name, std::string origin)
{
  const std::string& stage = h.stage[row];
  Index begin = row;
  while (begin > 0 && h.stage[begin - 1] == stage) --begin;
  const std::vector<Real>& time = h["time_s"];
  const Real from = time[row] - last_part * (time[row] - time[begin]);
  Real H = 0, V = 0;
  int rows = 0;
  for (Index k = row; k >= begin && time[k] >= from; --k) {
    if (!std::isfinite(h.by_label("H")[k]) || !std::isfinite(h.by_label("V")[k])) continue;
    H += h.by_label("H")[k], V += h.by_label("V")[k];
    ++rows;
  }
  const Real mean = rows > 0 ? 1. / rows : nan;
  return {std::move(name), std::move(origin), stage, row, h["u_m"][row], h["w_m"][row], mean * H, mean * V};
}

/// The last row of a stage of the case; none where it has none.
Index end_of_stage(const run_folder::History& h, const std::string& stage)
{
  const auto last = std::find(h.stage.rbegin(), h.stage.rend(), stage);
  return last == h.stage.rend() ? none : static_cast<Index>(h.stage.rend() - last - 1);
}

/// The last row of the last stage of a role that has begun; none where there is none.
Index end_of_role(const record::RunRecord& run, StageRole role)
{
  Index row = none;
  for (const settings::StageSettings& stage : run.settings.stage)
    if (stage.role == role)
      if (const Index end = end_of_stage(run.history, stage.name); end != none) row = end;
  return row;
}

/// The vertical force that a stage of the case gives at its end, N/m downwards; empty where it gives none.
std::optional<Real> given_V(const Stages& stages, const std::string& name)
{
  const auto found = std::find_if(stages.begin(), stages.end(), [&](const Stage& stage) { return stage.asked.name == name; });
  if (found == stages.end()) return {};
  if (found->kind == settings::StageKind::push) return found->force;
  return found->asked.vertical_force;
}

std::string end_words(const run_folder::History& h, Index row)
{
  return "end of stage " + h.stage[row];
}

/// Gives a state the force that is asked for, unless that of the soil is far from it.
void take_force(State& state, Real asked)
{
  if (asked != 0 && std::abs(state.V - asked) > tolerance_of_force * std::abs(asked))
    state.origin += fmt::format(", which has not reached its force of {:.4g} N/m", asked);
  else
    state.V = asked, state.V_given = true;
}

/// The last row of a run, or that before the lifts that end it, after which nothing presses the body down again; none where the run begins with them.
Index before_lifts(const Path& path, const run_folder::History& h)
{
  Index row = h.rows() - 1;
  for (auto push = path.other_pushes.rbegin(); push != path.other_pushes.rend() && push->lifts; ++push) {
    const Index begin = push->rows.front();
    if (!path.push.rows.empty() && path.push.rows.back() > begin) break;
    row = begin > 0 ? begin - 1 : none;
  }
  return row;
}

/// How far the area of an earthwork is from the body as a row has it, m; 0 inside.
Real distance_from(const bodies::EarthworkSettings& work, const record::RunRecord& run, const base::BodyScale& scale, Index row)
{
  const run_folder::History& h = run.history;
  const Real x = center_of<2>(bodies::make_shape<2>(run.settings.rigid[main_rigid(run.settings)].second.shape))[0], half = scale.width / 2;
  const Vec<2> center(x + h["u_m"][row], run.surface_at(x) - h["w_m"][row] + half);
  return std::max(Real(0), surface_at<2>(bodies::make_shape<2>(work.area), center).distance - half);
}

}  // namespace

std::optional<SoilWork> last_soil_work(const record::RunRecord& run, Index row)
{
  const run_folder::History& h = run.history;
  const base::BodyScale scale = base::body_scale(run);
  std::optional<SoilWork> last;
  if (run.settings.dimension() != 2 || !(scale.width > 0) || h.rows() == 0 || !h.has("w_m") || !h.has("u_m")) return last;
  for (const base::EarthworkWords& work : base::earthworks_in_words(run.settings)) {
    Index begin = none;
    bool near = false;
    for (Index k = 0; k < h.rows(); ++k) {
      if (h.stage[k] != work.settings.stage) continue;
      if (begin == none) begin = k;
      near = near || distance_from(work.settings, run, scale, k) <= near_the_body * scale.width;
    }
    if (near && begin <= row && (!last || begin > last->row)) last = SoilWork{work.words, begin};
  }
  return last;
}

States states_of(const record::RunRecord& run)
{
  States states;
  const run_folder::History& h = run.history;
  if (h.rows() == 0 || !h.has("w_m") || !h.has("u_m") || !h.has_label("V") || !h.has_label("H")) return states;
  const Stages stages = stages_of(run.settings);
  const Path path = path_of(h, stages);
  const auto add = [&](const char* name, Index row, const std::string& why) {
    if (row == none) return;
    states.push_back(state_at(h, row, name, end_words(h, row) + why));
    if (const std::optional<Real> V = given_V(stages, h.stage[row])) {
      take_force(states.back(), *V);
    } else if (!path.push.rows.empty() && row == path.push.rows.back()) {
      states.back().V = V_at_end(path.push, h, stages, base::body_scale(run));
      states.back().V_given = std::isfinite(force_that_ended(path.push, h, stages));
    }
  };
  if (const Index said = end_of_role(run, StageRole::touchdown); said != none)
    add("touchdown", said, "");
  else if (!path.push.rows.empty())
    add("touchdown", path.push.rows.back(), "");
  Index laid = end_of_role(run, StageRole::lay);
  for (const DragPath& drag : path.drags)
    if (drag.stage.lays) laid = std::max(laid == none ? 0 : laid, drag.rows.back());
  add("laid", laid, "");
  add("flooded", end_of_role(run, StageRole::flooded), "");
  add("emptied", end_of_role(run, StageRole::emptied), "");
  const DragPath& main = path.main_drag();
  if (const Index said = end_of_role(run, StageRole::operation); said != none)
    add("operation", said, "");
  else if (!main.rows.empty()) {
    const std::string before = ", before " + main.stage.name;
    add("operation", main.rows.front(), before);
    State& operation = states.back();
    const std::vector<Real> V = settled_V(main, h["time_s"]);
    const std::optional<Real>& given = main.stage.asked.vertical_force;
    if (!V.empty() && (given || (main.stage.holds_V && !operation.V_given)))
      operation.V = std::accumulate(V.begin(), V.end(), Real{0}) / static_cast<Real>(V.size());
    if (given) {
      operation.origin = end_words(h, operation.row) + before;
      take_force(operation, *given);
    }
  } else if (!path.other_pushes.empty() || (!path.push.rows.empty() && h.rows() - 1 > path.push.rows.back())) {
    const Index row = before_lifts(path, h);
    add("operation", row, row == h.rows() - 1 || row == none ? "" : ", before " + h.stage[row + 1]);
  }
  for (const DragPath& drag : path.drags)
    if (!drag.stage.lays) states.push_back(state_at(h, drag.rows.back(), "after_" + drag.stage.name, "end of " + drag.stage.name));
  std::stable_sort(states.begin(), states.end(), [](const State& a, const State& b) { return a.row < b.row; });
  return states;
}

const State* find_state(const States& states, const std::string& name)
{
  const auto found = std::find_if(states.begin(), states.end(), [&](const State& state) { return state.name == name; });
  return found == states.end() ? nullptr : &*found;
}

bool has_states_between(const States& states)
{
  const auto there = [&](const char* name) { return find_state(states, name) != nullptr; };
  if (there("laid") || there("flooded") || there("emptied")) return true;
  const State *touchdown = find_state(states, "touchdown"), *operation = find_state(states, "operation");
  return touchdown != nullptr && operation != nullptr && operation->row != touchdown->row;
}

}  // namespace berm::driven
