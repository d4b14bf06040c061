// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "record/run_record.hpp"
#include "settings/body_soil.hpp"
#include "settings/case.hpp"

namespace berm::base {

/// What the results of a case's main rigid body are made dimensionless with, and carried to the prototype.
struct BodyScale {
  Real width;        ///< D, m, in the model; 0: no push or drag moves the body and it is not loaded sideways (kind.hpp), or there is none
  Real unit_weight;  ///< effective unit weight of the soil in the model, N/m3: under all its gravity; 0 = weightless
  Real gravity_level = 1;   ///< gravity in the model over that of the earth
  bool noisy = true;        ///< whether forces have the noise of a dynamic method
  int dimension = 2;        ///< of forces: 2 = per metre run, 3 = whole
  Real strength = 0;        ///< undrained strength of soil without friction, Pa; 0: it has none
  Real strength_depth = 0;  ///< m, depth in the soil: where it has that strength; 0: it is the same at all depths
};

/// The scale of a case: the width of its main rigid body, weight and strength of the soil that touches it.
BodyScale body_scale(const settings::Case& c);

/// The same of a run: of the region below the body where regions have their own materials, and strength that varies with depth is that at the embedment at
/// which its push ended, where these are known.
BodyScale body_scale(const record::RunRecord& run);

/// Whether a push or a drag moves the main rigid body of a case, or it is loaded sideways (is_loaded_sideways), and it has a width.
bool drives_a_body(const settings::Case& c);

/// Whether the main rigid body reaches from one side of the mesh to the other, as the plate of an oedometer: a box mesh in the plane.
bool covers_the_mesh(const settings::Case& c);

/// What to call the main rigid body of a case in a sentence: its name there, with spaces for _; "body" without one.
std::string body_word(const settings::Case& c);

/// The main rigid body of a case where that is a pipe; else empty.
std::optional<bodies::DiskOutline> circle_of(const settings::Case& c);

/// The part of the pipe that a case models: 1, or 0.5 where a wall of a seabed goes through its centre, an axis of symmetry; NaN where a wall cuts it
/// elsewhere, or the body is no circle.
Real modelled_part(const settings::Case& c);

/// The contact of a deformable body with the main rigid body, the last where there are several; null where there is none.
const contact::ContactSettings* contact_of_body(const settings::Case& c);

/// The shear strength of an interface with adhesion over this strength of the soil, Pa; 1 where it is tied, NaN where it has friction or the soil no such strength.
Real interface_ratio(const contact::ContactSettings& contact, Real strength);

/// The soil of that deformable body; empty where none touches.
std::optional<settings::BodySoil> touched_soil(const settings::Case& c);

/// The same of a run: where regions have their own materials that of the region that lay below the body
/// at the start at reference_depth, if the run has noted it.
std::optional<settings::BodySoil> touched_soil(const record::RunRecord& run);

/// The entry of a summary's text that names this region.
constexpr const char* region_entry = "region_below_body";

/// The depth whose soil stands for all that the main rigid body meets, m: that of its lowest point at the start, or where a push by embedment ends if that is
/// deeper. It counts as w does, from this ground; without it from that which the input says.
Real reference_depth(const settings::Case& c, const problem::Ground& ground);
Real reference_depth(const settings::Case& c);

/// Depth in the soil of a point w below the ground at the main rigid body's axis at the start, m: on a level bed w.
Real soil_depth(const settings::Case& c, const problem::Ground& ground, Real w);

/// The material at that depth, with its strength there; where regions have their own materials, the body's own material; empty where none touches.
std::optional<material::Material> touched_material(const settings::Case& c);

/// Whether a model stands for a larger prototype: under gravity that differs from the earth's by more than 5 %, which 10 m/s2 does not; without gravity
/// there is none.
bool has_prototype(const BodyScale& scale);

/// The half width of the travel over which noisy forces are averaged, as part of the width.
constexpr Real averaging_half_width = 0.01;

/// The same in metres; 0 where there is no noise.
Real averaging_half(const BodyScale& scale);

/// The size of the cells (finite elements: of the elements) at the driven body, m; NaN where it is not known.
Real near_cell_size(const settings::Case& settings);

/// The same of a run: from its case, or as the run found it; and the largest that it met on its way, NaN where that was not watched.
struct NearCells {
  Real first, largest;  ///< m
};
NearCells near_cells(const record::RunRecord& run);

/// Particles a cell there, of the body that it touches; NaN where it is not known or there are none. Of a block or disk: particles per square of the cell size.
Real near_particles(const settings::Case& settings);

/// Particles a cell of a body that is filled cell by cell, where its regions have none of their own: as given, or the default of the filling.
int filled_particles(const bodies::BodySettings& body, int dim);

}  // namespace berm::base
