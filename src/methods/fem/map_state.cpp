// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/fem/remesher_test.cpp
#include "core/for_each.hpp"
#include "fem/point_locator.hpp"
#include "fem/remesher.hpp"
#include "material/laws.hpp"

#include <algorithm>

namespace berm::fem {
namespace {

/// The linear shape functions of the corners.
std::array<Real, 3> corner_parts(const Vec<2>& at)
{
  return {1 - at[0] - at[1], at[0], at[1]};
}

/// Total stress, Pa, tension positive, and the excess pore pressure, which is a part of it and so must be mapped in the same way; 0 where the law has none.
struct SoilStress {
  SymTensor<2> total;
  Real pore_pressure = 0;

  void add(Real weight, const SymTensor<2>& stress, Real pressure)
  {
    for (int c = 0; c < tensor_size<2>; ++c) total[c] += weight * stress[c];
    pore_pressure += weight * pressure;
  }
};

/// Stress at the corners: the mean of what the elements around them have there when it is drawn out linearly, by their areas.
NodeField<SoilStress> stress_at_corners(const FemModel& model, const FemState& state)
{
  NodeField<SoilStress> corners(model.mesh.node_count());
  NodeField<Real> area(model.mesh.node_count(), 0);
  const auto area_of = [&](Index cell) { return model.shape[cell][0].area + model.shape[cell][1].area + model.shape[cell][2].area; };
  for (Index cell = 0; cell < model.mesh.cell_count(); ++cell)
    for (int k = 0; k < 3; ++k) area[model.mesh.nodes[cell][k]] += area_of(cell);
  for (Index cell = 0; cell < model.mesh.cell_count(); ++cell) {
    const int pressure = pore_pressure_index(model.soil_of(cell).materials.front());
    for (int k = 0; k < 3; ++k) {
      const Index node = model.mesh.nodes[cell][k];
      const std::array<Real, triangle_points> weights = linear_weights(six_nodes[k]);
      for (int q = 0; q < triangle_points; ++q) {
        const SoilPoint& point = state.points[cell][q];
        corners[node].add(area_of(cell) / area[node] * weights[q], point.stress, pressure == none ? 0 : point.law_state[pressure]);
      }
    }
  }
  return corners;
}

/// What is known of the old mesh where it is now.
struct OldMesh {
  const FemModel& model;
  const FemState& state;
  NodeField<Vec<2>> position;
  NodeField<SoilStress> corners;
  PointLocator locator;

  OldMesh(const FemModel& m, const FemState& s)
      : model(m),
        state(s),
        position(positions_with(m, s.displacement)),
        corners(stress_at_corners(m, s)),
        locator(m.mesh, position)
  {
  }

