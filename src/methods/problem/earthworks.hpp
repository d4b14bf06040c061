// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "bodies/body_settings.hpp"
#include "core/describe.hpp"

#include <array>
#include <optional>

namespace berm::problem {

template <int dim>
struct Model;
template <int dim>
struct State;

/// Soil that a stage places or takes out, with its names looked up.
template <int dim>
struct Earthwork {
  std::string name;
  bool fills;  ///< or takes out
  Index body, stage;
  bodies::Polygon<dim> area;
  std::vector<Vec<2>> corners;  ///< m, of the area
  std::array<Real, 2> z_range;  ///< m
  Real bottom, top;             ///< m, levels y between which the area lies
  int lifts;
  Real duration;  ///< s
  // Of a fill.
  Index material = none;           ///< number among those of the body
  std::optional<Real> k0 = {};     ///< of each lift under its own weight
  std::vector<int> per_cell = {};  ///< particles of a cell, by region of the mesh
};

/// What an earthwork has done so far, per metre run (in space: in all; around an axis per radian).
template <int dim>
struct EarthworkState {
  Index lifts = 0;         ///< of its lifts
  std::int32_t first = 0;  ///< of a fill: number of its first particle
  BigIndex particles = 0;
  Real volume = 0;  ///< m2 or m3, as the particles had it
  Real mass = 0;    ///< kg/m or kg, of the density that gives the weight
  Real room = 0;    ///< m2 or m3, of a fill: what its lifts so far had room for
  // Of soil taken out; soil that is placed rests.
  Vec<dim> momentum = Vec<dim>::Zero();  ///< N s/m or N s, of the density that gives the inertia
  Real kinetic = 0;                      ///< J/m or J
};

/// All earthworks of a body, in the order in which those that are due at once are done: first what is taken out.
template <int dim>
void add_earthworks(const bodies::BodySettings& settings, Index body, Model<dim>& model);

/// The mass that a fill had room for so far, in the unit of EarthworkState::mass.
template <int dim>
Real mass_of_room(const Model<dim>& model, const Earthwork<dim>& fill, const EarthworkState<dim>& so_far);

/// How many particles the fills of a body can need.
template <int dim>
Index room_for_fills(const Model<dim>& model, Index body);

/// Places and takes out what is due at this moment; true where something was. A fill puts particles, at rest, at the points of the cells where a body would have
/// them at the start: inside its area and no rigid body, and where soil that is there leaves room (SoilAround::has_room). The volume of those of a lift is scaled so that they fill what soil and rigid
/// bodies leave of the area up to the top of the lift. Depends on the state alone, and not on how it is divided among ranks.
template <int dim>
bool carry_out_earthworks(const Model<dim>& model, State<dim>& state);

/// What soil took along that was taken out: momentum and kinetic energy.
template <int dim>
EarthworkState<dim> taken_out(const State<dim>& state);

}  // namespace berm::problem
