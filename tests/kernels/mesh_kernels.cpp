// SPDX-License-Identifier: BSD-3-Clause
#include "kernels.hpp"
#include "mesh/box.hpp"

#include <algorithm>
#include <benchmark/benchmark.h>

namespace berm {
namespace {

/// The centroid of each cell of a box is looked for from one of the cell's neighbours on.
template <int dim>
void find_cells(benchmark::State& state, Real cells_along_side)
{
  const mesh::Mesh<dim> mesh =
      mesh::make_box<dim>({.lower = {}, .size = std::vector<Real>(dim, 1.), .cells = std::vector<Real>(dim, cells_along_side)});
  std::vector<Vec<dim>> points;
  std::vector<Index> starts;
  for (Index c = 0; c < mesh.cell_count(); ++c) {
    points.push_back(mesh.centroid(c));
    starts.push_back(mesh.neighbor(c, 0));
    for (int k = 1; k <= dim; ++k) starts.back() = std::max(starts.back(), mesh.neighbor(c, k));
  }
  std::vector<mesh::Location> found(points.size());

  for (auto _ : state) {
    for (std::size_t p = 0; p < points.size(); ++p) found[p] = locate(mesh, points[p], starts[p]);
    benchmark::DoNotOptimize(found.data());
    benchmark::ClobberMemory();
  }
  state.SetItemsProcessed(state.iterations() * static_cast<BigIndex>(points.size()));

  for (Index c = 0; c < mesh.cell_count(); ++c)
    if (!found[c].inside || found[c].cell != c || starts[c] == c)
      state.SkipWithError("a point is not in the cell next to the one it began in");
}

}  // namespace

void add_mesh_kernels()
{
  benchmark::RegisterBenchmark("locate_2D/next_cell", find_cells<2>, 32);
  benchmark::RegisterBenchmark("locate_3D/next_cell", find_cells<3>, 8);
}

}  // namespace berm
