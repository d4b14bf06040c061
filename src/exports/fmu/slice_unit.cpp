// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/fmu/slice_unit_test.cpp
#include "fmu/slice_unit.hpp"

#include "fmu/embedded.hpp"
#include "fmu/unit.hpp"
#include "input/write_case.hpp"
#include "io/atomic_file.hpp"
#include "io/sha256.hpp"

#include <fmt/format.h>

namespace berm::fmu {
namespace {

/// Its variables are numbered as slice.c has them. No output depends on an input of the same time: an input drives the next step.
Unit unit_of(const std::string& token)
{
  return {.identifier = "berm_slice",
          .description = "Force between 1 m of pipe and the seabed, by the material point method",
          .variables = {{"time", "independent", "s", "time"},
                        {"v_u", "input", "m/s", "lateral velocity of the pipe in the next step"},
                        {"v_w", "input", "m/s", "velocity of the pipe in the next step, positive downwards"},
                        {"H", "output", "N/m", "force of the pipe on the soil along u, mean of the last step"},
                        {"V", "output", "N/m", "reaction of the soil on the pipe, positive upwards, mean of the last step"},
                        {"u", "output", "m", "lateral displacement of the pipe since the case began"},
                        {"w", "output", "m", "embedment of the invert, positive downwards"},
                        {"contact_mass", "output", "kg/m", "mass of the soil at the nodes that the pipe touches"}},
          .has_derivatives = false,
          .has_bytes_of_states = false,
          .needs_berm = true,
          .library = slice_library,
          .token = token};
}

/// What a case lacks. A body without mass has no force that would hold it.
std::string drive_stage(bool has_mass)
{
  return fmt::format(R"([[stage]]
name = "co_simulation"
kind = "drive"
drive.x.velocity = 0
{}
until.time = "60 s"    # at least as long as the co-simulation
)",
                     has_mass ? "drive.y.hold = true    # holds V; to hold the depth: drive.y.velocity = 0"
                              : "drive.y.velocity = 0   # holds the depth; if the body has a mass, V can be held: drive.y.hold = true");
}

void refuse_other_than_slice(const settings::Case& c)
{
  if (c.method != settings::Method::mpm) throw KeyError("method: FMU export needs method = \"mpm\", the material point method");
  if (c.geometry != settings::Geometry::plane_strain)
    throw KeyError("geometry: FMU export needs geometry = \"plane_strain\": the unit is a slice of soil across a pipe");
  if (c.rigid.size() != 1)
    throw KeyError(fmt::format("rigid: FMU export needs one rigid body, which the co-simulation moves; here there are {}", c.rigid.size()));
  if (c.pipeline)
    throw KeyError(
        "pipeline: FMU export needs a case without a pipeline: the unit is one slice of soil, and the co-simulation models the line");
  const settings::StageSettings& last = c.stage.back();
  if (last.kind != settings::StageKind::drive)
    throw NoDrive(fmt::format("stage[{}].kind: FMU export needs kind = \"drive\" as the last stage, which the co-simulation moves; append "
                              "it after \"{}\"",
                              c.stage.size() - 1, last.name),
                  drive_stage(c.rigid.front().second.mass > 0));
}

constexpr std::string_view dependencies =
    "libberm.so." BERM_LIBRARY_VERSION
    " of berm, of the version that wrote this unit, where the loader finds it: installed, or in a folder that "
    "LD_LIBRARY_PATH names. Gmsh where resources/case.toml has a mesh of kind \"seabed\" that is not a lattice.\n";

}  // namespace

std::string slice_description(int fmi_version, const std::string& token)
{
  return model_description(fmi_version, unit_of(token));
}

std::string fmu_of_slice(settings::Case settings, const std::filesystem::path& folder, int fmi_version)
{
  refuse_other_than_slice(settings);
  std::string mesh;
  std::vector<io::ZipEntry> files;
  const std::string of_mesh = "mesh.msh";
  if (auto* file = std::get_if<mesh::GmshFile>(&settings.mesh)) {
    mesh = io::read_text_file(folder / file->file);
    file->file = of_mesh;
    files.push_back({"resources/" + of_mesh, mesh});
  }
  const std::string text = input::resolved_toml(settings), stage = "stage " + settings.stage.back().name + "\n",
                    token = io::sha256_of(text + stage + mesh), resource = "token " + token + "\n" + stage;
  files.push_back({"resources/case.toml", text});
  files.push_back({"resources/unit.txt", resource});
  files.push_back({"documentation/externalDependencies.txt", dependencies});
  Unit unit = unit_of(token);
  unit.files = std::move(files);
  return archive_of(fmi_version, unit);
}

}  // namespace berm::fmu
