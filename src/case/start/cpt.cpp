// SPDX-License-Identifier: BSD-3-Clause
#include "start/cpt.hpp"

#include "input/units.hpp"
#include "os/control_characters.hpp"
#include "os/error.hpp"
#include "os/text_of_list.hpp"
#include "site/doubts.hpp"
#include "start/soils.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <regex>
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

/// Sand at its critical state, and what the angle of friction has beyond it by that of dilation: phi = phi_cv + 0.8 psi, of quartz (Bolton 1986).
constexpr Real phi_cv = 33 * degree, share_of_psi = 0.8;

Real dilation_angle(Real phi)
{
  return std::max((phi - phi_cv) / share_of_psi, Real(0));
}

/// A comment of a material without the strength that the sounding replaces. One of a soil by name says what is left of it.
std::string without_strength(const std::string& comment, bool first)
{
  static const std::vector<std::pair<std::regex, const char*>> strengths = {
      {std::regex("s_u = [0-9.]+ kPa \\+ [0-9.]+ kPa/m z"), "s_u from the sounding"},
      {std::regex("; E = [0-9.]+ [kM]Pa"), ""},
      {std::regex("phi = [0-9.]+ deg, (dilation|psi =) [0-9.]+ deg"), "phi and psi from the sounding"},
      {std::regex("phi = [0-9.]+ deg"), "phi and psi from the sounding"}};
  std::string text = comment;
  for (const auto& [strength, words] : strengths) text = std::regex_replace(text, strength, words);
  const bool of_template = text.starts_with("# Undrained") || text.starts_with("# Drained");
  return first && !of_template ? "# All but the strength is that of: " + text.substr(2) : text;
}

/// The lines of a table but those of some keys and its own header.
std::string without(const std::string& table, const std::vector<std::string>& keys)
{
  std::istringstream lines(table);
  std::string kept, line;
  std::getline(lines, line);
  for (bool first = true; std::getline(lines, line); first = false) {
    if (std::any_of(keys.begin(), keys.end(), [&](const std::string& key) { return line.starts_with(key + " = "); })) continue;
    kept += (line.starts_with("# ") ? without_strength(line, first) : line) + "\n";
  }
  return kept;
}

std::vector<site::Strength> down_to(Real base, std::vector<site::Strength> all)
{
  all.erase(std::find_if(all.begin() + 1, all.end(), [base](const site::Strength& one) { return one.top >= base; }), all.end());
  return all;
}

std::string source_of(const site::Sounding& sounding, Real submerged_unit_weight, const std::string& formula,
                      const std::vector<std::string>& doubts)
{
  std::string text = fmt::format("# From {}; {}: {}.\n", one_line(site::rows_of(sounding)), sounding.corrected, formula);
  if (const Real ratio = site::friction_ratio(sounding, submerged_unit_weight); ratio > 0)
    text += fmt::format("# Mean friction ratio {:.1f} %: sand has some 0.5 to 1 %, clay more than 2 %.\n", 100 * ratio);
  for (const std::string& doubt : doubts) text += fmt::format("# Warning: {}.\n", one_line(doubt));
  return text;
}

void add(std::vector<std::string>& doubts, const std::vector<std::string>& more)
{
  doubts.insert(doubts.end(), more.begin(), more.end());
}

CptCase clay(const std::string& table, const site::Sounding& sounding, Real base, Real N_kt)
{
  const Real weight = value_of(table, "submerged_unit_weight", "N/m^3");
  const site::StrengthProfile profile = site::undrained_strength(sounding, weight, N_kt);
  CptCase written = {"", site::doubts_of_rows(sounding, base)};
  add(written.doubts, site::doubts_of_clay(sounding, profile, weight));
  std::vector<std::string> depth, s_u;
  for (const site::Strength& one : down_to(base, profile.strength)) {
    depth.push_back(fmt::format("\"{:.2f} m\"", one.middle));
    s_u.push_back(fmt::format("\"{:.2f} kPa\"", one.value / 1000));
  }
  const std::string formula =
      fmt::format("s_u = (q_t - sigma_v0) / N_kt with N_kt = {:.3g}, of a range of 8 to 25 (Mayne and Peuchen 2018)", N_kt);
  written.text = fmt::format(
      "[material.clay]\n{}{}[material.clay.profile]               # means over layers of 0.1 m, and of a tenth of the "
      "depth below 1 m\ndepth = [{}]\nundrained_strength = [{}]\n",
      source_of(sounding, weight, formula, written.doubts), without(table, {"undrained_strength", "undrained_strength_gradient"}),
      text_of_list(depth, ", "), text_of_list(s_u, ", "));
  return written;
}

