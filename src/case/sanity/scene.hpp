// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "input/places.hpp"
#include "problem/model.hpp"

#include <functional>

namespace berm::sanity {

/// From ... to, m along one axis.
struct Span {
  Real from = infinity, to = -infinity;

  void add(Real x) { from = std::min(from, x), to = std::max(to, x); }
  Real length() const { return to - from; }
};
using Spans = std::array<Span, 3>;
using Place = std::array<Real, 3>;

/// The displacement of a driven body along an axis in a stage, as far as the input says it, m since the start.
struct Move {
  Real begin = 0, end = 0;
  bool begin_known = true;
  bool known = true;     ///< false: nothing in the input says where it ends; `end` is then `begin`
  bool at_most = false;  ///< the stage may end earlier
  bool moves = false;    ///< in this stage, by a velocity or a force
};

/// What a stage does with the body that it drives.
struct Way {
  std::size_t stage = 0;
  Index rigid = none;
  std::array<Move, 3> axis;
  Real begin_embedment = 0;  ///< m, w where the stage begins
  bool begin_known = true;   ///< whether that is known
  bool turns = false;        ///< by a velocity or a moment, or because it may

  Place begin() const { return {axis[0].begin, axis[1].begin, axis[2].begin}; }
  Place end() const { return {axis[0].end, axis[1].end, axis[2].end}; }
};

/// What a rigid body is at the start.
struct RigidScene {
  bool bounded = false;
  Real width = 0;  ///< m
  Spans space;     ///< what it takes, along each axis
};

/// A place of a rigid body's surface behind which lies a face that looks the other way, at the start.
struct ThinPlace {
  Place at = {}, normal = {};  ///< m; unit vector out of the body
  Real thickness = 0;          ///< m, along the normal
  Real lever = 0;              ///< m, at which a rotation about the centre moves it along its normal, at most
};

/// A region of the mesh that a deformable body fills.
struct RegionScene {
  std::string name;
  Spans space;
};

/// What a deformable body is at the start.
struct BodyScene {
  Spans space;          ///< of its particles or elements
  Real wave_speed = 0;  ///< m/s, of pressure waves
  Real depth = 0;       ///< m, of soil below the surface
  std::vector<RegionScene> regions = {};
};

/// A load on the surface of the soil: a traction, or the head of a support.
struct LoadScene {
  std::string key;            ///< "traction.fill", "support.base.head"
  std::vector<Place> points;  ///< m, at the start, a little within the soil of a head
};

/// The boundary that a support holds.
struct SupportScene {
  Spans space;
  Real cell = infinity;  ///< m, size of the smallest cell with soil at it
};

/// The highest frequencies that the cells resolve everywhere in the soil, Hz: waves of so many cells.
struct ResolvedWaves {
  static constexpr Real cells = 8;
  Real shear = infinity, pressure = infinity;
};

/// What a run will cost, as far as it is known before it begins.
struct Cost {
  Real time_step = 0;             ///< s; 0: there is none, or it is not known
  Real particles = 0;             ///< or nodes
  Real frame_bytes = 0;           ///< of one frame
  Real free_bytes = infinity;     ///< on the disk
  Real particle_steps_per_s = 0;  ///< expected
};

/// A case with what follows from it in its mesh, whatever its dimension: what the questions look at.
struct Scene {
  const settings::Case& c;
  const input::Places& places;
  int up = 1, along = 0;
  Real up_sign = 1;
  Real gravity = 0;  ///< m/s2, size
  Spans mesh = {};
  std::vector<std::string> mesh_remarks = {};  ///< of what reading changed of its file
  problem::Ground ground = {};
  std::vector<RigidScene> rigids = {};
  std::vector<BodyScene> bodies = {};
  std::vector<SupportScene> supports = {};              ///< by Case::support
  std::vector<LoadScene> loads = {};                    ///< tractions, in the order of Case::traction, then heads
  ResolvedWaves resolved = {};                          ///< where a support moves
  std::vector<std::pair<Index, Index>> neighbors = {};  ///< pairs of bodies that lie at each other at the start
  std::vector<Way> ways = {};                           ///< by stage
  std::vector<settings::StageSettings> stages = {};     ///< those of the case, with the limits of those that end at equilibrium
  std::function<Real(Index, const Place&)> cell_size =
      {};  ///< at a rigid body with a displacement since the start, m; NaN where it is not in the mesh
  std::function<std::string(const Place&)> region = {};  ///< of the mesh at a point; "" where there is none
  std::function<Real(const Place&, const Place&)> cell_along =
      {};                                                  ///< length of the cell at a point along a unit vector, m; NaN outside the mesh
  std::function<bool(Index, const Place&)> soil_at = {};   ///< whether cells of a body's soil are at a point at the start
  std::function<Real(Index, const Place&)> distance = {};  ///< of a point from a rigid body at the start, m; negative inside
  std::function<std::vector<ThinPlace>(Index)> thin_places = {};  ///< of a rigid body
  Cost cost = {};

  bool is_mpm() const { return c.method == settings::Method::mpm; }
  const material::Material& material_of(Index body) const { return c.material[index_of(c.material, c.body[body].second.material)].second; }
  /// The region of a body's soil at a depth below the surface, m, under the main rigid body; "" where none is there.
  std::string region_at(Index body, Real depth) const;
  /// The soil there.
  material::Material material_at(Index body, Real depth) const { return soil_of(c, c.body[body].second).at(region_at(body, depth), depth); }
  /// The weight of the soil above it over area, Pa.
  Real weight_above(Index body, Real depth) const
  {
    return gravity * soil_of(c, c.body[body].second).mass_above(region_at(body, depth), depth);
  }
  /// The body that touches a rigid one, the first of its contacts; none where nothing does.
  Index touched_by(Index rigid) const;
  /// Depth of soil of a body below the surface, m.
  Real depth_of(Index body) const { return bodies[body].depth; }
  /// Height of the ground below a body that is displaced along the drag, over that at another displacement, m; 0 on a level bed.
  Real ground_rise(Index rigid, Real from, Real to) const;
};

/// The scene of a problem by either method; particles and points of loads: of the material point method, else empty.
template <int dim>
Scene scene_of(const settings::Case& c, const input::Places& places, const problem::Model<dim>& model,
               const std::vector<bodies::Particles<dim>>& particles, const std::vector<problem::LoadPointState<dim>>& load_points,
               const Cost& cost);

/// How the stages move the bodies that they drive, as far as the input says it. Where a free body goes in a stage that does not drive it is not known.
template <int dim>
std::vector<Way> ways_of(const problem::Model<dim>& model);

/// What a body takes along an axis during a stage.
Span swept(const Scene& s, const Way& way, int d);

/// Whether the way meets the soil that a body has at the start along an axis; or both upwards and along the bed, then with what fills have placed by then. As far as
/// it is known.
bool may_meet(const Scene& s, const Way& way, const BodyScene& soil, int d);
bool may_meet(const Scene& s, const Way& way, Index body);

/// Whether a work of earth has begun when a stage does.
bool has_begun(const Scene& s, const bodies::EarthworkSettings& work, std::size_t stage);

/// Whether it meets any soil that touches the rigid body: a stage may be all in the air.
bool may_meet_soil(const Scene& s, const Way& way);

}  // namespace berm::sanity
