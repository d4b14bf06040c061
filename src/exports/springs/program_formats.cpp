// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/springs/formats_test.cpp
#include "os/control_characters.hpp"
#include "springs/written_springs.hpp"

#include <cmath>
#include <fmt/format.h>

namespace berm::springs {
namespace {

std::string abaqus_lines(const char* direction, const Points& points)
{
  std::string text = fmt::format("*PIPE-SOIL STIFFNESS, TYPE=NONLINEAR, DIRECTION={}\n", direction);
  for (const Point& p : points) text += fmt::format("{:.6g}, {:.6g}\n", p.F, p.x);
  return text;
}

/// Why a drag has no component of RIFLEX; "" where it has one.
std::string why_no_component(const Lateral& l)
{
  if (!(l.V > 0)) return without_friction(l.stage);
  if (!(l.peak > 0))
    return fmt::format("{} has no component: {}", l.stage,
                       l.only_berm() ? "its H increases against a berm, which is not a residual" : "no resistance of it is known");
  return is_stiffness(l.stiffness()) ? ""
                                     : fmt::format("{} has no component: H begins with its peak, so that it has no stiffness", l.stage);
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

ExportFiles abaqus_files(const Design& design)
{
  return by_estimate(design, "inp", [&](const std::string& set, const Springs& s) {
    std::string text = comments(design, "** ",
                                {"N and m; each line a force per length of pipe and a relative displacement",
                                 "Not run in Abaqus: by its keyword reference.",
                                 "To be included in the model, with the element sets of its own PSI24, PSI26, PSI34 or PSI36 elements."});
    std::vector<const Lateral*> lateral;
    for (const Lateral& l : s.lateral)
      if (!l.only_berm()) lateral.push_back(&l);
    for (std::size_t k = 0; k < std::max<std::size_t>(1, lateral.size()); ++k) {
      const std::string stage = lateral.empty() ? "" : lateral[k]->stage;
      text += fmt::format("*PIPE-SOIL INTERACTION, ELSET=SOIL_{}{}\n", identifier(set, 8),
                          k == 0 ? "" : fmt::format("_{}_{}", k + 1, identifier(stage, 50)));
      if (const Points axial = axial_spring(s); !axial.empty())
        text += remark("** ", axial_title(s) + ": " + axial_origin(s)) + abaqus_lines("AXIAL", both_ways(axial));
      // Downwards only: a pipe that is lifted meets nothing.
      if (Points vertical = from_rest(vertical_spring(s)); vertical.size() > 1) {
        vertical.insert(vertical.begin(), {-s.diameter, 0});
        text += remark("** ", "vertical: " + vertical_origin(s) + ". " + rest_words(s)) + abaqus_lines("VERTICAL", vertical);
      } else {
        text += remark("** ", "VERTICAL is missing: " + s.vertical.without_curve);
      }
      if (lateral.empty()) continue;
      if (const Points spring = lateral[k]->spring(); spring.size() > 1)
        text += remark("** ", "lateral: " + origin_of(s, *lateral[k])) + abaqus_lines("HORIZONTAL", both_ways(spring));
    }
    return text;
  });
}

ExportFiles orcaflex_files(const Design& design)
{
  return by_estimate(design, "csv", [&](const std::string& set, const Springs& s) {
    constexpr Real kilo = 1000;
    std::string text = comments(design, "# ", {"kN and m", "Not pasted into OrcaFlex yet: by its public help."});
    for (const WrittenSpring& spring : springs_to_write(s)) {
      const bool vertical = spring.direction == Direction::vertical;
      if (!vertical && !(spring.V > 0)) {
        text += remark("# ", without_friction(spring.direction == Direction::axial ? "the axial spring" : spring.travel));
        continue;
      }
      text += remark("# ", spring.origin);
      if (vertical)
        text += fmt::format("# vertical resistance, {} estimate: normal reaction against penetration\n", set) +
                "penetration (m),normal reaction (kN/m)\n";
      else
        text += fmt::format("# {}, {} estimate{}: a profile of the seabed's tangential resistance, {}, divided by the normal reaction "
                            "({:.6g} kN/m)\n",
                            spring.direction == Direction::axial ? axial_title(s) + ", breakout and residual" : "lateral resistance", set,
                            spring.direction == Direction::axial ? ", by formula" : ", stage " + one_line(spring.travel),
                            spring.direction == Direction::axial ? "axial" : "lateral", spring.V / kilo) +
                "deflection (m),effective friction coefficient\n";
      for (const Point& p : spring.points) text += fmt::format("{:.6g},{:.6g}\n", p.x, p.F / (vertical ? kilo : spring.V));
    }
    return text;
  });
}

ExportFiles ansys_files(const Design& design)
{
  return by_estimate(design, "mac", [&](const std::string& set, const Springs& s) {
    std::string text = comments(
        design, "! ",
        {"N and m", "Not run in ANSYS: by the help of Mechanical APDL.",
         fmt::format("Real constants of COMBIN39 springs between a node of the pipe and the ground, {} estimate. Define the elements "
                     "yourself, one type for each direction. With KEYOPT(1) = 1 the element allows no segment steeper than that at the "
                     "origin, which berms and penetration do not satisfy.",
                     set),
         "BERM_LENGTH: length of pipe that a node stands for, 1 where it is not set; BERM_REAL: number before the first set, 0 where it is "
         "not set."});
    text += "*IF,BERM_LENGTH,LE,1e-20,THEN\nBERM_LENGTH=1\n*ENDIF\n*IF,BERM_REAL,LE,1e-20,THEN\nBERM_REAL=0\n*ENDIF\n";
    int number = 0;
    for (const WrittenSpring& spring : springs_to_write(s)) {
      ++number;
      Points points;
      std::string what;
      if (spring.direction == Direction::lateral) {
        points = both_ways(level_beyond(spring.points, s.diameter));  // the element goes on with the last slope
        what = "lateral, stage " + spring.travel;
      } else if (spring.direction == Direction::axial) {
        points = both_ways(spring.points);
        what = axial_title(s) + ", by formula";
      } else {
        // With the point of the other quadrant no more than the twenty that the element takes: those up to the preload, and the last.
        const Points all = from_rest(spring.points);
        const std::size_t count = std::min<std::size_t>(all.size(), 19), first = std::min<std::size_t>(all.size(), 3);
        points = {{-s.diameter, 0}};
        for (std::size_t k = 0; k < first; ++k) points.push_back(all[k]);
        for (std::size_t k = first; k < count; ++k)
          points.push_back(all[first - 1 + (k - first + 1) * (all.size() - first) / (count - first)]);
        what = "vertical, downwards positive; nothing where the pipe is lifted. " + rest_words(s);
      }
      text += remark("! ", fmt::format("{}: {}; {}", number, what, spring.origin)) + combin39(number, points);
    }
    return text;
  });
}

ExportFiles sima_files(const Design& design)
{
  return by_estimate(design, "inp", [&](const std::string& set, const Springs& s) {
    constexpr Real kilo = 1000;
    std::string text = comments(design, "' ", {"kN and m", "Not run in SIMA: by the user guide of RIFLEX."});
    for (const std::string& line : refused_stiffnesses(s)) text += remark("' ", line);
    const Points axial = axial_spring(s);
    const NormalStiffness normal = normal_stiffness(s);
    if (!std::isnan(normal.value)) text += remark("' ", "STFBOT: " + normal.origin);
    if (s.V > 0 && normal.value > 0 && s.embedment > 0)
      text += remark("' ", fmt::format("STFBOT is linear: with the flat bottom at w = {:.4g} m below the seabed the pipe lies at w = "
                                       "{:.4g} m under V = {:.4g} N/m, as in the state",
                                       s.embedment - s.V / normal.value, s.embedment, s.V));
    const bool undrained = !std::isnan(s.axial.undrained);
    if (!axial.empty())
      text += remark("' ", "STFAXI and FRIAXI, " + axial_title(s) + ": " + axial_origin(s)) +
              remark("' ", fmt::format("FRIAXI: divided by V of the {}", undrained ? "travel" : "state"));
    int number = 0;
    for (const Lateral& l : s.lateral) {
      ++number;
      if (const std::string why = why_no_component(l); !why.empty()) {
        text += remark("' ", why);
        continue;
      }
      for (const bool residual : {false, true}) {
        const Real H = residual ? l.residual : l.peak;
        if (!(H > 0) || (residual && !l.breaks && !std::isnan(l.berm))) continue;  // its peak is the residual
        text += remark("' ", fmt::format("{} of stage {}, {} estimate, under {:.6g} kN/m: {}",
                                         residual ? "residual resistance" : peak_words(l), l.stage, set, l.V / kilo, origin_of(s, l)));
        text += fmt::format("NEW COMPONENT SEAFLOOR\n'CMPTYP-ID CHSFCT\n{} SPRI\n",
                            identifier(fmt::format("{}{}{}", residual ? "R" : "B", number, set), 8));
        text += std::isnan(normal.value) ? "'STFBOT DAMBOT: not known from these runs; put your own here\n"
                                         : fmt::format("'STFBOT DAMBOT\n{:.6g} 0\n", normal.value / kilo);
        const Real axial_normal = undrained ? l.V : axial_V(s), axial_force = residual ? s.axial.residual : s.axial.breakout();
        text += axial.empty() || !(axial_normal > 0)
                    ? "'STFAXI FRIAXI DAMAXI\n0 0 0\n"
                    : fmt::format("'STFAXI FRIAXI DAMAXI\n{:.6g} {:.6g} 0\n", axial[1].F / axial[1].x / kilo, axial_force / axial_normal);
        text += fmt::format("'STFLAT FRILAT DAMLAT ILTOR\n{:.6g} {:.6g} 0 0\n", l.stiffness() / kilo, H / l.V);
      }
    }
    return text;
  });
}

}  // namespace berm::springs
