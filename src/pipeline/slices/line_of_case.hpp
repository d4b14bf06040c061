// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "beam/stations.hpp"
#include "problem/case.hpp"

namespace berm::slices {

/// Loads of the whole line at a time: what a stage of kind pipeline names.
struct LineLoads {
  Real temperature = 0;  ///< K, rise since it was laid
  Real pressure = 0;     ///< Pa, rise since it was laid
  Real weight = 0;       ///< N/m, submerged
  Real lateral = 0;      ///< N/m
};

/// What a case says of its line, as numbers that do not change.
struct LineOfCase {
  explicit LineOfCase(const problem::Case& c);

  beam::Line line;
  std::vector<Real> places;  ///< m, x of the slices
  beam::Stations stations;
  Real diameter;                        ///< m
  Real mass;                            ///< kg/m, that moves sideways
  std::vector<Real> length_on_springs;  ///< m, by node: the part of the line beyond the slices
  problem::PipelineSettings settings;

  /// The effective compression of a length that cannot get longer (beam/pipe_section.hpp), N.
  Real constrained_force(const LineLoads& loads) const;
  /// As it was laid.
  LineLoads laid() const { return {0, 0, settings.submerged_weight, 0}; }
};

/// Where the loads go that are in force, in a stage.
LineLoads target_of(const problem::PipelineLoads& stage, const LineLoads& before);

/// Between two loads: part = 0 ... 1.
LineLoads between(const LineLoads& from, const LineLoads& to, Real part);

}  // namespace berm::slices
