// SPDX-License-Identifier: BSD-3-Clause
#include "mesh/box.hpp"

#include "mesh/kuhn.hpp"
#include "os/error.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::mesh {
namespace {

template <int dim>
struct Grid {
  Vec<dim> lower, size;
  std::array<Index, dim> cells;

  // Grid points are numbered with x fastest.
  Index point(const std::array<Index, dim>& at) const
  {
    Index number = at[dim - 1];
    for (int d = dim - 2; d >= 0; --d) number = number * (cells[d] + 1) + at[d];
    return number;
  }
  Vec<dim> position(const std::array<Index, dim>& at) const
  {
    Vec<dim> x;
    for (int d = 0; d < dim; ++d) x[d] = lower[d] + size[d] * (static_cast<Real>(at[d]) / cells[d]);
    return x;
  }
};

template <int dim>
Grid<dim> grid_of(const BoxMesh& box)
{
  const auto check_count = [](const char* key, std::size_t count) {
    if (count != dim) throw KeyError(fmt::format("mesh.{}: has {} entries; a mesh in {}D needs {}", key, count, dim, dim));
  };
  if (!box.lower.empty()) check_count("lower", box.lower.size());
  check_count("size", box.size.size());
  check_count("cells", box.cells.size());
  Grid<dim> grid;
  Real total = 1;
  for (int d = 0; d < dim; ++d) {
    grid.lower[d] = box.lower.empty() ? 0 : box.lower[d];
    grid.size[d] = box.size[d];
    if (!std::isfinite(grid.lower[d])) throw KeyError(fmt::format("mesh.lower[{}]: is {}; it must be finite", d, grid.lower[d]));
    if (!(grid.size[d] > 0 && std::isfinite(grid.size[d])))
      throw KeyError(fmt::format("mesh.size[{}]: is {:.6g} m; it must be positive", d, grid.size[d]));
    if (!(box.cells[d] >= 1 && box.cells[d] <= 1e6 && box.cells[d] == std::floor(box.cells[d])))
      throw KeyError(fmt::format("mesh.cells[{}]: is {:.6g}; it must be a whole number from 1 to 1000000", d, box.cells[d]));
    grid.cells[d] = static_cast<Index>(box.cells[d]);
    total *= box.cells[d];
  }
  constexpr Real max = 5e7;
  if (total > max)
    throw KeyError(fmt::format("mesh.cells: {:.3g} {} are too many; at most {:.0e}", total, dim == 2 ? "squares" : "cubes", max));
  return grid;
}

// Calls visit(at) for all grid points `at` with 0 <= at[d] < count[d].
template <int dim, class Visit>
void for_each_point(const std::array<Index, dim>& count, const Visit& visit)
{
  std::array<Index, dim> at{};
  while (true) {
    visit(at);
    int d = 0;
    while (d < dim && ++at[d] == count[d]) at[d++] = 0;
    if (d == dim) return;
  }
}

void add_criss_cross_cells(Mesh<2>& mesh, const Grid<2>& grid, const std::array<Index, 2>& at)
{
  const auto [i, j] = at;
  const Index ring[] = {grid.point({i, j}), grid.point({i + 1, j}), grid.point({i + 1, j + 1}), grid.point({i, j + 1})};
  const Index center = mesh.node_count();
  mesh.position.push_back((grid.position({i, j}) + grid.position({i + 1, j + 1})) / 2);
  for (int k = 0; k < 4; ++k) mesh.nodes.push_back({ring[k], ring[(k + 1) % 4], center});
}

}  // namespace

void describe(Describe& d, BoxMesh& box)
{
  d.value("lower", box.lower, {.meaning = "lower corner of the box, one entry for each direction; left out: the origin", .unit = "m"});
  d.value("size", box.size, {.meaning = "sides of the box", .unit = "m", .range = positive, .required = true});
  d.value("cells", box.cells,
          {.meaning = "squares (2D) or cubes (3D) along each side, whole numbers", .range = {1, 1e6}, .required = true});
  d.choice("pattern", box.pattern, {"diagonal", "criss_cross"},
           {.meaning = "cut of a square: in 2 triangles, or in 4 with a node in the centre; in 3D every cube is cut in 6 tetrahedra"});
}

template <int dim>
Mesh<dim> make_box(const BoxMesh& box)
{
  const Grid<dim> grid = grid_of<dim>(box);
  if (dim == 3 && box.pattern != BoxPattern::diagonal) throw KeyError("mesh.pattern: in 3D the pattern must be \"diagonal\"");

  Mesh<dim> mesh;
  mesh.region_names = {"box"};
  mesh.boundary_names = {"left", "right", "bottom", "top"};
  if (dim == 3) mesh.boundary_names.insert(mesh.boundary_names.end(), {"back", "front"});
  mesh.boundary_nodes.resize(mesh.boundary_names.size());

  auto points = grid.cells;
  for (Index& count : points) ++count;
  for_each_point<dim>(points, [&](const std::array<Index, dim>& at) {
    for (int d = 0; d < dim; ++d) {
      if (at[d] == 0) mesh.boundary_nodes[2 * d].push_back(mesh.node_count());
      if (at[d] == grid.cells[d]) mesh.boundary_nodes[2 * d + 1].push_back(mesh.node_count());
    }
    mesh.position.push_back(grid.position(at));
  });
  for_each_point<dim>(grid.cells, [&](const std::array<Index, dim>& at) {
    if constexpr (dim == 2) {
      if (box.pattern == BoxPattern::criss_cross) return add_criss_cross_cells(mesh, grid, at);
    }
    add_kuhn_cells<dim>(mesh, at, [&](const auto& corner) { return grid.point(corner); });
  });
  mesh.region.assign(mesh.cell_count(), 0);
  try {
    mesh.complete();
  } catch (const RunError& error) {
    throw KeyError(fmt::format("mesh.size: {}", error.what()));
  }
  return mesh;
}

template Mesh<2> make_box<2>(const BoxMesh&);
template Mesh<3> make_box<3>(const BoxMesh&);

}  // namespace berm::mesh
