// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "bodies/particles.hpp"
#include "bodies/rigid/dynamics.hpp"
#include "boundary/nodal_conditions.hpp"
#include "core/axes.hpp"
#include "mesh/patches.hpp"
#include "problem/depth_slices.hpp"
#include "problem/earthworks.hpp"
#include "problem/ground.hpp"
#include "problem/interface.hpp"
#include "problem/ledger.hpp"
#include "problem/pressure_means.hpp"
#include "problem/rigid_contact.hpp"
#include "settings/body_soil.hpp"
#include "settings/case.hpp"
#include "settings/interface.hpp"

#include <algorithm>

namespace berm::problem {

/// A deformable body: all of it that does not change.
template <int dim>
struct Body {
  std::string name;
  settings::BodySoil soil;
  NodeField<Real> damping;    ///< local damping factor of each node for this body
  Real weight_over_mass = 1;  ///< density over inertia density: the part of gravity that acts on its particles
  settings::SoilWaves waves = settings::waves_of(soil.materials.front());
  Real critical_length = 0;  ///< m, of the mesh (mesh/critical_length.hpp); 0: the time step is that of the smallest cell

  /// Whether water flows through its pores.
  bool flows() const { return hydraulics(soil.materials.front()).has_value(); }
};

/// A contact with its names looked up.
struct Contact {
  std::string name;
  Index body, rigid, other_body;  ///< rigid or other_body is none
  Real friction;                  ///< tan of the friction angle; where it differs from soil to soil the largest
  Real adhesion;                  ///< Pa; where it differs from place to place, that of adhesion_law
  contact::Scheme scheme;
  contact::Detection detection;
  Real gap_closing_steps;  ///< over State::default_dt
  Real tension = 0;        ///< Pa, that bonded points carry
  AdhesionLaw adhesion_law = {};
  settings::InterfaceMemory memory = {};  ///< of the particles
  int pore_pressure = none;  ///< place of the excess pore pressure, which friction does not feel, among the numbers of a particle; or none
  bool drained = false;      ///< water crosses the rigid body's surface: there is no excess pore pressure at it
  contact::ParticleRim particle_rim = contact::ParticleRim::whole;

  /// Whether points need their share of the surface.
  bool needs_areas() const { return adhesion > 0 || adhesion_law.differs() || tension > 0 || pore_pressure != none; }
};

/// Whether a rigid body rubs on soil with water by this contact, so that its friction comes of the effective normal stress.
template <int dim>
bool rubs_in_water(const Contact& contact, const std::vector<Body<dim>>& bodies)
{
  return contact.rigid != none && contact.friction > 0 && has_pore_pressure(bodies[contact.body].soil.materials.front());
}

/// A traction: when it acts. Its forces are those of the load points.
struct Traction {
  std::string name;
  Real ramp;               ///< s
  std::vector<char> acts;  ///< by stage
};

/// A point that hands a fixed part of a traction to the soil of one body.
template <int dim>
struct LoadPoint {
  Index traction, body;
  Vec<dim> force;  ///< N/m or N, of the whole traction
  Real area;       ///< m or m2 at the start
};

/// A particle that is watched: body and id.
struct Watch {
  std::string name;
  Index body;
  std::int32_t id;
};

/// What cannot change during a run.
template <int dim>
struct Model {
  mesh::Mesh<dim> mesh;
  mesh::Patches patches;  ///< that share one volume change; each cell alone without the volumetric projection
  std::vector<Body<dim>> bodies;
  std::vector<bodies::RigidBody<dim>> rigid_bodies;
  std::vector<DepthSlices> depth_slices;  ///< by rigid body
  std::vector<Contact> contacts;
  std::vector<RigidContact<dim>> rigid_contacts;
  std::vector<RigidPair<dim>> apart;       ///< without a contact: they must not come to overlap
  std::vector<Earthwork<dim>> earthworks;  ///< in the order in which those that are due at once are done
  std::vector<Traction> tractions;
  std::vector<LoadPoint<dim>> load_points;
  boundary::NodalConditions<dim>
      conditions;                       ///< at nodes: supports, motions, absorbing boundaries, water outside, axis and planes of symmetry
  std::array<bool, dim> mirrored = {};  ///< by axis: whether the mesh ends at a plane of symmetry across it, at its lowest coordinate
  Real parts = 1;     ///< equal ones that the whole has, of which this is one: 2 pi radians around an axis, halves, quarters
  Vec<dim> gravity;   ///< m/s2
  Axes<dim> axes;     ///< which way is up
  Real gravity_ramp;  ///< s
  Real surface;       ///< m, level of the bed
  Ground ground;      ///< where the bed is not level
  std::vector<settings::StageSettings> stages;
  std::vector<Index> driven;  ///< the rigid body that each stage drives, or none
  Index main_rigid;           ///< whose u, w, H and V are in the history, or none
  std::vector<Watch> watches;
  settings::MpmSettings mpm;
  bool update_stress_first = false;  ///< contact::SchemeRules::stress_first
  Real longest_period = 0;           ///< s, of the soil's swings; where a stage ends at equilibrium
  Real pressure_window = 0;          ///< s, of PressureMeans; where water flows through soil that has inertia

