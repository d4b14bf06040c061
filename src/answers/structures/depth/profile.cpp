// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/structures/depth/profile_test.cpp
#include "structures/depth/profile.hpp"

#include "structures/base/kind.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::depth {
namespace {

constexpr Real last_part = 0.1;                    // of the time of a stage
constexpr int steps = 20;                          // of a t-z curve
constexpr Real no_more = 1e-3;                     // of the drag load
constexpr Real at_rest = 1e-6;                     // of a slice's thickness: a way that is none
constexpr const char* endings[] = {"_N_m", "_N"};  // in plane strain, and of a whole

/// The columns of a rigid body with slices.
class Columns {
public:
  Columns(const run_folder::History& history, const std::string& body) : history_(history), body_(body) {}

  /// Null where the history has none.
  const std::vector<Real>* find(const std::string& symbol) const
  {
    for (const char* ending : endings)
      if (const std::vector<Real>* found = named(symbol + ending)) return found;
    return nullptr;
  }
  const std::vector<Real>* named(const std::string& name) const
  {
    for (std::size_t c = 0; c < history_.columns.size(); ++c)
      if (history_.columns[c].of == body_ && (history_.columns[c].name == name || history_.columns[c].name == body_ + '_' + name))
        return &history_.values[c];
    return nullptr;
  }
  bool whole() const { return named("V_base_N") != nullptr; }

private:
  const run_folder::History& history_;
  const std::string& body_;
};

std::vector<std::size_t> rows_of(const run_folder::History& history, const std::string& stage)
{
  std::vector<std::size_t> rows;
  for (std::size_t row = 0; row < history.stage.size(); ++row)
    if (history.stage[row] == stage) rows.push_back(row);
  return rows;
}

/// Rows of the last tenth of the time.
std::vector<std::size_t> last_of(const run_folder::History& history, const std::vector<std::size_t>& rows)
{
  const std::vector<Real>& time = history["time_s"];
  const Real from = std::lerp(time[rows.back()], time[rows.front()], last_part);
  std::vector<std::size_t> last;
  for (const std::size_t row : rows)
    if (time[row] >= from) last.push_back(row);
  return last;
}

Real mean(const std::vector<Real>& values, const std::vector<std::size_t>& rows)
{
  Real sum = 0;
  for (const std::size_t row : rows) sum += values[row];
  return sum / static_cast<Real>(rows.size());
}

/// Height of the soil beside a body at the start, as its slices have it: the w of the first row; NaN without rows.
Real sliced_height(const Columns& columns)
{
  const std::vector<Real>* w = columns.named("w_m");
  return w == nullptr || w->empty() ? nan : w->front();
}

/// Calls visit(name, slices, columns, thickness) for the bodies whose slices are in the history.
template <class Visit>
void for_sliced_bodies(const record::RunRecord& run, const Visit& visit)
{
  for (const auto& [name, rigid] : run.settings.rigid) {
    if (rigid.depth_slices == 0 || run.history.rows() == 0) continue;
    const Columns columns(run.history, name);
    const Real height = sliced_height(columns);
    if (columns.find("V_shaft1") == nullptr || columns.find("V_base") == nullptr || !(height > 0)) continue;
    visit(name, rigid.depth_slices, columns, height / rigid.depth_slices);
  }
}

}  // namespace

Real Profile::drag_load() const
{
  return *std::max_element(axial.begin(), axial.end()) - axial.front();
}

Real Profile::neutral_plane() const
{
  const Real reached = axial.front() + (1 - no_more) * drag_load();
  return level(static_cast<std::size_t>(std::find_if(axial.begin(), axial.end(), [&](Real N) { return N >= reached; }) - axial.begin()));
}

std::vector<Profile> profiles(const record::RunRecord& run)
{
  std::vector<Profile> all;
  for_sliced_bodies(run, [&](const std::string& name, int slices, const Columns& columns, Real thickness) {
    for (const settings::StageSettings& stage : run.settings.stage) {
      const std::vector<std::size_t> rows = rows_of(run.history, stage.name);
      if (rows.empty()) continue;
      const std::vector<std::size_t> last = last_of(run.history, rows);
      const bool sideways = (stage.rigid.empty() || stage.rigid == name) && base::goes_sideways(run.settings, stage);
      Profile profile{name, stage.name, columns.whole(), thickness, {}, {}, {}, sideways};
      for (int k = 1; k <= slices; ++k) {
        if (const std::vector<Real>* H = columns.find(fmt::format("H{}", k))) profile.h.push_back(mean(*H, last) / thickness);
        profile.v.push_back(mean(*columns.find(fmt::format("V_shaft{}", k)), last) / thickness);
      }
      profile.axial.assign(profile.v.size() + 1, mean(*columns.find("V_base"), last));
      for (std::size_t k = profile.v.size(); k-- > 0;) profile.axial[k] = profile.axial[k + 1] + thickness * profile.v[k];
      all.push_back(std::move(profile));
    }
  });
  return all;
}

std::vector<TzCurve> tz_curves(const record::RunRecord& run)
{
  std::vector<TzCurve> all;
  for_sliced_bodies(run, [&](const std::string& name, int slices, const Columns& columns, Real thickness) {
    const std::vector<Real>& w = *columns.named("w_m");
    for (const settings::StageSettings& stage : run.settings.stage) {
      const std::vector<std::size_t> rows = rows_of(run.history, stage.name);
      if (rows.empty()) continue;
      // The row before the stage is that of its beginning.
      const Real begin = w[rows.front() > 0 ? rows.front() - 1 : 0], way = w[rows.back()] - begin;
      if (!(std::abs(way) > at_rest * thickness)) continue;
      for (int k = 1; k <= slices; ++k) {
        const std::vector<Real>& V = *columns.find(fmt::format("V_shaft{}", k));
        TzCurve curve{name, stage.name, columns.whole(), (k - 0.5) * thickness, {}, {}};
        for (int step = 0; step < steps; ++step) {
          std::vector<std::size_t> within;
          for (const std::size_t row : rows)
            if (const Real part = (w[row] - begin) / way * steps; part > step && part <= step + 1) within.push_back(row);
          if (within.empty()) continue;
          curve.w.push_back(mean(w, within) - begin);
          curve.t.push_back(mean(V, within) / thickness);
        }
        if (!curve.w.empty()) all.push_back(std::move(curve));
      }
    }
  });
  return all;
}

}  // namespace berm::depth
