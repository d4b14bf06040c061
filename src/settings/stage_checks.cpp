// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/input/read_case_wrong_inputs_test.cpp
#include "settings/stage_checks.hpp"

#include "core/names.hpp"
#include "settings/drives.hpp"
#include "settings/load_checks.hpp"
#include "settings/sweeps.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::settings {
namespace {

/// What drives the body of a stage needs its inertia: a force its mass, a moment its moment of inertia.
template <int dim>
void check_inertia(Describe& d, const Case& c, const StageSettings& s, const std::string& path)
{
  if (s.kind != StageKind::drive && !s.velocity && !s.force && s.loads.empty()) return;
  const StageDrives<dim> drives = drives_of<dim>(s, axes_of<dim>(bodies::to_vec<dim>(c.gravity)), false);
  const std::string& driven = s.rigid.empty() ? c.rigid.front().first : s.rigid;
  for (const auto& [name, rigid] : c.rigid) {
    if (name != driven) continue;
    d.check(rigid.mass > 0 || s.drive.point.empty(), path, fmt::format("drives [rigid.{}] at a point, which therefore needs a mass", name));
    d.check(rigid.mass > 0 || !has_force<dim>(drives), path, fmt::format("a force drives [rigid.{}], which therefore needs a mass", name));
    d.check(rigid.mass > 0 || rigid.moment_of_inertia || !has_moment<dim>(drives), path,
            fmt::format("a moment rotates [rigid.{}], which therefore needs a mass or a moment_of_inertia", name));
    const auto turns = [](const FreedomDrive& drive) { return drive.by != FreedomDrive::By::velocity || drive.value != 0; };
    d.check(bodies::is_bounded(bodies::make_shape<2>(rigid.shape)) || std::none_of(drives.begin() + dim, drives.end(), turns), path,
            fmt::format("[rigid.{}] is a half-plane, which cannot rotate", name));
  }
}

/// A freedom is driven in one way, and only those of the geometry are.
void check_drive(Describe& d, const Case& c, const StageSettings& s, const std::string& path)
{
  const bool drive = s.kind == StageKind::drive, plane = c.dimension() == 2;
  const bool turned = drive || ((s.kind == StageKind::push || s.kind == StageKind::drag) && c.method == Method::mpm);
  bool any = false;
  const auto freedom = [&](const char* key, int ways, bool there) {
    const std::string at = path + ".drive." + key;
    any = any || ways > 0;
    d.check(ways == 0 || there, at,
            plane ? "is not a degree of freedom in plane strain: x, y and rotation are"
                  : "is not a degree of freedom in space: x, y, z and rotation_x, _y, _z are");
    d.check(ways <= 1, at, "is driven in one way only");
  };
  const auto spring = [&](const char* key, bool has, bool prescribed, bool there) {
    if (has) freedom(key, 1, there);
    d.check(!has || !prescribed, path + ".drive." + key + ".spring",
            "cannot be combined with what is prescribed; a force, hold or free does");
  };
  const auto shift = [&](const char* key, const FreedomSettings& f, bool there) {
    const int ways = f.velocity.has_value() + f.force.has_value() + f.hold + f.free;
    d.check(drive || (ways == 0 && !f.spring), path + ".drive." + key,
            "is for kind = \"drive\"; a push or a drag has velocity, force and vertical");
    freedom(key, ways, there);
    spring(key, f.spring.has_value(), f.velocity.has_value(), there);
  };
  const auto turn = [&](const char* key, const TurnSettings& f, bool there) {
    const int ways = f.velocity.has_value() + f.moment.has_value() + f.fixed + f.free;
    d.check(turned || (ways == 0 && !f.spring), path + ".drive." + key,
            "is for kind = \"drive\", \"push\" and \"drag\" of method = \"mpm\"");
    freedom(key, ways, there);
    spring(key, f.spring.has_value(), f.velocity.has_value() || f.fixed, there);
  };
  shift("x", s.drive.x, true);
  shift("y", s.drive.y, true);
  shift("z", s.drive.z, !plane);
  turn("rotation", s.drive.rotation, plane);
  turn("rotation_x", s.drive.rotation_x, !plane);
  turn("rotation_y", s.drive.rotation_y, !plane);
  turn("rotation_z", s.drive.rotation_z, !plane);
  d.check(!drive || any || has_load_history(s), path + ".drive", "a drive needs at least one degree of freedom: x, y, z or a rotation");
  const std::string point = path + ".drive.point";
  d.check(s.drive.point.empty() || drive, point, "is for kind = \"drive\"");
  d.check(s.drive.point.empty() || c.method == Method::mpm, point, "finite elements drive a body at its centre: leave it out");
  d.check(s.drive.point.empty() || static_cast<int>(s.drive.point.size()) == c.dimension(), point,
          plane ? "needs two coordinates" : "needs three coordinates");
  d.check(s.drive.point.empty() || (!s.drive.x.spring && !s.drive.y.spring && !s.drive.z.spring), point,
          "cannot be combined with springs along the axes, which hold the centre");
  const auto no_spring = [&](const char* key, const std::optional<Real>& stiffness) {
    d.check(!stiffness || c.method == Method::mpm, path + ".drive." + key + ".spring", "finite elements have no springs: leave it out");
  };
  no_spring("x", s.drive.x.spring);
  no_spring("y", s.drive.y.spring);
  no_spring("rotation", s.drive.rotation.spring);
}

void check_sweep(Describe& d, const StageSettings& s, const std::string& path)
{
  const bool sweep = s.kind == StageKind::sweep;
  d.check(!sweep || s.amplitude, path, "a sweep needs an amplitude, the travel of each drag");
  d.check(!sweep || s.sweeps > 0, path, "a sweep needs the number of drags: sweeps = 2 goes out and back");
  d.check(!sweep || (s.velocity && *s.velocity != 0), path,
          "a sweep needs a velocity: along x for the first drag, less than 0 = against x");
  d.check(sweep || !s.amplitude, path + ".amplitude", "only a sweep has an amplitude");
  d.check(sweep || s.sweeps == 0, path + ".sweeps", "only a sweep has several drags");
  d.check(sweep || s.pause == 0, path + ".pause", "only a sweep has pauses");
  d.check(!sweep || s.pause > 0 || s.strength_recovery == 0, path + ".strength_recovery", "of a sweep needs a pause between its drags");
  const Until& u = s.until;
  d.check(!sweep || (!u.time && !u.displacement && !u.embedment && !u.force && !u.consolidation), path + ".until",
          "a sweep ends after its drags");
}

void check_load_history(Describe& d, const Case& c, const StageSettings& s, const std::string& path)
{
  const bool given = !s.load_times.empty() || !s.load_factors.empty() || !s.loads.empty();
  d.check(given || !s.load_history.empty() || s.time_scale == 1, path + ".time_scale", "is for a load history, and there is none");
  d.check(given || !s.load_history.empty() || s.load_repeat == 1, path + ".load_repeat", "is for a load history, and there is none");
  d.check(given || !s.load_history.empty() || !s.water, path + ".water", "is for a load history, and there is none");
  if (!given && s.load_history.empty()) return;
  d.check(s.kind == StageKind::push || s.kind == StageKind::drag || s.kind == StageKind::drive || s.kind == StageKind::pipeline, path,
          "only a push, a drag, a drive or the loads of a pipeline have a load history");
  d.check(!given || s.load_history.empty(), path + ".load_times", "cannot be combined with load_history, which is a file of both");
  if (const std::string fault = fault_of_loads(c, s); !fault.empty()) {
    const std::size_t colon = fault.find(": ");
    d.check(false, colon == 0 ? path : path + "." + fault.substr(0, colon), fault.substr(colon + 2));
  }
}

void check_force_limit(Describe& d, const StageSettings& s, const std::string& path)
{
  if (!s.until.force) return;
  d.check(s.kind != StageKind::drive, path + ".until.force", "is V of a push or H of a drag");
  const bool up = s.kind == StageKind::push && (s.velocity.value_or(0) < 0 || s.force.value_or(0) < 0);
  d.check(*s.until.force > 0 || (up && *s.until.force < 0), path + ".until.force",
          up ? "must not be 0: V in a push upwards falls to it, and is less than 0 where the soil holds the body down"
             : "must be more than 0; less than 0 it is for a push upwards, where the soil holds the body down");
}

/// All displacements count from the first stage's beginning anyway.
void check_zero_displacements(Describe& d, const StageSettings& s, int k, const std::string& path)
{
  d.check(!s.zero_displacements || k > 0, path + ".zero_displacements",
          "without it displacements are measured from the first stage: it is for a later stage, from which they are to be measured");
}

void check_equilibrium(Describe& d, const Case& c, const StageSettings& s, const std::string& path)
{
  d.check(s.kind == StageKind::geostatic || !s.until.equilibrium, path + ".until.equilibrium",
          "is for kind = \"geostatic\", in which nothing drives the soil");
  const auto damped = [](const auto& body) { return body.second.damping > 0; };
  d.check(!ends_at_equilibrium(s) || c.method != Method::mpm || s.damping.value_or(0) > 0 ||
              (!s.damping && std::all_of(c.body.begin(), c.body.end(), damped)),
          path + ".damping", "is needed for equilibrium: without it the soil oscillates without end; take damping = 0.7 in this stage");
}

/// The stage in which thrown bodies begin drives none of them.
void check_thrown(Describe& d, const Case& c)
{
  const auto first = std::find_if(c.stage.begin(), c.stage.end(), [](const StageSettings& s) { return s.kind != StageKind::geostatic; });
  for (const auto& [name, rigid] : c.rigid) {
    if (rigid.velocity.empty()) continue;
    const std::string path = "rigid." + name + ".velocity";
    d.check(first != c.stage.end(), path, "is that where the first stage begins that is not geostatic, and there is none");
    d.check(
        first == c.stage.end() || !drives(first->kind) || (!first->rigid.empty() && first->rigid != name), path,
        "is that where the first stage begins that is not geostatic, and that stage drives the body: let one of kind \"free\" come first");
  }
}

/// A role is that of a stage that moves the body, or leaves a free one to its weight.
void check_role(Describe& d, const Case& c, const StageSettings& s, const std::string& path)
{
  const auto is_free = [](const auto& rigid) { return rigid.second.motion == bodies::Motion::free; };
  const bool falls = s.kind == StageKind::free && std::any_of(c.rigid.begin(), c.rigid.end(), is_free);
  d.check(s.role == StageRole::automatic || drives(s.kind) || falls, path + ".role",
          "is for a stage that drives the body, and this one drives nothing: give it to the stage that does");
}

}  // namespace

