// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/input/read_case_wrong_inputs_test.cpp
#include "settings/case.hpp"

#include "bodies/fill.hpp"
#include "core/axes.hpp"
#include "core/names.hpp"
#include "settings/body_soil.hpp"
#include "settings/drainage.hpp"
#include "settings/earthwork_checks.hpp"
#include "settings/interface.hpp"
#include "settings/rigid_contact_checks.hpp"
#include "settings/safety.hpp"
#include "settings/stage_checks.hpp"
#include "settings/support_checks.hpp"
#include "settings/symmetry.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::settings {

Case::Case() = default;
Case::Case(const Case&) = default;
Case::Case(Case&&) noexcept = default;
Case& Case::operator=(const Case&) = default;
Case& Case::operator=(Case&&) noexcept = default;
Case::~Case() = default;

namespace {

/// Whether up is +y.
bool upwards(const Case& c)
{
  const auto is_y = [](const auto& axes) { return axes.up == 1 && axes.sign > 0; };
  return c.dimension() == 2 ? is_y(axes_of<2>(bodies::to_vec<2>(c.gravity))) : is_y(axes_of<3>(bodies::to_vec<3>(c.gravity)));
}

void check_bodies(Describe& d, const Case& c)
{
  d.check(!c.body.empty(), "body", "a case needs at least one [body.NAME]");
  for (const auto& [name, body] : c.body) {
    const std::string path = "body." + name;
    check_name(d, path + ".material", body.material, "material", names_of(c.material));
    check_soil(d, c, path, body);
    d.check(!body.has_k0() || c.gravity_ramp == 0, path + ".k0",
            "the stress of a bed under full gravity cannot be combined with gravity_ramp");
    d.check(!body.has_k0() || c.gravity.size() < 2 || upwards(c), path + ".k0", "the bed's stress at rest is for gravity along -y");
    d.check(!body.regions.empty() + body.block.has_value() + body.disk.has_value() == 1, path,
            fmt::format("needs one of regions = [...], [body.{0}.block] and [body.{0}.disk]", name));
    d.check(body.initial_stress.empty() || !body.has_k0(), path + ".initial_stress", "cannot be combined with k0");
    d.check(body.initial_stress.empty() || body.initial_stress.size() == 3, path + ".initial_stress",
            fmt::format("needs 3 numbers, xx, yy and zz, and has {}", body.initial_stress.size()));
    const char* counts =
        c.dimension() == 2 ? "must be 1, 2, 4, 8, 9, 16, 18, ... (n^2 or 2 n^2) in triangles" : "must be 1, 8, 27, ... in tetrahedra";
    const auto shares_cell = [&](int count) { return c.dimension() == 2 ? bodies::shares_cell<2>(count) : bodies::shares_cell<3>(count); };
    d.check(body.particles_per_cell == 0 || shares_cell(body.particles_per_cell), path + ".particles_per_cell", counts);
    for (const auto& [region, count] : body.region_particles_per_cell) {
      const std::string key = path + ".region_particles_per_cell." + region;
      d.check(shares_cell(count), key, counts);
      d.check(among(region, body.regions), key, "the body does not fill this region", body.regions);
    }
    for (const auto& entry : body.region_damping)
      d.check(among(entry.first, body.regions), path + ".region_damping." + entry.first, "the body does not fill this region",
              body.regions);
    if (body.block) {
      bodies::check_entries(d, path + ".block.center", body.block->center, c.dimension());
      bodies::check_entries(d, path + ".block.size", body.block->size, c.dimension());
      d.check(c.dimension() == 2 || body.block->angle == 0, path + ".block.angle", "a block can be rotated in two dimensions only");
    }
    if (body.disk) {
      d.check(c.dimension() == 2, path + ".disk", "there are disks in two dimensions only");
      bodies::check_entries(d, path + ".disk.center", body.disk->center, c.dimension());
      d.check(body.disk->spacing < body.disk->diameter / 2, path + ".disk.spacing", "must be less than half the diameter");
    }
    for (std::size_t k = 0; k < body.initial_velocity.size(); ++k) {
      const bodies::InitialVelocity& wave = body.initial_velocity[k];
      const std::string item = fmt::format("{}.initial_velocity[{}]", path, k);
      bodies::check_entries(d, item + ".amplitude", wave.amplitude, c.dimension());
      bodies::check_entries(d, item + ".wave_number", wave.wave_number, c.dimension(), true);
      d.check(wave.phase == 0 || !wave.wave_number.empty(), item + ".phase", "only a wave has a phase: it needs a wave_number");
    }
  }
}

void check_initial_state(Describe& d, const Case& c)
{
  if (c.initial_state != InitialState::gravity_loading) return;
  const auto has_k0 = [](const auto& body) { return body.second.has_k0(); };
  d.check(std::any_of(c.body.begin(), c.body.end(), has_k0), "initial_state",
          "\"gravity_loading\" is for bodies with k0, and there is none");
  d.check(c.method == Method::mpm || std::all_of(c.body.begin(), c.body.end(), has_k0), "initial_state",
          "with finite elements \"gravity_loading\" needs k0 of all bodies");
  d.check(std::any_of(c.gravity.begin(), c.gravity.end(), [](Real g) { return g != 0; }), "initial_state",
          "\"gravity_loading\" needs gravity");
}

void check_rigids(Describe& d, const Case& c)
{
  for (const auto& [name, rigid] : c.rigid) {
    const std::string path = "rigid." + name;
    bodies::check(d, path, rigid, c.dimension());
    d.check(rigid.depth_slices == 0 || c.method == Method::mpm, path + ".depth_slices",
            "is for the material point method: finite elements do not split forces by depth");
    const auto* profile = std::get_if<bodies::ProfileSettings>(&rigid.shape);
    d.check(c.geometry != Geometry::plane_strain || profile == nullptr || !is_ring(*profile), path + ".x",
            "of a ring, off the axis all around, is for axisymmetry and space; in plane strain use shape = \"polygon\"");
  }
  for (const auto& [name, contact] : c.contact) {
    const std::string path = "contact." + name;
    check_name(d, path + ".body", contact.body, "body", names_of(c.body));
    d.check(contact.rigid.empty() != contact.other_body.empty(), path, "needs either rigid or other_body, and not both");
    if (!contact.rigid.empty()) check_name(d, path + ".rigid", contact.rigid, "rigid", names_of(c.rigid));
    if (!contact.other_body.empty()) check_name(d, path + ".other_body", contact.other_body, "body", names_of(c.body));
    d.check(contact.other_body != contact.body, path + ".other_body", "a body is in no contact with itself");
    d.check(contact.other_body.empty() || contact.detection != contact::Detection::particle, path + ".detection",
            "\"particle\" is for contact with a rigid body", {"automatic", "gap", "overlap", "distance"});
    d.check(rules_of(contact.scheme).stress_first == rules_of(c.contact.front().second.scheme).stress_first, path + ".scheme",
            "\"usf\" is another order of the step, so all contacts must have it, or none");
    check_interface(d, c, path, contact);
  }
  check_rigid_contacts(d, c);
}

void check_stage_names(Describe& d, const Case& c, const std::string& path, const std::vector<std::string>& names)
{
  std::vector<std::string> stages;
  for (const StageSettings& stage : c.stage) stages.push_back(stage.name);
  for (const std::string& name : names) d.check(among(name, stages), path, fmt::format("there is no stage \"{}\"", name), stages);
}

void check_consolidation(Describe& d, const Case& c)
{
  bool flows = false;
  for (const auto& [name, material] : c.material) {
    if (!hydraulics(material)) continue;
    flows = true;
    const std::string path = "material." + name + ".water.drainage";
    d.check(c.method == Method::fem || inertia_density(material) > material::water_density, "material." + name,
            fmt::format("needs inertia_density, that of the saturated soil, where its water flows: more than {:g} kg/m^3",
                        material::water_density));
    d.check(c.contact.empty() || !rules_of(c.contact.front().second.scheme).stress_first, path,
            "\"consolidation\" cannot be combined with scheme = \"usf\"");
  }
  for (std::size_t k = 0; k < c.stage.size(); ++k) {
    if (!c.stage[k].until.consolidation) continue;
    const std::string path = fmt::format("stage[{}].until.consolidation", k);
    d.check(flows, path, "no soil has water that flows: give it water.drainage = \"consolidation\", or end the stage otherwise");
    d.check(c.stage[k].kind != StageKind::geostatic, path, "is for the stages after it: a geostatic stage ends at equilibrium");
    d.check(speed_of(c.stage[k]) == 0, path, "needs a body at rest or under a force: pressure does not dissipate while it is moved");
  }
  for (const auto& [name, support] : c.support)
    d.check(!support.drained || flows, "support." + name + ".drained",
            "no soil has water that flows: give it water.drainage = \"consolidation\", or leave this out");
  for (const auto& [name, contact] : c.contact) {
    if (!contact.drained) continue;
    const std::string path = "contact." + name + ".drained";
    d.check(contact.other_body.empty(), path,
            "is for contact with a rigid body: the water of one deformable body does not cross to another");
    const Index body = index_of(c.body, contact.body);
    if (body == none || index_of(c.material, c.body[body].second.material) == none) continue;
    d.check(hydraulics(soil_of(c, c.body[body].second).materials.front()).has_value(), path,
            fmt::format("the water of [body.{}] does not flow: give its material water.drainage = \"consolidation\", or leave this out",
                        contact.body));
  }
}

/// Gives the stages that last a real time their time in the run.
void find_real_times(Describe& d, Case& c)
{
  for (std::size_t k = 0; k < c.stage.size(); ++k) {
    StageSettings& stage = c.stage[k];
    if (!stage.until.real_time) continue;
    const std::string path = fmt::format("stage[{}].until.real_time", k);
    const std::optional<Real> part = part_of_real_time(c);
    d.check(has_flowing_water(c), path,
            "no soil has water that flows: give it water.drainage = \"consolidation\", or end the stage otherwise");
    d.check(!has_flowing_water(c) || part, path,
            "needs water.real_permeability of each material whose water flows, the same fraction of its permeability in all");
    d.check(!moves_body(stage), path, "is for a body at rest or under a force: the time of a prescribed motion is not scaled");
    d.check(part.value_or(0) <= 1, path,
            "is for a run that is shortened: water.real_permeability is larger than permeability, are the two interchanged?");
    if (!part) continue;
    const Real time = *part * *stage.until.real_time;
    constexpr Real same = 1e-9;
    d.check(!stage.until.time || std::abs(*stage.until.time / time - 1) < same, path,
            fmt::format("is {:.4g} s in the run, and until.time says otherwise: give one of them", time));
    stage.until.time = time;
  }
}

void check_supports(Describe& d, const Case& c)
{
  const std::vector<std::string> directions =
      c.dimension() == 2 ? std::vector<std::string>{"x", "y"} : std::vector<std::string>{"x", "y", "z"};
  for (const auto& [name, support] : c.support) {
    for (const std::string& direction : support.fixed)
      d.check(among(direction, directions), "support." + name + ".fixed", fmt::format("\"{}\" is not a direction", direction), directions);
    check_stage_names(d, c, "support." + name + ".stages", support.stages);
    if (!support.absorbs) continue;
    const std::string key = "support." + name + ".absorbs";
    d.check(c.method == Method::mpm, key, "is for the material point method: finite elements have no waves");
    d.check(support.stages.empty(), key, "acts in all stages: leave out the stages of this support");
    d.check(!has_flowing_water(c), key, "is not for soil whose water flows: its two waves would need separate dashpots");
    const bool at_rest = !c.stage.empty() && c.stage.front().kind == StageKind::geostatic;
    const bool weighs = std::any_of(c.gravity.begin(), c.gravity.end(), [](Real g) { return g != 0; });
    d.check(at_rest || !weighs, key, "needs a geostatic stage first, which gives the force that the boundary then keeps");
    for (const auto& [other_name, other] : c.support) {
      if (&other == &support) break;
      const bool alike = other.absorbs && other.boundary == support.boundary &&
                         std::any_of(support.fixed.begin(), support.fixed.end(),
                                     [&, &other = other](const std::string& direction) { return among(direction, other.fixed); });
      d.check(!alike, key, fmt::format("[support.{}] absorbs the same waves at this boundary: leave one of them out", other_name));
    }
  }
}

void check_tractions(Describe& d, const Case& c)
{
  for (const auto& [name, traction] : c.traction) {
    const std::string path = "traction." + name;
    d.check(index_of(c.body, name) == none && index_of(c.watch, name) == none, path,
            "a [body.NAME] or [watch.NAME] has this name, and columns of the history begin with it");
    d.check(traction.stress.empty() == traction.pressure.has_value(), path, "needs either stress or pressure, and not both");
    if (!traction.pressure) bodies::check_entries(d, path + ".stress", traction.stress, c.dimension());
    d.check(traction.pressure_gradient == 0 || traction.pressure, path + ".pressure_gradient",
            "belongs to a pressure: give pressure = 0 where there is none at the level");
    d.check((traction.pressure_gradient != 0) == traction.level.has_value(), path + ".level",
            "is where the pressure begins to increase: give both level and pressure_gradient, or neither");
    const std::vector<Real>& range = traction.x_range;
    d.check(range.empty() || c.dimension() == 2, path + ".x_range", "a part of a boundary can be loaded in two dimensions only");
    d.check(range.empty() || (range.size() == 2 && range[0] < range[1]), path + ".x_range", "needs 2 numbers, the smaller one first");
    check_stage_names(d, c, path + ".stages", traction.stages);
  }
}

/// The columns of a reaction begin with the name of the support, as those of other things begin with theirs.
void check_support_reactions(Describe& d, const Case& c)
{
  if (!c.output.support_reactions) return;
  const std::string key = "output.support_reactions";
  d.check(!c.support.empty(), key, "there is no support: add a [support.NAME] that holds a boundary, or leave this out");
  d.check(!c.mpm.active_distance, key, "cannot be combined with mpm.active_distance: inactive soil transmits no force to its supports");
  for (const auto& entry : c.support) {
    const std::string& name = entry.first;
    const Index contact = index_of(c.contact, name);
    const auto free_of = [&](bool taken, const char* table) {
      d.check(!taken, "support." + name,
              fmt::format("a [{}.{}] has this name, and columns of the history begin with it: give the support another", table, name));
    };
    free_of(index_of(c.traction, name) != none, "traction");
    free_of(contact != none && !c.contact[contact].second.other_body.empty(), "contact");
    free_of(c.dimension() == 3 && index_of(c.rigid, name) != none, "rigid");
  }
}

/// About how many cells a bed gets around a circle or box that is cut out of it, what is cut out counted with them; 0 around a half-plane.
Real cells_around(const bodies::RigidShapeSettings& shape, mesh::SeabedMesh bed, Real size)
{
  const bodies::RigidShape<2> body = bodies::make_shape<2>(shape);
  if (!bodies::is_bounded(body)) return 0;
  const Vec<2> center = bodies::center_of<2>(body);
  const Real reach = bodies::reach_of<2>(body);
  const mesh::SeabedLayout at = layout_of(bed);
  bed.near_left = std::clamp(center[0] - reach, at.left, at.right);
  bed.near_right = std::clamp(center[0] + reach, at.left, at.right);
  const mesh::GroundLine ground = ground_of(bed);
  const Real level = ground.level() ? 0 : ground.height(center[0]);
  bed.slope = 0;
  bed.trench.reset();
  bed.step.reset();
  bed.near_depth = std::clamp(level + reach - center[1], Real(0), bed.depth);
  bed.near_height = std::clamp(center[1] - level + reach, Real(0), bed.headroom);
  bed.near_size = size;
  bed.far_size.reset();
  bed.layer = 0;
  return expected_cells(bed);
}

void check_fem(Describe& d, const Case& c)
{
  const auto* bed = std::get_if<mesh::SeabedMesh>(&c.mesh);
  if (c.method != Method::fem || !c.fem.contact_size || bed == nullptr) return;
  for (const auto& [name, rigid] : c.rigid)
    d.check(cells_around(rigid.shape, *bed, *c.fem.contact_size) <= mesh::max_seabed_cells, "fem.contact_size",
            fmt::format("makes more than {:.0e} cells around [rigid.{}]: enlarge it or mesh.growth", mesh::max_seabed_cells, name));
}

/// A box of so many cells that its mesh takes minutes and gigabytes, for a stone in it, is a digit too many.
void check_cells_of_box(Describe& d, const Case& c)
{
  const auto* box = std::get_if<mesh::BoxMesh>(&c.mesh);
  const bool by_regions = std::ranges::any_of(c.body, [](const auto& body) { return !body.second.block && !body.second.disk; });
  if (box == nullptr || by_regions || c.method != Method::mpm) return;
  constexpr Real usual = 1e6, for_a_particle = 1e4;
  Real cells = 1, particles = 0;
  for (const Real count : box->cells) cells *= count;
  for (const auto& [name, body] : c.body) {
    if (body.disk) particles += bodies::particles_in(*body.disk);
    if (body.block) particles += c.dimension() == 2 ? bodies::particles_in<2>(*body.block) : bodies::particles_in<3>(*body.block);
  }
  d.check(cells <= std::max(usual, for_a_particle * particles), "mesh.cells",
          fmt::format("makes {:.3g} cells for {:.3g} particles: take larger cells, or a mesh that ends where soil no longer moves", cells,
                      particles));
}

/// Rows and frames are written to a disk that ends. Stages of unknown duration are not counted.
void check_output(Describe& d, const Case& c)
{
  constexpr Real max_rows = 1e10, max_frames = 1e5;
  Real time = 0, travel = 0;
  for (const StageSettings& stage : c.stage) {
    if (stage.until.force || (!stage.velocity && (stage.until.displacement || stage.until.embedment))) continue;
    time += expected_time(stage);
    travel += std::abs(stage.velocity.value_or(0)) * expected_time(stage);
  }
  const auto check_number = [&](const std::optional<Real>& interval, Real whole, Real max, const char* key, const char* what) {
    const Real number = interval ? whole / *interval : 0;
    d.check(number <= max, std::string("output.") + key, fmt::format("makes {:.3g} {}; at most {:.0e} are written", number, what, max));
  };
  check_number(c.output.history_time, time, max_rows, "history_time", "rows of history.csv");
  check_number(c.output.frame_time, time, max_frames, "frame_time", "frames");
  check_number(c.output.frame_travel, travel, max_frames, "frame_travel", "frames");
}

}  // namespace

