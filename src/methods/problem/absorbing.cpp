// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/physics/absorbing_boundary.cpp
#include "problem/absorbing.hpp"

#include "bodies/fill.hpp"
#include "os/error.hpp"
#include "problem/supports.hpp"

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
  const auto& rows = model.conditions.rows;
  const auto found = std::find_if(
      rows.begin(), rows.end(), [&](const auto& row) { return row.name == support && std::holds_alternative<boundary::Motion>(row.kind); });
  return found == rows.end() ? none : static_cast<Index>(found - rows.begin());
}

/// Adds a part of C through which the wave of a motion comes in.
template <int dim>
void add_incoming(const Model<dim>& model, Index motion, Index index, const Matrix<dim>& part, boundary::Dashpots<dim>& dashpots)
{
  dashpots.incoming.resize(model.conditions.rows.size());
  std::vector<Matrix<dim>>& of_motion = dashpots.incoming[motion];
  if (of_motion.empty()) of_motion.assign(dashpots.resistance.size(), Matrix<dim>::Zero());
  of_motion[index] += part;
}

/// Where no soil is at the start the boundary holds what comes there.
template <int dim>
void hold_without_soil(const std::string& name, std::uint8_t directions, std::vector<char> acts, Index boundary, Model<dim>& model)
{
  const auto& dashpots = model.conditions.dashpots;
  const NodeField<char> at_boundary = nodes_at(model.mesh, boundary);
  const auto keep = [&](Index node) {
    return at_boundary[node] != 0 && std::none_of(dashpots.begin(), dashpots.end(),
                                                  [&](const auto& of_body) { return of_body.any() && of_body.of_node[node] != none; });
  };
  add_condition<dim>({.name = name, .kind = boundary::Hold{boundary::Flux::unchanged}, .directions = directions, .acts = std::move(acts)},
                     keep, model);
}

}  // namespace

template <int dim>
std::vector<Index> bodies_of_regions(const mesh::Mesh<dim>& mesh, const settings::Case& c)
{
  std::vector<Index> body_of(mesh.region_names.size(), none);
  for (Index b = static_cast<Index>(c.body.size()); b-- > 0;)
    for (const std::string& region : c.body[b].second.regions) body_of[bodies::filled_region(mesh, c.body[b].first, region)] = b;
  return body_of;
}

template <int dim>
void add_dashpots(const settings::Case& c, const settings::SupportSets& sets, Model<dim>& model)
{
  if (std::none_of(c.support.begin(), c.support.end(), [](const auto& support) { return support.second.absorbs; })) return;
  const mesh::Mesh<dim>& mesh = model.mesh;
  const std::vector<Index> body_of = bodies_of_regions(mesh, c);
  model.conditions.dashpots.resize(model.bodies.size());
  for (Index s = 0; s < static_cast<Index>(c.support.size()); ++s) {
    const auto& [name, support] = c.support[s];
    if (!support.absorbs) continue;
    const Index boundary = fixed_boundary(mesh, name, support);
    const std::uint8_t directions = fixed_directions(support);
    const Index motion = motion_of(model, name);
    for (const boundary::LoadedPoint<dim>& point : points_at(model, name, support, body_of)) {
      const Index region = mesh.region[point.cell], body = body_of[region];
      boundary::Dashpots<dim>& dashpots = model.conditions.dashpots[body];
      if (!dashpots.any()) dashpots.of_node = NodeField<Index>(mesh.node_count(), none);
      const material::Material soil = model.bodies[body].soil.at(mesh.region_names[region], model.soil_depth(point.x));
      const Matrix<dim> of_point = point.area * impedance<dim>(soil, point.force / point.area);
      const mesh::Shape<dim> shape = mesh.shape(point.cell);
      for (int k = 0; k <= dim; ++k) {
        constexpr Real round_off = 1e-9;
        const Real weight = shape.value(k, point.x);
        if (!(weight > round_off)) continue;
        Index& index = dashpots.of_node[mesh.nodes[point.cell][k]];
        if (index == none) {
          index = static_cast<Index>(dashpots.resistance.size());
          dashpots.resistance.push_back(Matrix<dim>::Zero());
          dashpots.directions.push_back(0);
          for (auto& matrices : dashpots.incoming)
            if (!matrices.empty()) matrices.push_back(Matrix<dim>::Zero());
        }
        dashpots.resistance[index] += in_directions<dim>(weight * of_point, directions);
        if (motion != none) add_incoming<dim>(model, motion, index, in_directions<dim>(weight * of_point, directions), dashpots);
        dashpots.directions[index] |= directions;
      }
    }
    hold_without_soil(name, directions, stages_with(settings::SupportRole::absorbs, s, sets), boundary, model);
  }
}

#define BERM_INSTANTIATE(dim)                                                                                                              \
  template std::vector<Index> bodies_of_regions(const mesh::Mesh<dim>&, const settings::Case&);                                            \
  template void add_dashpots(const settings::Case&, const settings::SupportSets&, Model<dim>&);
BERM_INSTANTIATE(2)
BERM_INSTANTIATE(3)
#undef BERM_INSTANTIATE

}  // namespace berm::problem
