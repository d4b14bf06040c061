// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/report/results/results_section_test.cpp
#include "structures/pipe/display_units.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace berm::pipe {
namespace {

constexpr const char* nothing = "–";
constexpr Real largest_in_mm = 0.5;  // m: beyond this diameter lengths are told in m

/// Without an exponent in the range of engineering numbers.
std::string with_digits(Real value, int digits)
{
  const Real size = std::abs(value);
  if (size > 0 && (size < 1e-5 || size >= 1e7)) return fmt::format("{:.{}e}", value, digits - 1);
  const int before = size > 0 ? static_cast<int>(std::floor(std::log10(size))) + 1 : 1;
  return fmt::format("{:.{}f}", value, std::max(0, digits - before));
}

}  // namespace

std::string table_number(Real value)
{
  return std::isfinite(value) ? with_digits(value, 4) : nothing;
}

std::string short_number(Real value)
{
  if (!std::isfinite(value)) return nothing;
  std::string text = with_digits(value, 3);
  if (text.find('.') == std::string::npos || text.find('e') != std::string::npos) return text;
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text;
}

ForceMeasure force_measure(const RunRecord& run)
{
  const material::Material* material = touched_material(run.settings);
  const std::optional<material::Strength> soil = material == nullptr ? std::nullopt : strength_at_rest(*material);
  const Real D = run.scale.diameter;
  if (soil && soil->friction_angle == 0 && soil->cohesion > 0) return {ForceMeasure::Kind::strength, D * soil->cohesion};
  if (run.scale.unit_weight > 0) return {ForceMeasure::Kind::weight, run.scale.unit_weight * D * D};
  return {};
}

std::string letters_of(ForceMeasure::Kind kind)
{
  return kind == ForceMeasure::Kind::strength ? "D s<sub>u</sub>" : kind == ForceMeasure::Kind::weight ? "γ′ D²" : "";
}

DisplayUnits::DisplayUnits(const std::vector<RunRecord>& runs) : force_{1, "N/m"}, prototype_force_{1, "N/m"}, length_{1e-3, "mm"}
{
  Real largest = 0, largest_prototype = 0, diameter = 0;
  for (const RunRecord& run : runs) {
    if (!run.has_pipe()) continue;
    diameter = std::max(diameter, run.scale.diameter);
    const Real level = std::round(10 * run.scale.gravity_level) / 10;
    if (has_prototype(run.scale) && std::find(levels_.begin(), levels_.end(), level) == levels_.end()) levels_.push_back(level);
    by_weight_ = by_weight_ || force_measure(run).kind == ForceMeasure::Kind::weight;
    by_strength_ = by_strength_ || force_measure(run).kind == ForceMeasure::Kind::strength;
    for (const run_folder::Quantity& q : run.quantities) {
      if (q.unit != "N/m" || !std::isfinite(q.value)) continue;
      largest = std::max(largest, std::abs(q.value));
      largest_prototype = std::max(largest_prototype, std::abs(q.value) * run.scale.gravity_level);
    }
  }
  force_ = text::unit_of_forces(largest, 2);
  prototype_force_ = text::unit_of_forces(largest_prototype, 2);
  if (diameter > largest_in_mm) length_ = {1, "m"};
}

std::vector<text::HtmlCell> DisplayUnits::force_columns(const std::string& symbol) const
{
  std::vector<text::HtmlCell> cells{{fmt::format("{}, {}", symbol, force_.name), true}};
  if (by_weight_) cells.push_back({fmt::format("{}/({})", symbol, letters_of(ForceMeasure::Kind::weight)), true});
  if (by_strength_) cells.push_back({fmt::format("{}/({})", symbol, letters_of(ForceMeasure::Kind::strength)), true});
  if (!levels_.empty()) cells.push_back({fmt::format("{} in the prototype, {}", symbol, prototype_force_.name), true});
  return cells;
}

std::vector<text::HtmlCell> DisplayUnits::force_cells(const RunRecord& run, Real force) const
{
  const ForceMeasure measure = force_measure(run);
  const auto over = [&](ForceMeasure::Kind kind) { return kind == measure.kind ? table_number(force / measure.size) : nothing; };
  std::vector<text::HtmlCell> cells{{table_number(force / force_.size), true}};
  if (by_weight_) cells.push_back({over(ForceMeasure::Kind::weight), true});
  if (by_strength_) cells.push_back({over(ForceMeasure::Kind::strength), true});
  if (!levels_.empty())
    cells.push_back({has_prototype(run.scale) ? table_number(force * run.scale.gravity_level / prototype_force_.size) : nothing, true});
  return cells;
}

std::vector<text::HtmlCell> DisplayUnits::length_columns(const std::string& symbol) const
{
  std::vector<text::HtmlCell> cells{{symbol + "/D", true}, {fmt::format("{}, {}", symbol, length_.name), true}};
  if (!levels_.empty()) cells.push_back({symbol + " in the prototype, m", true});
  return cells;
}

std::vector<text::HtmlCell> DisplayUnits::length_cells(const RunRecord& run, Real length) const
{
  std::vector<text::HtmlCell> cells{{table_number(length / run.scale.diameter), true}, {table_number(length / length_.size), true}};
  if (!levels_.empty()) cells.push_back({has_prototype(run.scale) ? table_number(length * run.scale.gravity_level) : nothing, true});
  return cells;
}

std::string DisplayUnits::prototype_words() const
{
  if (levels_.empty()) return "";
  std::vector<std::string> levels;
  for (const Real level : levels_) levels.push_back(short_number(level));
  return text::html_paragraph(
      fmt::format("In the prototype, lengths and forces per metre are those of the model times the gravity level ({}).",
                  fmt::join(levels, ", ")),
      "quiet");
}

std::string DisplayUnits::force_text(const RunRecord& run, Real force) const
{
  const ForceMeasure measure = force_measure(run);
  std::string also;
  if (has_prototype(run.scale))
    also =
        fmt::format("{} {} in the prototype", short_number(force * run.scale.gravity_level / prototype_force_.size), prototype_force_.name);
  if (measure.kind != ForceMeasure::Kind::unknown)
    also += fmt::format("{}{} {}", also.empty() ? "" : ", ", short_number(force / measure.size), letters_of(measure.kind));
  const std::string model = fmt::format("{} {}", short_number(force / force_.size), force_.name);
  return also.empty() ? model : fmt::format("{} ({})", model, also);
}

std::string DisplayUnits::length_text(const RunRecord& run, Real length) const
{
  std::string also = fmt::format("{} {}", short_number(length / length_.size), length_.name);
  if (has_prototype(run.scale)) also += fmt::format(", {} m in the prototype", short_number(length * run.scale.gravity_level));
  return fmt::format("{} D ({})", short_number(length / run.scale.diameter), also);
}

}  // namespace berm::pipe
