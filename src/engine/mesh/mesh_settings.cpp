// SPDX-License-Identifier: BSD-3-Clause
#include "mesh/mesh_settings.hpp"

#include "mesh/lattice_seabed.hpp"
#include "mesh/spatial_seabed.hpp"
#include "os/error.hpp"
#include "os/gmsh_program.hpp"
#include "os/mesh_cache.hpp"

#include <fmt/format.h>

namespace berm::mesh {
namespace {

namespace fs = std::filesystem;

template <int dim>
Mesh<dim> make(const SeabedMesh& seabed, const fs::path&, const fs::path& work_folder)
{
  refuse_other_dimension(seabed, dim);
  if constexpr (dim == 3) {
    return make_spatial_seabed(seabed);
  } else {
    if (seabed.pattern == SeabedPattern::lattice) return make_lattice_seabed(seabed);
    const fs::path geo = work_folder / "mesh.geo", msh = work_folder / "mesh.msh";
    write_geo(seabed, geo);
    return mesh_by_gmsh<dim>(geo, msh, "mesh");
  }
}

template <int dim>
Mesh<dim> make(const GmshFile& mesh, const fs::path& case_folder, const fs::path& work_folder)
{
  const fs::path user_file = case_folder / mesh.file, ours = work_folder / "mesh.msh";
  std::error_code error;
  if (user_file.extension() == ".geo") {
    if (!fs::is_regular_file(user_file, error)) throw KeyError(fmt::format("mesh.file: there is no geometry {}", user_file.string()));
    return mesh_by_gmsh<dim>(user_file, ours, "mesh.file", &mesh);
  }
  if (!fs::exists(user_file, error)) throw KeyError(fmt::format("mesh.file: {}: there is no such file", user_file.string()));
  Mesh<dim> read = read_msh<dim>(user_file, mesh);
  if (!fs::exists(ours) || !fs::equivalent(user_file, ours)) fs::copy_file(user_file, ours, fs::copy_options::overwrite_existing);
  return read;
}

template <int dim>
Mesh<dim> make(const BoxMesh& box, const fs::path&, const fs::path&)
{
  return make_box<dim>(box);
}

}  // namespace

template <int dim>
Mesh<dim> mesh_by_gmsh(const fs::path& geo, const fs::path& msh, const std::string& key, const GmshFile* settings)
{
  if (settings == nullptr)
    cached_or_generated(geo, msh, dim, [&] { run_gmsh(geo, msh, dim, GeometryBy::berm); });
  else  // a user's geometry may take in other files
    run_gmsh(geo, msh, dim, GeometryBy::user);
  try {
    return settings == nullptr ? read_msh<dim>(msh) : read_msh<dim>(msh, *settings);
  } catch (const InputError& error) {
    std::string why = error.what();
    if (const std::string name = msh.string() + ":"; why.starts_with(name)) why.erase(0, name.size());
    throw KeyError(fmt::format("{}: the mesh that gmsh made cannot be used:{}{}", key, why.starts_with(' ') ? "" : " line ", why));
  }
}

template Mesh<2> mesh_by_gmsh<2>(const fs::path&, const fs::path&, const std::string&, const GmshFile*);
template Mesh<3> mesh_by_gmsh<3>(const fs::path&, const fs::path&, const std::string&, const GmshFile*);

void describe(Describe& d, MeshSettings& mesh)
{
  d.one_of("kind", mesh, {"seabed", "gmsh", "box"},
           {.meaning =
                "where the mesh comes from: generated for a pipe on a seabed, level or with a slope, a trench or a step; read from a "
                "Gmsh file; or a structured box",
            .required = true});
}

template <int dim>
Mesh<dim> make_mesh(const MeshSettings& settings, const fs::path& case_folder, const fs::path& work_folder)
{
  try {
    fs::create_directories(work_folder);
    return std::visit([&](const auto& kind) { return make<dim>(kind, case_folder, work_folder); }, settings);
  } catch (const fs::filesystem_error& error) {
    throw RunError(fmt::format("the mesh cannot be written to the run folder: {}", error.what()));
  }
}

template Mesh<2> make_mesh<2>(const MeshSettings&, const fs::path&, const fs::path&);
template Mesh<3> make_mesh<3>(const MeshSettings&, const fs::path&, const fs::path&);

}  // namespace berm::mesh
