// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "beam/stations.hpp"
#include "settings/case.hpp"

namespace berm::slices {

/// The share of its largest resistance from which on a spring of the far soil stands for soil that fails.
constexpr Real much_mobilised = 0.4;

/// Loads of the whole line at a time: what a stage of kind pipeline names.
struct LineLoads {
  Real temperature = 0;      ///< K, rise since it was laid, at x = 0
  Real far_temperature = 0;  ///< K, at the far end; linear between
  Real pressure = 0;         ///< Pa, rise since it was laid
  Real weight = 0;           ///< N/m, submerged
  Real lateral = 0;          ///< N/m
  Real pull = 0;             ///< N, effective tension at the far end
};

/// The longest element of a line that may buckle, m: a quarter of the half wave of a column under the largest compression of all stages, which short waves of a buckle come near to. Without compression the length of the line.
Real longest_element_of(const settings::Case& c);

/// What a case says of its line, as numbers that do not change.
struct LineOfCase {
  explicit LineOfCase(const settings::Case& c);

  beam::Line line;
  std::vector<Real> places;  ///< m, x of the slices
  beam::Stations stations;
  Real diameter;                               ///< m
  Real mass;                                   ///< kg/m, that moves sideways
  std::vector<Real> length_of_nodes;           ///< m, by node
  std::vector<Real> length_beyond;             ///< m, by node: the part of the line beyond the slices
  std::optional<beam::PlasticSpring> lateral;  ///< the far soil sideways
  Real vertical_stiffness;                     ///< of the far soil, N/m2
  settings::PipelineSettings settings;

  /// The effective compression of a length that cannot get longer (beam/pipe_section.hpp), N, at a place x (m).
  Real constrained_force(const LineLoads& loads, Real x) const;
  /// As it was laid.
  LineLoads laid() const;
  /// Whether slices can be springs: these are then at the nodes under them, too.
  bool may_be_springs() const { return settings.slices.as_spring != settings::SliceAsSpring::never; }
  /// The share of its largest resistance that the far soil has at a displacement sideways from where the line was laid, m; 1 where it has none.
  Real mobilised(Real displacement) const;
  /// Whether the resistance along the line is that of an interface, which follows the force and embedment in each slice.
  bool has_interface() const { return settings.far_soil.axial_angle || settings.far_soil.axial_strength; }
  /// N/m: at an embedment of the pipe (m) under this force on the soil (N/m); upwards there is none.
  Real axial_resistance(Real embedment, Real force) const;
};

/// Where the loads go that are in force, in a stage.
LineLoads target_of(const settings::PipelineLoads& stage, const LineLoads& before);

/// The loads in a stage, a time (s) after it began: on the way of its ramp from those before it, or as its load history has them.
LineLoads loads_in(const settings::StageSettings& stage, const LineLoads& before, Real since);
/// Those with which it ends.
LineLoads end_of(const settings::StageSettings& stage, const LineLoads& before);

/// The stage of kind pipeline that first brings the largest compression of all at x = 0.
std::size_t hottest_stage_of(const settings::Case& c, const LineOfCase& of);

/// "20 slices every 4 m, to 76 m", or "20 slices 2.1 to 6.3 m apart, to 71 m".
std::string words_of_places(const std::vector<Real>& places);

}  // namespace berm::slices
