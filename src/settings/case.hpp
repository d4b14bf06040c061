// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "bodies/body_settings.hpp"
#include "bodies/rigid/rigid_settings.hpp"
#include "boundary/support.hpp"
#include "boundary/traction.hpp"
#include "contact/contact_settings.hpp"
#include "contact/rigid_contact_settings.hpp"
#include "core/names.hpp"
#include "material/material.hpp"
#include "mesh/mesh_settings.hpp"
#include "settings/pipeline_settings.hpp"
#include "settings/random_field_settings.hpp"
#include "settings/stage.hpp"

namespace berm::settings {

/// What the particles of a cell stand for where stress is integrated.
enum class Quadrature {
  full_cells,  ///< within a body a cell for its own volume, at a free surface the particles for theirs
  particles,   ///< each particle for its own volume, everywhere
  cut_cells    ///< as full_cells; of a cell that a rigid body cuts, the part outside of it counts
};

/// What the plane of a case stands for, or that it has none.
enum class Geometry {
  plane_strain,  ///< a metre across the plane x-y: forces and masses are per metre run
  axisymmetric,  ///< all around the axis x = 0, with x the radius: forces and masses are whole ones
  space
};

/// How the material point method runs.
struct MpmSettings {
  /// Time step over the time that a wave needs across the smallest height; empty: by the longest time step for which the mesh is stable.
  std::optional<Real> courant;
  bool volumetric_projection = true;  ///< the cure against volumetric locking
  Quadrature quadrature = Quadrature::full_cells;
  Real min_volume_ratio = 0.8;  ///< bounds of a particle's volume over its first
  Real max_volume_ratio = 1.2;
  /// Of soil that can yield: the part of unresolved particle velocities that is taken out while a wave crosses the smallest height.
  Real velocity_filter = 0.1;
  /// Of soil that can yield: viscous mean stress over density, wave speed, height and rate of volume change.
  Real bulk_viscosity = 0.06;
  /// m: while a stage drives a rigid body, soil farther than that from every bounded one rests; empty: no soil does.
  std::optional<Real> active_distance;
};

/// What computes a case.
enum class Method {
  mpm,  ///< the material point method: large deformation
  fem   ///< small-strain finite elements around a rigid body that is wished in place
};

/// Where k0 takes the stress at the start from.
enum class InitialState {
  automatic,       ///< level_ground where the ground is level in the plane of the drag, else gravity_loading
  level_ground,    ///< sigma_yy = -density gravity (surface - y), which is right below a level surface in soil of one density
  gravity_loading  ///< equilibrium of the bodies with k0 under their own weight, on supports and each other, any surface and layers
};

/// How the finite element method runs.
struct FemSettings {
  std::optional<Real> contact_size;  ///< m, of the elements at the rigid body; empty: that of the fine zone
  Real tolerance = 1e-3;             ///< unbalanced forces over contact forces
  bool large_deformation = false;    ///< the geometry follows the soil, and the mesh is made anew as the rigid body travels
  Real remeshing_travel = 0.04;      ///< of the rigid body from one mesh to the next, over its width
  Real largest_step = 0.02;          ///< travel in one increment, over the width of the rigid body
  Real relaxation = 1e-6;            ///< travel over which stress beyond the strength fades, over the width of the rigid body: at most
};

/// A particle whose motion is written to the history: the one nearest to `point` at the start.
struct WatchSettings {
  std::string body;
  std::vector<Real> point;  ///< m
};

/// A trial of the factor of safety (problem/safety.hpp).
struct SafetySettings {
  Real factor = 1;               ///< what the strength of all soil is divided by
  std::optional<Real> movement;  ///< m, of the soil, from which on it has failed; empty: movement_at_failure
};

/// What is written, and how often.
struct OutputSettings {
  std::optional<Real> history_time;  ///< s between rows of history.csv
  std::optional<Real> frame_time;    ///< s between frames
  std::optional<Real> frame_travel;  ///< m of travel of the driven rigid body between frames
  bool support_reactions = false;    ///< the force of each support on the soil, in the history
  Real checkpoint_wall_time = 300;   ///< s of wall time between checkpoints; 0: at the ends of stages only, and where the run is stopped
};

/// What a report says of the work that the run is part of. Nothing of it enters the computation.
struct ReportSettings {
  std::string project, client, document, revision, date, author, checker, note;
};

/// One input file, in SI units: everything that the user can choose.
struct Case {
  std::string title;
  Method method = Method::mpm;
  Geometry geometry = Geometry::plane_strain;
  std::vector<std::string> symmetry;  ///< axes of the planes that the mesh ends at and the whole is mirrored in: "x", "z"
  std::vector<Real> gravity;          ///< m/s2, one entry a direction; empty = none
  Real gravity_ramp = 0;              ///< s from no gravity to all of it, at the start
  Real surface = 0;                   ///< m, level y of the bed's surface at the start
  bool surface_given = false;         ///< whether the input names that level: then embedment counts from it, whatever the ground
  InitialState initial_state = InitialState::automatic;
  mesh::MeshSettings mesh;
  std::vector<std::pair<std::string, material::Material>> material;
  std::vector<std::pair<std::string, RandomFieldSettings>> random_field;
  std::vector<std::pair<std::string, bodies::BodySettings>> body;
  std::vector<std::pair<std::string, bodies::RigidSettings>> rigid;
  std::vector<std::pair<std::string, contact::ContactSettings>> contact;
  std::vector<std::pair<std::string, contact::RigidContactSettings>> rigid_contact;
  std::vector<std::pair<std::string, boundary::SupportSettings>> support;
  std::vector<std::pair<std::string, boundary::TractionSettings>> traction;
  std::vector<StageSettings> stage;
  MpmSettings mpm;
  FemSettings fem;
  std::vector<std::pair<std::string, WatchSettings>> watch;
  std::optional<SafetySettings> safety;
  std::optional<PipelineSettings> pipeline;  ///< of which the case is a slice
  OutputSettings output;
  ReportSettings report;

  // In case.cpp: what copies and destroys all these lists would else be compiled into half of all sources.
  Case();
  Case(const Case&);
  Case(Case&&) noexcept;
  Case& operator=(const Case&);
  Case& operator=(Case&&) noexcept;
  ~Case();

  /// Finite elements around a body wished in place, which their strains leave there.
  bool small_strain() const { return method == Method::fem && !fem.large_deformation; }
  /// Of its mesh: 2 or 3.
  int dimension() const { return geometry == Geometry::space ? 3 : 2; }
  /// Of its forces: 2 where they are per metre run (N/m), 3 where they are whole (N).
  int force_dimension() const { return geometry == Geometry::plane_strain ? 2 : 3; }
};

void describe(Describe& d, MpmSettings& mpm);
void describe(Describe& d, FemSettings& fem);
void describe(Describe& d, WatchSettings& watch);
void describe(Describe& d, SafetySettings& safety);
void describe(Describe& d, OutputSettings& output);
void describe(Describe& d, ReportSettings& report);

/// All parameters of a case, then what must fit together: names that refer to something, numbers of directions, stages that can end.
void describe(Describe& d, Case& c);

/// What a support does in a stage.
enum class SupportRole : char { none, holds, absorbs };

/// The sets of supports that act together, by place in Case::support; and the set of each stage.
struct SupportSets {
  std::vector<std::vector<SupportRole>> roles;
  std::vector<Index> of_stage;
};
SupportSets support_sets(const Case& c);

/// The rigid body whose u, w, H and V are in the history: the first that a stage names, else the first there is; none without rigid bodies.
Index main_rigid(const Case& c);

}  // namespace berm::settings
