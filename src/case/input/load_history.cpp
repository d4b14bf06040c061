// SPDX-License-Identifier: BSD-3-Clause
#include "input/load_history.hpp"

#include "input/table_file.hpp"
#include "input/units.hpp"
#include "os/error.hpp"
#include "settings/load_checks.hpp"
#include "settings/support_checks.hpp"
#include "settings/time_scale.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::input {
namespace {

/// Reads the file of a load history into the stage.
void read_load_file(const settings::Case& c, const std::string& key, const std::filesystem::path& folder, settings::StageSettings& stage)
{
  const std::vector<std::size_t> allowed = columns_for(c, stage);
  TableForm form{"the load history of this stage", {}, true, "time_s,H_N_m,V_N_m"};
  for (const std::size_t k : allowed) {
    const settings::LoadColumn& column = settings::load_columns[k];
    form.columns.push_back({column.name, c.force_dimension() == 3 ? unit_of_whole(column.unit) : column.unit});
  }
  read_table(key, folder / stage.load_history, form,
             [&](Real time, const std::vector<std::size_t>& columns, const std::vector<Real>& values) {
               stage.load_times.push_back(time);
               if (columns.empty()) stage.load_factors.push_back(values.front());
               for (std::size_t n = 0; n < columns.size(); ++n) stage.loads.columns[allowed[columns[n]]].push_back(values[n]);
               const std::optional<settings::RowFault> fault = fault_of_row(stage, stage.load_times.size() - 1);
               return fault ? fault->message : "";
             });
}

/// Throws KeyError with the key of a table of which "KEY: MESSAGE" is wrong, "" where nothing is.
void refuse_fault(const std::string& table, const std::string& fault)
{
  if (!fault.empty()) throw KeyError(table + (fault.starts_with(": ") ? "" : ".") + fault);
}

}  // namespace

void read_motion(settings::Case& c, std::size_t support_number, const std::filesystem::path& folder)
{
  auto& [name, support] = c.support[support_number];
  if (!support.motion || support.motion->table.empty()) return;
  boundary::MotionSettings& motion = *support.motion;
  const std::string table = fmt::format("support.{}.motion", name);
  TableForm form{"this motion", {}, false, c.dimension() == 2 ? "time_s,x_m_s,y_m_s" : "time_s,x_m_s,y_m_s,z_m_s"};
  for (int d = 0; d < c.dimension(); ++d) form.columns.push_back({boundary::motion_axes[d], boundary::unit_of_motion});
  read_table(table + ".table", folder / motion.table, form,
             [&](Real time, const std::vector<std::size_t>& columns, const std::vector<Real>& values) {
               motion.times.push_back(time);
               for (std::size_t n = 0; n < columns.size(); ++n) motion.velocity[columns[n]].push_back(values[n]);
               return boundary::fault_of_row(motion.times, motion.times.size() - 1);
             });
  motion.table.clear();
  refuse_fault(table, fault_of_motion(c, support));
}

void read_load_history(settings::Case& c, std::size_t stage_number, const std::filesystem::path& folder)
{
  settings::StageSettings& stage = c.stage[stage_number];
  if (!has_load_history(stage)) return;
  const auto key = [&](const std::string& rest) { return fmt::format("stage[{}]{}", stage_number, rest); };
  if (!stage.load_history.empty()) {
    read_load_file(c, key(".load_history"), folder, stage);
    stage.load_history.clear();
    refuse_fault(key(""), settings::fault_of_loads(c, stage));
  }
  if (stage.load_repeat > 1) repeat_load_history(stage);
  if (stage.time_scale == settings::automatic_time_scale) {
    const std::optional<settings::TimeScale> found = settings::time_scale_of(c, stage);
    if (!found)
      throw KeyError(fmt::format("{}: is chosen for a record of forces only where a body with a width touches soil: give a number here",
                                 key(".time_scale")));
    stage.time_scale = found->scale;
  }
  stage.until.time = std::min(stage.until.time.value_or(infinity), stage.load_times.back() * stage.time_scale);
}

}  // namespace berm::input