  /// A field of the nodes at a point.
  Vec<2> at(const MeshPoint& point, const NodeField<Vec<2>>& field) const
  {
    const AtSixNodes<Real> part = shape_functions(point.at);
    Vec<2> sum = Vec<2>::Zero();
    for (int k = 0; k < 6; ++k) sum += part[k] * field[model.mesh.nodes[point.cell][k]];
    return sum;
  }
  /// The excess pore pressure there, Pa; 0 where no water flows.
  Real pressure_at(const MeshPoint& point) const
  {
    if (!model.flow.in(point.cell)) return 0;
    const std::array<Real, 3> part = corner_parts(point.at);
    Real sum = 0;
    for (int k = 0; k < 3; ++k) sum += part[k] * state.displacement[model.flow.unknown[model.mesh.nodes[point.cell][k]]];
    return sum;
  }
};

/// The stress between the corners, and what else the points of an element carry drawn out linearly within their range.
SoilPoint soil_at(const OldMesh& old, const MeshPoint& there)
{
  const std::array<Real, triangle_points> weights = linear_weights(there.at);
  const auto& points = old.state.points[there.cell];
  const auto mean = [&](const auto& of) {
    const Real values[3] = {of(points[0]), of(points[1]), of(points[2])};
    const auto [least, most] = std::minmax({values[0], values[1], values[2]});
    return std::clamp(weights[0] * values[0] + weights[1] * values[1] + weights[2] * values[2], least, most);
  };
  SoilPoint soil;
  soil.deviatoric_strain = mean([](const SoilPoint& point) { return point.deviatoric_strain; });
  for (std::size_t k = 0; k < soil.law_state.size(); ++k)
    soil.law_state[k] = mean([&](const SoilPoint& point) { return point.law_state[k]; });
  SoilStress stress;
  const std::array<Real, 3> part = corner_parts(there.at);
  for (int k = 0; k < 3; ++k) {
    const SoilStress& corner = old.corners[old.model.mesh.nodes[there.cell][k]];
    stress.add(part[k], corner.total, corner.pore_pressure);
  }
  soil.stress = stress.total;
  if (const int k = pore_pressure_index(old.model.soil_of(there.cell).materials.front()); k != none)
    soil.law_state[k] = stress.pore_pressure;
  return soil;
}

/// Puts the stress back onto the surface of the law, where it is beyond it.
void return_to_surface(const FemModel& model, Index cell, int q, Real time, SoilPoint& point)
{
  std::visit(
      [&](const auto& law) {
        update(law, point.stress, material::Increment<2, Real>{{}, 0, time, model.cell_size[cell]}, point.law_state.data());
      },
      prepare(model.soil_at(cell, q)));
}

/// Shear and state of the old contact at a point of the outline.
class OldContact {
public:
  explicit OldContact(const OldMesh& old) : old_(old), point_of_(old.model.mesh.node_count(), none)
  {
    for (std::size_t k = 0; k < old.model.contact.size(); ++k) point_of_[old.model.contact[k].node] = static_cast<Index>(k);
    NodeField<int> sides(old.model.mesh.node_count(), 0);
    end_.assign(old.model.mesh.node_count(), 0);
    for (const BoundarySide& side : old.model.mesh.boundary_sides)
      for (const Index node : {side.from, side.to}) end_[node] += mean_of(side), ++sides[node];
    for (Index node = 0; node < sides.size(); ++node)
      if (sides[node] > 0) end_[node] /= sides[node];
  }

  /// Pa, along (-n_y, n_x): linear between the mean of a side in its middle and the means of two at their common end.
  Real shear_at(const OutlinePoint& point) const
  {
    const BoundarySide& side = old_.model.mesh.boundary_sides[point.side];
    const Real middle = mean_of(side);
    return point.part < 0.5 ? end_[side.from] + 2 * point.part * (middle - end_[side.from])
                            : middle + (2 * point.part - 1) * (end_[side.to] - middle);
  }
  /// That of the nearest node in this contact; null where it had none.
  const FemContactState* nearest(const OutlinePoint& point, Index contact) const
  {
    const BoundarySide& side = old_.model.mesh.boundary_sides[point.side];
    const Index node = point.part < 0.25 ? side.from : point.part < 0.75 ? side.middle : side.to;
    const Index k = point_of_[node] == none ? point_of_[side.middle] : point_of_[node];  // on the axis a node has no point
    const bool none_here = k == none || old_.model.contact[static_cast<std::size_t>(k)].contact != contact;
    return none_here ? nullptr : &old_.state.contact[static_cast<std::size_t>(k)];
  }

private:
  Real shear_of(Index node) const
  {
    const Index k = point_of_[node];
    if (k == none) return 0;
    const Vec<2>& normal = old_.model.contact[static_cast<std::size_t>(k)].normal;
    return old_.state.contact[static_cast<std::size_t>(k)].traction.dot(Vec<2>(-normal[1], normal[0]));
  }
  Real mean_of(const BoundarySide& side) const { return (shear_of(side.from) + 4 * shear_of(side.middle) + shear_of(side.to)) / 6; }

