// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/describe.hpp"

#include <optional>

namespace berm::problem {

struct Case;

/// What the other half of a line is that ends at x = 0.
enum class LineHalf {
  symmetric,     ///< its mirror image: one buckle, with its crown at x = 0
  antisymmetric  ///< turned by half a turn: two buckles to either side
};

/// What holds the far end of a line.
enum class LineEnd {
  anchored,  ///< it stays where it is
  free       ///< it moves along the line
};

/// The line's shape without stress, sideways, for |x| < length/2, with k = 2 pi/length: amplitude (1 + cos kx)/2; antisymmetric: amplitude (1 + cos kx) sin kx 4/(3 sqrt 3), whose largest is amplitude, too.
struct Imperfection {
  Real amplitude = 0;  ///< m, along the slices' x
  Real length = 0;     ///< m, of the whole
};

/// Slices of soil under the line, the same case each.
struct SliceSettings {
  Real spacing = 0;  ///< m
  Real to = 0;       ///< m, x of the last; the first is at x = 0
};

/// Soil beyond the last slice: springs. Forces are parts of the submerged weight.
struct FarSoil {
  Real friction = 0.6;             ///< sideways
  Real mobilisation = 0;           ///< m, of this friction; 0: a hundredth of the diameter
  Real axial_friction = 0.5;       ///< along the line, under the slices, too
  Real axial_mobilisation = 2e-3;  ///< m
  std::optional<Real> stiffness;   ///< N/m2, downwards; absent: the weight over a hundredth of the diameter
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
  Imperfection imperfection;
  SliceSettings slices;
  FarSoil far_soil;
  Real vertical_damping = 5;  ///< 1/s, force over momentum of the line upwards
};

void describe(Describe& d, Imperfection& imperfection);
void describe(Describe& d, SliceSettings& slices);
void describe(Describe& d, FarSoil& soil);
void describe(Describe& d, PipelineSettings& pipeline);

/// What must fit together: the line, its slices and the stages that load it.
void check_pipeline(Describe& d, const Case& c);

}  // namespace berm::problem
