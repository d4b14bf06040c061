// SPDX-License-Identifier: BSD-3-Clause
#include "structures/base/display_units.hpp"

#include "os/text_of_list.hpp"
#include "text/quantity_words.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::base {
namespace {

constexpr Real largest_in_mm = 0.5;  // m: beyond this width lengths are told in m

/// Stress times length, in space times area: lengths go with the gravity level.
Real in_prototype(const BodyScale& scale, Real force)
{
  return scale.dimension == 2 ? force * scale.gravity_level : force * scale.gravity_level * scale.gravity_level;
}

}  // namespace

ForceMeasure force_measure(const BodyScale& scale)
{
  if (scale.dimension != 2) return {};
  const Real D = scale.width;
  if (scale.strength > 0) return {ForceMeasure::Kind::strength, D * scale.strength};
  if (scale.unit_weight > 0) return {ForceMeasure::Kind::weight, scale.unit_weight * D * D};
  return {};
}

std::optional<run_folder::Quantity> measure_quantity(const BodyScale& scale)
{
  const ForceMeasure measure = force_measure(scale);
  if (!(measure.size > 0)) return {};
  const bool by_strength = measure.kind == ForceMeasure::Kind::strength;
  return run_folder::Quantity{by_strength ? "suD" : "gammaD2", measure.size, "N/m", by_strength ? "D s_u" : "γ′ D²"};
}

std::string letters_of(ForceMeasure::Kind kind)
{
  return kind == ForceMeasure::Kind::strength ? "D s<sub>u</sub>" : kind == ForceMeasure::Kind::weight ? "γ′ D²" : "";
}

std::string DisplayUnits::ForceUnit::heading(bool some_in_plane, bool some_in_space) const
{
  return some_in_plane && some_in_space ? fmt::format("{}, whole body {}", plane.name, space.name)
         : some_in_space                ? space.name
                                        : plane.name;
}

DisplayUnits::DisplayUnits(const std::vector<ScaledRun>& runs) : length_{1e-3, "mm"}
{
  Real largest = 0, largest_prototype = 0, width = 0;
  for (const auto& [scale, quantities] : runs) {
    if (!(scale.width > 0)) continue;
    width = std::max(width, scale.width);
    (scale.dimension == 2 ? in_plane_ : in_space_) = true;
    const Real level = std::round(10 * scale.gravity_level) / 10;
    if (has_prototype(scale) && std::find(levels_.begin(), levels_.end(), level) == levels_.end()) levels_.push_back(level);
    const std::pair strength(scale.strength, scale.strength_depth);
    if (scale.strength_depth > 0 && std::find(strengths_.begin(), strengths_.end(), strength) == strengths_.end())
      strengths_.push_back(strength);
    by_weight_ = by_weight_ || force_measure(scale).kind == ForceMeasure::Kind::weight;
    by_strength_ = by_strength_ || force_measure(scale).kind == ForceMeasure::Kind::strength;
    for (const run_folder::Quantity& q : *quantities) {
      if ((q.unit != "N/m" && q.unit != "N") || !std::isfinite(q.value)) continue;
      largest = std::max(largest, std::abs(q.value));
      largest_prototype = std::max(largest_prototype, std::abs(in_prototype(scale, q.value)));
    }
  }
  force_ = {text::unit_of_forces(largest, 2), text::unit_of_forces(largest, 3)};
  prototype_force_ = {text::unit_of_forces(largest_prototype, 2), text::unit_of_forces(largest_prototype, 3)};
  if (width > largest_in_mm) length_ = {1, "m"};
}

std::vector<text::HtmlCell> DisplayUnits::force_columns(const std::string& symbol) const
{
  std::vector<text::HtmlCell> cells{{fmt::format("{}, {}", symbol, force_.heading(in_plane_, in_space_)), true}};
  if (by_weight_) cells.push_back({fmt::format("{}/({})", symbol, letters_of(ForceMeasure::Kind::weight)), true});
  if (by_strength_) cells.push_back({fmt::format("{}/({})", symbol, letters_of(ForceMeasure::Kind::strength)), true});
  if (!levels_.empty())
    cells.push_back({fmt::format("{} in the prototype, {}", symbol, prototype_force_.heading(in_plane_, in_space_)), true});
  return cells;
}

