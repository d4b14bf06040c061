// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/describe.hpp"
#include "mesh/mesh.hpp"

namespace berm::boundary {

/// A load on the soil that lies at one boundary of the mesh at the start. It moves with this soil and keeps its magnitude
/// and direction.
struct TractionSettings {
  std::string boundary;
  std::vector<Real> stress;         ///< Pa, force per initial area, one entry a direction; or
  std::optional<Real> pressure;     ///< Pa, against the initial normal of the soil
  std::vector<Real> x_range;        ///< m, from and to: only this part of the boundary; empty: all of it
  Real ramp = 0;                    ///< s, over which it grows to its value, and falls to zero in a stage without it
  std::vector<std::string> stages;  ///< in which it acts; empty: all
  Real pressure_gradient = 0;       ///< Pa/m, of the pressure with depth below `level`
  std::optional<Real> level = {};   ///< m, y
};

void describe(Describe& d, TractionSettings& traction);

/// The boundary of the mesh that the traction `name` loads. Throws InputError where the mesh has none of that name.
template <int dim>
Index loaded_boundary(const mesh::Mesh<dim>& mesh, const std::string& name, const TractionSettings& traction);

/// Traction, Pa, at a point where the soil has this outward normal.
template <int dim>
Vec<dim> stress_on(const TractionSettings& traction, const Vec<dim>& normal, const Vec<dim>& x);

/// The part of a line that x_range leaves, as fractions of the way from one end to the other; from >= to where it is empty.
struct LoadedRange {
  Real from, to;
};
LoadedRange loaded_range(const TractionSettings& traction, const Vec<2>& begin, const Vec<2>& end);

/// A point at the loaded boundary, and the force that it gives to the soil.
template <int dim>
struct LoadedPoint {
  Index cell;  ///< of the soil
  Vec<dim> x, force;
  Real area;  ///< m2 (per metre run: m), its share of the boundary
};

/// Load points on the faces of soil at the boundary of the traction `name`: four on an edge, nine on a triangle, evenly
/// spaced. body_of_region is none for regions without soil. Faces between soil and soil are not loaded. Throws InputError
/// where no soil lies at the boundary, or none of it in x_range.
template <int dim>
std::vector<LoadedPoint<dim>> loaded_points(const mesh::Mesh<dim>& mesh, const std::string& name, const TractionSettings& traction,
                                            const std::vector<Index>& body_of_region);

/// Throws the error of a traction that loads no soil.
[[noreturn]] void refuse_without_soil(const std::string& name, const TractionSettings& traction);

}  // namespace berm::boundary
