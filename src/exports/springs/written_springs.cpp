// SPDX-License-Identifier: BSD-3-Clause
#include "springs/written_springs.hpp"

#include "os/control_characters.hpp"
#include "os/text_of_list.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace berm::springs {
namespace {

/// Words that are there, between commas.
std::string sentence(std::vector<std::string> words)
{
  std::erase(words, "");
  return one_line(text_of_list(words, ", "));
}

std::string state_words(const Springs& s)
{
  std::vector<std::string> known;
  if (!s.state_origin.empty()) known.push_back(s.state_origin);
  if (std::isfinite(s.embedment)) known.push_back(fmt::format("w = {:.4g} m", s.embedment));
  if (std::isfinite(s.V)) known.push_back(fmt::format("V = {:.4g} N/m", s.V));
  const std::string within = known.empty() ? "" : fmt::format(" ({})", text_of_list(known, ", "));
  return (s.state.empty() ? "state at the end of the push" : "state " + s.state) + within;
}

/// Of undrained clay: that its axial resistance is neither remoulded nor set up.
std::string axial_strength_words(const Springs& s)
{
  if (!(s.axial.undrained > 0) || s.axial.strength.empty()) return "";
  std::string words = "The axial spring has the strength of " + s.axial.strength + ": not remoulded, and without set-up by consolidation";
  if (s.axial.sensitivity > 1)
    words += fmt::format("; remoulded it is 1/{:.3g} of that (sensitivity), {:.4g} N/m", s.axial.sensitivity,
                         s.axial.undrained / s.axial.sensitivity);
  return words;
}

std::string run_words(const Springs& s)
{
  return s.run.empty() ? "" : "run " + s.run;
}

}  // namespace

std::vector<std::pair<std::string, const Springs*>> sets_of(const Design& design)
{
  std::vector<std::pair<std::string, const Springs*>> sets;
  if (design.low) sets.emplace_back("low", &*design.low);
  sets.emplace_back("best", &design.best);
  if (design.high) sets.emplace_back("high", &*design.high);
  return sets;
}

const char* peak_words(const Lateral& l)
{
  if (l.breaks) return "H at breakout";
  return std::isnan(l.berm) ? "largest H" : "residual H before the berm";
}

std::string origin_of(const Springs& s, const Lateral& l)
{
  const std::string other = l.state.empty() || l.state == s.state ? "" : fmt::format(" of the pipe in state {}", l.state);
  return sentence(
      {run_words(s), state_words(s), "travel " + l.stage + other, "computed",
       std::isnan(l.largest) ? "" : fmt::format("largest H {:.6g} N/m at u = {:.4g} m, behind its first peak", l.largest, l.u_largest),
       std::isnan(l.residual) ? "no residual" : "",
       std::isnan(l.berm) ? "" : fmt::format("{:.6g} N/m against a berm at its end, which is not a residual", l.berm)});
}

std::string axial_origin(const Springs& s)
{
  const bool undrained = !std::isnan(s.axial.undrained);
  const std::string& source = undrained ? s.axial.undrained_source : s.axial.drained_source;
  return sentence({run_words(s), state_words(s), "no travel: a plane across the pipe has none along it",
                   undrained ? "undrained" : "drained", source.empty() ? "by a formula with the interface of the case" : "by " + source,
                   "displacement by " + axial_breakout_source()});
}

std::string axial_title(const Springs& s)
{
  return std::isnan(s.axial.undrained) ? "axial, drained" : s.axial.strength.empty() ? "axial" : "axial, " + s.axial.strength;
}

std::string push_origin(const Springs& s)
{
  const Real deepest = s.vertical.curve.empty() ? nan : s.vertical.curve.back().x;
  const auto unloading = std::ranges::find_if(s.vertical.unloading, [](const Unloading& u) { return is_stiffness(u.stiffness); });
  return sentence(
      {run_words(s), "from the surface of the bed down", "travel push", "computed",
       "virgin curve: it is followed where V is larger than ever before",
       unloading == s.vertical.unloading.end()
           ? "stiffness of unloading and reloading not known"
           : fmt::format("unloading and reloading have {:.4g} N/m2 (stage {}; springs.csv has it)", unloading->stiffness, unloading->stage),
       s.embedment > deepest * (1 + 1e-6) ? fmt::format("it ends at w = {:.4g} m, above the pipe in {}", deepest, state_words(s))
                                          : "for " + state_words(s)});
}