std::vector<text::HtmlCell> DisplayUnits::force_cells(const BodyScale& scale, Real force) const
{
  const ForceMeasure measure = force_measure(scale);
  const auto over = [&](ForceMeasure::Kind kind) {
    return kind == measure.kind ? text::table_number(force / measure.size) : text::no_number;
  };
  std::vector<text::HtmlCell> cells{{text::table_number(in_force_unit(force)), true}};
  if (by_weight_) cells.push_back({over(ForceMeasure::Kind::weight), true});
  if (by_strength_) cells.push_back({over(ForceMeasure::Kind::strength), true});
  if (!levels_.empty())
    cells.push_back(
        {has_prototype(scale) ? text::table_number(in_prototype(scale, force) / prototype_force_.plane.size) : text::no_number, true});
  return cells;
}

std::vector<text::HtmlCell> DisplayUnits::length_columns(const std::string& symbol) const
{
  std::vector<text::HtmlCell> cells{{symbol + "/D", true}, {fmt::format("{}, {}", symbol, length_.name), true}};
  if (!levels_.empty()) cells.push_back({symbol + " in the prototype, m", true});
  return cells;
}

std::vector<text::HtmlCell> DisplayUnits::length_cells(const BodyScale& scale, Real length) const
{
  std::vector<text::HtmlCell> cells{{text::table_number(length / scale.width), true}, {text::table_number(length / length_.size), true}};
  if (!levels_.empty()) cells.push_back({has_prototype(scale) ? text::table_number(length * scale.gravity_level) : text::no_number, true});
  return cells;
}

std::string DisplayUnits::scale_words() const
{
  std::vector<std::string> strengths;
  for (const auto& [strength, depth] : strengths_)
    strengths.push_back(fmt::format("{} at a depth of {}", text::stress_words(strength), text::length_words(depth)));
  std::string words;
  if (!strengths.empty())
    words = text::html_paragraph(fmt::format("Strength varies with depth: s_u is that at the depth of the lowest point of the body at the "
                                             "end of its push, below the surface at the start ({}).",
                                             text_of_list(strengths, "; ")),
                                 "quiet");
  if (levels_.empty()) return words;
  std::vector<std::string> levels;
  for (const Real level : levels_) levels.push_back(text::short_number(level));
  return words + text::html_paragraph(
                     fmt::format("In the prototype, lengths and forces per metre are those of the model times the gravity level ({}){}.",
                                 text_of_list(levels, ", "), in_space_ ? ", forces on whole bodies those times its square" : ""),
                     "quiet");
}

std::string DisplayUnits::force_text(const BodyScale& scale, Real force) const
{
  const ForceMeasure measure = force_measure(scale);
  std::string also;
  if (has_prototype(scale))
    also = fmt::format("{} {} in the prototype", text::short_number(in_prototype(scale, force) / prototype_force_.plane.size),
                       prototype_force_.of(scale).name);
  if (measure.kind != ForceMeasure::Kind::unknown)
    also += fmt::format("{}{} {}", also.empty() ? "" : ", ", text::short_number(force / measure.size), letters_of(measure.kind));
  const std::string model = fmt::format("{} {}", text::short_number(in_force_unit(force)), force_.of(scale).name);
  return also.empty() ? model : fmt::format("{} ({})", model, also);
}

std::string DisplayUnits::length_text(const BodyScale& scale, Real length) const
{
  std::string also = fmt::format("{} {}", text::short_number(length / length_.size), length_.name);
  if (has_prototype(scale)) also += fmt::format(", {} m in the prototype", text::short_number(length * scale.gravity_level));
  return fmt::format("{} D ({})", text::short_number(length / scale.width), also);
}

std::string printed_range(const char* range)
{
  constexpr std::pair<const char*, const char*> signs[] = {{"&lt;=", "≤"},
                                                           {"&gt;=", "≥"},
                                                           {"phi", "φ"},
                                                           {"psi", "ψ"},
                                                           {"delta", "δ"},
                                                           {" deg", "°"},
                                                           {"s_u0", "s<sub>u0</sub>"},
                                                           {"s_u", "s<sub>u</sub>"},
                                                           {"V_max", "V<sub>max</sub>"},
                                                           {"I_r", "I<sub>r</sub>"}};
  std::string text = text::html_text(range);
  for (const auto& [plain, sign] : signs)
    for (std::size_t at = text.find(plain); at != std::string::npos; at = text.find(plain, at + 1))
      text.replace(at, std::string(plain).size(), sign);
  return text;
}

}  // namespace berm::base
