// SPDX-License-Identifier: BSD-3-Clause
#include "sea/displacement.hpp"

#include "bodies/rigid/shape.hpp"
#include "macro_element/under_force.hpp"
#include "os/error.hpp"

#include <algorithm>
#include <chrono>
#include <fmt/format.h>

namespace berm::sea {
namespace {

settings::StageSettings in_water(const SeaCase& c)
{
  settings::StageSettings stage;
  stage.kind = settings::StageKind::drag;
  stage.water = water_of(c);
  return stage;
}

settings::StageSettings whole(const SeaCase& c, const LoadRecord& record)
{
  settings::StageSettings stage = in_water(c);
  for (std::size_t row = 0; row < record.velocity.size(); ++row) stage.load_times.push_back(record.time(row));
  stage.loads.of("water") = record.velocity;
  return stage;
}

constexpr Real digits = 1e-4;  // of a file

bool close(Real x, Real y)
{
  return std::abs(x - y) <= digits * std::max<Real>(1, std::abs(x));
}

/// Whether two load histories and their water are the same but for the digits of a file.
bool same(const settings::StageSettings& one, const settings::StageSettings& other)
{
  return std::ranges::equal(one.load_times, other.load_times, close) &&
         std::ranges::equal(one.loads.of("water"), other.loads.of("water"), close);
}

}  // namespace

std::vector<WaveRow> load_history_of(const SeaCase& c, const LoadRecord& record, const std::vector<LoadWave>& waves)
{
  const Real ramp = pi / c.spectrum->peak();  // half a period
  std::vector<WaveRow> rows = {{0, 0, 0, c.pipe.weight}};
  Real time = ramp;
  for (const LoadWave& wave : waves)
    for (std::size_t row = wave.begin; row < wave.end; ++row, time += record.step)
      rows.push_back({time, record.velocity[row], record.H[row], record.V[row]});
  rows.push_back({time + ramp, 0, 0, c.pipe.weight});
  return rows;
}

settings::StageSettings stage_of_waves(const SeaCase& c, const SeaAnswer& a, std::size_t seed)
{
  settings::StageSettings stage = in_water(c);
  const auto waves = largest_waves(a.waves_of_record[seed], static_cast<std::size_t>(c.record.waves));
  for (const WaveRow& row : load_history_of(c, a.records[seed], waves))
    stage.load_times.push_back(row.time), stage.loads.of("water").push_back(row.velocity);
  return stage;
}

RunBeside run_beside(const record::RunRecord& run, const std::vector<settings::StageSettings>& waves, Real mass, Real diameter)
{
  const std::string folder = run.folder.string();
  const auto& stages = run.settings.stage;
  const auto stage = std::find_if(stages.begin(), stages.end(), [](const auto& one) { return one.water.has_value(); });
  if (stage == stages.end()) throw RunError(fmt::format("soil.runs: {} has no stage with [stage.water]", folder));
  const auto table = std::find_if(waves.begin(), waves.end(), [&](const auto& one) { return same(one, *stage); });
  if (table == waves.end())
    throw RunError(
        fmt::format("soil.runs: the load history of {} is none of the tables of the largest waves of this sea state, waves_1.csv to "
                    "waves_{}.csv",
                    folder, waves.size()));
  const settings::WaterSettings &of_run = *stage->water, &of_sea = *table->water;
  const auto& rigid = run.settings.rigid[stage->rigid.empty() ? 0 : index_of(run.settings.rigid, stage->rigid)].second;
  const std::optional<bodies::DiskOutline> pipe = bodies::pipe_section(rigid.shape);
  if (!close(of_run.density, of_sea.density) || !close(of_run.drag, of_sea.drag) || !close(of_run.inertia, of_sea.inertia) ||
      !close(of_run.lift, of_sea.lift) || !close(of_run.weight, of_sea.weight) || of_run.permeable != of_sea.permeable ||
      !close(of_run.trench_depth, of_sea.trench_depth) || !close(of_run.trench_angle, of_sea.trench_angle))
    throw RunError(fmt::format("soil.runs: [stage.water] of {} has other numbers than this sea: paste stage.toml", folder));
  constexpr Real same_pipe = 0.02;
  if (!pipe || std::abs(2 * pipe->radius / diameter - 1) > same_pipe || std::abs(rigid.mass / mass - 1) > same_pipe)
    throw RunError(
        fmt::format("soil.runs: {} is of another pipe: this one has {:.4g} m and {:.4g} kg/m with added mass", folder, diameter, mass));
  RunBeside beside{.name = run.name,
                   .method = run.settings.method == settings::Method::mpm ? "material points" : "remeshed finite elements",
                   .seed = static_cast<int>(table - waves.begin()) + 1,
                   .track = {}};
  const run_folder::History& history = run.history;
  const auto in_stage = [&](Index row) { return row < history.rows() && history.stage[static_cast<std::size_t>(row)] == stage->name; };
  for (Index row = 0; row < history.rows(); ++row) {
    if (!in_stage(row) && !in_stage(row + 1)) continue;  // it begins at the row before
    beside.track.time.push_back(history["time_s"][row]);
    beside.track.u.push_back(history["u_m"][row]), beside.track.w.push_back(history["w_m"][row]);
  }
  if (beside.track.time.empty()) throw RunError(fmt::format("soil.runs: {} has not reached its stage \"{}\"", folder, stage->name));
  const Real begin = beside.track.time.front();
  if (beside.track.time.back() - begin < (1 - 1e-3) * stage->load_times.back())
    throw RunError(fmt::format("soil.runs: {} has not finished its stage \"{}\": resume it", folder, stage->name));
  for (Real& time : beside.track.time) time -= begin;
  return beside;
}

Real mass_of(const SeaCase& c)
{
  return c.pipe.mass.value_or(mass_in_water(water_of(c), c.pipe.diameter));
}

std::optional<Displacements> displacements_of(const SeaCase& c, const SeaAnswer& a)
{
  if (!c.macro_element) return {};
  const macro_element::Parameters& soil = *c.macro_element;
  const berm_macro_element_state laid = macro_element::laid(soil, c.soil->laying_force.value_or(c.pipe.weight), c.pipe.weight);
  const Real mass = mass_of(c);
  Displacements found;
  const auto begin = std::chrono::steady_clock::now();
  for (const LoadRecord& record : a.records) found.seeds.push_back(march(soil, laid, whole(c, record), mass));
  found.wall_s = std::chrono::duration<Real>(std::chrono::steady_clock::now() - begin).count();
  std::vector<settings::StageSettings> waves;
  for (std::size_t seed = 0; seed < a.records.size(); ++seed) {
    waves.push_back(stage_of_waves(c, a, seed));
    found.waves.push_back(march(soil, laid, waves.back(), mass));
  }
  for (const std::string& folder : c.soil->runs)
    found.runs.push_back(run_beside(record::read_run(c.folder / folder), waves, mass, c.pipe.diameter));
  return found;
}

}  // namespace berm::sea