void describe(Describe& d, MpmSettings& mpm)
{
  d.value(
      "courant", mpm.courant,
      {.meaning =
           "time step divided by the travel time of a wave across the smallest height of a cell; without it, in soil that can yield, three "
           "quarters of the longest one for which the mesh as a whole is stable (docs/theory/method.md)",
       .range = {1e-6, 1}});
  d.value("volumetric_projection", mpm.volumetric_projection,
          {.meaning = "average volume changes over patches of two triangles (six tetrahedra), against locking"});
  d.choice("quadrature", mpm.quadrature, {"full_cells", "particles", "cut_cells"},
           {.meaning =
                "volume over which stress is integrated: a cell within the body over its own volume, one at a free surface or at a rigid "
                "body over "
                "its particles'; each particle over its own everywhere, as published; or as the first, except that a cell cut by a rigid "
                "body is integrated over the remaining volume, and with the adhesion on each face of a rigid body from the particles "
                "beside it: for shaft "
                "friction and for soil that settles along a structure (docs/how_to/penetrate.md)"});
  d.value("min_volume_ratio", mpm.min_volume_ratio,
          {.meaning = "smallest volume of a particle, divided by its initial one", .range = {0, 1, true}});
  d.value("max_volume_ratio", mpm.max_volume_ratio,
          {.meaning = "largest volume of a particle, divided by its initial one; a particle at that volume does not dilate further",
           .range = {1, 10}});
  d.value("velocity_filter", mpm.velocity_filter,
          {.meaning = "in soil that can yield: fraction of the particle velocity not resolved by the nodes that is removed while a wave "
                      "crosses its cell; prevents noise from weakening soil without cohesion",
           .range = {0, 1}});
  d.value("bulk_viscosity", mpm.bulk_viscosity,
          {.meaning =
               "in soil that can yield: viscous mean stress divided by (density x wave speed x height of a cell x rate of volume change); "
               "damps the pressure waves that weaken soil without cohesion",
           .range = {0, 1}});
  d.value("active_distance", mpm.active_distance,
          {.meaning = "while a stage drives a rigid body, soil farther than this from the surface of every rigid body (except half-planes) "
                      "is inactive and takes no computing time: it is held, and keeps its stress; absent: all soil is active",
           .unit = "m",
           .range = positive});
}

