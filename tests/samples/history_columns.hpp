// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "run_folder/history.hpp"

#include <algorithm>

namespace berm {

/// Rows of columns that a test names, such as u_m, tip_vx_m_s or a: of endings that are none of a unit it makes bare numbers.
class NamedRow {
public:
  explicit NamedRow(std::vector<std::string> names) : names_(std::move(names)) {}

  run_folder::Row& with(Real time, const std::string& stage, const std::vector<Real>& values)
  {
    using namespace run_folder;
    static constexpr ColumnUnit units[] = {
        newton_metres<2>, newtons<2>, joules<2>, newton_metre_seconds<2>, metres_per_second, radians, pascals, metres, seconds, newtons<3>};
    row_.begin(time, stage);
    for (std::size_t k = 0; k < values.size(); ++k) {
      const std::string name = k < names_.size() ? names_[k] : "one_more";
      ColumnUnit unit = bare;
      for (const ColumnUnit& each : units)
        if (*unit.ending == '\0' && name.ends_with(std::string("_") + each.ending)) unit = each;
      const std::size_t ending = *unit.ending == '\0' ? 0 : std::string(unit.ending).size() + 1;
      row_(name.substr(0, name.size() - ending), values[k], unit, "of a test");
    }
    return row_;
  }

private:
  std::vector<std::string> names_;
  run_folder::Row row_;
};

/// A history with named columns on its way to the disk.
class NamedHistory {
public:
  NamedHistory(const std::filesystem::path& path, std::vector<std::string> names) : file_(path), row_(std::move(names)) {}
  void add(Real time, const std::string& stage, const std::vector<Real>& values) { file_.add(row_.with(time, stage, values)); }

private:
  run_folder::HistoryFile file_;
  NamedRow row_;
};

/// What is said of such columns; time_s may be among them.
inline std::vector<run_folder::Column> columns_named(const std::vector<std::string>& names)
{
  std::vector<std::string> others;
  std::copy_if(names.begin(), names.end(), std::back_inserter(others), [](const std::string& name) { return name != "time_s"; });
  NamedRow row(others);
  const std::vector<run_folder::Column> made = row.with(0, "", std::vector<Real>(others.size(), 0)).columns();
  std::vector<run_folder::Column> columns;
  for (const std::string& name : names) columns.push_back(*std::ranges::find(made, name, &run_folder::Column::name));
  return columns;
}

/// The same beside a history.csv that a test writes as text.
inline void put_schema(const std::filesystem::path& history, const std::vector<std::string>& names)
{
  run_folder::write_schema(history, columns_named(names));
}

}  // namespace berm
