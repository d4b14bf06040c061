// SPDX-License-Identifier: BSD-3-Clause
#include "start/cpt.hpp"

#include "core/error.hpp"
#include "input/units.hpp"
#include "start/soils.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <numbers>
#include <sstream>

namespace berm::start {
namespace {

/// The quantity that a key has in a text, such as "6 kN/m^3", in its SI unit.
Real value_of(const std::string& text, const std::string& key, const std::string& unit)
{
  const std::string begin = "\n" + key + " = \"";
  const std::size_t first = text.find(begin) + begin.size();
  return input::to_si(text.substr(first, text.find('"', first) - first), unit);
}

/// The lines of a table but those of some keys and its own header.
std::string without(const std::string& table, const std::vector<std::string>& keys)
{
  std::istringstream lines(table);
  std::string kept, line;
  std::getline(lines, line);
  while (std::getline(lines, line))
    if (std::none_of(keys.begin(), keys.end(), [&](const std::string& key) { return line.starts_with(key + " = "); })) kept += line + "\n";
  return kept;
}

std::vector<site::Strength> down_to(Real base, std::vector<site::Strength> all)
{
  all.erase(std::find_if(all.begin() + 1, all.end(), [base](const site::Strength& one) { return one.top >= base; }), all.end());
  return all;
}

std::string source_of(const site::Sounding& sounding, Real submerged_unit_weight, const std::string& formula)
{
  std::string text = fmt::format("# From {}, {:.2f} to {:.2f} m, {}: {}.\n", sounding.file, sounding.depth.front(), sounding.depth.back(),
                                 sounding.corrected, formula);
  if (const Real ratio = site::friction_ratio(sounding, submerged_unit_weight); ratio > 0)
    text += fmt::format("# Mean friction ratio {:.1f} %: sand has some 0.5 to 1 %, clay more than 2 %.\n", 100 * ratio);
  if (sounding.left_out > 0) text += fmt::format("# {} rows without a value are left out.\n", sounding.left_out);
  return text;
}

std::string clay(const std::string& table, const site::Sounding& sounding, Real base, Real N_kt)
{
  const Real weight = value_of(table, "submerged_unit_weight", "N/m^3");
  std::vector<std::string> depth, s_u;
  for (const site::Strength& one : down_to(base, site::undrained_strength(sounding, weight, N_kt))) {
    depth.push_back(fmt::format("\"{:.2f} m\"", one.middle));
    s_u.push_back(fmt::format("\"{:.2f} kPa\"", one.value / 1000));
  }
  const std::string formula =
      fmt::format("s_u = (q_t - sigma_v0) / N_kt with N_kt = {:.3g}, of a range of 8 to 25 (Mayne and Peuchen 2018)", N_kt);
  return fmt::format("[material.clay]\n{}{}[material.clay.profile]               # means over layers of 0.1 m, and of a tenth of the depth "
                     "below 1 m\ndepth = [{}]\nundrained_strength = [{}]\n",
                     source_of(sounding, weight, formula), without(table, {"undrained_strength", "undrained_strength_gradient"}),
                     fmt::join(depth, ", "), fmt::join(s_u, ", "));
}

struct Sand {
  std::string materials, layers;
};

Sand sand(const std::string& table, const site::Sounding& sounding, Real base, site::Correlation correlation)
{
  const Real weight = value_of(table, "submerged_unit_weight", "N/m^3");
  const bool kulhawy = correlation == site::Correlation::kulhawy_mayne;
  const std::string formula =
      kulhawy ? "phi by Kulhawy and Mayne (1990), 17.6 deg + 11 deg log10((q_t / p_a) / sqrt(sigma'_v0 / p_a)), 45 deg at most"
              : "phi by Robertson and Campanella (1983), tan phi = (log10(q_t / sigma'_v0) + 0.29) / 2.68, 45 deg at most";
  Sand written;
  std::vector<std::string> tops;
  for (const site::Strength& one : down_to(base, site::friction_angle(sounding, weight, correlation))) {
    const std::string name = tops.empty() && written.materials.empty() ? "sand" : fmt::format("sand_{}", tops.size() + 2);
    if (name != "sand") tops.push_back(fmt::format("{{ top = \"{:.2f} m\", material = \"{}\" }}", one.top, name));
    written.materials += fmt::format("{}[material.{}]\n{}{}friction_angle = \"{:.1f} deg\"\n", name == "sand" ? "" : "\n", name,
                                     name == "sand" ? source_of(sounding, weight, formula) : "", without(table, {"friction_angle"}),
                                     one.value * 180 / std::numbers::pi);
  }
  if (!tops.empty()) written.layers = fmt::format("soil_layer = [{}]\n", fmt::join(tops, ", "));
  return written;
}

}  // namespace

std::string with_cpt(const Kind& kind, const std::string& text, const site::Sounding& sounding, const CptChoice& choice)
{
  const Table of_clay = table_of(text, "clay"), of_sand = table_of(text, "sand");
  const bool has_clay = of_clay.begin != std::string::npos, has_sand = of_sand.begin != std::string::npos;
  if (has_clay == has_sand || text.find("\nsoil_layer = ") != std::string::npos)
    throw InputError(fmt::format("--cpt: {} takes no sounding; write its strengths into the file", kind.name));
  const Table& table = has_clay ? of_clay : of_sand;
  const std::string own = text.substr(table.begin, table.end - table.begin), before = text.substr(0, table.begin),
                    after = text.substr(table.end);
  const Real base = value_of(text, "depth", "m");
  if (has_clay) return before + clay(own, sounding, base, choice.N_kt) + after;
  const Sand written = sand(own, sounding, base, choice.correlation);
  const std::string line = "\nmaterial = \"sand\"\n";
  const std::size_t end = after.find(line) + line.size();
  return before + written.materials + after.substr(0, end) + written.layers + after.substr(end);
}

}  // namespace berm::start
