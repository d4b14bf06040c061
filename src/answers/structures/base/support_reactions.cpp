// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/structures/base/support_reactions_test.cpp
#include "structures/base/support_reactions.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::base {
namespace {

constexpr Real last_part = 0.05;  // of the time of a stage
constexpr const char* directions[] = {"x", "y", "z"};

/// Rows of a history that are of one stage, from the first to before the last.
struct Rows {
  Index begin, end;
};

/// Those of the last twentieth of a stage; none of one that did not begin.
Rows last_rows(const run_folder::History& h, const std::string& stage)
{
  const auto first = std::find(h.stage.begin(), h.stage.end(), stage);
  Rows rows{static_cast<Index>(first - h.stage.begin()), static_cast<Index>(first - h.stage.begin())};
  while (rows.end < h.rows() && h.stage[rows.end] == stage) ++rows.end;
  if (rows.begin == rows.end) return rows;
  const std::vector<Real>& time = h["time_s"];
  const Real from = time[rows.end - 1] - last_part * (time[rows.end - 1] - time[rows.begin]);
  while (time[rows.begin] < from) ++rows.begin;
  return rows;
}

std::string quantity_name(const std::string& support, int direction, const std::string& stage)
{
  return fmt::format("{}_F{}_of_{}", support, directions[direction], stage);
}

}  // namespace

std::vector<SupportReaction> support_reactions_of(const record::RunRecord& run)
{
  std::vector<SupportReaction> found;
  const settings::Case& c = run.settings;
  const run_folder::History& h = run.history;
  if (!c.output.support_reactions || h.rows() == 0) return found;
  for (const settings::StageSettings& stage : c.stage) {
    const Rows rows = last_rows(h, stage.name);
    if (rows.begin == rows.end) continue;
    for (const auto& entry : c.support) {
      SupportReaction reaction{stage.name, entry.first, {}};
      for (int d = 0; d < c.dimension(); ++d) {
        const std::string column = fmt::format("{}_F{}_{}", entry.first, directions[d], c.force_dimension() == 2 ? "N_m" : "N");
        if (!h.has(column)) return {};
        Real sum = 0;
        for (Index k = rows.begin; k < rows.end; ++k) sum += h[column][k];
        reaction.force.push_back(sum / static_cast<Real>(rows.end - rows.begin));
      }
      found.push_back(std::move(reaction));
    }
  }
  return found;
}

std::vector<run_folder::Quantity> support_quantities(const record::RunRecord& run)
{
  std::vector<run_folder::Quantity> quantities;
  for (const SupportReaction& reaction : support_reactions_of(run))
    for (std::size_t d = 0; d < reaction.force.size(); ++d)
      quantities.push_back(
          {quantity_name(reaction.support, static_cast<int>(d), reaction.stage), reaction.force[d],
           run.settings.force_dimension() == 2 ? "N/m" : "N",
           fmt::format("force of support {} on the soil along {} at the end of {}", reaction.support, directions[d], reaction.stage)});
  return quantities;
}

std::vector<std::string> support_quantity_names(const settings::Case& c)
{
  std::vector<std::string> names;
  if (!c.output.support_reactions) return names;
  for (const settings::StageSettings& stage : c.stage)
    for (const auto& entry : c.support)
      for (int d = 0; d < c.dimension(); ++d) names.push_back(quantity_name(entry.first, d, stage.name));
  return names;
}

}  // namespace berm::base
