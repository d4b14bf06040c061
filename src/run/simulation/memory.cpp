// SPDX-License-Identifier: BSD-3-Clause
#include "simulation/memory.hpp"

#include "bodies/fill.hpp"
#include "core/ranks.hpp"
#include "mesh/lattice_seabed.hpp"
#include "mpm/grid.hpp"
#include "os/control_group.hpp"
#include "os/error.hpp"
#include "run_folder/frame_maker.hpp"
#include "settings/interface.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <malloc.h>
#include <sstream>
#include <sys/resource.h>
#include <unistd.h>

namespace berm::simulation {
namespace {

constexpr Real kibibyte = 1 << 10, mebibyte = 1 << 20;

template <int dim, class CellsOf>
std::vector<RunSize::OfBody> min_bodies(const settings::Case& c, const CellsOf& cells_of)
{
  std::vector<RunSize::OfBody> bodies;
  for (const auto& [name, settings] : c.body) {
    RunSize::OfBody body;
    if (index_of(c.material, settings.material) != none)
      for (const std::vector<FieldInfo>& fields : {particle_extra(soil_of(c, settings)), settings::memory_fields(c, name)})
        for (const FieldInfo& field : fields) body.extra_size += field.components;
    if (settings.block || settings.disk) {
      body.particles = settings.block ? particles_in<dim>(*settings.block) : particles_in(*settings.disk);
      body.blocks = body.particles / lanes;
    }
    for (const std::string& region : settings.regions) {
      const Real cells = cells_of(region), in_cell = particles_per_cell<dim>(settings, region);
      body.particles += cells * in_cell;
      body.cells += cells;
      body.blocks += cells * std::ceil(in_cell / lanes);
    }
    bodies.push_back(body);
  }
  return bodies;
}

Real page_count(int place)
{
  std::istringstream file(kernel_words("/proc/self/statm"));
  Real pages = 0;
  for (int k = 0; k <= place; ++k) file >> pages;
  return pages * static_cast<Real>(::sysconf(_SC_PAGESIZE));
}

std::string words_of_memory(Real bytes)
{
  constexpr Real tebibyte = mebibyte * mebibyte;
  return bytes > 1000 * tebibyte ? "more than 1000 TiB" : fmt::format("{:.0f} MiB", bytes / mebibyte);
}

/// Whether the mesh is a lattice, which finite elements do without.
bool is_lattice(const settings::Case& c)
{
  const auto* bed = std::get_if<mesh::SeabedMesh>(&c.mesh);
  return bed != nullptr && bed->pattern == mesh::SeabedPattern::lattice && c.method == settings::Method::mpm;
}

}  // namespace

std::string words_of_count(Real count, const char* of)
{
  constexpr Real most = 1e15;
  return count > most ? fmt::format("more than {:g} {}", most, of) : fmt::format("{:.4g} {}", count, of);
}

template <int dim>
RunSize min_size(const settings::Case& c)
{
  RunSize size;
  size.contacts = c.contact.size();
  if (const auto* box = std::get_if<mesh::BoxMesh>(&c.mesh)) {
    Real squares = 1, points = 1;
    for (const Real cells : box->cells) squares *= cells, points *= cells + 1;
    const bool crossed = dim == 2 && box->pattern == mesh::BoxPattern::criss_cross;
    size.cells = squares * (dim == 3 ? 6 : crossed ? 4 : 2);
    size.nodes = points + (crossed ? squares : 0);
  } else if (const auto* bed = std::get_if<mesh::SeabedMesh>(&c.mesh)) {
    const Real surely = bed->in_space() ? 1 : 0.5;  // in the plane it is an estimate for a mesh that is not made yet
    size.cells = is_lattice(c) ? cells_in_lattice(*bed) : surely * expected_cells(*bed);
    size.nodes = size.cells / mesh::patch_cells<dim>;
  }
  const bool is_box = std::holds_alternative<mesh::BoxMesh>(c.mesh);
  size.bodies = min_bodies<dim>(c, [&](const std::string&) { return is_box ? size.cells : 0; });
  return size;
}

template <int dim>
RunSize min_size(const settings::Case& c, const mesh::Mesh<dim>& mesh)
{
  RunSize size;
  size.contacts = c.contact.size();
  size.cells = mesh.cell_count();
  size.nodes = mesh.node_count();
  size.bodies = min_bodies<dim>(c, [&](const std::string& name) {
    return static_cast<Real>(std::count(mesh.region.begin(), mesh.region.end(), mesh.find_region(name)));
  });
  return size;
}

template <int dim>
RunSize size_of(const problem::Problem<dim>& problem)
{
  RunSize size;
  size.contacts = problem.model.contacts.size();
  size.cells = problem.model.mesh.cell_count();
  size.nodes = problem.model.mesh.node_count();
  for (const bodies::Particles<dim>& particles : problem.state.particles) {
    RunSize::OfBody body{static_cast<Real>(particles.size()), static_cast<Real>(particles.occupied().size()), 0, particles.extra_size()};
    BigIndex blocks = 0;
    for (const Index cell : particles.occupied()) blocks += bodies::blocks_for(particles.count_in(cell));
    body.blocks = static_cast<Real>(blocks);
    size.bodies.push_back(body);
  }
  return size;
}

template <int dim>
Real memory_of(const RunSize& size)
{
  constexpr int corners = dim + 1;
  const Real bodies = static_cast<Real>(size.bodies.size()), contacts = static_cast<Real>(size.contacts);

  // Mesh and Model.
  constexpr Real of_cell = sizeof(typename mesh::Mesh<dim>::Corners) + corners * sizeof(mesh::CornerEntry) + 2 * sizeof(Index);
  const Real of_node = sizeof(Vec<dim>) + sizeof(Index) + sizeof(std::uint8_t) + bodies * sizeof(Real) + contacts * sizeof(Index);
  // Particles by cell and BodyGrid, where the body is, of soil that yields.
  constexpr Real of_cell_with_soil = 3 * sizeof(Index) + sizeof(mpm::Moments<dim>) + corners * sizeof(mpm::CornerSums<dim>) +
                                     sizeof(mesh::Gradients<dim>) + sizeof(mpm::VolumeChange) + 4 * sizeof(Real);
  constexpr Real of_node_with_soil = 3 * sizeof(Real) + 4 * sizeof(Vec<dim>) + 2 * sizeof(std::uint8_t) + sizeof(Index);
  const Real nodes_a_cell = size.nodes / std::max(size.cells, Real(1));

  Real frames = 0, bytes = size.cells * of_cell + size.nodes * of_node;
  for (const RunSize::OfBody& body : size.bodies) {
    // What frames remember of the start, the frame before and the new one.
    frames += body.particles *
              static_cast<Real>(run_folder::FrameMaker<dim>::bytes_a_particle + 2 * run_folder::bytes_of_point<dim>(body.extra_size));
    bytes += body.cells * (of_cell_with_soil + nodes_a_cell * of_node_with_soil) +
             body.blocks * static_cast<Real>(sizeof(bodies::Block<dim>) + body.extra_size * sizeof(StoredLanes));
  }
  // Or mesh.vtu on its way to the disk.
  const Real mesh_file = size.cells * ((corners + 1) * sizeof(std::int64_t) + sizeof(std::int32_t) + 1) + size.nodes * 3 * sizeof(Real);
  return bytes + std::max(frames, mesh_file);
}

Real memory_of_gmsh(const settings::Case& c)
{
  const auto* bed = std::get_if<mesh::SeabedMesh>(&c.mesh);
  if (bed == nullptr || bed->in_space() || is_lattice(c)) return 0;
  constexpr Real at_start = 50 * mebibyte, of_cell = 445;  // measured: docs/reliability.md
  return at_start + of_cell * expected_cells(*bed);
}

Real memory_in_use()
{
  return page_count(1);
}

Real largest_memory_in_use()
{
  const Real kibibytes = kernel_number("/proc/self/status", "VmHWM:");
  return kibibytes == infinity ? nan : kibibyte * kibibytes;
}

Real memory_of_data()
{
  ::malloc_trim(0);
  return page_count(1) - page_count(2);
}

Real memory_left()
{
  rlimit space{};
  const Real of_limit =
      ::getrlimit(RLIMIT_AS, &space) == 0 && space.rlim_cur != RLIM_INFINITY ? static_cast<Real>(space.rlim_cur) - page_count(0) : infinity;
  return std::min({kibibyte * kernel_number("/proc/meminfo", "MemAvailable:"), ControlGroups().memory_left(), of_limit});
}

void refuse_without_memory(Real bytes, Real in_use, const std::string& what, const std::string& advice)
{
  const Real here = Ranks::of_run().count_here();
  const Real needed = here * (in_use + bytes), there = here * memory_in_use() + memory_left();
  if (needed > there)
    throw KeyError(fmt::format("mesh: {} need {} of memory at least, and there are {}; {}", what, words_of_memory(needed),
                               words_of_memory(there), advice));
}

void refuse_without_memory_for_gmsh(const settings::Case& c)
{
  refuse_without_memory(memory_of_gmsh(c), memory_in_use(), "gmsh and its mesh", "take larger cells");
}

template <int dim>
void refuse_without_memory(const RunSize& size, Real in_use)
{
  Real particles = 0;
  for (const RunSize::OfBody& body : size.bodies) particles += body.particles;
  refuse_without_memory(memory_of<dim>(size), in_use,
                        words_of_count(size.cells, "cells") + " and " + words_of_count(particles, "particles"),
                        "take larger cells or fewer particles in each");
}

#define BERM_INSTANTIATE(dim)                                                                                                              \
  template RunSize min_size<dim>(const settings::Case&);                                                                                   \
  template RunSize min_size(const settings::Case&, const mesh::Mesh<dim>&);                                                                \
  template RunSize size_of(const problem::Problem<dim>&);                                                                                  \
  template Real memory_of<dim>(const RunSize&);                                                                                            \
  template void refuse_without_memory<dim>(const RunSize&, Real);
BERM_INSTANTIATE(2)
BERM_INSTANTIATE(3)
#undef BERM_INSTANTIATE

}  // namespace berm::simulation