  bool water_flows() const
  {
    return std::any_of(bodies.begin(), bodies.end(), [](const Body<dim>& body) { return body.flows(); });
  }
  /// The level from which the embedment of a rigid body counts whose axis is there, m along the vertical axis.
  Real surface_at(const Vec<dim>& x) const { return ground.level_at(x[axes.along], surface); }
  /// Depth of a point of the soil, for strength and stiffness that vary with it, m.
  Real soil_depth(const Vec<dim>& x) const
  {
    return axes.depth(x, ground.laid_down.level() ? surface : ground.laid_down.height(x[axes.along]));
  }
  /// Where a point of the soil is, for what varies from place to place.
  settings::SoilPlace soil_place(const Vec<dim>& x) const
  {
    settings::SoilPlace place{x[axes.along], soil_depth(x)};
    if constexpr (dim == 3) place.z = x[3 - axes.up - axes.along];
    return place;
  }
};

/// How a traction or a head grows or falls: the fraction of it that acts goes from one value to another since `begin_time`.
struct TractionState {
  Real begin_time = 0;  ///< s
  Real from = 0, to = 0;
};

/// Where a load point is.
template <int dim>
struct LoadPointState {
  Vec<dim> x;  ///< m
  Index cell;
};

/// How a drive by velocity comes to the limit of force of its stage.
struct ForceApproach {
  Real begin = 0;        ///< N/m or N, the resistance when the stage began
  Real travel = 0;       ///< m, of the drive since the resistance began to go to the limit
  Real mean_travel = 0;  ///< m, its mean, which fades as that of the resistance does

