// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/physics/absorbing_boundary.cpp
#include "problem/absorbing.hpp"

#include "bodies/fill.hpp"
#include "os/error.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::problem {
namespace {

/// C per area, Pa s/m, of a boundary with this unit normal.
template <int dim>
Matrix<dim> impedance(const material::Material& soil, const Vec<dim>& normal)
{
  const Real density = inertia_density(soil);
  const Real of_pressure = std::sqrt(density * p_wave_modulus(soil)), of_shear = std::sqrt(density * elasticity(soil).shear);
  const Matrix<dim> along = normal * normal.transpose();
  return of_pressure * along + of_shear * (Matrix<dim>::Identity() - along);
}

/// Points on the soil at a boundary, with their area and, as force over it, the inward normal.
template <int dim>
std::vector<boundary::LoadedPoint<dim>> points_at(const Model<dim>& model, const std::string& name,
                                                  const boundary::SupportSettings& support, const std::vector<Index>& body_of)
{
  boundary::TractionSettings unit;
  unit.boundary = support.boundary;
  unit.pressure = 1;
  try {
    return loaded_points(model.mesh, name, unit, body_of);
  } catch (const KeyError&) {
    throw KeyError(fmt::format("support.{}.absorbs: no body that fills regions has soil at the boundary \"{}\"", name, support.boundary));
  }
}

/// C without the directions that the support does not name.
template <int dim>
Matrix<dim> in_directions(Matrix<dim> resistance, std::uint8_t directions)
{
  for (int d = 0; d < dim; ++d)
    if ((directions >> d & 1) == 0) resistance.row(d).setZero(), resistance.col(d).setZero();
  return resistance;
}

/// The motion of a support, or none.
template <int dim>
Index motion_of(const Model<dim>& model, const std::string& support)
{
  for (std::size_t m = 0; m < model.motions.size(); ++m)
    if (model.motions[m].name == support) return static_cast<Index>(m);
  return none;
}

/// Adds a part of C through which the wave of a motion comes in.
template <int dim>
void add_incoming(const Model<dim>& model, Index motion, Index place, const Matrix<dim>& part, boundary::Dashpots<dim>& dashpots)
{
  dashpots.incoming.resize(model.motions.size());
  std::vector<Matrix<dim>>& of_motion = dashpots.incoming[motion];
  if (of_motion.empty()) of_motion.assign(dashpots.resistance.size(), Matrix<dim>::Zero());
  of_motion[place] += part;
}

/// Where no soil is at the start the boundary holds what comes there.
template <int dim>
void hold_without_soil(const Case& c, const std::string& name, std::uint8_t directions, const std::vector<Index>& nodes, Model<dim>& model)
{
  const SupportSets sets = support_sets(c);
  const auto place = static_cast<std::size_t>(index_of(c.support, name));
  const auto has_dashpot = [&](Index node) {
    return std::any_of(model.dashpots.begin(), model.dashpots.end(),
                       [&](const auto& of_body) { return of_body.any() && of_body.of_node[node] != none; });
  };
  for (std::size_t k = 0; k < sets.roles.size(); ++k)
    for (const Index node : nodes)
      if (sets.roles[k][place] == SupportRole::absorbs && !has_dashpot(node)) model.fixed[k][node] |= directions;
}

}  // namespace

template <int dim>
std::vector<Index> bodies_of_regions(const mesh::Mesh<dim>& mesh, const Case& c)
{
  std::vector<Index> body_of(mesh.region_names.size(), none);
  for (Index b = static_cast<Index>(c.body.size()); b-- > 0;)
    for (const std::string& region : c.body[b].second.regions) body_of[bodies::filled_region(mesh, c.body[b].first, region)] = b;
  return body_of;
}

template <int dim>
void add_dashpots(const Case& c, Model<dim>& model)
{
  if (std::none_of(c.support.begin(), c.support.end(), [](const auto& support) { return support.second.absorbs; })) return;
  const mesh::Mesh<dim>& mesh = model.mesh;
  const std::vector<Index> body_of = bodies_of_regions(mesh, c);
  model.dashpots.resize(model.bodies.size());
  for (const auto& [name, support] : c.support) {
    if (!support.absorbs) continue;
    const Index boundary = fixed_boundary(mesh, name, support);
    const std::uint8_t directions = fixed_directions(support);
    const Index motion = motion_of(model, name);
    for (const boundary::LoadedPoint<dim>& point : points_at(model, name, support, body_of)) {
      const Index region = mesh.region[point.cell], body = body_of[region];
      boundary::Dashpots<dim>& dashpots = model.dashpots[body];
      if (!dashpots.any()) dashpots.of_node = NodeField<Index>(mesh.node_count(), none);
      const material::Material soil = model.bodies[body].soil.at(mesh.region_names[region], model.soil_depth(point.x));
      const Matrix<dim> of_point = point.area * impedance<dim>(soil, point.force / point.area);
      const mesh::Shape<dim> shape = mesh.shape(point.cell);
      for (int k = 0; k <= dim; ++k) {
        constexpr Real round_off = 1e-9;
        const Real part = shape.value(k, point.x);
        if (!(part > round_off)) continue;
        Index& place = dashpots.of_node[mesh.nodes[point.cell][k]];
        if (place == none) {
          place = static_cast<Index>(dashpots.resistance.size());
          dashpots.resistance.push_back(Matrix<dim>::Zero());
          dashpots.directions.push_back(0);
          for (auto& matrices : dashpots.incoming)
            if (!matrices.empty()) matrices.push_back(Matrix<dim>::Zero());
        }
        dashpots.resistance[place] += in_directions<dim>(part * of_point, directions);
        if (motion != none) add_incoming<dim>(model, motion, place, in_directions<dim>(part * of_point, directions), dashpots);
        dashpots.directions[place] |= directions;
      }
    }
    hold_without_soil(c, name, directions, mesh.boundary_nodes[boundary], model);
  }
}

#define BERM_INSTANTIATE(dim)                                                                                                              \
  template std::vector<Index> bodies_of_regions(const mesh::Mesh<dim>&, const Case&);                                                      \
  template void add_dashpots(const Case&, Model<dim>&);
BERM_INSTANTIATE(2)
BERM_INSTANTIATE(3)
#undef BERM_INSTANTIATE

}  // namespace berm::problem