struct Sand {
  std::string materials, layers;
  std::vector<std::string> doubts;
};

Sand sand(const std::string& table, const site::Sounding& sounding, Real base, site::Correlation correlation)
{
  const Real weight = value_of(table, "submerged_unit_weight", "N/m^3");
  const bool kulhawy = correlation == site::Correlation::kulhawy_mayne;
  const std::string formula =
      kulhawy ? "phi by Kulhawy and Mayne (1990), 17.6 deg + 11 deg log10((q_t / p_a) / sqrt(sigma'_v0 / p_a)), 45 deg at most"
              : "phi by Robertson and Campanella (1983), tan phi = (log10(q_t / sigma'_v0) + 0.29) / 2.68, 45 deg at most";
  const site::StrengthProfile profile = site::friction_angle(sounding, weight, correlation);
  Sand written = {"", "", site::doubts_of_rows(sounding, base)};
  add(written.doubts, site::doubts_of_sand(sounding, profile, weight));
  const std::string dilation = ". psi = (phi - 33 deg) / 0.8 of quartz, 0 deg at least (Bolton 1986)";
  std::vector<std::string> tops;
  for (const site::Strength& one : down_to(base, profile.strength)) {
    const std::string name = tops.empty() && written.materials.empty() ? "sand" : fmt::format("sand_{}", tops.size() + 2);
    if (name != "sand") tops.push_back(fmt::format("{{ top = \"{:.2f} m\", material = \"{}\" }}", one.top, name));
    written.materials +=
        fmt::format("{}[material.{}]\n{}{}friction_angle = \"{:.1f} deg\"\ndilation_angle = \"{:.1f} deg\"\n", name == "sand" ? "" : "\n",
                    name, name == "sand" ? source_of(sounding, weight, formula + dilation, written.doubts) : "",
                    without(table, {"friction_angle", "dilation_angle"}), one.value / degree, dilation_angle(one.value) / degree);
  }
  if (!tops.empty()) written.layers = fmt::format("soil_layer = [{}]\n", text_of_list(tops, ", "));
  return written;
}

}  // namespace

bool takes_sounding(const std::string& text)
{
  const bool has_clay = table_of(text, "clay").begin != std::string::npos, has_sand = table_of(text, "sand").begin != std::string::npos;
  return has_clay != has_sand && text.find("\nsoil_layer = ") == std::string::npos;
}

CptCase with_cpt(const Kind& kind, const std::string& text, const site::Sounding& sounding, const CptChoice& choice)
{
  const Table of_clay = table_of(text, "clay"), of_sand = table_of(text, "sand");
  const bool has_clay = of_clay.begin != std::string::npos, has_sand = of_sand.begin != std::string::npos;
  if (!takes_sounding(text)) throw InputError(fmt::format("--cpt: {} takes no sounding; write its strengths into the file", kind.name));
  if (has_clay && choice.correlation) throw InputError(fmt::format("--phi is for sand, and {} is in clay: use --n-kt", kind.name));
  if (has_sand && choice.N_kt) throw InputError(fmt::format("--n-kt is for clay, and {} is in sand: use --phi", kind.name));
  const Table& table = has_clay ? of_clay : of_sand;
  const std::string own = text.substr(table.begin, table.end - table.begin), before = text.substr(0, table.begin),
                    after = text.substr(table.end);
  const Real base = value_of(text, "depth", "m");
  if (has_clay) {
    const CptCase written = clay(own, sounding, base, choice.N_kt.value_or(usual_N_kt));
    return {before + written.text + after, written.doubts};
  }
  const Sand written = sand(own, sounding, base, choice.correlation.value_or(usual_correlation));
  const std::string line = "\nmaterial = \"sand\"\n";
  const std::size_t end = after.find(line) + line.size();
  return {before + written.materials + after.substr(0, end) + written.layers + after.substr(end), written.doubts};
}

}  // namespace berm::start
