// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "formulas/hobbs.hpp"
#include "route/route_settings.hpp"

#include <functional>

namespace berm::route {

/// NaN where it is not known.
struct Bounds {
  Real low = nan, best = nan, high = nan;
};

/// What the bed does to the pipe in operation. Forces are N/m.
struct Resistances {
  Real V = nan;      ///< under which it lies: the weight in operation
  Bounds embedment;  ///< m
  Bounds stiffness;  ///< N/m2, V over the embedment
  Bounds lateral_breakout, lateral_residual;
  Bounds hydrotest_breakout;  ///< lateral, of the flooded pipe
  Bounds axial_breakout, axial_residual;
  Bounds uplift;                    ///< of a buried line
  std::string source;               ///< the formulas, or the run
  std::vector<std::string> doubts;  ///< where a formula is outside its range
};

/// Whether the line leaves its place, with the resistance that makes that more likely.
struct Screening {
  Real constrained_force = 0;    ///< P_0, N, the largest in the section
  Real compression = 0;          ///< N, the largest that there is: where the line moves at its ends, what axial resistance holds of it
  Real hobbs = nan;              ///< N, the smallest P_0 that has a buckle, of modes of two to four lobes
  int lobes = 0;                 ///< of that
  Real curve = nan;              ///< N, the force that pushes the line out of the curve it is laid in
  Real lateral = nan;            ///< compression divided by the smaller of the two
  formulas::HobbsBuckle buckle;  ///< at that compression, with the best residual resistances; NaN where there is none
  Bounds anchor_spacing;         ///< m, between the virtual anchors of that buckle: low with the high axial residual
  Real feed_in = nan;            ///< m, that the line lengthens into it
  Real download = nan;           ///< N/m, that holds a buried line down on its prop
  Real upheaval = nan;           ///< that divided by the weight in operation plus the low uplift resistance
};

/// The compression at a place of the route.
struct ForceAt {
  Real kp, force;  ///< m, N
};

struct SectionAnswer {
  Resistances soil;
  std::vector<ForceAt> compression;  ///< where its slope changes, and at both ends of the section
  Screening screening;
};

/// The springs of the run of a section.
using FromRun = std::function<Resistances(const std::filesystem::path& folder, const Pipe& pipe)>;

std::vector<SectionAnswer> answer_of(const RouteCase& c, const FromRun& from_run);

}  // namespace berm::route
