// SPDX-License-Identifier: BSD-3-Clause
#include "macro_element_fit/path.hpp"

#include "os/error.hpp"
#include "structures/base/driven_body.hpp"
#include "structures/base/soil_words.hpp"
#include "structures/driven/states.hpp"
#include "structures/structures.hpp"
#include "study/study_rows.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::macro_element_fit {
namespace {

namespace fs = std::filesystem;

/// Points that a path has about: enough for curves, few enough to go through a thousand times.
constexpr Index path_points = 250;

bool by_force(const settings::StageSettings& stage)
{
  if (stage.kind == settings::StageKind::push) return stage.force.has_value();
  if (stage.kind == settings::StageKind::drag) return stage.vertical == settings::Vertical::hold && !stage.vertical_velocity;
  return stage.kind == settings::StageKind::drive && (stage.drive.y.force || stage.drive.y.hold);
}

/// Rows [begin, end) of a history as one point: where the pipe was at their end, and the mean of the forces.
PathPoint point_of(const run_folder::History& history, Index begin, Index end, bool by_force)
{
  const std::vector<Real>&H = history.by_label("H"), &V = history.by_label("V");
  PathPoint point{history["u_m"][end - 1], history["w_m"][end - 1], 0, 0, by_force};
  for (Index row = begin; row < end; ++row) point.H += H[row] / Real(end - begin), point.V += V[row] / Real(end - begin);
  return point;
}

}  // namespace

Real Path::largest_H() const
{
  Real largest = 0;
  for (const PathPoint& p : points) largest = std::max(largest, std::abs(p.H));
  return largest;
}

Real Path::largest_V() const
{
  Real largest = 0;
  for (const PathPoint& p : points) largest = std::max(largest, std::abs(p.V));
  return largest;
}

Path path_of(const record::RunRecord& run)
{
  const std::string folder = run.folder.string();
  if (!base::drives_a_body(run.settings) || run.settings.geometry != settings::Geometry::plane_strain)
    throw RunError(fmt::format("{} is not a plane-strain run of a pipe: a macro-element gives forces per length of pipe", folder));
  if (run.end != record::RunEnd::finished) throw RunError(fmt::format("{} has not finished: run it to the end, or leave it out", folder));
  const run_folder::History& history = run.history;
  if (const std::optional<driven::SoilWork> work = driven::last_soil_work(run, history.rows() - 1))
    throw RunError(fmt::format("{}: {}, is at the pipe: a macro-element needs a bed without excavation or fill", folder, work->words));
  Path path;
  path.name = run.name;
  path.run = run.folder;
  path.diameter = base::body_scale(run).width;
  if (const contact::ContactSettings* contact = base::contact_of_body(run.settings)) path.friction = std::tan(contact->friction_angle);
  if (run.summary) path.invalid = run.summary->invalid;
  Index moving = 0;
  for (Index row = 0; row < history.rows(); ++row) moving += history["w_m"][row] > 0;
  const Index block = std::max<Index>(1, moving / path_points);
  bool dragged = false;
  for (Index begin = 0, end = 0; begin < history.rows(); begin = end) {
    while (end < history.rows() && history.stage[end] == history.stage[begin]) ++end;
    const auto& stages = run.settings.stage;
    const auto stage = std::find_if(stages.begin(), stages.end(), [&](const auto& one) { return one.name == history.stage[begin]; });
    if (stage == stages.end() || !drives(stage->kind)) continue;
    const bool first_push = path.push.empty() && !dragged && stage->kind == settings::StageKind::push && stage->velocity;
    Index first = begin;
    while (first < end && !(history["w_m"][first] > 0)) ++first;
    // The stage's last block holds its last row, where the pipe turns.
    while (first < end) {
      const Index last = end - first < 2 * block ? end : first + block;
      path.points.push_back(point_of(history, first, last, by_force(*stage)));
      if (first_push) path.push.push_back(path.points.back());
      first = last;
    }
    dragged = dragged || stage->kind != settings::StageKind::push;
  }
  if (path.points.size() < 2) throw RunError(fmt::format("{}: the pipe was never in the soil", folder));
  return path;
}

std::vector<Path> paths_in(const std::vector<std::string>& folders)
{
  std::vector<Path> paths;
  for (const fs::path folder : folders) {
    if (record::is_run_folder(folder)) {
      paths.push_back(path_of(structures::read_run(folder)));
      continue;
    }
    const auto rows = study::read_rows(folder);
    if (!rows)
      throw RunError(fmt::format("{} is neither a run folder nor the output of berm study (it has no resolved.toml and no study.json)",
                                 folder.string()));
    for (const study::SavedRow& row : *rows) paths.push_back(path_of(structures::read_run(row.run)));
  }
  return paths;
}

}  // namespace berm::macro_element_fit
