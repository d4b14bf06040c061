// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/describe.hpp"

#include <optional>

namespace berm::settings {

struct Case;

/// What the other half of a line is that ends at x = 0.
enum class LineHalf {
  symmetric,      ///< its mirror image: one buckle, with its crown at x = 0
  antisymmetric,  ///< rotated by 180 degrees: two buckles to either side
  none            ///< there is none: x = 0 is an end of the line, free
};

/// What holds the far end of a line.
enum class LineEnd {
  anchored,  ///< it stays where it is
  free,      ///< it moves along the line
  spring     ///< it moves along the line against a spring
};

/// When a slice is a spring, of the far soil, in place of soil.
enum class SliceAsSpring {
  never,
  until_sliding,  ///< it is soil from when its spring has 40 % of its resistance sideways
  always          ///< the line lies on springs alone
};

/// Points of a curve: of a file beside the case file, or as numbers.
struct GivenPoints {
  std::string table;       ///< CSV file; "" once a case is read
  std::vector<Real> x, y;  ///< as many

  bool empty() const { return table.empty() && x.empty() && y.empty(); }
};

/// y (m) over x (m) of a line as it lies without stress.
struct Route : GivenPoints {};

/// Resistance sideways (N/m) over displacement (m).
struct LateralCurve : GivenPoints {};

/// The line's shape without stress, sideways, for |x| < length/2, with k = 2 pi/length: amplitude (1 + cos kx)/2; antisymmetric: amplitude (1 + cos kx) sin kx 4/(3 sqrt 3), whose largest is amplitude, too.
struct Imperfection {
  Real amplitude = 0;  ///< m, along the slices' x
  Real length = 0;     ///< m, of the whole
};

/// Slices of soil under the line, the same case each: evenly spaced, at places of their own, or as many as are asked for where berm places them.
struct SliceSettings {
  std::optional<Real> spacing;  ///< m
  std::optional<Real> to;       ///< m, x of the last; the first is at x = 0
  std::vector<Real> at;         ///< m
  int count = 0;                ///< instead of places; 0 once a case is read, which gives them places (slices/place_slices.hpp)
  SliceAsSpring as_spring = SliceAsSpring::never;
};

/// x of the slices, m; empty where they have no places yet.
std::vector<Real> places_of(const SliceSettings& slices);

/// Slices of other soil than that of the case.
struct OtherSoil {
  Real from = 0, to = 0;         ///< m: the slices from here to there
  std::vector<std::string> set;  ///< as --set has it: KEY=VALUE of the case
};

/// Soil beyond the last slice: springs. Forces are parts of the submerged weight.
struct FarSoil {
  Real friction = 0.6;                 ///< sideways
  Real mobilisation = 0;               ///< m, of this friction; 0: a hundredth of the diameter
  Real axial_friction = 0.5;           ///< along the line, under the slices, too
  std::optional<Real> axial_angle;     ///< rad, of friction between pipe and soil along the line, on the normal force around the contact
  std::optional<Real> axial_strength;  ///< Pa, shear strength there, on the length of the contact; both instead of axial_friction
  Real axial_mobilisation = 2e-3;      ///< m
  std::optional<Real> stiffness;       ///< N/m2, downwards; absent: the weight over a hundredth of the diameter
  LateralCurve lateral;                ///< instead of friction
  std::string macro_element;           ///< file of berm macro-element, instead of all these
};

/// A line on springs beside that on slices, with the resistance that a drag in the same soil finds.
struct SpringsBeside {
  Real travel = 0;      ///< m, of the drag
  Real velocity = 0.1;  ///< m/s, of the drag
};

/// The pipeline of which a case in plane strain is a slice.
struct PipelineSettings {
  std::optional<Real> wall, young_modulus;                 ///< m, Pa
  std::optional<Real> bending_stiffness, axial_stiffness;  ///< N m2, N, instead
  Real poisson_ratio = 0.3;
  Real expansion = 0;              ///< 1/K
  Real submerged_weight = 0;       ///< N/m, as it was laid
  std::optional<Real> mass;        ///< kg/m, with content and added water; absent: that of the rigid body
  std::optional<Real> axial_mass;  ///< kg/m; absent: `mass`
  Real lay_tension = 0;            ///< N, effective
  LineHalf half = LineHalf::symmetric;
  Real length = 0;  ///< m, from x = 0 to the far end
  LineEnd end = LineEnd::anchored;
  std::optional<Real> end_stiffness;  ///< N/m, of a far end on a spring
  Imperfection imperfection;
  Route route;  ///< instead of an imperfection
  SliceSettings slices;
  std::vector<OtherSoil> soil;
  FarSoil far_soil;
  std::optional<SpringsBeside> springs;
  Real vertical_damping = 5;  ///< 1/s, force over momentum of the line upwards
};

void describe(Describe& d, Imperfection& imperfection);
void describe(Describe& d, SliceSettings& slices);
void describe(Describe& d, OtherSoil& soil);
void describe(Describe& d, Route& route);
void describe(Describe& d, LateralCurve& curve);
void describe(Describe& d, FarSoil& soil);
void describe(Describe& d, SpringsBeside& springs);
void describe(Describe& d, PipelineSettings& pipeline);

/// What must fit together: the line, its slices and the stages that load it.
void check_pipeline(Describe& d, const Case& c);

}  // namespace berm::settings
