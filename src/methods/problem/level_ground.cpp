// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/problem/build_test.cpp
#include "bodies/fill.hpp"
#include "os/error.hpp"
#include "os/text_of_list.hpp"
#include "problem/initial_state.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::problem {
namespace {

constexpr Real accepted = 0.02;  // of the largest weight over area
template <int dim>
constexpr int lines_along = dim == 2 ? 200 : 20;

/// Soil on a vertical line.
struct Piece {
  Real bottom, top;  ///< m
  Index body, region = none;
};

/// Where a vertical line through x is in a cell; bottom >= top where it is not.
template <int dim>
Piece chord(const mesh::Mesh<dim>& mesh, Index cell, Vec<dim> x)
{
  const mesh::Shape<dim> shape = mesh.shape(cell);
  x[1] = 0;
  Piece piece{-infinity, infinity, none};
  for (int k = 0; k <= dim; ++k) {
    const Real at_zero = shape.value(k, x), slope = shape.gradient(k)[1];  // N_k along the line, which is not less than 0 in the cell
    if (slope > 0) piece.bottom = std::max(piece.bottom, -at_zero / slope);
    if (slope < 0) piece.top = std::min(piece.top, -at_zero / slope);
    if (slope == 0 && at_zero < 0) return {0, 0, none};
  }
  return piece;
}

/// Where a line stands between its neighbours, along x and along z: nowhere that a regular mesh has an edge or a diagonal face.
constexpr Real between[] = {0.4142, 0.7321};

/// Vertical lines, evenly over the mesh, and the soil on each.
template <int dim>
struct Lines {
  static constexpr int along = lines_along<dim>, count = dim == 2 ? along : along * along;
  Vec<dim> lower, spacing;
  std::vector<std::vector<Piece>> pieces = std::vector<std::vector<Piece>>(count);

  explicit Lines(const mesh::Mesh<dim>& mesh) : lower(mesh.lower), spacing((mesh.upper - mesh.lower) / along) {}

  Vec<dim> position(int line) const
  {
    Vec<dim> x = lower;
    x[0] += (line % along + between[0]) * spacing[0];
    if (dim == 3) x[dim - 1] += (line / along + between[1]) * spacing[dim - 1];
    return x;
  }

  void add(const mesh::Mesh<dim>& mesh, Index cell, Index body)
  {
    int first[2] = {0, 0}, last[2] = {0, 0};
    for (const int d : {0, dim - 1}) {
      if (d == 1) continue;
      Real min = infinity, max = -infinity;
      for (const Index i : mesh.nodes[cell]) {
        min = std::min(min, mesh.position[i][d]);
        max = std::max(max, mesh.position[i][d]);
      }
      first[d > 0] = std::max(0, static_cast<int>(std::ceil((min - lower[d]) / spacing[d] - between[d > 0])));
      last[d > 0] = std::min(along - 1, static_cast<int>(std::floor((max - lower[d]) / spacing[d] - between[d > 0])));
    }
    for (int j = first[1]; j <= last[1]; ++j)
      for (int i = first[0]; i <= last[0]; ++i) {
        Piece piece = chord<dim>(mesh, cell, position(j * along + i));
        piece.body = body;
        piece.region = mesh.region[cell];
        if (piece.bottom < piece.top) pieces[j * along + i].push_back(piece);
      }
  }
};

/// Whether a vertical line meets a rigid body, which the soil may have been shaped around.
template <int dim>
bool meets_rigid(const Model<dim>& model, const Vec<dim>& x)
{
  return std::any_of(model.rigid_bodies.begin(), model.rigid_bodies.end(), [&](const bodies::RigidBody<dim>& rigid) {
    if (!bodies::is_bounded<dim>(rigid.shape)) return false;
    Vec<dim> away = center_of<dim>(rigid.shape) - x;
    away[1] = 0;
    return away.norm() < reach_of<dim>(rigid.shape);
  });
}

}  // namespace

template <int dim>
void refuse_k0_below_uneven_ground(const settings::Case& c, const Model<dim>& model)
{
  const auto by_level = [&](Index body) { return body != none && c.body[body].second.has_k0(); };
  const Real gravity = -model.gravity[1];
  std::vector<Index> body_of(model.mesh.region_names.size(), none);
  bool any = false;
  for (Index b = static_cast<Index>(c.body.size()); b-- > 0;)
    for (const std::string& region : c.body[b].second.regions) {
      body_of[bodies::filled_region(model.mesh, c.body[b].first, region)] = b;
      any = any || by_level(b);
    }
  if (!any || gravity == 0) return;
  Lines<dim> lines(model.mesh);
  for (Index cell = 0; cell < model.mesh.cell_count(); ++cell)
    if (const Index body = body_of[model.mesh.region[cell]]; body != none) lines.add(model.mesh, cell, body);

  struct Worst {
    Real difference = 0, weight = 0, taken = 0;
    Vec<dim> x = Vec<dim>::Zero();
    Index body = none;
  } worst;
  Real largest = 0;
  for (int line = 0; line < lines.count; ++line) {
    Vec<dim> x = lines.position(line);
    if (meets_rigid(model, x)) continue;
    std::vector<Piece>& pieces = lines.pieces[line];
    std::sort(pieces.begin(), pieces.end(), [](const Piece& a, const Piece& b) { return a.top > b.top; });
    Real above = 0;
    for (const Piece& piece : pieces) {
      const auto weight_above = [&](Real y) {
        return gravity * model.bodies[piece.body].soil.mass_above(model.mesh.region_names[piece.region], c.surface - y);
      };
      x[1] = (piece.top + piece.bottom) / 2;
      const Real taken = std::max(Real(0), weight_above(x[1])), weight = above + weight_above(x[1]) - weight_above(piece.top);
      above += weight_above(piece.bottom) - weight_above(piece.top);
      largest = std::max({largest, std::abs(taken), std::abs(weight)});
      if (by_level(piece.body) && std::abs(weight - taken) > worst.difference)
        worst = {std::abs(weight - taken), weight, taken, x, piece.body};
    }
  }
  if (worst.difference > accepted * largest)
    throw KeyError(fmt::format("body.{}.k0: the ground is not level at `surface`, or not of one density: at ({}) m the overburden "
                               "is {:.4g} kPa, where k0 takes density gravity (surface - y) = {:.4g} kPa; initial_state = "
                               "\"gravity_loading\" finds the stress below any surface and in layers",
                               c.body[worst.body].first, text_of_list(worst.x, ", ", "{:.6g}"), worst.weight / 1e3, worst.taken / 1e3));
}

template void refuse_k0_below_uneven_ground(const settings::Case&, const Model<2>&);
template void refuse_k0_below_uneven_ground(const settings::Case&, const Model<3>&);

}  // namespace berm::problem
