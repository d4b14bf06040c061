// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/field_info.hpp"
#include "problem/model.hpp"

#include <algorithm>
#include <vector>

namespace berm::run_folder {

/// A field of points, with what is said of it: `info.components` numbers of each point, one point after the other.
template <class Number>
struct FieldValues {
  FieldInfo info;
  std::vector<Number> values;

  std::size_t place(std::size_t point, int component = 0) const { return point * static_cast<std::size_t>(info.components) + component; }
  Number& at(std::size_t point, int component = 0) { return values[place(point, component)]; }
  const Number& at(std::size_t point, int component = 0) const { return values[place(point, component)]; }
};

/// The field of that name; null where there is none.
template <class Number>
const FieldValues<Number>* find_field(const std::vector<FieldValues<Number>>& fields, const std::string& name)
{
  const auto found = std::find_if(fields.begin(), fields.end(), [&](const FieldValues<Number>& field) { return field.info.name == name; });
  return found == fields.end() ? nullptr : &*found;
}

/// A rigid body as a frame shows it.
template <int dim>
struct FrameRigid {
  bodies::SurfaceMesh<dim> surface;
  Vec<dim> velocity;  ///< m/s
};

/// What one frame shows: points of the soil with fields, and the rigid bodies where they are. The points are particles, by body and then number, or nodes of
/// finite elements, each with the area that belongs to it as its volume.
template <int dim>
struct Frame {
  Real time = 0;  ///< s
  std::vector<Vec<dim>> points;
  std::vector<Real> volume;            ///< by point: m2, the area in the plane; in space m3
  std::vector<std::int32_t> body, id;  ///< by point
  std::vector<FieldValues<Real>> fields;
  std::vector<std::array<Index, 6>> triangles;  ///< quadratic, of points: corners counter-clockwise, middles of sides 01 12 20; none in MPM
  std::vector<std::array<Index, 10>> tetrahedra;  ///< in space likewise: corners, middles of sides 01 12 20 03 13 23
  std::vector<FrameRigid<dim>> rigid_bodies;

  /// Makes room for so many points and these fields, all zero; what there was is gone, its memory is used again.
  void allocate(std::size_t count, const std::vector<FieldInfo>& infos);
  /// The field of that name; throws std::logic_error where there is none.
  FieldValues<Real>& field(const std::string& name);
  const FieldValues<Real>& field(const std::string& name) const;
};

/// The fields that every frame has, in `dim` dimensions: those of all particles that go to frames (bodies/particle_fields.hpp), and what both methods work
/// out from the motion of the soil, whose displacement counts since then (settings::displacements_since).
template <int dim>
std::vector<FieldInfo> common_fields(const std::string& since = "");

/// The fields of frames with undrained soil, whose `stress` is the total one less the hydrostatic pressure.
template <int dim>
std::vector<FieldInfo> effective_stress_fields();

/// What such frames have in a ground with weight: r_u, the excess pore pressure over the effective vertical stress at rest; 1: the soil is liquefied.
FieldInfo pore_pressure_ratio_field();

/// The flux of the water, of frames with soil whose water flows: its volume in a second through a square metre of soil, against the soil (Darcy).
template <int dim>
FieldInfo water_flux_field();

/// The effective vertical stress at rest, Pa, compression positive: the weight of the soil of a body above a depth, m, at the start.
template <int dim>
Real overburden(const problem::Model<dim>& model, Index body, const std::string& region, const settings::SoilPlace& place);

/// Whether every frame has a field of that name; another one belongs to a law or a method.
bool is_common_field(const std::string& name);

/// The fields of one number a point that not every frame has and that are not zero everywhere: each is worth a picture of its own.
std::vector<std::string> own_fields(const Frame<2>& frame);

/// Bytes of a point of a frame whose fields, beside the common ones, have so many numbers.
template <int dim>
std::size_t bytes_of_point(int more_numbers);

/// The model's rigid bodies where `rigid_bodies` says that they are; a half-plane as far as the mesh reaches.
template <int dim>
std::vector<FrameRigid<dim>> frame_rigids(const problem::Model<dim>& model, const std::vector<bodies::RigidState<dim>>& rigid_bodies);

}  // namespace berm::run_folder
