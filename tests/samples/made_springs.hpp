// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "springs/design.hpp"

namespace berm {

/// Springs of a pipe of 0.5 m in operation that was never run: a breakout and a residual in sweep_1, a breakout and a berm in sweep_2, an unloading in which V
/// falls while the pipe sinks. Forces times `factor`.
inline springs::Springs made_springs(Real factor = 1)
{
  springs::Springs s;
  s.run = "b1";
  s.state = "operation";
  s.state_origin = "end of stage unload";
  s.V = 1000;
  s.diameter = 0.5;
  s.embedment = 0.136;
  for (const char* stage : {"sweep_1", "sweep_2"}) {
    springs::Lateral l;
    l.stage = stage;
    l.V = 1000;
    l.breaks = true;
    l.peak = 800 * factor;
    l.u_peak = 0.02;
    for (std::size_t k = 0; k < springs::mobilised_parts.size(); ++k) l.mobilised[k] = springs::mobilised_parts[k] * l.u_peak;
    l.travel = 1.5;
    s.lateral.push_back(l);
  }
  s.lateral[0].residual = s.lateral[0].end = 500 * factor;
  s.lateral[0].u_residual = 0.2;
  s.lateral[1].berm = s.lateral[1].end = 1129 * factor;
  s.vertical.curve = {{0.025, 500 * factor}, {0.05, 1200 * factor}, {0.1, 2000 * factor}};
  s.vertical.preload = 2000 * factor;
  s.vertical.unloading = {{"unload", 1860, 1000, -104219.65}};
  s.axial.undrained = 240 * factor;
  s.axial.undrained_source = "White and Randolph 2007";
  s.axial.residual = s.axial.undrained;
  s.axial.mobilise(s.diameter);
  return s;
}

/// Of eleven such runs, the best of which is `best`.
inline springs::Design made_design(const springs::Springs& best = made_springs())
{
  std::vector<springs::Springs> draws;
  for (int k = -5; k <= 5; ++k) {
    draws.push_back(best);
    for (springs::Lateral& l : draws.back().lateral)
      for (Real* force : {&l.peak, &l.residual, &l.berm, &l.end}) *force *= 1 + 0.05 * k;
    for (springs::Point& p : draws.back().vertical.curve) p.F *= 1 + 0.05 * k;
    draws.back().vertical.preload *= 1 + 0.05 * k;
    for (Real* force : {&draws.back().axial.undrained, &draws.back().axial.residual}) *force *= 1 + 0.05 * k;
  }
  springs::Design design = design_of_sample("line", best, draws);
  design.provenance = {"written by berm 0", "a title\nof two lines"};
  return design;
}

}  // namespace berm