void describe(Describe& d, FemSettings& fem)
{
  d.value("contact_size", fem.contact_size,
          {.meaning = "size of the elements at the rigid body; absent: that of the mesh there", .unit = "m", .range = positive});
  d.value("tolerance", fem.tolerance,
          {.meaning = "sum of the unbalanced nodal forces, divided by that of the contact forces, that counts as equilibrium",
           .range = {0, 0.1, true}});
  d.value("large_deformation", fem.large_deformation,
          {.meaning =
               "whether the geometry follows the soil and the mesh is renewed as the rigid body travels (updated Lagrangian elements "
               "with remeshing); without it strains are small and the rigid body is wished in place"});
  d.value("remeshing_travel", fem.remeshing_travel,
          {.meaning = "with large_deformation: travel of the rigid body between remeshings, as a fraction of its width",
           .range = {0, 1, true}});
  d.value("largest_step", fem.largest_step,
          {.meaning = "largest travel in one increment, divided by the width of the rigid body", .range = {0, 1, true}});
  d.value(
      "relaxation", fem.relaxation,
      {.meaning =
           "travel over which stress beyond the strength decays, divided by the width of the rigid body: the largest that is used. While "
           "increments converge quickly it falls to half, or to a ten-thousandth where all soil has dilation_angle = "
           "friction_angle",
       .range = {0, 1, true}});
}

