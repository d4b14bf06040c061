// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/simulation/longer_mesh_test.cpp
#include "simulation/longer_mesh.hpp"

#include "core/ranks.hpp"
#include "input/read_case.hpp"
#include "input/write_case.hpp"
#include "os/error.hpp"
#include "os/text_of_list.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace berm::simulation {
namespace {

const std::vector<std::string> keys = {"mesh.near_left", "mesh.near_right", "mesh.left", "mesh.length"};

void refuse_other_keys(const std::vector<std::string>& set)
{
  for (const std::string& change : set)
    if (const std::string key = change.substr(0, change.find('=')); std::find(keys.begin(), keys.end(), key) == keys.end())
      throw InputError(
          fmt::format("--set {}: a run is resumed as it was begun, but for a longer mesh (allowed: {})", change, text_of_list(keys, ", ")));
}

/// The seabed of the mesh of a case that can go on on a longer one; else null.
const mesh::SeabedMesh* bed_to_lengthen(const settings::Case& c)
{
  const auto* bed = std::get_if<mesh::SeabedMesh>(&c.mesh);
  const bool in_plane = c.method == settings::Method::mpm && c.geometry == settings::Geometry::plane_strain;
  return bed != nullptr && in_plane && !bed->trench && !bed->step ? bed : nullptr;
}

const mesh::SeabedMesh& bed_of(const settings::Case& c)
{
  if (const mesh::SeabedMesh* bed = bed_to_lengthen(c)) return *bed;
  throw InputError(
      "--set: only a run of the material point method in plane strain on a mesh of kind = \"seabed\" without trench and step is resumed on "
      "a longer mesh: begin a new run");
}

/// From x = 0 to the left wall, m.
Real left_of(const mesh::SeabedMesh& bed)
{
  return bed.left.value_or(bed.length / 2);
}

/// `right`: of an end on the right, m.
void refuse_shorter(const char* what, Real now, Real before, bool right)
{
  constexpr Real rounding = 1e-9;
  if (right ? now < before - rounding : now > before + rounding)
    throw InputError(fmt::format("--set: {} would lie at x = {:.6g} m, inside of that of the run, {:.6g} m: a mesh can only become longer",
                                 what, now, before));
}

/// To 0.1 m.
Real rounded_up(Real x)
{
  return std::ceil(10 * x - 1e-6) / 10;
}

}  // namespace

RunRequest on_longer_mesh(const RunRequest& resumed, const std::vector<std::string>& set)
{
  refuse_other_keys(set);
  const mesh::SeabedMesh& before = bed_of(resumed.settings);
  if (Ranks::of_run().count() > 1)
    throw InputError("--set: a run is carried to a longer mesh by one process: start it without the launcher");
  RunRequest longer = resumed;
  longer.settings = input::read_case_text((resumed.folder / "resolved.toml").string(), input::resolved_toml(resumed.settings), set);
  const mesh::SeabedMesh& bed = bed_of(longer.settings);
  refuse_shorter("mesh.near_left", bed.near_left, before.near_left, false);
  refuse_shorter("mesh.near_right", bed.near_right, before.near_right, true);
  refuse_shorter("the left end of the mesh, -mesh.left,", -left_of(bed), -left_of(before), false);
  refuse_shorter("the right end of the mesh, mesh.length - mesh.left,", bed.length - left_of(bed), before.length - left_of(before), true);
  if (input::resolved_toml(longer.settings) == input::resolved_toml(resumed.settings)) return resumed;
  longer.set = set;
  longer.shorter = std::make_shared<const RunRequest>(resumed);
  return longer;
}

std::string command_to_lengthen(const RunRequest& run, const Sides& sides)
{
  const mesh::SeabedMesh* bed = bed_to_lengthen(run.settings);
  if (bed == nullptr) return "";
  const auto& [start, now] = sides;
  const Real width = start.to - start.from;
  const auto outgrows = [&](Real room, Real travel) { return room < width && travel > 0.1 * width; };
  const bool left = outgrows(now.from - bed->near_left, start.from - now.from),
             right = outgrows(bed->near_right - now.to, now.to - start.to);
  if (!left && !right) return "";
  const Real near_left = left ? rounded_up(3 * width - now.from) : -bed->near_left,
             near_right = right ? rounded_up(now.to + 3 * width) : bed->near_right, added_left = near_left + bed->near_left,
             added_right = near_right - bed->near_right;
  std::string command = fmt::format("berm run --resume {}", run.folder.string());
  const auto set = [&](const char* key, Real value) { command += fmt::format(" --set 'mesh.{}=\"{:.6g} m\"'", key, value); };
  if (left) set("near_left", -near_left);
  if (right) set("near_right", near_right);
  if (left || !bed->left) set("left", left_of(*bed) + added_left);
  set("length", bed->length + added_left + added_right);
  return command;
}

}  // namespace berm::simulation
