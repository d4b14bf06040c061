// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/physics/tractions.cpp
#include "mpm/loads.hpp"

#include "core/ranks.hpp"
#include "core/timer.hpp"
#include "os/error.hpp"
#include "os/text_of_list.hpp"
#include "problem/stages.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <span>

namespace berm::mpm {
namespace {

/// Soil that swings back may carry a point out of the mesh by this many heights of the cell; it then counts as on the
/// nearest face.
constexpr Real max_outside = 0.5;

[[noreturn]] void refuse(const std::string& traction, const Real* x, int dim, Real time, BigIndex step, const char* what)
{
  throw RunError(fmt::format("traction \"{}\": {} at ({}) m at t = {:.6g} s (step {})", traction, what,
                             text_of_list(std::span(x, static_cast<std::size_t>(dim)), ", ", "{:.9g}"), time, step));
}

/// The shares of a load point that the corners of its cell get: its shape functions, not less than zero. A corner with less
/// than a twentieth of the mass of the cell's heaviest gets proportionally less, and one without mass nothing: the load
/// would accelerate so small a mass without bound. Their sum is 1.
template <int dim>
std::array<Real, dim + 1> shares_of(const problem::Model<dim>& model, const problem::State<dim>& state, const BodyGrid<dim>& grid,
                                    std::size_t l)
{
  constexpr Real round_off = 1e-9;  // a node with mass has a share at least this large, so that the sum is never 0 there
  constexpr Real little = 0.05;
  const problem::LoadPointState<dim>& point = state.load_points[l];
  const mesh::Shape<dim> shape = model.mesh.shape(point.cell);
  const auto& nodes = model.mesh.nodes[point.cell];
  Real heaviest = 0;
  for (Index node : nodes) heaviest = std::max(heaviest, grid.mass[node]);
  std::array<Real, dim + 1> shares;
  Real total = 0;
  for (int k = 0; k <= dim; ++k) {
    const Real m = grid.mass[nodes[k]];
    shares[k] = m > 0 ? std::max(shape.value(k, point.x), round_off) * std::min(Real(1), m / (little * heaviest)) : 0;
    total += shares[k];
  }
  if (!(total > 0))
    refuse(model.tractions[model.load_points[l].traction].name, point.x.data(), dim, state.time, state.step,
           "there is no soil left under the load");
  for (Real& share : shares) share /= total;
  return shares;
}

/// Gives all ranks the values of the load points that others have.
template <int dim, class Value>
void share_load_points(Workspace<dim>& workspace, std::vector<Value>& values)
{
  Ranks::of_run().share<Value>(
      static_cast<Index>(values.size()), [&](Index l) { return workspace.load_owner[l]; },
      [&](Index l, Value& value) { value = values[l]; }, [&](Index l, const Value& value) { values[l] = value; });
}

}  // namespace

template <int dim>
void spread_tractions(const problem::Model<dim>& model, const problem::State<dim>& state, Workspace<dim>& workspace)
{
  if (model.load_points.empty()) return;
  const Timer timer("tractions");
  Ranks& ranks = Ranks::of_run();
  const std::size_t count = model.load_points.size();
  workspace.load_shares.resize(count);
  workspace.load_owner.resize(count);
  ranks.together([&] {
    for (std::size_t l = 0; l < count; ++l) workspace.load_owner[l] = ranks.divided() ? ranks.owner_of_cell(state.load_points[l].cell) : 0;
    for (std::size_t l = 0; l < count; ++l)
      if (workspace.load_owner[l] == ranks.rank())
        workspace.load_shares[l] = shares_of(model, state, workspace.grids[model.load_points[l].body], l);
  });
  share_load_points(workspace, workspace.load_shares);
  for (std::size_t l = 0; l < count; ++l) {
    const problem::LoadPoint<dim>& point = model.load_points[l];
    BodyGrid<dim>& grid = workspace.grids[point.body];
    const Real fraction = acting_fraction(model.tractions[point.traction], state.tractions[point.traction], state.time);
    const auto& nodes = model.mesh.nodes[state.load_points[l].cell];
    for (int k = 0; k <= dim; ++k) grid.traction[nodes[k]] += workspace.load_shares[l][k] * fraction * point.force;
  }
}

template <int dim>
void move_load_points(const problem::Model<dim>& model, problem::State<dim>& state, Workspace<dim>& workspace)
{
  if (model.load_points.empty()) return;
  const Timer timer("tractions");
  const auto move = [&](std::size_t l) {
    const BodyGrid<dim>& grid = workspace.grids[model.load_points[l].body];
    problem::LoadPointState<dim>& point = state.load_points[l];
    const auto& nodes = model.mesh.nodes[point.cell];
    const std::array<Real, dim + 1> shares = shares_of(model, state, grid, l);
    for (int k = 0; k <= dim; ++k)
      if (shares[k] > 0) point.x += state.dt * shares[k] * grid.mapped_velocity[nodes[k]];
    const mesh::Location found = locate(model.mesh, point.x, point.cell);
    point.cell = found.cell;
    if (found.inside) return;
    const mesh::Shape<dim> shape = model.mesh.shape(point.cell);
    for (int k = 0; k <= dim; ++k)
      if (!(shape.value(k, point.x) > -max_outside))
        refuse(model.tractions[model.load_points[l].traction].name, point.x.data(), dim, state.time, state.step,
               "the loaded soil has left the mesh");
  };
  Ranks& ranks = Ranks::of_run();
  for (std::size_t l = 0; l < model.load_points.size(); ++l)
    for (const Index node : model.mesh.nodes[state.load_points[l].cell])
      workspace.grids[model.load_points[l].body].traction[node].setZero();
  ranks.together([&] {
    for (std::size_t l = 0; l < model.load_points.size(); ++l)
      if (workspace.load_owner[l] == ranks.rank()) move(l);
  });
  share_load_points(workspace, state.load_points);
}

#define BERM_INSTANTIATE(dim)                                                                                                              \
  template void spread_tractions(const problem::Model<dim>&, const problem::State<dim>&, Workspace<dim>&);                                 \
  template void move_load_points(const problem::Model<dim>&, problem::State<dim>&, Workspace<dim>&);
BERM_INSTANTIATE(2)
BERM_INSTANTIATE(3)
#undef BERM_INSTANTIATE

}  // namespace berm::mpm
