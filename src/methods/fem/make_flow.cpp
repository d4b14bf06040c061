// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/fem/flow_test.cpp
#include "fem/fem_problem.hpp"

#include <algorithm>

namespace berm::fem {
namespace {

bool flows(const FemModel& model, Index cell)
{
  return model.model.bodies[model.mesh.body[cell]].flows();
}

bool is_drained(const FemModel& model, Index cell)
{
  return !has_pore_pressure(model.soil_of(cell).materials.front());
}

PointWater water_of(const material::Material& material)
{
  PointWater water;
  water.compressibility = 1 / water_stiffness(material);
  water.min_pressure = min_pore_pressure(pore_water(material).value());
  water.hydraulics = hydraulics(material).value();
  return water;
}

/// The smallest height of the triangle of the corners, m.
Real smallest_height(const AtSixNodes<Vec<2>>& nodes)
{
  const Vec<2> a = nodes[1] - nodes[0], b = nodes[2] - nodes[0];
  return std::abs(a[0] * b[1] - a[1] * b[0]) / std::max({a.norm(), b.norm(), (b - a).norm()});
}

/// h^2 / (6 c_v), s.
Real diffusion_time(const material::Material& material, Real h)
{
  const Real stiffness = water_stiffness(material), skeleton = p_wave_modulus(material) - stiffness;
  const Real consolidation = hydraulics(material)->permeability / material::unit_weight_of_water / (1 / skeleton + 1 / stiffness);
  return h * h / (6 * consolidation);
}

/// Whether the directions in which the support of a side's middle is closed are across it rather than along it.
bool closed_across(const FemModel& model, const BoundarySide& side, std::uint8_t directions)
{
  const Vec<2> along = model.mesh.position[side.to] - model.mesh.position[side.from];
  Real across = 0;
  for (int d = 0; d < 2; ++d)
    if ((directions >> d & 1) != 0) across += along[1 - d] * along[1 - d];
  return across >= along.squaredNorm() / 2;
}

/// The volume of the soil at an integration point over that at the start.
Real volume_ratio(const FemModel& model, const NodeField<Vec<2>>& was_at, Index cell, int q)
{
  AtSixNodes<Vec<2>> first;
  for (int k = 0; k < 6; ++k) first[k] = was_at[model.mesh.nodes[cell][k]];
  ShapeAtPoint then = shape_at(first, q);
  if (model.model.mesh.metric == mesh::Metric::axisymmetric) turn_around_axis(then, position_of(then, first));
  return model.shape[cell][q].area / then.area;
}

/// The sides that rigid bodies keep shut: those whose middle touches one that does not drain; corners are arcs in large deformations, which the first mesh does not have. What touches overlaps by what
/// compresses the springs of the contact.
std::vector<BoundarySide> shut_sides(const FemModel& model, const std::vector<bodies::Pose<2>>& poses)
{
  constexpr Real rounding = 1e-6;
  std::vector<BoundarySide> sides;
  for (const BoundarySide& side : model.contact_sides) {
    const NearestSurface nearest = nearest_surface(model, poses, model.mesh.position[side.middle]);
    if (!model.model.contacts[nearest.contact].drained &&
        nearest.distance < rounding * (model.mesh.position[side.to] - model.mesh.position[side.from]).norm())
      sides.push_back(side);
  }
  return sides;
}

NodeField<char> open_nodes(const FemModel& model, const std::vector<BoundarySide>& shut, const NodeField<std::uint8_t>& closed)
{
  NodeField<char> open(model.mesh.node_count(), false);
  NodeField<char> at_body(model.mesh.node_count(), false);
  for (const BoundarySide& side : shut) at_body[side.middle] = true;
  for (const BoundarySide& side : model.mesh.boundary_sides) {
    const bool on_axis = model.model.mesh.metric == mesh::Metric::axisymmetric && model.mesh.position[side.middle][0] == 0;
    if (!at_body[side.middle] && !on_axis && !closed_across(model, side, closed[side.middle])) open[side.from] = open[side.to] = true;
  }
  for (Index cell = 0; cell < model.mesh.cell_count(); ++cell)
    if (is_drained(model, cell))
      for (int k = 0; k < 3; ++k) open[model.mesh.nodes[cell][k]] = true;
  return open;
}

std::vector<std::array<Index, 2>> pressures_at_contact(const FemModel& model)
{
  NodeField<std::array<Index, 2>> ends(model.mesh.node_count());
  for (Index node = 0; node < model.mesh.node_count(); ++node) ends[node] = {model.flow.unknown[node], model.flow.unknown[node]};
  for (const BoundarySide& side : model.mesh.boundary_sides)
    ends[side.middle] = {model.flow.unknown[side.from], model.flow.unknown[side.to]};
  std::vector<std::array<Index, 2>> pressures;
  for (const FemContactPoint& point : model.contact) pressures.push_back(ends[point.node]);
  return pressures;
}

}  // namespace

void make_flow(const NodeField<Vec<2>>& was_at, const std::vector<bodies::Pose<2>>& poses, FemModel& model)
{
  const Index cells = model.mesh.cell_count();
  if (std::none_of(model.model.bodies.begin(), model.model.bodies.end(), [](const auto& body) { return body.flows(); })) return;
  FlowModel& flow = model.flow;
  flow.unknown = NodeField<Index>(model.mesh.node_count(), none);
  flow.water.assign(cells);
  flow.first_dt = infinity;
  for (Index cell = 0; cell < cells; ++cell) {
    if (!flows(model, cell)) continue;
    for (int k = 0; k < 3; ++k)
      if (Index& unknown = flow.unknown[model.mesh.nodes[cell][k]]; unknown == none) unknown = model.pressure_unknown() + flow.count++;
    for (int q = 0; q < triangle_points; ++q) {
      const material::Material material = model.soil_at(cell, q);
      material::Hydraulics& now = (flow.water[cell][q] = water_of(material)).hydraulics;
      if (model.settings.large_deformation) {
        const Real porosity = now.porosity_at(volume_ratio(model, was_at, cell, q));
        now = {now.permeability_at(porosity), porosity, now.kozeny_carman};
      }
      flow.first_dt = std::min(flow.first_dt, diffusion_time(material, smallest_height(model.mesh.positions_of(cell))));
    }
  }
  flow.at_contact = pressures_at_contact(model);
  for (const std::vector<Index>& nodes : model.mesh.head_nodes) {
    std::vector<Index>& unknowns = flow.at_head.emplace_back();
    for (const Index node : nodes)
      if (const Index unknown = flow.unknown[node]; unknown != none) unknowns.push_back(unknown);
    std::sort(unknowns.begin(), unknowns.end());
  }
  const std::vector<BoundarySide> shut = shut_sides(model, poses);
  for (const NodeField<std::uint8_t>& closed : model.mesh.impermeable) flow.open.push_back(open_nodes(model, shut, closed));
}

}  // namespace berm::fem
