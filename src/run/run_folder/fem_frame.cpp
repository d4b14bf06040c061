// SPDX-License-Identifier: BSD-3-Clause
#include "run_folder/fem_frame.hpp"

#include "run_folder/gradient_strain.hpp"

#include <algorithm>
#include <functional>
#include <tuple>

namespace berm::run_folder {
namespace {

/// The weight of point of integration q in the value drawn out to node k: the linear function through the three points.
constexpr Real drawn_out(int k, int q)
{
  if (k < 3) return k == q ? 5. / 3 : -1. / 3;
  return (k - 3 == q || (k - 2) % 3 == q) ? 2. / 3 : -1. / 3;
}

/// A field of the points of integration: what is said of it, and the member that keeps it.
template <class Member>
struct PointField {
  const char *name, *label, *unit;
  Member fem::SoilPoint::*member;

  static constexpr bool is_number = std::is_same_v<Member, Real>;
  FieldInfo info() const { return {name, label, unit, is_number ? 1 : tensor_size<2>, to_frame}; }
  Real of(const fem::SoilPoint& point, int component) const
  {
    if constexpr (is_number)
      return point.*member;
    else
      return (point.*member)[component];
  }
};

/// What points of integration carry to frames beside what their law keeps. The bare numbers are never negative.
constexpr std::tuple point_fields = {
    PointField<SymTensor<2>>{"stress", "stress (tension positive)", "Pa", &fem::SoilPoint::stress},
    PointField<Real>{"accumulated_deviatoric_strain", "accumulated deviatoric strain", "", &fem::SoilPoint::deviatoric_strain},
    PointField<Real>{"overstress", "overstress: stress beyond the strength", "Pa", &fem::SoilPoint::overstress}};

struct NodalSums {
  Real area = 0;
  Matrix<2> gradient = Matrix<2>::Zero(), gradient_since_last = Matrix<2>::Zero();  ///< of the displacement
};

/// du/dx at a point of integration; `displacement` by unknown.
Matrix<2> gradient_at(const fem::ShapeAtPoint& shape, const fem::AtSixNodes<Index>& nodes, const std::vector<Real>& displacement)
{
  Matrix<2> gradient = Matrix<2>::Zero();
  for (int k = 0; k < 6; ++k)
    gradient += Vec<2>(displacement[2 * nodes[k]], displacement[2 * nodes[k] + 1]) * shape.gradient[k].transpose();
  return gradient;
}

/// The gradient of the displacement since a moment, by the places of then: F - 1, of which the inverse is known, the gradient of those places by the ones of now.
Matrix<2> gradient_since(const fem::FemModel& model, const fem::FemState& state, fem::Moment moment, Index cell, int q)
{
  const fem::AtSixNodes<Index>& nodes = model.mesh.nodes[cell];
  const fem::ShapeAtPoint shape = fem::shape_at(fem::positions_now(model, state, cell), q);
  Matrix<2> inverse = Matrix<2>::Zero();
  for (int k = 0; k < 6; ++k) inverse += state.place_at(moment)[nodes[k]] * shape.gradient[k].transpose();
  return inverse.inverse() - Matrix<2>::Identity();
}

/// A field of a frame that points of integration of some bodies carry.
struct DrawnField {
  FieldInfo info;
  std::vector<int> first;  ///< by body: which of the numbers of a point is its first component, or none
  std::function<Real(const fem::SoilPoint&, int first, int component)> of;
};

/// What the soil has of its own at the integration points, where it varies: by body, the field's place among the own values.
struct OwnField {
  FieldInfo info;
  std::vector<int> place;
};

std::vector<OwnField> own_fields_of(const problem::Model<2>& model)
{
  std::vector<OwnField> fields;
  for (std::size_t b = 0; b < model.bodies.size(); ++b) {
    const std::vector<FieldInfo> own = local_fields(model.bodies[b].soil);
    for (std::size_t k = 0; k < own.size(); ++k) {
      auto found = std::find_if(fields.begin(), fields.end(), [&](const OwnField& field) { return field.info.name == own[k].name; });
      if (found == fields.end()) found = fields.insert(found, {own[k], std::vector<int>(model.bodies.size(), none)});
      found->place[b] = static_cast<int>(k);
    }
  }
  return fields;
}

/// Adds the effective stress of a body, if it is undrained.
void add_effective_stress(const problem::Model<2>& model, std::size_t body, std::vector<DrawnField>& fields)
{
  const int place = pore_pressure_index(model.bodies[body].soil.materials.front());
  if (place == none) return;
  const auto effective = [](const fem::SoilPoint& point, int pressure, int component) {
    return point.stress[component] + (component < 3 ? point.law_state[pressure] : 0);
  };
  const auto mean = [effective](const fem::SoilPoint& point, int pressure, int) {
    return (effective(point, pressure, 0) + effective(point, pressure, 1) + effective(point, pressure, 2)) / 3;
  };
  for (const FieldInfo& info : effective_stress_fields<2>()) {
    auto found = std::find_if(fields.begin(), fields.end(), [&](const DrawnField& field) { return field.info.name == info.name; });
    if (found == fields.end()) {
      const std::vector<int> in_no_body(model.bodies.size(), none);
      found = fields.insert(found, info.components > 1 ? DrawnField{info, in_no_body, effective} : DrawnField{info, in_no_body, mean});
    }
    found->first[body] = place;
  }
}

std::vector<DrawnField> drawn_fields(const problem::Model<2>& model)
{
  std::vector<DrawnField> fields;
  const std::size_t bodies = model.bodies.size();
  std::apply(
      [&](const auto&... field) {
        (fields.push_back({field.info(), std::vector<int>(bodies, 0),
                           [&field](const fem::SoilPoint& point, int, int component) { return field.of(point, component); }}),
         ...);
      },
      point_fields);
  for (std::size_t b = 0; b < bodies; ++b) {
    int offset = 0;
    for (const FieldInfo& info : state_fields(model.bodies[b].soil.materials.front())) {
      const int first = offset;
      offset += info.components;
      if (!info.goes(to_frame)) continue;
      auto found = std::find_if(fields.begin(), fields.end(), [&](const DrawnField& field) { return field.info.name == info.name; });
      if (found == fields.end())
        found = fields.insert(found, {info, std::vector<int>(bodies, none),
                                      [](const fem::SoilPoint& point, int place, int) { return point.law_state[place]; }});
      found->first[b] = first;
    }
    add_effective_stress(model, b, fields);
  }
  return fields;
}

/// A frame with room for what nodes carry.
Frame<2> empty_frame(const fem::QuadraticMesh& mesh, const std::vector<DrawnField>& drawn, const std::vector<OwnField>& own,
                     bool with_ratio, bool with_flux, const std::string& since)
{
  std::vector<FieldInfo> infos = common_fields<2>(since);
  for (const DrawnField& field : drawn)
    if (!is_common_field(field.info.name)) infos.push_back(field.info);
  for (const OwnField& field : own) infos.push_back(field.info);
  if (with_ratio) infos.push_back(pore_pressure_ratio_field());
  if (with_flux) infos.push_back(water_flux_field<2>());
  Frame<2> frame;
  frame.allocate(static_cast<std::size_t>(mesh.node_count()), infos);
  frame.triangles.assign(mesh.nodes.begin(), mesh.nodes.end());
  return frame;
}

/// Draws the fields of the points of integration out to the nodes and averages them over the elements by their area. Gives the sums by node.
NodeField<NodalSums> draw_out(const fem::FemModel& model, const fem::FemState& state, const std::vector<Real>& last_displacement,
                              const std::vector<Real>& zero, const std::vector<DrawnField>& drawn, Frame<2>& frame)
{
  const fem::QuadraticMesh& mesh = model.mesh;
  std::vector<FieldValues<Real>*> shown;
  for (const DrawnField& field : drawn) shown.push_back(&frame.field(field.info.name));
  NodeField<NodalSums> sums(mesh.node_count());
  std::vector<char> positive(drawn.size(), 1);  // what is nowhere negative is not drawn out to be
  for (Index cell = 0; cell < mesh.cell_count(); ++cell) {
    Real area = 0;
    for (const fem::ShapeAtPoint& shape : model.shape[cell]) area += shape.per_radius > 0 ? shape.area * shape.per_radius : shape.area;
    std::array<Matrix<2>, fem::triangle_points> gradient, since_last;
    for (int q = 0; q < fem::triangle_points; ++q) {
      if (model.settings.large_deformation) {
        gradient[q] = gradient_since(model, state, fem::Moment::zero, cell, q);
        since_last[q] = gradient_since(model, state, fem::Moment::last_frame, cell, q);
        continue;
      }
      const Matrix<2> now = gradient_at(model.shape[cell][q], mesh.nodes[cell], state.displacement);
      gradient[q] = now - gradient_at(model.shape[cell][q], mesh.nodes[cell], zero);
      since_last[q] = now - gradient_at(model.shape[cell][q], mesh.nodes[cell], last_displacement);
    }
    for (int k = 0; k < 6; ++k) {
      const Index node = mesh.nodes[cell][k];
      NodalSums& sum = sums[node];
      sum.area += area;
      frame.body[node] = mesh.body[cell];
      for (int q = 0; q < fem::triangle_points; ++q) {
        const Real weight = area * drawn_out(k, q);
        sum.gradient += weight * gradient[q];
        sum.gradient_since_last += weight * since_last[q];
        for (std::size_t f = 0; f < drawn.size(); ++f)
          for (int c = 0, first = drawn[f].first[mesh.body[cell]]; first != none && c < drawn[f].info.components; ++c) {
            const Real value = drawn[f].of(state.points[cell][q], first, c);
            shown[f]->at(node, c) += weight * value;
            positive[f] = positive[f] && value >= 0;
          }
      }
    }
  }
  for (std::size_t f = 0; f < drawn.size(); ++f)
    for (Index node = 0; node < mesh.node_count(); ++node)
      for (int c = 0; c < drawn[f].info.components; ++c) {
        Real& value = shown[f]->at(node, c);
        value /= sums[node].area;
        if (drawn[f].info.components == 1 && positive[f]) value = std::max(Real(0), value);
      }
  return sums;
}

/// Gives each node the mean of what the soil of its elements has there at the start.
void set_own(const fem::FemModel& model, const fem::FemState& state, const std::vector<OwnField>& own, Frame<2>& frame)
{
  NodeField<Real> cells(model.mesh.node_count(), 0);
  for (Index cell = 0; cell < model.mesh.cell_count() && !own.empty(); ++cell)
    for (const Index node : model.mesh.nodes[cell]) {
      const settings::BodySoil& soil = model.soil_of(cell);
      const std::vector<Real> values = local_values(
          soil, model.region_of(cell),
          model.model.soil_place(model.settings.large_deformation ? state.place_at(fem::Moment::start)[node] : model.mesh.position[node]));
      ++cells[node];
      for (const OwnField& field : own)
        if (const int place = field.place[model.mesh.body[cell]]; place != none && !values.empty()) {
          Real& mean = frame.field(field.info.name).at(node);
          mean += (values[place] - mean) / cells[node];
        }
    }
}

/// Gives each node that water has a pressure at r_u, with the mean of what rests on the points of its elements.
void set_pore_pressure_ratio(const fem::FemModel& model, Frame<2>& frame)
{
  const std::string name = pore_pressure_ratio_field().name;
  if (find_field(frame.fields, name) == nullptr) return;
  struct Mean {
    Real sum = 0;
    int count = 0;
  };
  NodeField<Mean> at_rest(model.mesh.node_count());
  for (Index cell = 0; cell < model.mesh.cell_count(); ++cell) {
    if (pore_pressure_index(model.soil_of(cell).materials.front()) == none) continue;
    for (int q = 0; q < fem::triangle_points; ++q) {
      const Real above = overburden(model.model, model.mesh.body[cell], model.region_of(cell), model.place[cell][q]);
      for (const Index node : model.mesh.nodes[cell]) at_rest[node].sum += above, ++at_rest[node].count;
    }
  }
  for (Index node = 0; node < model.mesh.node_count(); ++node)
    if (at_rest[node].sum > 0)
      frame.field(name).at(node) = frame.field("excess_pore_pressure").at(node) * at_rest[node].count / at_rest[node].sum;
}

/// Draws the flux of the water out to the nodes and averages it over those of their elements in which it flows, by their area.
void set_water_flux(const fem::FemModel& model, const fem::FemState& state, Frame<2>& frame)
{
  FieldValues<Real>& flux = frame.field(water_flux_field<2>().name);
  NodeField<Real> areas(model.mesh.node_count(), 0);
  for (Index cell = 0; cell < model.mesh.cell_count(); ++cell) {
    if (!model.flow.in(cell)) continue;
    const fem::AtSixNodes<Index>& nodes = model.mesh.nodes[cell];
    fem::VolumeStrain displacement;
    for (int k = 0; k < 12; ++k) displacement[k] = state.displacement[2 * nodes[k / 2] + k % 2];
    std::array<Real, 3> pressure;
    for (int k = 0; k < 3; ++k) pressure[k] = state.displacement[model.flow.unknown[nodes[k]]];
    std::array<Vec<2>, fem::triangle_points> at_points;
    Real area = 0;
    for (int q = 0; q < fem::triangle_points; ++q) {
      const fem::ShapeAtPoint& shape = model.shape[cell][q];
      at_points[q] = fem::water_flux(shape, model.flow.water[cell][q], displacement, pressure);
      area += shape.per_radius > 0 ? shape.area * shape.per_radius : shape.area;
    }
    for (int k = 0; k < 6; ++k) {
      areas[nodes[k]] += area;
      for (int q = 0; q < fem::triangle_points; ++q)
        for (int d = 0; d < 2; ++d) flux.at(nodes[k], d) += area * drawn_out(k, q) * at_points[q][d];
    }
  }
  for (Index node = 0; node < model.mesh.node_count(); ++node)
    for (int d = 0; d < 2 && areas[node] > 0; ++d) flux.at(node, d) /= areas[node];
}

/// What the nodes' own motion and the gradients of their elements say.
void set_motion(const fem::FemModel& model, const fem::FemState& state, const std::vector<Real>& last_displacement,
                const std::vector<Real>& zero, const NodeField<NodalSums>& sums, Frame<2>& frame)
{
  const fem::QuadraticMesh& mesh = model.mesh;
  const auto stretch_around = [&](Index node, Real moved, const Matrix<2>& gradient) {
    if (model.model.mesh.metric != mesh::Metric::axisymmetric) return Real(1);
    const Real radius = mesh.position[node][0];
    return 1 + (radius > 0 ? moved / radius : gradient(0, 0));
  };
  const FieldValues<Real>& stress = frame.field("stress");
  FieldValues<Real>&displacement = frame.field("displacement"), &mean_stress = frame.field("mean_stress"),
  &deviatoric = frame.field("deviatoric_strain"), &volumetric = frame.field("volumetric_strain"),
  &increment = frame.field("incremental_deviatoric_strain");
  for (Index node = 0; node < mesh.node_count(); ++node) {
    const NodalSums& sum = sums[node];
    const bool large = model.settings.large_deformation;
    const Vec<2> moved_by(state.displacement[2 * node], state.displacement[2 * node + 1]), now = mesh.position[node] + moved_by;
    const Vec<2> since_zero = large ? Vec<2>(now - state.place_at(fem::Moment::zero)[node])
                                    : Vec<2>(moved_by - Vec<2>(zero[2 * node], zero[2 * node + 1])),
                 since_frame = large ? Vec<2>(now - state.place_at(fem::Moment::last_frame)[node])
                                     : Vec<2>(moved_by - Vec<2>(last_displacement[2 * node], last_displacement[2 * node + 1]));
    frame.id[node] = node;
    frame.points[node] = now;
    frame.volume[node] = sum.area / 6;
    for (int d = 0; d < 2; ++d) displacement.at(node, d) = since_zero[d];
    mean_stress.at(node) = (stress.at(node, 0) + stress.at(node, 1) + stress.at(node, 2)) / 3;
    const Matrix<2> gradient = sum.gradient / sum.area, since_last = sum.gradient_since_last / sum.area;
    const Real around = stretch_around(node, displacement.at(node, 0), gradient),
               around_since_last = stretch_around(node, since_frame[0], since_last);
    const GradientStrain strain = gradient_strain<2>(Matrix<2>::Identity() + gradient, around);
    deviatoric.at(node) = strain.deviatoric;
    volumetric.at(node) = strain.volumetric;
    increment.at(node) = gradient_strain<2>(Matrix<2>::Identity() + since_last, around_since_last).deviatoric;
  }
}

}  // namespace

FemFrameMaker::FemFrameMaker(const fem::FemModel& model)
    : model_(model),
      last_displacement_(model.unknowns(), 0.),
      zero_(model.unknowns(), 0.)
{
}

void FemFrameMaker::archive(Archive& k)
{
  if (model_.settings.large_deformation) return;  // the state has what they count from
  k.fixed("last_displacement", last_displacement_);
  if (!displacements_since(model_.model.stages).empty()) k.fixed("zero_of_nodes", zero_);
}

Frame<2> FemFrameMaker::make(const fem::FemState& state)
{
  const std::vector<DrawnField> drawn = drawn_fields(model_.model);
  const std::vector<OwnField> own = own_fields_of(model_.model);
  const auto& bodies = model_.model.bodies;
  const bool with_ratio = model_.model.gravity.norm() > 0 && std::any_of(bodies.begin(), bodies.end(), [](const auto& body) {
                            return has_pore_pressure(body.soil.materials.front());
                          });
  Frame<2> frame = empty_frame(model_.mesh, drawn, own, with_ratio, model_.flow.count > 0, displacements_since(model_.model.stages));
  frame.time = state.state.time;
  set_motion(model_, state, last_displacement_, zero_, draw_out(model_, state, last_displacement_, zero_, drawn, frame), frame);
  last_displacement_ = state.displacement;
  set_own(model_, state, own, frame);
  set_pore_pressure_ratio(model_, frame);
  if (model_.flow.count > 0) set_water_flux(model_, state, frame);
  frame.rigid_bodies = frame_rigids(model_.model, state.state.rigid_bodies);
  return frame;
}

}  // namespace berm::run_folder
