// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/element/element_report_test.cpp
#include "element/element_table.hpp"

#include "run_folder/history.hpp"
#include "text/quantity_words.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::element {
namespace {

constexpr run_folder::ColumnUnit of_stress = run_folder::pascals;

std::string words_of_leg(const TestRecord& record, int leg)
{
  const int legs = legs_of_cycle(record.settings), of_cycle = leg % legs;
  const bool consolidates = reconsolidated(record.settings.kind) && of_cycle == legs - 1;
  const std::string words = consolidates ? "reconsolidation" : fmt::format("leg {}", of_cycle + 1);
  return record.settings.cycles == 1 ? words : fmt::format("cycle {} {}", leg / legs + 1, words);
}

void add_stresses(run_folder::Row& line, const TestRecord& record, const TestRow& row)
{
  const char* effective = shows_effective_stress(record) ? "effective " : "";
  line("vertical_stress", vertical_stress(row), of_stress, fmt::format("vertical {}stress", effective));
  line("lateral_stress", lateral_stress(row), of_stress, fmt::format("lateral {}stress", effective));
  if (!std::holds_alternative<Triaxial>(record.settings.kind))
    line("out_of_plane_stress", -row.stress[2], of_stress, fmt::format("horizontal {}stress across the lateral one", effective));
  if (std::holds_alternative<SimpleShear>(record.settings.kind))
    line("tau", shear_stress(row), of_stress, "horizontal shear stress");
  else
    line("q", deviator_stress(row), of_stress, "vertical minus lateral stress");
  line("p", mean_stress(row), of_stress, fmt::format("mean {}stress", effective));
  line("s", middle_stress(row), of_stress, "(s1 + s3)/2 of the principal stresses");
  line("t", max_shear_stress(row), of_stress, "(s1 - s3)/2 of the principal stresses");
  if (const std::optional<Real> t = strength(record, row)) line("strength", *t, of_stress, "largest (s1 - s3)/2 that the law allows here");
  if (shows_effective_stress(record))
    line("mobilised_friction_angle", mobilised_friction_angle(row), run_folder::radians, "asin((s1 - s3)/(s1 + s3))");
  if (const std::optional<Real> du = excess_pore_pressure(record, row))
    line("excess_pore_pressure", *du, of_stress, "excess pore pressure");
}

void add_state(run_folder::Row& line, const TestRecord& record, const TestRow& row)
{
  std::size_t next = 0;
  for (const FieldInfo& field : material::state_fields(record.material)) {
    std::string ending = field.unit;
    std::replace_if(
        ending.begin(), ending.end(), [](char c) { return std::isalnum(static_cast<unsigned char>(c)) == 0; }, '_');
    const run_folder::ColumnUnit unit = field.unit.empty() ? run_folder::bare : run_folder::ColumnUnit{field.unit.c_str(), ending.c_str()};
    for (int k = 0; k < field.components; ++k)
      line(field.components == 1 ? field.name : fmt::format("{}_{}", field.name, k), row.state.at(next++), unit, field.label);
  }
}

}  // namespace

void write_rows(const TestRecord& record, const std::filesystem::path& path)
{
  run_folder::HistoryFile file(path);
  run_folder::Row line;
  const bool shears = std::holds_alternative<SimpleShear>(record.settings.kind);
  for (const TestRow& row : record.rows) {
    line.begin(row.time, words_of_leg(record, row.leg));
    line.of_main("specimen");
    line(shears ? "shear_strain" : "axial_strain", driven_strain(record.settings, row), run_folder::bare,
         shears ? "engineering shear strain" : "axial strain, positive in the direction of the test");
    line("volumetric_strain", volumetric_strain(row), run_folder::bare, "volumetric strain, compression positive");
    add_stresses(line, record, row);
    add_state(line, record, row);
    file.add(line);
  }
}

std::vector<ResultTable> result_tables(const std::vector<TestRecord>& records)
{
  std::vector<ResultTable> tables;
  for (const TestRecord& record : records) {
    const std::vector<KeyResult> results = key_results(record);
    if (results.empty()) continue;
    const std::string title = words_of_kind(record);
    auto table = std::find_if(tables.begin(), tables.end(), [&](const ResultTable& t) { return t.title == title; });
    if (table == tables.end()) {
      table = tables.insert(table, {title, {}, {}});
      for (const KeyResult& result : results) table->rows.push_back({result.heading()});
    }
    table->tests.push_back(record.settings.name);
    for (std::size_t k = 0; k < results.size(); ++k) table->rows[k].push_back(results[k].shown());
  }
  return tables;
}

std::string words_of_kind(const TestRecord& record)
{
  std::string words = kind_word(record.settings.kind);
  std::replace(words.begin(), words.end(), '_', ' ');
  if (!is_compression(record.settings.kind)) words += drained(record.settings.kind) ? ", drained" : ", undrained";
  return shows_effective_stress(record) ? words : words + ", total stress";
}

std::string words_of_test(const TestRecord& record)
{
  const StartStress& start = start_of(record.settings.kind);
  const auto extends = [](const auto& kind) {
    if constexpr (requires { kind.direction; }) return kind.direction == Direction::extension ? ", in extension" : "";
    return "";
  };
  const std::string from = start.confining_stress
                               ? text::stress_words(*start.confining_stress)
                               : fmt::format("{} vertically, K0 = {:.4g}", text::stress_words(start.vertical()), start.k0.value_or(0));
  return fmt::format("{}{}, {}, from {}{}", words_of_kind(record), std::visit(extends, record.settings.kind), record.settings.material,
                     from, record.settings.strain_rate ? fmt::format(", {:.3g}/s", *record.settings.strain_rate) : "");
}

}  // namespace berm::element
