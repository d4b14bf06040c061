// SPDX-License-Identifier: BSD-3-Clause
#include "fem/space_assembly.hpp"

#include "core/for_each.hpp"
#include "fem/point_law.hpp"
#include "material/laws.hpp"

#include <algorithm>

namespace berm::fem {
namespace {

/// Strain (xx, yy, zz, and gammas xy, yz, xz) per displacement of the nodes.
using StrainMatrix = Eigen::Matrix<Real, 6, 30>;
using CellMatrix = Eigen::Matrix<Real, 30, 30>;

StrainMatrix strain_matrix(const ElementPoint<3>& shape, const AtElementNodes<3, Vec<3>>& mean)
{
  StrainMatrix b = StrainMatrix::Zero();
  for (int k = 0; k < element_nodes<3>; ++k) {
    const Vec<3>&g = shape.gradient[k], volumetric = (mean[k] - g) / 3;
    for (int d = 0; d < 3; ++d) {
      const int next = (d + 1) % 3;
      for (int n = 0; n < 3; ++n) b(n, 3 * k + d) = volumetric[d];
      b(d, 3 * k + d) += g[d];
      b(3 + d, 3 * k + d) = g[next];  // xy, yz, zx
      b(3 + d, 3 * k + next) = g[d];
    }
  }
  return b;
}

SymTensor<3> strain_of(const ElementPoint<3>& shape, const AtElementNodes<3, Vec<3>>& mean, const AtElementNodes<3, Index>& nodes,
                       const std::vector<Real>& change)
{
  SymTensor<3> strain{};
  Real volumetric = 0;
  for (int k = 0; k < element_nodes<3>; ++k) {
    const Vec<3> u(change[3 * nodes[k]], change[3 * nodes[k] + 1], change[3 * nodes[k] + 2]);
    const Vec<3>& g = shape.gradient[k];
    volumetric += (mean[k] - g).dot(u) / 3;
    for (int d = 0; d < 3; ++d) {
      const int next = (d + 1) % 3;
      strain[d] += g[d] * u[d];
      strain[3 + d] += (g[next] * u[d] + g[d] * u[next]) / 2;
    }
  }
  for (int d = 0; d < 3; ++d) strain[d] += volumetric;
  return strain;
}

}  // namespace

struct SpaceAssembly::Laws {
  CellField<std::array<material::PreparedMaterial, element_points<3>>> of_cell;
};

SpaceAssembly::SpaceAssembly(const SpaceModel& model)
    : model_(model),
      laws_(std::make_unique<Laws>()),
      cells_(model.mesh.cell_count()),
      points_(model.mesh.cell_count()),
      soil_force_(static_cast<std::size_t>(model.unknowns())),
      residual_(static_cast<std::size_t>(model.unknowns())),
      initial_imbalance_(static_cast<std::size_t>(model.unknowns()), 0.),
      prescribed_(static_cast<std::size_t>(model.unknowns()))
{
  laws_->of_cell.assign(model.mesh.cell_count());
  for (Index cell = 0; cell < model.mesh.cell_count(); ++cell)
    for (int q = 0; q < element_points<3>; ++q) laws_->of_cell[cell][q] = prepare(model.soil_at(cell, q));
}

SpaceAssembly::~SpaceAssembly() = default;

Real SpaceAssembly::bytes_of_element()
{
  constexpr std::size_t here = sizeof(CellWork) + element_points<3> * (sizeof(ElementSoil<3>) + sizeof(material::PreparedMaterial)),
                        of_model = sizeof(AtElementNodes<3, Index>) + sizeof(AtElementNodes<3, Vec<3>>) +
                                   element_points<3> * (sizeof(ElementPoint<3>) + sizeof(Real) + sizeof(settings::SoilPlace)),
                        of_state = element_points<3> * sizeof(ElementSoil<3>);
  return static_cast<Real>(here + of_model + of_state);
}

void SpaceAssembly::evaluate_cell(const SpaceState& begin, const std::vector<Real>& change, const Vec<3>& gravity, Real viscosity,
                                  Index cell)
{
  const AtElementNodes<3, Vec<3>>& mean = model_.mean_gradient[cell];
  CellWork& work = cells_[cell];
  work.force.fill(Vec<3>::Zero());
  work.work = 0;
  for (int q = 0; q < element_points<3>; ++q) {
    const ElementPoint<3>& shape = model_.shape[cell][q];
    const SymTensor<3> strain = strain_of(shape, mean, model_.mesh.nodes[cell], change);
    ElementSoil<3>& point = points_[cell][q];
    point = begin.points[cell][q];
    const SymTensor<3> start = point.stress;
    std::visit(
        [&](const auto& law) {
          update_point(law, viscosity, material::Increment<3, Real>{strain, dt_, begin.state.time, model_.model.mesh.size(cell)}, point);
        },
        laws_->of_cell[cell][q]);
    const SymTensor<3>& s = point.stress;
    SymTensor<3> middle;
    for (int k = 0; k < 6; ++k) middle[k] = (start[k] + s[k]) / 2;
    work.work += shape.area * double_dot(middle, strain);
    Matrix<3> deviator;
    const Real p = (s[0] + s[1] + s[2]) / 3;
    deviator << s[0] - p, s[3], s[5], s[3], s[1] - p, s[4], s[5], s[4], s[2] - p;
    const Vec<3> weight = model_.density[cell][q] * gravity;
    for (int k = 0; k < element_nodes<3>; ++k)
      work.force[k] += shape.area * (deviator * shape.gradient[k] + p * mean[k] - shape.value[k] * weight);
  }
}

void SpaceAssembly::prescribe(const ElementLoads<3>& loads, Index stage)
{
  const NodeField<std::uint8_t>& fixed = model_.mesh.fixed[model_.model.conditions.table_of_stage[stage]];
  for (Index node = 0; node < fixed.size(); ++node)
    for (int d = 0; d < 3; ++d) prescribed_[3 * node + d] = static_cast<char>(model_.tied[node] != none || (fixed[node] >> d & 1) != 0);
  for (Index contact = 0; contact < model_.contact_count(); ++contact)
    for (Index d = 0; d < 6; ++d) {
      const auto direction = loads.direction_of(contact, d);
      prescribed_[model_.rigid_unknown(contact) + d] = static_cast<char>(!direction.by_force);
      if (direction.by_force) residual_[model_.rigid_unknown(contact) + d] -= direction.value;
    }
}

void SpaceAssembly::evaluate(const SpaceState& begin, const std::vector<Real>& change, const ElementLoads<3>& loads, Real viscosity)
{
  dt_ = loads.dt;
  for_each("evaluate elements", cells_.size(), [&](Index cell) { evaluate_cell(begin, change, loads.gravity, viscosity, cell); });
  const Timer timer("assemble");
  NodeField<Vec<3>> force = model_.rest_force;
  for (Index cell = 0; cell < cells_.size(); ++cell)
    for (int k = 0; k < element_nodes<3>; ++k) force[model_.mesh.nodes[cell][k]] += cells_[cell].force[k];
  for (std::size_t k = 0; k < soil_force_.size(); ++k) soil_force_[k] = -loads.initial_imbalance_factor * initial_imbalance_[k];
  contact_force_ = 0;
  for (Index node = 0; node < force.size(); ++node) {
    if (model_.tied[node] != none) contact_force_ += force[node].norm();
    for (int d = 0; d < 3; ++d)
      model_.for_parts(node, d, [&](const UnknownPart& part) { soil_force_[part.unknown] += part.factor * force[node][d]; });
  }
  residual_ = soil_force_;
  prescribe(loads, begin.state.stage.index);
  unbalanced_ = 0;
  const auto free_part = [&](Index first) {
    Vec<3> part;
    for (int d = 0; d < 3; ++d) part[d] = prescribed_[first + d] != 0 ? 0 : residual_[first + d];
    return part.norm();
  };
  for (Index node = 0; node < force.size(); ++node) unbalanced_ += free_part(3 * node);
  for (Index contact = 0; contact < model_.contact_count(); ++contact)
    unbalanced_ += free_part(model_.rigid_unknown(contact)) + free_part(model_.rigid_unknown(contact) + 3) / model_.width;
}

void SpaceAssembly::differentiate(const SpaceState& begin, const std::vector<Real>& change, Real viscosity, std::span<Real> entries,
                                  std::span<Real> right)
{
  std::fill(entries.begin(), entries.end(), 0);
  const std::vector<Real> step(right.begin(), right.end());
  constexpr Index at_once = 256;  // elements whose matrices are kept
  std::vector<CellMatrix> matrices(at_once);
  const auto add = [&](const UnknownPart& a, const UnknownPart& b, Real value) {
    if (a.unknown < b.unknown) return;
    const Real part = a.factor * b.factor * value;
    const bool row_held = prescribed(a.unknown), column_held = prescribed(b.unknown);
    if (!row_held && !column_held) {
      entries[model_.pattern.index_of(a.unknown, b.unknown)] += part;
    } else if (row_held != column_held) {
      const Index held = row_held ? a.unknown : b.unknown, other = row_held ? b.unknown : a.unknown;
      right[other] -= part * step[held];
    }
  };
  for (Index first = 0; first < cells_.size(); first += at_once) {
    const Index count = std::min(at_once, cells_.size() - first);
    for_each("differentiate elements", count, [&](Index here) {
      const Index cell = first + here;
      CellMatrix& matrix = matrices[here];
      matrix.setZero();
      for (int q = 0; q < element_points<3>; ++q) {
        const ElementPoint<3>& shape = model_.shape[cell][q];
        const StrainMatrix b = strain_matrix(shape, model_.mean_gradient[cell]);
        const SymTensor<3> strain = strain_of(shape, model_.mean_gradient[cell], model_.mesh.nodes[cell], change);
        const StiffnessInSpace d = std::visit(
            [&](const auto& law) -> StiffnessInSpace {
              const bool elastic = has_constant_moduli<std::decay_t<decltype(law)>>() && viscosity > 0 && points_[cell][q].overstress == 0;
              if (elastic) return elastic_stiffness_in_space(law.elastic);
              return stiffness_of_point(law, viscosity,
                                        material::Increment<3, Real>{strain, dt_, begin.state.time, model_.model.mesh.size(cell)},
                                        begin.points[cell][q]);
            },
            laws_->of_cell[cell][q]);
        matrix.noalias() += b.transpose() * (shape.area * d * b);
      }
      matrix = ((matrix + matrix.transpose()) / 2).eval();
    });
    const Timer timer("assemble");
    for (Index here = 0; here < count; ++here) {
      const AtElementNodes<3, Index>& nodes = model_.mesh.nodes[first + here];
      for (int i = 0; i < 30; ++i)
        model_.for_parts(nodes[i / 3], i % 3, [&](const UnknownPart& a) {
          for (int j = 0; j < 30; ++j)
            model_.for_parts(nodes[j / 3], j % 3, [&](const UnknownPart& b) { add(a, b, matrices[here](i, j)); });
        });
    }
  }
  for (Index unknown = 0; unknown < model_.unknowns(); ++unknown)
    if (prescribed(unknown)) entries[model_.pattern.index_of(unknown, unknown)] = 1;
}

void SpaceAssembly::carry_tied_nodes(std::vector<Real>& change) const
{
  for (Index node = 0; node < model_.mesh.node_count(); ++node)
    for (int d = 0; d < 3 && model_.tied[node] != none; ++d) {
      Real moved = 0;
      model_.for_parts(node, d, [&](const UnknownPart& part) { moved += part.factor * change[part.unknown]; });
      change[3 * node + d] = moved;
    }
}

Vec<3> SpaceAssembly::reaction(Index contact) const
{
  Vec<3> force = -Eigen::Map<const Vec<3>>(&soil_force_[model_.rigid_unknown(contact)]);
  for (int d = 0; d < 3; ++d)
    if (model_.model.mirrored[d]) force[d] = 0;
  return force;
}

Vec<3> SpaceAssembly::torque(Index contact) const
{
  Vec<3> moment = -Eigen::Map<const Vec<3>>(&soil_force_[model_.rigid_unknown(contact) + 3]);
  for (int across = 0; across < 3; ++across)
    for (int d = 0; d < 3; ++d)
      if (model_.model.mirrored[across] && d != across) moment[d] = 0;
  return moment;
}

void SpaceAssembly::accept(SpaceState& state, const std::vector<Real>& change, const ElementLoads<3>& loads) const
{
  problem::Totals<3>& totals = state.state.ledger.totals;
  const Vec<3> gravity = (state.gravity + loads.gravity) / 2;
  Real over = 0, carried = 0;
  for (Index cell = 0; cell < cells_.size(); ++cell) {
    totals.internal += cells_[cell].work;
    for (int q = 0; q < element_points<3>; ++q) {
      const ElementPoint<3>& shape = model_.shape[cell][q];
      for (int k = 0; k < element_nodes<3>; ++k)
        totals.external += shape.area * shape.value[k] * model_.density[cell][q] *
                           gravity.dot(Eigen::Map<const Vec<3>>(&change[3 * model_.mesh.nodes[cell][k]]));
      if (const ElementSoil<3>& point = points_[cell][q]; point.overstress > 0) {
        over += shape.area * point.overstress;
        carried += shape.area * std::sqrt(double_dot(point.stress, point.stress));
      }
    }
  }
  for (Index node = 0; node < model_.mesh.node_count(); ++node)
    totals.external -= model_.rest_force[node].dot(Eigen::Map<const Vec<3>>(&change[3 * node]));
  const Real fictitious = (state.initial_imbalance_factor + loads.initial_imbalance_factor) / 2;
  for (Index k = 0; k < model_.rigid_unknown(); ++k)
    if (model_.tied[k / 3] == none) totals.external += fictitious * initial_imbalance_[k] * change[k];
  for (std::size_t k = 0; k < change.size(); ++k) state.displacement[k] += change[k];
  state.overstress = carried > 0 ? over / carried : 0;
  for (Index contact = 0; contact < model_.contact_count(); ++contact) {
    bodies::RigidState<3>& rigid = state.state.rigid_bodies[model_.model.contacts[contact].rigid];
    const Index first = model_.rigid_unknown(contact);
    const Eigen::Map<const Vec<3>> moved(&change[first]), turned(&change[first + 3]);
    totals.external -= (rigid.reaction + reaction(contact)).dot(moved) / 2 + (rigid.torque + torque(contact)).dot(turned) / 2;
    rigid.reaction = reaction(contact);
    rigid.torque = torque(contact);
    rigid.recent = bodies::RecentReaction<3>::steady(rigid.reaction, rigid.torque);
    rigid.displacement = Eigen::Map<const Vec<3>>(&state.displacement[first]);
    rigid.orientation.turn_by(turned);
  }
  state.points = points_;
  state.gravity = loads.gravity;
  state.initial_imbalance_factor = loads.initial_imbalance_factor;
  state.unbalanced = unbalanced_;
}

void SpaceAssembly::store_initial_imbalance(const SpaceState& state, const ElementLoads<3>& loads)
{
  ElementLoads<3> nothing = loads;
  nothing.initial_imbalance_factor = 0;
  evaluate(state, std::vector<Real>(static_cast<std::size_t>(model_.unknowns()), 0.), nothing, 0);
  initial_imbalance_ = residual_;
}

}  // namespace berm::fem
