// SPDX-License-Identifier: BSD-3-Clause
#include "os/text_of_list.hpp"
#include "report/setup/setup_section.hpp"

#include "material/laws.hpp"
#include "settings/body_soil.hpp"
#include "settings/symmetry.hpp"
#include "text/html.hpp"
#include "text/quantity_words.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::report {
namespace {

/// Depths (m) at which a profile of the material has an entry.
std::vector<Real> profile_depths(const material::Material& material)
{
  return visit(
      [](const auto& law) -> std::vector<Real> {
        if constexpr (requires { law.profile.depth; }) return law.profile.depth;
        return {};
      },
      material);
}

/// The depth of the bed; NaN where the mesh does not tell it.
Real bed_depth(const settings::Case& c)
{
  const auto* bed = std::get_if<mesh::SeabedMesh>(&c.mesh);
  return bed == nullptr ? nan : bed->depth;
}

/// The depths between which the soil of a region is linear, from 0; the last is that of the bed, or NaN.
std::vector<Real> parts_of(const settings::BodySoil& soil, const std::string& region, Real bed)
{
  std::vector<Real> depths = {0};
  const bool has_layers = soil.of_region.find(region) == soil.of_region.end();
  for (const settings::SoilLayer& layer : soil.layers)
    if (has_layers) depths.push_back(layer.top);
  for (const material::Material& material : soil.materials)
    for (const Real depth : profile_depths(material)) depths.push_back(depth);
  std::erase_if(depths, [&](Real depth) { return depth < 0 || depth >= bed; });
  std::sort(depths.begin(), depths.end());
  depths.erase(std::unique(depths.begin(), depths.end()), depths.end());
  depths.push_back(bed);
  return depths;
}

/// "2 kPa" or "2 kPa to 5 kPa".
std::string from_to(const std::string& top, const std::string& bottom)
{
  return top == bottom ? top : top + " to " + bottom;
}

std::vector<text::HtmlCell> row_of(const settings::BodySoil& soil, const std::string& region, Real top, Real bottom)
{
  const bool ends = std::isfinite(bottom);
  // A layer's own values at its bottom are those just above it.
  const material::Material upper = soil.at(region, top), lower = soil.at(region, ends ? std::nextafter(bottom, top) : top);
  const std::string depth = ends ? fmt::format("{} to {}", text::length_words(top), text::length_words(bottom))
                                 : fmt::format("from {} down", text::length_words(top));
  const auto stress = [&](auto of) { return from_to(text::stress_words(of(upper)), text::stress_words(of(lower))); };
  const auto angle = [&](auto of) { return text::angle_words(of(*strength_at_rest(upper))); };
  const bool yields = strength_at_rest(upper).has_value();
  return {{depth},
          {text::html_text(soil.names[soil.material_index_at(region, top)])},
          {yields ? stress([](const material::Material& m) { return strength_at_rest(m)->cohesion; }) : "–"},
          {yields ? angle([](const material::Strength& s) { return s.friction_angle; }) : "–"},
          {stress([](const material::Material& m) {
            const auto [E, nu] = young_poisson(m);
            return E;
          })},
          {fmt::format("{:.4g} kg/m³", density(upper))}};
}

std::vector<std::vector<text::HtmlCell>> rows_of(const settings::BodySoil& soil, const std::string& region, Real bed)
{
  const std::vector<Real> depths = parts_of(soil, region, bed);
  std::vector<std::vector<text::HtmlCell>> rows;
  for (std::size_t k = 0; k + 1 < depths.size(); ++k) rows.push_back(row_of(soil, region, depths[k], depths[k + 1]));
  return rows;
}

/// The rows of a case with their groups, as HTML cells.
using Groups = std::vector<std::pair<std::string, std::vector<std::vector<text::HtmlCell>>>>;

Groups groups_of(const settings::Case& c)
{
  Groups groups;
  const Real bed = bed_depth(c);
  for (const auto& [name, settings] : c.body) {
    const settings::BodySoil soil = soil_of(c, settings);
    if (!varies(soil)) continue;
    groups.emplace_back(fmt::format("body {}", name), rows_of(soil, "", bed));
    for (const auto& [region, number] : soil.of_region)
      groups.emplace_back(fmt::format("body {}, region {}", name, region), rows_of(soil, region, bed));
  }
  return groups;
}

std::string signature(const Groups& groups)
{
  std::string all;
  for (const auto& [name, rows] : groups) {
    all += name + "\n";
    for (const auto& row : rows)
      for (const text::HtmlCell& cell : row) all += cell.content + "\t";
  }
  return all;
}

}  // namespace

std::string soil_over_depth(const std::vector<record::RunRecord>& runs)
{
  std::vector<std::pair<Groups, std::vector<std::string>>> soils;
  for (const record::RunRecord& run : runs) {
    const Groups groups = groups_of(run.settings);
    if (groups.empty()) continue;
    const auto same =
        std::find_if(soils.begin(), soils.end(), [&](const auto& soil) { return signature(soil.first) == signature(groups); });
    if (same == soils.end())
      soils.push_back({groups, {run.name}});
    else
      same->second.push_back(run.name);
  }
  if (soils.empty()) return "";
  text::HtmlTable table(
      "soil-table",
      "Soil over depth below the bed's surface at the start: linear in each row, except where it follows from the vertical stress");
  table.columns({{"depth"}, {"material"}, {"cohesion or undrained strength"}, {"friction angle"}, {"Young's modulus"}, {"density"}});
  for (const auto& [groups, names] : soils)
    for (const auto& [name, rows] : groups) {
      table.row({{text::html_text(fmt::format("{}: {}", text_of_list(names, ", "), name))}}, "group");
      for (const auto& row : rows) table.row(row);
    }
  return table.html();
}

}  // namespace berm::report