void check_stages(Describe& d, const Case& c)
{
  d.check(!c.stage.empty(), "stage", "a case needs at least one [[stage]]");
  check_thrown(d, c);
  std::vector<std::string> seen;
  for (int k = 0; k < static_cast<int>(c.stage.size()); ++k) {
    const StageSettings& s = c.stage[k];
    const std::string path = fmt::format("stage[{}]", k);
    const bool drag = s.kind == StageKind::drag || s.kind == StageKind::sweep, drive = s.kind == StageKind::drive,
               sweep = s.kind == StageKind::sweep, line = s.kind == StageKind::pipeline, driven = drives(s.kind),
               short_form = driven && !drive && !line;
    d.check(!s.name.empty() && s.name.size() <= max_stage_name && s.name.find_first_of(",\".") == std::string::npos, path + ".name",
            fmt::format("must be a word without comma, dot or quotes, {} bytes at most", max_stage_name));
    d.check(!among(s.name, seen), path + ".name", "another stage has this name");
    seen.push_back(s.name);
    check_zero_displacements(d, s, k, path);
    if (!s.rigid.empty()) check_name(d, path + ".rigid", s.rigid, "rigid", names_of(c.rigid));
    d.check(driven || s.rigid.empty(), path + ".rigid", "only a push, a drag or a drive moves a rigid body");
    d.check(!driven || !c.rigid.empty(), path + ".kind", "there is no [rigid.NAME] to drive");
    d.check(!driven || !s.rigid.empty() || c.rigid.size() == 1, path, "must say which rigid body it drives: rigid = \"...\"",
            names_of(c.rigid));
    d.check(!short_form || s.velocity.has_value() != s.force.has_value() || (!s.velocity && has_load_history(s)), path,
            "needs either velocity or force, and not both");
    d.check(short_form || !s.velocity, path + ".velocity", "only a push or a drag has a velocity");
    d.check(short_form || !s.force, path + ".force", "only a push or a drag has a force");
    d.check(drag || !s.vertical_force, path + ".vertical_force", "only a drag has a vertical force; a push has `force`");
    d.check(!s.vertical_force || s.vertical == Vertical::hold, path + ".vertical_force", "cannot be combined with vertical = \"fixed\"");
    d.check(drag || !s.vertical_velocity, path + ".vertical_velocity", "only a drag has a vertical velocity; a push has `velocity`");
    d.check(!s.vertical_velocity || s.vertical == Vertical::hold, path + ".vertical_velocity",
            "cannot be combined with vertical = \"fixed\"");
    d.check(!s.vertical_velocity || !s.vertical_force, path + ".vertical_velocity", "cannot be combined with vertical_force");
    check_role(d, c, s, path);
    check_drive(d, c, s, path);
    check_sweep(d, s, path);
    check_load_history(d, c, s, path);
    d.check(c.method == Method::mpm || s.pause == 0, path + ".pause", "the finite element method has no time: leave the pause out");
    const Until& u = s.until;
    if (driven) check_force_limit(d, s, path);
    d.check(sweep || ends_at_equilibrium(s) || has_load_history(s) || u.time || u.displacement || u.embedment || u.force || u.consolidation,
            path + ".until", "needs at least one of time, displacement, embedment, force, consolidation");
    check_equilibrium(d, c, s, path);
    d.check(driven || (!u.displacement && !u.embedment && !u.force), path + ".until",
            "a stage that drives nothing ends at a time, or at equilibrium if it is geostatic");
    if (driven) c.dimension() == 2 ? check_inertia<2>(d, c, s, path) : check_inertia<3>(d, c, s, path);
  }
}

}  // namespace berm::settings
