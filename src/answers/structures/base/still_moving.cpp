// SPDX-License-Identifier: BSD-3-Clause
#include "structures/base/still_moving.hpp"

#include "settings/stage.hpp"
#include "structures/base/driven_body.hpp"
#include "text/quantity_words.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::base {
namespace {

constexpr Real part = 0.1;          // of a stage: what is its last part at most, and for how long it may go on
constexpr Real counts = 0.02;       // of the travel in the stage
constexpr Real ended = 0.99;        // of its time
constexpr Real least_width = 1e-3;  // of the width of the body: less is rest

using settings::StageKind;

/// Whether only forces move the body or the line in a stage, and only time ends it.
bool goes_on_for_its_time(const settings::StageSettings& s)
{
  if (s.kind == StageKind::geostatic || s.velocity || s.vertical_velocity) return false;
  for (const settings::FreedomSettings* freedom : {&s.drive.x, &s.drive.y, &s.drive.z})
    if (freedom->velocity) return false;
  for (std::size_t k = 0; k < settings::load_columns.size(); ++k)
    if (const settings::LoadQuantity quantity = settings::load_columns[k].quantity;
        !s.loads.columns[k].empty() && (quantity == settings::LoadQuantity::velocity || quantity == settings::LoadQuantity::displacement))
      return false;
  return !s.until.displacement && !s.until.embedment && !s.until.force && !s.until.consolidation;
}

struct Motion {
  Real before, end, velocity, travel;  ///< m, m, m/s, m
};

/// Of a column in these rows, whose last part begins at a time.
Motion motion_of(const std::vector<Real>& time, const std::vector<Real>& column, Index first, Index last, Real from)
{
  Index begin = last;
  while (begin > first && time[begin] > from) --begin;
  Real travel = 0;
  for (Index k = first; k <= last; ++k) travel = std::max(travel, std::abs(column[k] - column[first]));
  return {column[begin], column[last], (column[last] - column[begin]) / (time[last] - time[begin]), travel};
}

}  // namespace

std::vector<StillMoving> still_moving(const record::RunRecord& run)
{
  std::vector<StillMoving> all;
  const run_folder::History& h = run.history;
  if (h.rows() == 0) return all;
  const std::vector<Real>& time = h["time_s"];
  const Real width = body_scale(run).width;
  for (const settings::StageSettings& stage : run.settings.stage) {
    if (!goes_on_for_its_time(stage)) continue;
    const auto begin = std::ranges::find(h.stage, stage.name);
    const auto end = std::find(h.stage.rbegin(), h.stage.rend(), stage.name);
    if (begin == h.stage.end()) continue;
    const Index first = std::max<Index>(0, static_cast<Index>(begin - h.stage.begin()) - 1),
                last = static_cast<Index>(h.stage.rend() - end) - 1;
    const Real lasted = time[last] - time[first], since_ramp = lasted - stage.ramp;
    const Real last_part = since_ramp > 0 ? std::min(part * lasted, since_ramp) : part * lasted;
    if (!(last_part > 0) || lasted < ended * settings::expected_time(stage)) continue;  // a run that was stopped in it
    std::optional<StillMoving> fastest;
    const bool line = stage.kind == StageKind::pipeline;
    for (const auto& [symbol, name] : {std::pair{"y", "line_y_m"}, {"u", "u_m"}, {"w", "w_m"}}) {
      if (!h.has(name) || line != (symbol == std::string_view("y"))) continue;
      const Motion m = motion_of(time, h[name], first, last, time[last] - last_part);
      const Real goes_on = std::abs(m.velocity) * part * lasted;
      if (!(goes_on > counts * m.travel) || !(goes_on > least_width * width)) continue;
      if (!fastest || std::abs(m.velocity) > std::abs(fastest->velocity))
        fastest = StillMoving{stage.name, symbol, m.velocity, m.before, m.end, last_part};
    }
    if (fastest) all.push_back(*fastest);
  }
  return all;
}

std::string still_moving_words(const StillMoving& m)
{
  return fmt::format("still moving at the end: {} at {}, from {} to {} in the last {}", m.symbol, text::speed_words(std::abs(m.velocity)),
                     text::length_words(m.before), text::length_words(m.end), text::time_words(m.last_part));
}

std::string still_moving_lines(const record::RunRecord& run)
{
  std::string lines;
  for (const StillMoving& moving : still_moving(run)) lines += fmt::format("\"{}\" was {}\n", moving.stage, still_moving_words(moving));
  return lines;
}

}  // namespace berm::base