void describe(Describe& d, WatchSettings& watch)
{
  d.value("body", watch.body, {.meaning = "name of the body", .required = true});
  d.value("point", watch.point,
          {.meaning = "the point of the soil, by its initial position: it moves with the soil, and stress and pore pressure are those at "
                      "its current position, linear between the means of the cells around it",
           .unit = "m",
           .required = true});
}

void describe(Describe& d, SafetySettings& safety)
{
  d.value("factor", safety.factor,
          {.meaning =
               "factor by which the strength of all soil and of its interfaces is divided from the start: cohesion, tangents of friction "
               "angles, undrained strength, adhesion, tension",
           .range = positive,
           .required = true});
  d.value("movement", safety.movement,
          {.meaning = "displacement of the soil that counts as failure and ends the run; absent = a hundredth of the height that can slide "
                      "plus twice the compression of elastic soil of that height under its weight and loads",
           .unit = "m",
           .range = positive});
}

void describe(Describe& d, OutputSettings& output)
{
  d.value(
      "history_time", output.history_time,
      {.meaning = "time between rows of history.csv; absent = a thousandth of the duration of the stages", .unit = "s", .range = positive});
  d.value("frame_time", output.frame_time,
          {.meaning = "time between frames; start and end of every stage are always written", .unit = "s", .range = positive});
  d.value("frame_travel", output.frame_travel,
          {.meaning = "travel of the driven rigid body between frames", .unit = "m", .range = positive});
  d.value("support_reactions", output.support_reactions,
          {.meaning =
               "the force of each support on the soil is written to history.csv, by direction. At a node that two supports hold in one "
               "direction, as at a corner, it counts with the one that comes first in the case"});
  d.value("checkpoint_wall_time", output.checkpoint_wall_time,
          {.meaning = "wall time between checkpoints, from which berm run --resume resumes; 0 = only at the end of a stage and where the "
                      "run is stopped",
           .unit = "s",
           .range = not_negative});
}

