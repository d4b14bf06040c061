// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/describe.hpp"
#include "mesh/mesh.hpp"

namespace berm::boundary {

/// A load on the soil that lies at one boundary of the mesh at the start. It moves with this soil and keeps its size and direction.
struct TractionSettings {
  std::string boundary;
  std::vector<Real> stress;         ///< Pa, force over first area, one entry a direction; or
  std::optional<Real> pressure;     ///< Pa, against the first normal of the soil
  std::vector<Real> x_range;        ///< m, from and to: only this part of the boundary; empty: all of it
  Real ramp = 0;                    ///< s, in which it grows to its value, and falls to nothing where a stage is without it
  std::vector<std::string> stages;  ///< in which it acts; empty: all
};

void describe(Describe& d, TractionSettings& traction);

/// The boundary of the mesh that the traction `name` loads. Throws InputError where the mesh has none of that name.
template <int dim>
Index loaded_boundary(const mesh::Mesh<dim>& mesh, const std::string& name, const TractionSettings& traction);

/// The force over area, Pa, where the soil has this outward normal.
template <int dim>
Vec<dim> stress_on(const TractionSettings& traction, const Vec<dim>& normal);

/// The ends, as parts of the way from one point to the other, of what x_range leaves of a line; from >= to where it leaves nothing.
struct Stretch {
  Real from, to;
};
Stretch stretch_in_range(const TractionSettings& traction, const Vec<2>& begin, const Vec<2>& end);

/// A place at the boundary, and the part of a traction that is handed to the soil there.
template <int dim>
struct LoadedPlace {
  Index cell;  ///< of the soil
  Vec<dim> x, force;
  Real area;  ///< m2 (per metre run: m) that it stands for
};

/// Places on the faces of soil at the boundary of the traction `name`: four on an edge, nine on a triangle, evenly. body_of_region tells which regions hold
/// soil (not none). A face between soil and soil is none. Throws InputError where no soil lies at the boundary, or none of it in x_range.
template <int dim>
std::vector<LoadedPlace<dim>> loaded_places(const mesh::Mesh<dim>& mesh, const std::string& name, const TractionSettings& traction,
                                            const std::vector<Index>& body_of_region);

/// The error where nothing is loaded.
[[noreturn]] void refuse_without_soil(const std::string& name, const TractionSettings& traction);

}  // namespace berm::boundary
