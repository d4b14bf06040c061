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

/// What the axial resistance is of, and between which it may be later.
std::string axial_strength_words(const Springs& s)
{
  const Axial& axial = s.axial;
  if (!(axial.breakout() > 0)) return "";
  std::string words;
  if (axial.undrained > 0 && !axial.strength.empty())
    words = fmt::format("Axial breakout {:.4g} N/m has the strength of {}{}", axial.undrained, axial.strength,
                        axial.set_up.empty() ? ", without set-up by consolidation" : "");
  if (axial.sensitivity > 1)
    words += fmt::format("; remoulded it is 1/{:.3g} of that (sensitivity): axial residual {:.4g} N/m", axial.sensitivity, axial.residual);
  for (const SetUp& rest : axial.set_up)
    words += fmt::format("{}Axial set-up in {}: {:.4g} to {:.4g} N/m at U = {:.3g}", words.empty() ? "" : ". ", rest.stage, rest.before,
                         rest.after, rest.degree);
  if (const Range band = axial.cyclic(); band.high > band.low * (1 + 1e-9))
    words += fmt::format("{}After cycles the axial resistance is between {:.4g} ({}) and {:.4g} N/m ({})", words.empty() ? "" : ". ",
                         band.low, axial.residual < axial.breakout() ? "undrained, remoulded" : "that of breakout", band.high,
                         band.high > axial.breakout() ? "drained, no excess pore pressure left"
                         : std::isnan(axial.drained)  ? "that of breakout: the drained one is not known without friction of the interface"
                                                      : "that of breakout");
  return words;
}

/// V over w of the push from the surface on.
Points virgin_curve(const Springs& s)
{
  Points points{{0, 0}};
  for (const Point& p : s.vertical.curve)
    if (p.x > points.back().x) points.push_back(p);
  return points;
}

Real deepest_virgin(const Springs& s)
{
  return s.vertical.curve.empty() ? 0 : s.vertical.curve.back().x;
}

/// Whether the pipe lies in the bed under a load in the state.
bool lies_in_state(const Springs& s)
{
  return s.V > 0 && s.embedment > 0;
}

/// Steep enough that the pipe does not rise out of the bed before it is without load.
Real state_stiffness(const Springs& s)
{
  return std::max(normal_stiffness(s).value, s.V / s.embedment);
}

Real preload_of(const Springs& s)
{
  return std::isnan(s.vertical.preload) ? s.V : std::max(s.vertical.preload, s.V);
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
      {run_words(s), state_words(s), l.stage + other, "computed",
       std::isnan(l.largest) ? "" : fmt::format("largest H {:.6g} N/m at u = {:.4g} m, after its first peak", l.largest, l.u_largest),
       std::isnan(l.residual) ? "no residual" : "",
       std::isnan(l.berm) ? "" : fmt::format("{:.6g} N/m against a berm at its end, which is not a residual", l.berm)});
}

std::string axial_origin(const Springs& s)
{
  const bool undrained = !std::isnan(s.axial.undrained);
  const std::string& source = undrained ? s.axial.undrained_source : s.axial.drained_source;
  return sentence({run_words(s), state_words(s), "not computed in plane strain", undrained ? "undrained" : "drained",
                   "by " + (source.empty() ? "a formula with the interface of the case" : source),
                   "displacements by " + axial_displacement_source()});
}

std::string axial_title(const Springs& s)
{
  return std::isnan(s.axial.undrained) ? "axial, drained" : s.axial.strength.empty() ? "axial" : "axial, " + s.axial.strength;
}

std::string vertical_origin(const Springs& s)
{
  const Points points = vertical_spring(s);
  if (!lies_in_state(s)) return sentence({run_words(s), "from the seabed down", "push", "computed, virgin curve"});
  const Real preload = preload_of(s);
  return sentence(
      {run_words(s), state_words(s), "push",
       fmt::format("computed: unloading and reloading have {:.4g} N/m2 ({}), from V = 0 at w = {:.4g} m to the preload of {:.4g} N/m",
                   state_stiffness(s), normal_stiffness(s).origin, points.back().x - from_rest(points).back().x, preload),
       deepest_virgin(s) > points.back().x * (1 - 1e-9) ? "the virgin curve beyond"
                                                        : "beyond it the last slope of the virgin curve, which was not followed so deep"});
}

