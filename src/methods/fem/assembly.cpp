// SPDX-License-Identifier: BSD-3-Clause
#include "fem/assembly.hpp"

#include "core/for_each.hpp"
#include "fem/contact_force.hpp"
#include "fem/moved_cell.hpp"
#include "fem/point_law.hpp"
#include "material/laws.hpp"

#include <algorithm>

namespace berm::fem {
namespace {

/// The largest and the smallest principal stress.
std::pair<Real, Real> extreme_stresses(const SymTensor<2>& stress)
{
  const Real mean = (stress[0] + stress[1]) / 2, radius = std::hypot((stress[0] - stress[1]) / 2, stress[3]);
  return {std::max(mean + radius, stress[2]), std::min(mean - radius, stress[2])};
}

/// Strain (e_xx, e_yy, gamma_xy) per displacement of the nodes (x, y, x, y, ...): the B-matrix.
using StrainMatrix = Eigen::Matrix<Real, 3, 12>;

StrainMatrix strain_matrix(const ShapeAtPoint& shape)
{
  StrainMatrix b = StrainMatrix::Zero();
  for (int k = 0; k < 6; ++k) {
    b(0, 2 * k) = b(2, 2 * k + 1) = shape.gradient[k][0];
    b(1, 2 * k + 1) = b(2, 2 * k) = shape.gradient[k][1];
  }
  return b;
}

/// The strain around an axis per displacement of the nodes: N_k / r.
using HoopStrain = Eigen::Matrix<Real, 12, 1>;

HoopStrain hoop_strain(const ShapeAtPoint& shape)
{
  HoopStrain h = HoopStrain::Zero();
  for (int k = 0; k < 6; ++k) h[2 * k] = shape.value[k] * shape.per_radius;
  return h;
}

[[gnu::always_inline]] inline SymTensor<2> strain_of(const ShapeAtPoint& shape, const AtSixNodes<Index>& nodes,
                                                     const std::vector<Real>& change)
{
  SymTensor<2> strain{};
  for (int k = 0; k < 6; ++k) {
    const Real x = change[2 * nodes[k]], y = change[2 * nodes[k] + 1];
    const Vec<2>& gradient = shape.gradient[k];
    strain[0] += gradient[0] * x;
    strain[1] += gradient[1] * y;
    strain[2] += shape.value[k] * shape.per_radius * x;
    strain[3] += (gradient[1] * x + gradient[0] * y) / 2;
  }
  return strain;
}

/// The law at an integration point for increments that begin with an effective stress.
material::PreparedMaterial law_from(const FemModel& model, const SymTensor<2>& stress, Index cell, int q)
{
  const material::Material soil = model.soil_at(cell, q);
  return prepare(associated(model.flow.in(cell) ? material::drained(soil) : soil, stress));
}

}  // namespace

/// The law of an integration point for the increments that begin with this effective stress, prepared once because that is
/// expensive. Its strength may be that of another stress (update_strength).
struct Assembly::PointLaw {
  SymTensor<2> begin{{nan}};  ///< Pa, effective
  SymTensor<2> at;            ///< Pa, effective: that of the strength
  material::PreparedMaterial law;
};

struct Assembly::PointLaws {
  explicit PointLaws(Index cells) : now(cells), before(cells) {}
  CellField<std::array<PointLaw, triangle_points>> now, before;  ///< the last update_strength
};

Assembly::Assembly(const FemModel& model)
    : model_(model),
      cells_(model.mesh.nodes.size()),
      stiffness_(model.mesh.nodes.size()),
      mirrored_(model.unsymmetric ? model.mesh.nodes.size() : 0),
      elastic_(model.mesh.nodes.size(), 0),
      flow_(model.flow.water.size()),
      flow_stiffness_(model.flow.water.size()),
      points_(model.mesh.nodes.size()),
      laws_(std::make_unique<PointLaws>(model.mesh.nodes.size())),
      contact_(model.contact.size()),
      arms_(model.contact.size()),
      soil_residual_(model.unknowns()),
      residual_(model.unknowns()),
      initial_imbalance_(model.unknowns(), 0.),
      prescribed_(model.unknowns()),
      inertia_(static_cast<std::size_t>(3 * model.contact_count()))
{
}

Assembly::~Assembly() = default;

Real Assembly::bytes_of_element()
{
  constexpr std::size_t here = sizeof(CellWork) + 2 * sizeof(CellStiffness) + triangle_points * (sizeof(SoilPoint) + 2 * sizeof(PointLaw)),
                        of_model = sizeof(AtSixNodes<Index>) + sizeof(std::array<Index, 78>) +
                                   triangle_points * (sizeof(ShapeAtPoint) + sizeof(Real)),
                        of_state = triangle_points * sizeof(SoilPoint);
  return static_cast<Real>(here + of_model + of_state);
}

SymTensor<2> Assembly::effective_stress(const SoilPoint& point, Index cell) const
{
  return material::effective_stress(model_.soil_of(cell).materials.front(), point.stress, point.law_state.data());
}

FlowIncrement Assembly::flow_increment(const FemState& begin, const std::vector<Real>& change, Index cell) const
{
  const AtSixNodes<Index>& nodes = model_.mesh.nodes[cell];
  FlowIncrement increment;
  increment.dt = dt_;
  for (int k = 0; k < 12; ++k) {
    increment.moved_before[k] = begin.displacement[2 * nodes[k / 2] + k % 2];
    increment.moved[k] = change[2 * nodes[k / 2] + k % 2];
  }
  for (int k = 0; k < 3; ++k) {
    const Index unknown = model_.flow.unknown[nodes[k]];
    increment.pressure_before[k] = begin.displacement[unknown];
    increment.added[k] = change[unknown];
  }
  return increment;
}

/// Gives the point its total stress, from the effective one.
void Assembly::set_pressure(SoilPoint& point, Real pressure, Index cell) const
{
  point.law_state[pore_pressure_index(model_.soil_of(cell).materials.front())] = pressure;
  for (int k = 0; k < 3; ++k) point.stress[k] -= pressure;
}

/// The point for the law of the skeleton alone, where water flows.
SoilPoint Assembly::with_effective_stress(SoilPoint point, Index cell) const
{
  if (model_.flow.in(cell)) point.stress = effective_stress(point, cell);
  return point;
}

/// Where deformations are large: the element in the increment.
std::optional<MovedCell> Assembly::moved_cell(const FemState& begin, const std::vector<Real>& change, Index cell) const
{
  if (!model_.settings.large_deformation) return std::nullopt;
  AtSixNodes<Vec<2>> moved;
  for (int k = 0; k < 6; ++k) {
    const Index node = model_.mesh.nodes[cell][k];
    moved[k] = Vec<2>(change[2 * node], change[2 * node + 1]);
  }
  return move_cell(positions_now(model_, begin, cell), moved, model_.model.mesh.metric);
}

const Assembly::PointLaw& Assembly::law_of_point(const SymTensor<2>& begin, Index cell, int q)
{
  PointLaw& made = laws_->now[cell][q];
  if (!std::equal(begin.c, begin.c + tensor_size<2>, made.begin.c)) {
    made.begin = made.at = begin;
    made.law = law_from(model_, begin, cell, q);
  }
  return made;
}

void Assembly::update_strength(Real part)
{
  laws_->before = laws_->now;
  for_each("follow strength", cells_.size(), [&](Index cell) {
    for (int q = 0; q < triangle_points; ++q) {
      PointLaw& of_point = laws_->now[cell][q];
      const SymTensor<2> end = effective_stress(points_[cell][q], cell);
      for (int k = 0; k < 4; ++k) of_point.at[k] += part * (end[k] - of_point.at[k]);
      of_point.law = law_from(model_, of_point.at, cell, q);
    }
  });
}

void Assembly::undo_strength_update()
{
  laws_->now = laws_->before;
}

void Assembly::reset_strength()
{
  for (std::array<PointLaw, triangle_points>& laws : laws_->now) laws.fill(PointLaw{});
}

StrengthLag Assembly::strength_lag(const FemState& begin, const std::vector<Real>& change) const
{
  StrengthLag lag;
  for (Index cell = 0; cell < cells_.size(); ++cell) {
    const std::optional<MovedCell> moved = moved_cell(begin, change, cell);
    if (moved && moved->inverted) continue;
    for (int q = 0; q < triangle_points; ++q) {
      const material::Material material = model_.soil_at(cell, q);
      const material::Elasticity elastic = elasticity(material);
      const ShapeAtPoint& shape = moved ? moved->middle[q] : model_.shape[cell][q];
      const SymTensor<2> end = effective_stress(points_[cell][q], cell);
      const auto [s1, s3] = extreme_stresses(end);
      const std::optional<Real> strength = shear_strength(material, (s1 + s3) / 2, points_[cell][q].law_state.data());
      if (!strength) continue;
      SymTensor<2> returned = effective_stress(begin.points[cell][q], cell);
      if (moved) returned = rotated(returned, moved->rotation[q]);
      add_elastic_stress(elastic, returned, strain_of(shape, model_.mesh.nodes[cell], change));
      for (int k = 0; k < 4; ++k) returned[k] -= end[k];
      const auto [r1, r3] = extreme_stresses(returned);
      const Real flow = shape.area * (r1 - r3) / (2 * elastic.shear), shear = (s1 - s3) / 2;
      lag.missing += (*strength - shear) * flow;
      lag.dissipated += shear * flow;
    }
  }
  return lag;
}

void Assembly::evaluate_cell(const FemState& begin, const std::vector<Real>& change, const Vec<2>& gravity, Real viscosity, Index cell)
{
  CellWork& work = cells_[cell];
  work.force.fill(0);
  work.work = 0;
  const std::optional<MovedCell> moved = moved_cell(begin, change, cell);
  if (moved && moved->inverted) return work.force.fill(nan);
  for (int q = 0; q < triangle_points; ++q) {
    const Vec<2> weight = model_.density[cell][q] * gravity;
    const ShapeAtPoint &middle = moved ? moved->middle[q] : model_.shape[cell][q], &shape = moved ? moved->end[q] : model_.shape[cell][q];
    const SymTensor<2> strain = strain_of(middle, model_.mesh.nodes[cell], change);
    SoilPoint& point = points_[cell][q];
    point = begin.points[cell][q];
    const SymTensor<2> effective = effective_stress(point, cell);
    if (moved) point.stress = rotated(point.stress, moved->rotation[q]);
    const SymTensor<2> start = point.stress;
    point = with_effective_stress(point, cell);
    SymTensor<2> mean;
    std::visit(
        [&](const auto& law) {
          if (moved) rotate_state(law, point.law_state, moved->rotation[q]);
          update_point(law, viscosity, {strain, dt_, begin.state.time, model_.cell_size[cell]}, point);
        },
        law_of_point(effective, cell, q).law);
    if (model_.flow.in(cell)) set_pressure(point, pressure_at_end(corner_shape(shape), flow_increment(begin, change, cell)), cell);
    for (int k = 0; k < 4; ++k) mean[k] = (start[k] + point.stress[k]) / 2;
    work.work += middle.area * double_dot(mean, strain);
    const SymTensor<2>& stress = point.stress;
    for (int k = 0; k < 6; ++k) {
      const Vec<2>& gradient = shape.gradient[k];
      const Real value = shape.value[k];
      work.force[2 * k] +=
          shape.area * (gradient[0] * stress[0] + gradient[1] * stress[3] + value * (shape.per_radius * stress[2] - weight[0]));
      work.force[2 * k + 1] += shape.area * (gradient[1] * stress[1] + gradient[0] * stress[3] - value * weight[1]);
    }
  }
  if (model_.flow.in(cell))
    flow_[cell] = water_balance(moved ? moved->middle : model_.shape[cell], model_.flow.water[cell], flow_increment(begin, change, cell));
}

/// Whether all stresses of an element that were evaluated last are elastic, as viscosity tells: it moves every other.
bool Assembly::is_elastic(Real viscosity, Index cell) const
{
  if (!(viscosity > 0)) return false;
  for (int q = 0; q < triangle_points; ++q) {
    const bool constant =
        std::visit([](const auto& law) { return has_constant_moduli<std::decay_t<decltype(law)>>(); }, laws_->now[cell][q].law);
    if (!constant || points_[cell][q].overstress > 0) return false;
  }
  return true;
}

/// Adds what the forces of a stress change by as the element turns and stretches, its symmetric part: with g_i the gradients of the shape functions and the Jaumann rate of the stress
///
///   A ((g_i . s g_j) 1/2 - (s g_j g_i^T + (s g_i g_j^T)^T + (g_i . g_j) s)/2 + (s g_i g_j^T + (s g_j g_i^T)^T)/2).
void add_initial_stress(const ShapeAtPoint& shape, const SymTensor<2>& stress, Eigen::Matrix<Real, 12, 12>& stiffness)
{
  Matrix<2> s;
  s << stress[0], stress[3], stress[3], stress[1];
  for (int i = 0; i < 6; ++i)
    for (int j = 0; j < 6; ++j) {
      const Vec<2>&g = shape.gradient[i], &h = shape.gradient[j];
      const Vec<2> sg = s * g, sh = s * h;
      const Matrix<2> turn = sh * g.transpose() + h * sg.transpose() + g.dot(h) * s, widen = sg * h.transpose() + g * sh.transpose();
      stiffness.block<2, 2>(2 * i, 2 * j) += shape.area / 2 * (g.dot(sh) * Matrix<2>::Identity() - turn + widen);
    }
}

void Assembly::differentiate_cell(const FemState& begin, const std::vector<Real>& change, Real viscosity, Index cell)
{
  const bool elastic = is_elastic(viscosity, cell), kept = elastic && !model_.flow.in(cell);
  if (kept && elastic_[cell] != 0) return;
  // Elastic soil without water keeps the stiffness that it had when the mesh was made: it moves little, and residuals are those of now.
  const std::optional<MovedCell> moved = kept ? std::nullopt : moved_cell(begin, change, cell);
  if (moved && moved->inverted) return;
  elastic_[cell] = static_cast<char>(elastic);
  Eigen::Matrix<Real, 12, 12> stiffness = Eigen::Matrix<Real, 12, 12>::Zero();
  for (int q = 0; q < triangle_points; ++q) {
    const ShapeAtPoint &middle = moved ? moved->middle[q] : model_.shape[cell][q], &shape = moved ? moved->end[q] : model_.shape[cell][q];
    const StrainMatrix b = strain_matrix(shape);
    const SymTensor<2> strain = strain_of(middle, model_.mesh.nodes[cell], change);
    SoilPoint point = begin.points[cell][q];
    const SymTensor<2> effective = effective_stress(point, cell);
    if (moved) point.stress = rotated(point.stress, moved->rotation[q]);
    const PointStiffness d = std::visit(
        [&](const auto& law) {
          if (elastic) return elastic_point(law.elastic);
          if (moved) rotate_state(law, point.law_state, moved->rotation[q]);
          return stiffness_of_point(law, viscosity, {strain, dt_, begin.state.time, model_.cell_size[cell]},
                                    with_effective_stress(point, cell));
        },
        law_of_point(effective, cell, q).law);
    stiffness += b.transpose() * (shape.area * d.plane * b);
    if (moved && model_.flow.in(cell)) add_initial_stress(shape, points_[cell][q].stress, stiffness);
    if (!(shape.per_radius > 0)) continue;
    const HoopStrain h = hoop_strain(shape), across = b.transpose() * Eigen::Vector3d(d.across),
                     along = b.transpose() * Eigen::Vector3d(d.along);
    stiffness += shape.area * (across * h.transpose() + h * along.transpose() + d.around * h * h.transpose());
  }
  int k = 0;
  for (int i = 0; i < 12; ++i)
    for (int j = 0; j <= i; ++j, ++k) {
      // The lower triangle is that by unknown where it matters.
      const bool swapped = model_.unsymmetric && model_.mesh.nodes[cell][i / 2] < model_.mesh.nodes[cell][j / 2];
      stiffness_[cell][k] = swapped ? stiffness(j, i) : stiffness(i, j);
      if (model_.unsymmetric) mirrored_[cell][k] = swapped ? stiffness(i, j) : stiffness(j, i);
    }
  if (model_.flow.in(cell))
    flow_stiffness_[cell] =
        balance_derivatives(moved ? moved->middle : model_.shape[cell], model_.flow.water[cell], flow_increment(begin, change, cell));
}

void Assembly::add_contact(const FemState& begin, const std::vector<Real>& change)
{
  contact_force_ = 0;
  for (std::size_t k = 0; k < contact_.size(); ++k) {
    const FemContactPoint& point = model_.contact[k];
    const std::array<Index, 5> unknowns = model_.unknowns_of(point);
    Eigen::Matrix<Real, 5, 1> moved;
    for (int i = 0; i < 5; ++i) moved[i] = change[unknowns[i]];
    const ContactForce now = fem::contact_force(model_, k, begin, moved);
    contact_[k] = now.state;
    arms_[k] = now.arm;
    contact_force_ += point.area * now.state.traction.norm();
    for (int i = 0; i < 5; ++i) residual_[unknowns[i]] -= now.force[i];
  }
}

void Assembly::prescribe_unknowns(const std::vector<Real>& change, const FemLoads& loads, Index stage)
{
  const NodeField<std::uint8_t>& fixed = model_.mesh.fixed[model_.model.conditions.table_of_stage[stage]];
  for (Index node = 0; node < fixed.size(); ++node)
    for (int d = 0; d < 2; ++d) prescribed_[2 * node + d] = static_cast<char>(fixed[node] >> d & 1);
  for (Index contact = 0; contact < model_.contact_count(); ++contact)
    for (Index d = 0; d < 3; ++d) {
      const Index unknown = model_.rigid_unknown(contact) + d;
      const FemLoads::Direction direction = loads.direction_of(contact, d);
      prescribed_[unknown] = static_cast<char>(!direction.by_force);
      Real& inertia = inertia_[static_cast<std::size_t>(3 * contact + d)];
      inertia = loads.dt > 0 ? direction.mass / (weight_of_end * loads.dt * loads.dt) : 0;
      if (direction.by_force) residual_[unknown] += inertia * (change[unknown] - loads.dt * direction.velocity) - direction.value;
    }
  if (model_.flow.count == 0) return;
  const NodeField<char>& open = model_.flow.open[model_.model.conditions.table_of_stage[stage]];
  for (Index node = 0; node < open.size(); ++node)
    if (const Index unknown = model_.flow.unknown[node]; unknown != none)
      prescribed_[unknown] = static_cast<char>(loads.drained || open[node] != 0);
  if (model_.flow.at_head.empty()) return;
  outside_.assign(static_cast<std::size_t>(model_.flow.count), 0);
  for (std::size_t h = 0; h < loads.heads.size() && !loads.drained; ++h)
    for (const Index unknown : model_.flow.at_head[h]) outside_[unknown - model_.pressure_unknown()] += loads.heads[h];
}

/// Adds the balance of the water to the residual.
void Assembly::add_flow()
{
  if (model_.flow.count == 0) return;
  Real volume = 0, unbalanced = 0;
  for (Index cell = 0; cell < cells_.size(); ++cell) {
    if (!model_.flow.in(cell)) continue;
    volume += flow_[cell].volume;
    for (int k = 0; k < 3; ++k) residual_[model_.flow.unknown[model_.mesh.nodes[cell][k]]] += flow_[cell].residual[k];
  }
  for (Index unknown = model_.pressure_unknown(); unknown < model_.unknowns(); ++unknown)
    if (!prescribed_[unknown]) unbalanced += std::abs(residual_[unknown]);
  unbalanced_flow_ = unbalanced / volume;
}

void Assembly::evaluate(const FemState& begin, const std::vector<Real>& change, const FemLoads& loads, Real viscosity)
{
  dt_ = loads.dt;
  for_each("evaluate elements", cells_.size(), [&](Index cell) { evaluate_cell(begin, change, loads.gravity, viscosity, cell); });
  const Timer timer("assemble");
  for (std::size_t k = 0; k < residual_.size(); ++k) residual_[k] = -loads.initial_imbalance_factor * initial_imbalance_[k];
  for (Index cell = 0; cell < cells_.size(); ++cell) {
    const auto& nodes = model_.mesh.nodes[cell];
    for (int k = 0; k < 12; ++k) residual_[2 * nodes[k / 2] + k % 2] += cells_[cell].force[k];
  }
  for (std::size_t t = 0; t < loads.tractions.size(); ++t)
    for (const NodalLoad& load : model_.loads[t])
      for (int d = 0; d < 2; ++d) residual_[2 * load.node + d] -= loads.tractions[t] * load.force[d];
  prescribe_unknowns(change, loads, begin.state.stage.index);
  add_flow();
  soil_residual_ = residual_;
  add_contact(begin, change);

  unbalanced_ = 0;
  for (Index node = 0; node < model_.mesh.position.size(); ++node) {
    Vec<2> force;
    for (int d = 0; d < 2; ++d) force[d] = prescribed_[2 * node + d] ? 0 : residual_[2 * node + d];
    unbalanced_ += force.norm();
  }
  for (Index contact = 0; contact < model_.contact_count(); ++contact) {
    const Index first = model_.rigid_unknown(contact);
    for (const Index unknown : {first, first + 1})
      if (!prescribed_[unknown]) unbalanced_ += std::abs(residual_[unknown]);
    if (const FemLoads::Direction angle = loads.direction_of(contact, 2); angle.by_force && angle.value != 0)
      unbalanced_ += std::abs(residual_[first + 2]) / model_.width;
  }
}

void Assembly::differentiate(const FemState& begin, const std::vector<Real>& change, Real viscosity)
{
  for_each("differentiate elements", cells_.size(), [&](Index cell) { differentiate_cell(begin, change, viscosity, cell); });
}

std::vector<Real> Assembly::matrix() const
{
  const Timer timer("assemble");
  const SparsePattern& pattern = model_.pattern;
  const Index count = pattern.entry_count();
  std::vector<Real> matrix(static_cast<std::size_t>(model_.unsymmetric ? 2 * count : count), 0.);
  const auto add = [&](Index first, const CellField<CellStiffness>& of_cells) {
    for (Index cell = 0; cell < of_cells.size(); ++cell)
      for (int k = 0; k < 78; ++k) matrix[first + model_.cell_entries[cell][k]] += of_cells[cell][k];
    for (Index cell = 0; cell < model_.flow.entries.size(); ++cell)
      if (model_.flow.in(cell))
        for (int k = 0; k < pressure_entries; ++k) matrix[first + model_.flow.entries[cell][k]] += flow_stiffness_[cell][k];
  };
  add(0, stiffness_);
  if (model_.unsymmetric) add(count, mirrored_);
  for (Index row = 0; row < pattern.size(); ++row)
    for (Index k = pattern.first[row]; k < pattern.first[row + 1]; ++k) {
      const bool diagonal = pattern.column[k] == row, held = prescribed_[row] || prescribed_[pattern.column[k]];
      if (held) matrix[k] = diagonal ? 1 : 0;
      if (model_.unsymmetric && (held || diagonal)) matrix[count + k] = 0;
    }
  return matrix;
}

Real Assembly::norm() const
{
  Real sum = 0;
  for (Index k = 0; k < model_.pressure_unknown(); ++k)
    if (!prescribed_[k]) sum += residual_[k] * residual_[k];
  return std::sqrt(sum);
}

Vec<2> Assembly::reaction(Index contact) const
{
  Vec<2> sum = Vec<2>::Zero();
  for (std::size_t k = 0; k < contact_.size(); ++k)
    if (model_.contact[k].contact == contact) sum -= model_.contact[k].area * contact_[k].traction;
  if (model_.model.mesh.metric == mesh::Metric::axisymmetric) sum[0] = 0;  // balances itself around the axis
  return sum;
}

Real Assembly::torque(Index contact) const
{
  Real sum = 0;
  if (model_.model.mesh.metric == mesh::Metric::axisymmetric) return sum;
  for (std::size_t k = 0; k < contact_.size(); ++k) {
    if (model_.contact[k].contact != contact) continue;
    const Vec<2>&arm = arms_[k], &traction = contact_[k].traction;
    sum -= model_.contact[k].area * (arm[0] * traction[1] - arm[1] * traction[0]);
  }
  return sum;
}

std::vector<Vec<2>> Assembly::support_forces(Index stage) const
{
  std::vector<Vec<2>> forces(model_.model.conditions.reported.size(), Vec<2>::Zero());
  if (forces.empty()) return forces;
  const NodeField<boundary::Holders<2>>& holders = model_.mesh.holders[model_.model.conditions.table_of_stage[stage]];
  for (Index node = 0; node < holders.size(); ++node)
    for (int d = 0; d < 2; ++d)
      if (const Index support = holders[node][d]; support != none) forces[support][d] += residual_[2 * node + d];
  return forces;
}

void Assembly::accept(FemState& state, const std::vector<Real>& change, const FemLoads& loads) const
{
  count_work(state, change, loads);
  state.points = points_;
  state.contact = contact_;
  for (std::size_t k = 0; k < contact_.size(); ++k)
    if (parts(model_.interfaces[model_.contact[k].contact], contact_[k])) state.contact[k].parted = 1;
  state.gravity = loads.gravity;
  state.tractions = loads.tractions;
  state.initial_imbalance_factor = loads.initial_imbalance_factor;
  state.unbalanced = unbalanced_;
  state.support_forces = support_forces(state.state.stage.index);
  for (std::size_t k = 0; k < change.size(); ++k) state.displacement[k] += change[k];
  Real over = 0, carried = 0;
  for (Index cell = 0; cell < cells_.size(); ++cell)
    for (int q = 0; q < triangle_points; ++q)
      if (const SoilPoint& point = points_[cell][q]; point.overstress > 0) {
        over += model_.shape[cell][q].area * point.overstress;
        carried += model_.shape[cell][q].area * std::sqrt(double_dot(point.stress, point.stress));
      }
  state.overstress = carried > 0 ? over / carried : 0;
  for (Index contact = 0; contact < model_.contact_count(); ++contact) {
    bodies::RigidState<2>& rigid = state.state.rigid_bodies[model_.model.contacts[contact].rigid];
    rigid.reaction = reaction(contact);
    rigid.torque = torque(contact);
    rigid.recent = bodies::RecentReaction<2>::steady(rigid.reaction, rigid.torque);
    const Index first = model_.rigid_unknown(contact);
    rigid.displacement = Vec<2>(state.displacement[first], state.displacement[first + 1]);
    rigid.orientation.angle = state.displacement[first + 2];
  }
}

void Assembly::store_initial_imbalance(const FemState& state, const FemLoads& loads)
{
  FemLoads nothing = loads;
  nothing.initial_imbalance_factor = 0;
  evaluate(state, std::vector<Real>(model_.unknowns(), 0.), nothing, 0);
  initial_imbalance_ = residual_;
}

}  // namespace berm::fem