  /// N/m2 or N/m: how fast the mean resistance changes with the mean travel; 0 while it does not.
  Real stiffness(Real mean) const { return mean_travel > 0 ? std::abs(mean - begin) / mean_travel : 0; }
  /// The present resistance, N/m or N, of which this is the mean: without the lag that both means have.
  Real now(Real mean) const { return mean + (mean < begin ? -1 : 1) * stiffness(mean) * (travel - mean_travel); }
};

/// Where the run stands in its list of stages.
template <int dim>
struct StageState {
  Index index = 0;
  Real begin_time = 0;
  Vec<dim> begin_displacement = Vec<dim>::Zero();  ///< of the driven rigid body
  bodies::Orientation<dim> begin_orientation;      ///< and its orientation then
  bodies::Drive drive[bodies::freedoms<dim>] = {};
  ForceApproach approach;
  Real excess_pressure = 0;  ///< Pa, the largest magnitude of excess pore pressure in soil whose water flows, at this moment
  PressureMeans pressure_means;
};

/// Degree of consolidation U since the stage began, 0 to 1: 1 - p/p_max of the largest excess pore pressures in the soil, now and in the stage, without waves.
template <int dim>
Real degree_of_consolidation(const StageState<dim>& stage)
{
  return degree_of_consolidation(stage.pressure_means);
}

/// Which soil takes part in the steps, where the case has MpmSettings::active_distance.
template <int dim>
struct ActiveSoil {
  bool everywhere = true;
  std::vector<bodies::Pose<dim>> poses;  ///< of the rigid bodies when it was last found around them; empty where it is everywhere
  Real stopped = 0;  ///< J/m or J, kinetic energy of soil that still moved when it came to rest: a part of Totals::damping
};

/// Everything that changes during a run; a checkpoint is exactly this.
template <int dim>
struct State {
  Ledger<dim> ledger;  ///< what has been given and taken since the start
  Real time = 0;
  BigIndex step = 0;
  Real dt = 0;                                    ///< s, the time step in force
  Real stable_dt = 0;                             ///< s, the longest that is stable, as it was found last
  Real default_dt = 0;                            ///< s, the same where no mpm.courant is set, however long steps are
  bool stable_dt_holds = false;                   ///< for the step to come; else it is found anew
  Real max_dt = infinity;                         ///< s, which the caller allows
  std::vector<bodies::Particles<dim>> particles;  ///< by body
  std::vector<std::int32_t> numbered;             ///< by body: particles that have got a number so far
  bool lengthened = false;                        ///< carried to a longer mesh (problem/lengthen.hpp): particles are not those of the start
  std::vector<EarthworkState<dim>> earthworks;    ///< by Model::earthworks
  std::vector<NodeField<Vec<dim>>> flux;          ///< by body, at the nodes: of water against the soil (Darcy), m/s; empty where none flows
  std::vector<CellField<Real>>
      pressure_sums;  ///< by body: weighted excess pore pressures of the window in hand, Pa; empty where none flows
  std::vector<bodies::RigidState<dim>> rigid_bodies;
  /// By rigid body: its pose when the cells near it were last listed (contact/detect.hpp), on which the order of sums depends.
  std::vector<bodies::Pose<dim>> listed_poses;
  std::vector<NodeField<Vec<dim>>>
      held_forces;  ///< by body, at the nodes of boundaries that absorb: what held them when they last did, N; empty where none does
  std::vector<TractionState> tractions;
  std::vector<TractionState> heads;  ///< by boundary::Head of Model::conditions
  std::vector<LoadPointState<dim>> load_points;
  StageState<dim> stage;
  ActiveSoil<dim> active_soil;
};

/// The problem that a case asks for.
template <int dim>
struct Problem {
  Model<dim> model;
  State<dim> state;
};

/// All of the model that follows from the case and this mesh; patches and watches stay empty. Throws InputError where a name refers to nothing in the mesh.
template <int dim>
Model<dim> make_model(const settings::Case& c, mesh::Mesh<dim> mesh);

/// Whether some contact lets this rigid body rub on soil with water.
template <int dim>
bool rubs_in_water(const Model<dim>& model, Index rigid)
{
  return std::any_of(model.contacts.begin(), model.contacts.end(),
                     [&](const Contact& contact) { return contact.rigid == rigid && rubs_in_water(contact, model.bodies); });
}

/// Builds patches, particles and rigid bodies on this mesh. Throws InputError where a name refers to nothing in the mesh or a body has no particles.
template <int dim>
Problem<dim> build(const settings::Case& c, mesh::Mesh<dim> mesh);

/// The same on the mesh that the case asks for. Relative paths are those of case_folder; the mesh generator writes into work_folder.
template <int dim>
Problem<dim> build(const settings::Case& c, const std::string& case_folder, const std::string& work_folder);

}  // namespace berm::problem
