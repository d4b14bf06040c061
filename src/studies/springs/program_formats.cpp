// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/springs/formats_test.cpp
#include "springs/formats.hpp"

#include <cmath>
#include <fmt/format.h>

namespace berm::springs {
namespace {

/// Lines of provenance behind a mark that begins a comment.
std::string comments(const Design& design, const std::string& mark, const std::string& units)
{
  std::string text;
  for (const std::string& line : design.provenance) text += mark + line + "\n";
  return text + mark + units + "\n" +
         (design.best.scale != 1 ? fmt::format("{}prototype: {:.6g} times the size of the model\n", mark, design.best.scale) : "");
}

/// A name of at most `max` characters, of letters, digits and _.
std::string identifier(const std::string& name, std::size_t max)
{
  std::string text;
  for (const char c : name)
    text += std::isalnum(static_cast<unsigned char>(c)) != 0 ? static_cast<char>(std::toupper(static_cast<unsigned char>(c))) : '_';
  return text.substr(0, max);
}

/// One file for each estimate, made by body(set, springs).
template <class Body>
ExportFiles by_estimate(const Design& design, const char* extension, const Body& body)
{
  ExportFiles files;
  for (const auto& [set, springs] : sets_of(design)) files.push_back({fmt::format("springs_{}.{}", set, extension), body(set, *springs)});
  return files;
}

/// A spring that resists both ways: its points mirrored, from the least displacement on.
Points both_ways(const Points& spring)
{
  Points points;
  for (auto p = spring.rbegin(); p != spring.rend(); ++p)
    if (p->x > 0) points.push_back({-p->x, -p->F});
  points.insert(points.end(), spring.begin(), spring.end());
  return points;
}

/// From the displacement of breakout on the axial resistance stays.
Points axial_spring(const Springs& s)
{
  const Real F = std::isnan(s.axial.undrained) ? s.axial.drained : s.axial.undrained;
  if (!(F > 0)) return {};
  return {{0, 0}, {s.axial.breakout, F}, {s.diameter, F}};
}

/// V over the embedment from the surface on.
Points push_of(const Springs& s)
{
  Points points{{0, 0}};
  for (const Point& p : s.vertical.curve)
    if (p.x > points.back().x) points.push_back(p);
  return points;
}

std::string abaqus_lines(const char* direction, const Points& points)
{
  std::string text = fmt::format("*PIPE-SOIL STIFFNESS, TYPE=NONLINEAR, DIRECTION={}\n", direction);
  for (const Point& p : points) text += fmt::format("{:.6g}, {:.6g}\n", p.F, p.x);
  return text;
}

/// R and RMORE hold six numbers each, displacement before force.
std::string combin39(int number, const Points& points)
{
  std::string text;
  for (std::size_t k = 0; k < points.size(); k += 3) {
    text += k == 0 ? fmt::format("R,BERM_REAL+{}", number) : "RMORE";
    for (std::size_t j = k; j < std::min(k + 3, points.size()); ++j)
      text += fmt::format(",{:.6g},{:.6g}*BERM_LENGTH", points[j].x, points[j].F);
    text += "\n";
  }
  return text;
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

ExportFiles abaqus_files(const Design& design)
{
  return by_estimate(design, "inp", [&](const std::string& set, const Springs& s) {
    std::string text = comments(design, "** ", "N and m; each line a force per length of pipe and a relative displacement");
    text += "** To be included in the model, with the element sets of its own PSI24, PSI26, PSI34 or PSI36 elements.\n";
    for (std::size_t k = 0; k < std::max<std::size_t>(1, s.lateral.size()); ++k) {
      const std::string stage = s.lateral.empty() ? "" : s.lateral[k].stage;
      text += fmt::format("*PIPE-SOIL INTERACTION, ELSET=SOIL_{}{}\n", identifier(set, 8),
                          k == 0 ? "" : fmt::format("_{}_{}", k + 1, identifier(stage, 50)));
      if (const Points axial = axial_spring(s); !axial.empty()) text += abaqus_lines("AXIAL", both_ways(axial));
      // Downwards only: a pipe that is lifted meets nothing.
      if (Points push = push_of(s); push.size() > 1) {
        push.insert(push.begin(), {-s.diameter, 0});
        text += abaqus_lines("VERTICAL", push);
      } else {
        text += "** VERTICAL is missing: the pipe lay in the bed from the start, so that nothing is known of its penetration\n";
      }
      if (!s.lateral.empty())
        if (const Points spring = s.lateral[k].spring(); spring.size() > 1) text += abaqus_lines("HORIZONTAL", both_ways(spring));
    }
    return text;
  });
}

ExportFiles orcaflex_files(const Design& design)
{
  return by_estimate(design, "csv", [&](const std::string& set, const Springs& s) {
    constexpr Real kilo = 1000;
    std::string text = comments(design, "# ", "kN and m");
    for (const Lateral& l : s.lateral) {
      const Points spring = l.spring();
      if (spring.size() < 2 || !(l.V > 0)) continue;
      text += fmt::format("# lateral resistance, {} estimate, stage {}: a profile of the seabed's tangential resistance, lateral, over the "
                          "normal reaction ({:.6g} kN/m)\n",
                          set, l.stage, l.V / kilo);
      text += "deflection (m),effective friction coefficient\n";
      for (const Point& p : spring) text += fmt::format("{:.6g},{:.6g}\n", p.x, p.F / l.V);
    }
    if (const Points axial = axial_spring(s); !axial.empty() && !s.lateral.empty() && s.lateral[0].V > 0) {
      text += fmt::format("# axial resistance, {} estimate, by formula: a profile of the seabed's tangential resistance, axial, over the "
                          "normal reaction ({:.6g} kN/m)\n",
                          set, s.lateral[0].V / kilo);
      text += "deflection (m),effective friction coefficient\n";
      for (const Point& p : axial) text += fmt::format("{:.6g},{:.6g}\n", p.x, p.F / s.lateral[0].V);
    }
    if (const Points push = push_of(s); push.size() > 1) {
      text += fmt::format(
          "# vertical resistance, {} estimate: normal reaction over the penetration\npenetration (m),normal reaction (kN/m)\n", set);
      for (const Point& p : push) text += fmt::format("{:.6g},{:.6g}\n", p.x, p.F / kilo);
    }
    return text;
  });
}

ExportFiles ansys_files(const Design& design)
{
  return by_estimate(design, "mac", [&](const std::string& set, const Springs& s) {
    std::string text = comments(design, "! ", "N and m");
    text += fmt::format("! Real constants of COMBIN39 springs between a node of the pipe and the ground, {} estimate. Define the elements "
                        "yourself, one type for each\n"
                        "! direction. With KEYOPT(1) = 1 the element wants no segment steeper than that at the origin, which berms and "
                        "penetration do not keep to.\n"
                        "! BERM_LENGTH: length of pipe that a node stands for, 1 where it is not set; BERM_REAL: number before the first "
                        "set, 0 where it is not set.\n",
                        set);
    text += "*IF,BERM_LENGTH,LE,1e-20,THEN\nBERM_LENGTH=1\n*ENDIF\n*IF,BERM_REAL,LE,1e-20,THEN\nBERM_REAL=0\n*ENDIF\n";
    int number = 1;
    for (const Lateral& l : s.lateral) {
      Points spring = l.spring();
      if (spring.size() < 2) continue;
      spring.push_back({spring.back().x + s.diameter, spring.back().F});  // the element goes on with the last slope
      text += fmt::format("! {}: lateral, stage {}\n", number, l.stage) + combin39(number, both_ways(spring));
      ++number;
    }
    if (const Points axial = axial_spring(s); !axial.empty()) {
      text += fmt::format("! {}: axial, by formula\n", number) + combin39(number, both_ways(axial));
      ++number;
    }
    if (const Points push = push_of(s); push.size() > 1) {
      // With the point of the other quadrant no more than the twenty that the element takes, the first and the last among them.
      const std::size_t count = std::min<std::size_t>(push.size(), 19);
      Points some = {{-s.diameter, 0}};
      for (std::size_t k = 0; k < count; ++k) some.push_back(push[k * (push.size() - 1) / (count - 1)]);
      text += fmt::format("! {}: vertical, downwards positive; nothing where the pipe is lifted\n", number) + combin39(number, some);
    }
    return text;
  });
}

ExportFiles sima_files(const Design& design)
{
  return by_estimate(design, "inp", [&](const std::string& set, const Springs& s) {
    constexpr Real kilo = 1000;
    std::string text = comments(design, "' ", "kN and m");
    const Points axial = axial_spring(s), push = push_of(s);
    Real normal = nan;
    for (const Unloading& u : s.vertical.unloading)
      if (std::isnan(normal) && u.stiffness > 0) normal = u.stiffness;
    if (std::isnan(normal) && push.size() > 1) normal = push.back().F / push.back().x;
    int number = 0;
    for (const Lateral& l : s.lateral) {
      ++number;
      if (!(l.V > 0) || !(l.peak > 0) || !(l.stiffness() > 0)) continue;
      for (const bool residual : {false, true}) {
        const Real H = residual ? l.residual : l.peak;
        if (!(H > 0)) continue;
        text += fmt::format("' {} of stage {}, {} estimate, under {:.6g} kN/m\n",
                            residual   ? "residual resistance"
                            : l.breaks ? "resistance at breakout"
                                       : "largest resistance",
                            l.stage, set, l.V / kilo);
        text += fmt::format("NEW COMPONENT SEAFLOOR\n'CMPTYP-ID CHSFCT\n{} SPRI\n",
                            identifier(fmt::format("{}{}{}", residual ? "R" : "B", number, set), 8));
        text += std::isnan(normal) ? "'STFBOT DAMBOT: not known from these runs; put your own here\n"
                                   : fmt::format("'STFBOT DAMBOT\n{:.6g} 0\n", normal / kilo);
        text += axial.empty() ? "'STFAXI FRIAXI DAMAXI\n0 0 0\n"
                              : fmt::format("'STFAXI FRIAXI DAMAXI\n{:.6g} {:.6g} 0\n", axial[1].F / axial[1].x / kilo,
                                            std::isnan(s.axial.undrained) ? axial.back().F / s.lateral[0].V : axial.back().F / l.V);
        text += fmt::format("'STFLAT FRILAT DAMLAT ILTOR\n{:.6g} {:.6g} 0 0\n", l.stiffness() / kilo, H / l.V);
      }
    }
    return text;
  });
}

}  // namespace berm::springs