Points axial_spring(const Springs& s, Real Range::*estimate)
{
  const Real F = s.axial.breakout(), residual = s.axial.residual;
  if (!(F > 0)) return {};
  Points points{{0, 0}, {s.axial.u_breakout.*estimate, F}};
  if (residual < F) points.push_back({s.axial.u_residual.*estimate, residual});
  points.push_back({std::max(s.diameter, 2 * points.back().x), points.back().F});
  return points;
}

Real axial_V(const Springs& s)
{
  if (!std::isnan(s.V)) return s.V;
  return s.lateral.empty() ? nan : s.lateral[0].V;
}

Points vertical_spring(const Springs& s)
{
  const Points virgin = virgin_curve(s);
  if (virgin.size() < 2 || !lies_in_state(s)) return virgin.size() < 2 ? Points{} : virgin;
  const Real k = state_stiffness(s), preload = preload_of(s);
  Points points{{0, 0}};
  const auto add = [&](Real x, Real F) {
    if (x > points.back().x * (1 + 1e-12)) points.push_back({x, F});
  };
  add(s.embedment - s.V / k, 0);
  add(s.embedment, s.V);
  add(s.embedment + (preload - s.V) / k, preload);
  const std::size_t known = points.size();
  for (const Point& p : virgin)
    if (p.F > points.back().F) add(p.x, p.F);
  if (points.size() > known) return points;
  const Point &end = virgin.back(), &before = virgin[virgin.size() - 2];
  const Real slope = end.F > before.F ? (end.F - before.F) / (end.x - before.x) : end.F / end.x, more = 0.1 * s.diameter;
  add(points.back().x + more, points.back().F + std::min(slope, k) * more);
  return points;
}

Points from_rest(Points vertical)
{
  std::size_t last = 0;
  while (last + 1 < vertical.size() && !(vertical[last + 1].F > 0)) ++last;
  vertical.erase(vertical.begin(), vertical.begin() + static_cast<std::ptrdiff_t>(last));
  const Real rest = vertical.empty() ? 0 : vertical.front().x;
  for (Point& p : vertical) p.x -= rest;
  return vertical;
}

std::string rest_words(const Springs& s)
{
  const Points all = vertical_spring(s);
  if (all.size() < 2) return "";
  return fmt::format("Vertical displacements are from the unloaded pipe, {:.6g} m below the seabed: under V of the state its embedment is "
                     "that of the state.",
                     all.back().x - from_rest(all).back().x);
}

std::vector<WrittenSpring> springs_to_write(const Springs& s)
{
  std::vector<WrittenSpring> all;
  for (const Lateral& l : s.lateral)
    if (Points points = l.spring(); points.size() > 1)
      all.push_back({Direction::lateral, l.stage, std::move(points), l.V, origin_of(s, l)});
  if (Points points = axial_spring(s); !points.empty())
    all.push_back({Direction::axial, "", std::move(points), axial_V(s), axial_origin(s)});
  if (Points points = vertical_spring(s); points.size() > 1)
    all.push_back({Direction::vertical, "push", std::move(points), nan, vertical_origin(s)});
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
  for (auto p = push.rbegin(); p != push.rend(); ++p) points.push_back({0 - p->x, 0 - p->F});
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
    if (is_stiffness(u.stiffness)) return {u.stiffness, sentence({run_words(s), u.stage, "slope, computed"})};
  if (is_stiffness(s.vertical.rebound)) return {s.vertical.rebound, "by " + s.vertical.rebound_source};
  if (const Points push = virgin_curve(s); push.size() > 1)
    return {push.back().F / push.back().x, sentence({run_words(s), "push", "secant to its end, computed"})};
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
  for (const std::string& line : remarks)
    if (!line.empty()) text += remark(mark, line);
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
