// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/report/quality/quality_section_test.cpp
#include "report/quality/indicators.hpp"

#include "report/setup/setup_tables.hpp"
#include "text/quantity_words.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::report {
namespace {

constexpr Real unknown = std::numeric_limits<Real>::quiet_NaN();

}  // namespace

text::Standing judge(const Limit& limit, Real value)
{
  if (std::isnan(value)) return text::Standing::unknown;
  if (limit.large ? value >= limit.good : value <= limit.good) return text::Standing::good;
  return (limit.large ? value < limit.bad : value > limit.bad) ? text::Standing::bad : text::Standing::fair;
}

EnergyError energy_error(const pipe::RunRecord& run)
{
  EnergyError found{run.check("energy_error"), ""};
  const run_folder::History& h = run.history;
  if (h.rows() == 0 || !h.has_label("energy error") || !h.has_label("external") || !h.has_label("internal")) return found;
  Real largest = 0, work = 0;
  Index row = none;
  for (Index k = 0; k < h.rows(); ++k) {
    const Real error = std::abs(h.by_label("energy error")[k]);
    work = std::max({work, std::abs(h.by_label("external")[k]), std::abs(h.by_label("internal")[k])});
    if (error > largest) largest = error, row = k;
  }
  if (std::isnan(found.over_work) && work > 0) found.over_work = largest / work;
  if (row == none) return found;
  const bool drag = std::find(run.stages.drag.begin(), run.stages.drag.end(), h.stage[row]) != run.stages.drag.end();
  const std::string at = run.has_pipe() ? fmt::format("{} = {}", drag ? "u" : "w", text::length_words(h[drag ? "u_m" : "w_m"][row]))
                                        : "t = " + text::time_words(h["time_s"][row]);
  found.where = fmt::format("{}, {}", h.stage[row], at);
  return found;
}

Real work_of_contact(const pipe::RunRecord& run)
{
  const run_folder::History& h = run.history;
  if (h.rows() == 0 || !h.has_label("friction") || !h.has_label("external") || !h.has_label("internal"))
    return std::numeric_limits<Real>::quiet_NaN();
  Real work = 0;
  for (Index k = 0; k < h.rows(); ++k) work = std::max({work, std::abs(h.by_label("external")[k]), std::abs(h.by_label("internal")[k])});
  return work > 0 ? std::max(Real(0), -h.by_label("friction").back() / work) : 0;
}

Real kinetic_over_internal(const pipe::RunRecord& run, const std::vector<std::string>& stages)
{
  const run_folder::History& h = run.history;
  if (h.rows() == 0 || !h.has_label("kinetic") || !h.has_label("internal")) return unknown;
  Real largest = unknown;
  for (const std::string& stage : stages) {
    const auto rows = std::count(h.stage.begin(), h.stage.end(), stage);
    std::ptrdiff_t before = 0;
    for (Index k = 0; k < h.rows(); ++k) {
      if (h.stage[k] != stage || 10 * before++ < rows) continue;
      const Real ratio = h.by_label("kinetic")[k] / std::abs(h.by_label("internal")[k]);
      if (std::isfinite(ratio)) largest = std::isnan(largest) ? ratio : std::max(largest, ratio);
    }
  }
  return largest;
}

bool holds_force(const problem::Case& settings)
{
  return std::any_of(settings.stage.begin(), settings.stage.end(), [](const problem::StageSettings& stage) {
    return stage.kind == problem::StageKind::drag && stage.vertical == problem::Vertical::hold && !stage.vertical_velocity;
  });
}

Real quantity_value(const pipe::RunRecord& run, const std::string& name)
{
  const run_folder::Quantity* quantity = run.quantity(name);
  return quantity == nullptr ? unknown : quantity->value;
}

Real gap_in_cells(const pipe::RunRecord& run)
{
  return quantity_value(run, "gap_mean") / near_cell_size(run.settings);
}

Real acts_larger(const pipe::RunRecord& run)
{
  return 2 * quantity_value(run, "gap_mean_over_D");
}

}  // namespace berm::report
