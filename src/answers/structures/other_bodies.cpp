// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/structures/other_bodies_test.cpp
#include "structures/other_bodies.hpp"

#include "structures/structures.hpp"

#include <algorithm>

namespace berm::structures {
namespace {

bool is_driven_by(const settings::StageSettings& stage, const std::string& rigid)
{
  return drives(stage.kind) && stage.rigid == rigid;
}

/// The case without the stages that drive other bodies, so that this one is the main one.
settings::Case case_of_body(const settings::Case& c, const std::string& rigid)
{
  settings::Case own = c;
  std::erase_if(own.stage, [&](const settings::StageSettings& stage) { return drives(stage.kind) && !is_driven_by(stage, rigid); });
  return own;
}

/// The history with the columns of this body in place of those of the main one.
run_folder::History history_of_body(const run_folder::History& history, const std::string& main, const std::string& rigid)
{
  run_folder::History own;
  own.stage = history.stage;
  for (std::size_t k = 0; k < history.columns.size(); ++k) {
    run_folder::Column column = history.columns[k];
    if (column.of == main) continue;
    if (column.of == rigid && column.name.starts_with(rigid + '_')) {
      column.name.erase(0, rigid.size() + 1);
      if (column.label.starts_with(rigid + ' ')) column.label.erase(0, rigid.size() + 1);
    }
    own.columns.push_back(std::move(column));
    own.values.push_back(history.values[k]);
  }
  return own;
}

/// The run as if it had this body for its main one.
record::RunRecord run_of_body(const record::RunRecord& run, const std::string& rigid)
{
  record::RunRecord own = run;
  own.settings = case_of_body(run.settings, rigid);
  own.history = history_of_body(run.history, run.settings.rigid[main_rigid(run.settings)].first, rigid);
  own.quantities.clear();
  return own;
}

/// The held forces of the stages that case_of_body keeps.
std::vector<Real> forces_of_body(const settings::Case& c, const std::string& rigid, const std::vector<Real>& held_forces)
{
  std::vector<Real> own;
  for (std::size_t k = 0; k < std::min(c.stage.size(), held_forces.size()); ++k)
    if (!drives(c.stage[k].kind) || is_driven_by(c.stage[k], rigid)) own.push_back(held_forces[k]);
  return own;
}

}  // namespace

std::vector<std::string> other_driven_bodies(const settings::Case& c)
{
  std::vector<std::string> others;
  const Index main = main_rigid(c);
  for (Index k = 0; k < static_cast<Index>(c.rigid.size()); ++k)
    if (k != main && std::ranges::any_of(c.stage, [&](const auto& stage) { return is_driven_by(stage, c.rigid[k].first); }))
      others.push_back(c.rigid[k].first);
  return others;
}

std::vector<run_folder::Quantity> quantities_of(const record::RunRecord& run, const std::vector<Real>& held_forces)
{
  std::vector<run_folder::Quantity> all = structure_of(run.settings).quantities(run, held_forces);
  for (const std::string& rigid : other_driven_bodies(run.settings)) {
    const record::RunRecord own = run_of_body(run, rigid);
    if (!own.history.has("u_m") || !own.history.has("w_m")) continue;
    for (run_folder::Quantity& q : structure_of(own.settings).quantities(own, forces_of_body(run.settings, rigid, held_forces))) {
      q.name = rigid + '.' + q.name;
      if (std::ranges::find(all, q.name, &run_folder::Quantity::name) == all.end()) all.push_back(std::move(q));
    }
  }
  return all;
}

std::vector<std::string> quantity_names_of(const settings::Case& c)
{
  std::vector<std::string> all = structure_of(c).quantity_names(c);
  if (all.empty()) return all;
  for (const std::string& rigid : other_driven_bodies(c)) {
    const settings::Case own = case_of_body(c, rigid);
    for (const std::string& name : structure_of(own).quantity_names(own)) all.push_back(rigid + '.' + name);
  }
  return all;
}

}  // namespace berm::structures
