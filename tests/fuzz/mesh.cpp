// SPDX-License-Identifier: BSD-3-Clause
// A .msh file of Gmsh, read in the plane and in space: refused in one line, or a mesh in which every cell is found where its centre lies.
#include "target.hpp"

#include "mesh/gmsh.hpp"
#include "mesh/patches.hpp"
#include "os/error.hpp"

using namespace berm;

namespace {

template <int dim>
void read_in(const std::filesystem::path& path)
{
  try {
    const mesh::Mesh<dim> mesh = mesh::read_msh<dim>(path);
    make_patches(mesh);
    for (Index cell = 0; cell < mesh.cell_count(); ++cell) {
      const mesh::Location found = locate(mesh, mesh.centroid(cell), 0);
      promise(found.inside, "a cell's centre lies in the mesh", std::to_string(cell));
    }
  } catch (const InputError& error) {
    promise_one_line(error.what());
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  static const MemoryFile file;
  read_in<2>(file.hold(data, size));
  read_in<3>(file.hold(data, size));
  return 0;
}