Points axial_spring(const Springs& s)
{
  const Real F = std::isnan(s.axial.undrained) ? s.axial.drained : s.axial.undrained;
  if (!(F > 0)) return {};
  return {{0, 0}, {s.axial.breakout, F}, {s.diameter, F}};
}

Real axial_V(const Springs& s)
{
  if (!std::isnan(s.V)) return s.V;
  return s.lateral.empty() ? nan : s.lateral[0].V;
}

Points push_of(const Springs& s)
{
  Points points{{0, 0}};
  for (const Point& p : s.vertical.curve)
    if (p.x > points.back().x) points.push_back(p);
  return points;
}

std::vector<WrittenSpring> springs_to_write(const Springs& s)
{
  std::vector<WrittenSpring> all;
  for (const Lateral& l : s.lateral)
    if (Points points = l.spring(); points.size() > 1)
      all.push_back({Direction::lateral, l.stage, std::move(points), l.V, origin_of(s, l)});
  if (Points points = axial_spring(s); !points.empty())
    all.push_back({Direction::axial, "", std::move(points), axial_V(s), axial_origin(s)});
  if (Points points = push_of(s); points.size() > 1) all.push_back({Direction::vertical, "push", std::move(points), nan, push_origin(s)});
  return all;
}

Points both_ways(const Points& spring)
{
  Points points;
  for (auto p = spring.rbegin(); p != spring.rend(); ++p)
    if (p->x > 0) points.push_back({-p->x, -p->F});
  points.insert(points.end(), spring.begin(), spring.end());
  return points;
}

Points upwards_positive(const Points& push, Real lift)
{
  Points points;
  for (auto p = push.rbegin(); p != push.rend(); ++p) points.push_back(p->x > 0 ? Point{-p->x, -p->F} : Point{0, 0});
  points.push_back({lift, 0});
  return points;
}

Points level_beyond(Points spring, Real length)
{
  spring.push_back({spring.back().x + length, spring.back().F});
  return spring;
}

NormalStiffness normal_stiffness(const Springs& s)
{
  for (const Unloading& u : s.vertical.unloading)
    if (is_stiffness(u.stiffness)) return {u.stiffness, sentence({run_words(s), "travel " + u.stage, "slope, computed"})};
  if (const Points push = push_of(s); push.size() > 1)
    return {push.back().F / push.back().x, "secant to the end of the push: " + push_origin(s)};
  return {};
}

std::string without_friction(const std::string& spring)
{
  return spring + " has no coefficient of friction: V is not positive";
}

std::string remark(const std::string& mark, const std::string& text)
{
  constexpr std::size_t most = 120;
  std::string rest = one_line(text), lines;
  while (rest.size() > most) {
    const std::size_t space = rest.rfind(' ', most);
    if (space == std::string::npos || space == 0) break;
    lines += mark + rest.substr(0, space) + "\n";
    rest.erase(0, space + 1);
  }
  return lines + mark + rest + "\n";
}

std::string comments(const Design& design, const std::string& mark, const std::vector<std::string>& remarks)
{
  std::string text;
  for (const std::string& line : design.provenance) text += remark(mark, line);
  for (const std::string& line : design.best.missing) text += remark(mark, line);
  if (const std::string line = axial_strength_words(design.best); !line.empty()) text += remark(mark, line);
  for (const std::string& line : remarks) text += remark(mark, line);
  if (design.best.scale != 1) text += fmt::format("{}prototype: {:.6g} times the size of the model\n", mark, design.best.scale);
  return text;
}

std::string identifier(const std::string& name, std::size_t max)
{
  std::string text;
  for (const char c : name)
    text += std::isalnum(static_cast<unsigned char>(c)) != 0 ? static_cast<char>(std::toupper(static_cast<unsigned char>(c))) : '_';
  return text.substr(0, max);
}

}  // namespace berm::springs