  const OldMesh& old_;
  NodeField<Index> point_of_;
  NodeField<Real> end_;
};

std::vector<FemContactState> map_contact(const OldMesh& old, const std::vector<const OutlinePoint*>& outline, const FemModel& model,
                                         const FemState& state)
{
  const OldContact contact(old);
  std::vector<FemContactState> mapped;
  for (const FemContactPoint& point : model.contact) {
    const OutlinePoint& there = *outline[static_cast<std::size_t>(point.node)];
    const FemContactState* before = contact.nearest(there, point.contact);
    FemContactState& now = mapped.emplace_back();
    now.gap = surface_now(model, point.contact, state.state.rigid_bodies[model.model.contacts[point.contact].rigid], there.x).distance;
    now.parted = before == nullptr ? 1 : before->parted;
    now.slip = before == nullptr ? 0 : before->slip;
    now.traction = contact.shear_at(there) * Vec<2>(-point.normal[1], point.normal[0]);
  }
  return mapped;
}

Real elastic_energy(const material::Elasticity& elastic, const SymTensor<2>& stress)
{
  const Real mean = (stress[0] + stress[1] + stress[2]) / 3, bulk = elastic.lame + 2 * elastic.shear / 3;
  return (double_dot(stress, stress) - 3 * mean * mean) / (4 * elastic.shear) + mean * mean / (2 * bulk);
}

}  // namespace

Content content_of(const FemModel& model, const FemState& state)
{
  Content content;
  for (Index cell = 0; cell < model.mesh.cell_count(); ++cell) {
    const AtSixNodes<Vec<2>> nodes = positions_now(model, state, cell);
    for (int q = 0; q < triangle_points; ++q) {
      ShapeAtPoint shape = shape_at(nodes, q);
      if (model.model.mesh.metric == mesh::Metric::axisymmetric) turn_around_axis(shape, position_of(shape, nodes));
      const SoilPoint& point = state.points[cell][q];
      const material::Material soil = model.soil_at(cell, q);
      content.area += shape.area;
      content.energy +=
          shape.area * elastic_energy(elasticity(soil), material::effective_stress(soil, point.stress, point.law_state.data()));
    }
  }
  return content;
}

void map_state(const FemModel& old_model, const FemState& old_state, const std::vector<const OutlinePoint*>& outline,
               const settings::Case& c, FemModel& model, FemState& state)
{
  const OldMesh old(old_model, old_state);
  const QuadraticMesh& mesh = model.mesh;
  NodeField<MeshPoint> of_node(mesh.node_count());
  for_each("map nodes", mesh.node_count(), [&](Index node) { of_node[node] = old.locator.find(mesh.position[node]); });
  for (int m = 0; m < moments; ++m) {
    state.was_at[m].assign(mesh.node_count());
    for (Index node = 0; node < mesh.node_count(); ++node) state.was_at[m][node] = old.at(of_node[node], old_state.was_at[m]);
  }
  fit_to_mesh(c, state.place_at(Moment::start), poses_of(old_state), model);

  state.displacement.assign(static_cast<std::size_t>(model.unknowns()), 0.);
  for (Index d = 0; d < model.pressure_unknown() - model.rigid_unknown(); ++d)
    state.displacement[model.rigid_unknown() + d] = old_state.displacement[old_model.rigid_unknown() + d];
  for (Index node = 0; model.flow.count > 0 && node < mesh.node_count(); ++node)
    if (const Index unknown = model.flow.unknown[node]; unknown != none) state.displacement[unknown] = old.pressure_at(of_node[node]);

  state.points.assign(mesh.cell_count());
  for_each("map stresses", mesh.cell_count(), [&](Index cell) {
    const AtSixNodes<Vec<2>> nodes = mesh.positions_of(cell);
    for (int q = 0; q < triangle_points; ++q) {
      SoilPoint& point = state.points[cell][q];
      point = soil_at(old, old.locator.find(position_of(model.shape[cell][q], nodes)));
      return_to_surface(model, cell, q, state.state.time, point);
    }
  });
  place_contact(model, state);
  state.contact = map_contact(old, outline, model, state);
  for (FemWatch& watch : model.watches) {
    Vec<2> x = Vec<2>::Zero();
    for (int k = 0; k < 6; ++k) x += watch.of_nodes[k] * old.position[old_model.mesh.nodes[watch.cell][k]];
    watch = make_watch(mesh, watch.name, x, old_model.mesh.body[watch.cell]);
  }
}

}  // namespace berm::fem