void describe(Describe& d, ReportSettings& report)
{
  d.value("project", report.project, {.meaning = "name or number of the project"});
  d.value("client", report.client, {.meaning = "client"});
  d.value("document", report.document, {.meaning = "number of the document"});
  d.value("revision", report.revision, {.meaning = "its revision"});
  d.value("date", report.date, {.meaning = "its date, as it is to be written"});
  d.value("author", report.author, {.meaning = "author of the case"});
  d.value("checker", report.checker, {.meaning = "checker"});
  d.value("note", report.note, {.meaning = "a remark for the reader"});
}

void describe(Describe& d, Case& c)
{
  d.value("title", c.title, {.meaning = "description of the case in one line"});
  d.choice("method", c.method, {"mpm", "fem"},
           {.meaning = "material point method; or finite elements, of small strain around a rigid body wished in place, or of large "
                       "deformations (fem.large_deformation)"});
  d.choice("geometry", c.geometry, {"plane_strain", "axisymmetric", "space"},
           {.meaning =
                "plane strain, all per metre run; axisymmetric about x = 0, with x the radius and gravity along y; or three-dimensional"});
  d.value("symmetry", c.symmetry,
          {.meaning = "in space: axes normal to planes of symmetry, where the mesh ends at its lowest x or z: [\"z\"] for a half, [\"x\", "
                      "\"z\"] for a quarter. Input and results are those of the whole"});
  d.value("gravity", c.gravity,
          {.meaning = "gravity, one number per direction, such as [0, \"-50 gravity\"]; absent = none", .unit = "m/s^2"});
  d.value("gravity_ramp", c.gravity_ramp,
          {.meaning = "time over which gravity increases from zero to its full value at the start", .unit = "s", .range = not_negative});
  std::optional<Real> level = c.surface_given || c.surface != 0 ? std::optional(c.surface) : std::nullopt;
  d.value("surface", level,
          {.meaning = "level y of the seabed at the start, from which embedment is measured; absent = 0 for a level bed, and on a "
                      "slope, in a trench or on a step the ground below the rigid body",
           .unit = "m"});
  c.surface_given = level.has_value();
  c.surface = level.value_or(0);
  d.choice(
      "initial_state", c.initial_state, {"automatic", "level_ground", "gravity_loading"},
      {.meaning =
           "initial stress of bodies with k0: that below a level surface in soil of one density; or the elastic equilibrium under gravity, "
           "for slopes, trenches and layers; automatic = the second where the ground is not level (in the plane), else the first"});
  d.table("mesh", c.mesh, {.meaning = "the background mesh", .required = true});
  d.named_tables("material", c.material, {.meaning = "materials", .required = true});
  d.named_tables("random_field", c.random_field,
                 {.meaning = "strength or stiffness that varies at random from place to place, by a lognormal distribution"});
  d.named_tables("body", c.body, {.meaning = "deformable bodies", .required = true});
  d.named_tables("rigid", c.rigid, {.meaning = "rigid bodies"});
  d.named_tables("contact", c.contact, {.meaning = "contacts of a deformable body with a rigid one or another deformable one"});
  d.named_tables("rigid_contact", c.rigid_contact, {.meaning = "contacts of a rigid body with another rigid one"});
  d.named_tables("support", c.support, {.meaning = "boundaries that are fixed"});
  d.named_tables("traction", c.traction, {.meaning = "loads on boundaries of the soil"});
  d.array("stage", c.stage, {.meaning = "the stages of the run, in sequence", .required = true});
  d.table("mpm", c.mpm, {.meaning = "the material point method"});
  d.table("fem", c.fem, {.meaning = "the finite element method"});
  d.named_tables("watch", c.watch, {.meaning = "points of the soil whose motion, stress and pore pressure are written to the history"});
  d.optional_table(
      "safety", c.safety,
      {.meaning = "a trial of the factor of safety: whether the soil is stable with reduced strength; berm safety makes such trials"});
  d.optional_table("pipeline", c.pipeline, {.meaning = "makes the case a slice of a pipeline: a bending line on slices of deforming soil"});
  d.table("output", c.output, {.meaning = "output"});
  d.table("report", c.report, {.meaning = "project data for berm report; no effect on results"});

  bodies::check_entries(d, "gravity", c.gravity, c.dimension(), true);
  if (const auto* file = std::get_if<mesh::GmshFile>(&c.mesh)) {
    mesh::check_axes(d, "mesh.axes", file->axes, c.dimension());
    bodies::check_entries(d, "mesh.shift", file->shift, c.dimension(), true);
  }
  for (const auto& [name, material] : c.material) check(d, "material." + name, material);
  for (auto& [name, body] : c.body) find_k0(d, c, "body." + name, body);
  check_bodies(d, c);
  check_random_fields(d, c);
  check_earthworks(d, c);
  check_initial_state(d, c);
  check_rigids(d, c);
  for (const auto& [name, watch] : c.watch) {
    check_name(d, "watch." + name + ".body", watch.body, "body", names_of(c.body));
    bodies::check_entries(d, "watch." + name + ".point", watch.point, c.dimension());
  }
  find_real_times(d, c);
  check_stages(d, c);
  check_consolidation(d, c);
  check_active_distance(d, c);
  check_supports(d, c);
  check_heads(d, c);
  check_motions(d, c);
  check_support_reactions(d, c);
  check_tractions(d, c);
  check_axisymmetry(d, c);
  check_symmetry(d, c);
  check_fem(d, c);
  check_cells_of_box(d, c);
  check_safety(d, c);
  check_pipeline(d, c);
  check_output(d, c);
}

SupportSets support_sets(const Case& c)
{
  SupportSets sets;
  for (const StageSettings& stage : c.stage) {
    std::vector<SupportRole> roles;
    for (const auto& [name, support] : c.support) {
      const bool acts = acts_in(support.stages, stage.name);
      const bool absorbs = support.absorbs && stage.kind != StageKind::geostatic;
      roles.push_back(!acts ? SupportRole::none : absorbs ? SupportRole::absorbs : SupportRole::holds);
    }
    const auto same = std::find(sets.roles.begin(), sets.roles.end(), roles);
    sets.of_stage.push_back(static_cast<Index>(same - sets.roles.begin()));
    if (same == sets.roles.end()) sets.roles.push_back(roles);
  }
  if (sets.roles.empty()) sets.roles.emplace_back(c.support.size(), SupportRole::holds);
  return sets;
}

Index main_rigid(const Case& c)
{
  for (const StageSettings& stage : c.stage)
    for (Index k = 0; k < static_cast<Index>(c.rigid.size()); ++k)
      if (c.rigid[k].first == stage.rigid) return k;
  return c.rigid.empty() ? none : 0;
}

}  // namespace berm::settings
