// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "structures/base/answer.hpp"
#include "structures/base/structure.hpp"

namespace berm::anchor {

/// What a body that is dragged through the bed meets on its way: all drags of a run, one after the other, by row.
struct TowPath {
  std::vector<Real> travel;  ///< m, from where the first drag began
  std::vector<Real> depth;   ///< m, of the lowest point below the bed's surface
  std::vector<Real> H, V;    ///< N (plane strain N/m): against the drag; upwards on the body
};

TowPath tow_path(const record::RunRecord& run);

/// Numbers of a tow. Forces are averaged over +-0.05 D of travel.
struct TowResults {
  Real travel = nan;                     ///< m
  Real first_depth = nan, depth = nan;   ///< m, at the begin and the end
  Real max_depth = nan, at_depth = nan;  ///< m, and the travel to it
  Real max_force = nan, at_force = nan;  ///< N, largest H, m
  Real last_travel = nan;                ///< m, the end over which the following are taken: D, a third of a short way
  Real force = nan, vertical = nan;      ///< N, means of H and V
  Real depth_change = nan;               ///< m, how much deeper the straight line fitted to the depth goes there
  Real work = nan;                       ///< J, of H
};

TowResults tow_results(const TowPath& path, const base::BodyScale& scale);

template <auto Number>
constexpr base::Access<TowResults> of_tow = base::number<TowResults, Number>.value;

/// Of forces N and kN stand for N/m and kN/m in plane strain, and J for J/m.
using Row = base::Answer<TowResults>;
inline constexpr Row tow_answers[] = {
    Row{"tow_travel", base::AnswerUnit::length, "travel of all drags", of_tow<&TowResults::travel>}.headed({"travel", "m"}),
    Row{"tow_depth_begin", base::AnswerUnit::length, "depth of the lowest point where the first drag begins",
        of_tow<&TowResults::first_depth>}
        .headed({"initial depth", "m"}),

    Row{"tow_depth_end", base::AnswerUnit::length, "depth of the lowest point at the end of the drags", of_tow<&TowResults::depth>}.headed(
        {"at end", "m"}),

    Row{"tow_depth_max", base::AnswerUnit::length, "largest depth of the lowest point in the drags", of_tow<&TowResults::max_depth>}.headed(
        {"largest", "m"}),
    Row{"u_at_tow_depth_max", base::AnswerUnit::length, "travel to that depth", of_tow<&TowResults::at_depth>}.headed({"after", "m"}),
    Row{"tow_force_max", base::AnswerUnit::force, "largest tow force, averaged", of_tow<&TowResults::max_force>}.headed(
        {"largest tow force", "kN", 1e3}),
    Row{"u_at_tow_force_max", base::AnswerUnit::length, "travel to that force", of_tow<&TowResults::at_force>}.headed({"after", "m"}),
    Row{"tow_force_end", base::AnswerUnit::force, "mean tow force over the end of the drags", of_tow<&TowResults::force>}.headed(
        {"at end", "kN", 1e3}),

    Row{"tow_V_end", base::AnswerUnit::force, "mean vertical reaction over the end of the drags", of_tow<&TowResults::vertical>}.headed(
        {"V at end", "kN", 1e3}),
    {"tow_depth_change", base::AnswerUnit::length, "how much deeper the body goes over the end of the drags",
     of_tow<&TowResults::depth_change>},
    Row{"tow_work", base::AnswerUnit::work, "work of the tow force", of_tow<&TowResults::work>}.headed({"work", "kJ", 1e3}),
};

}  // namespace berm::anchor
