// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/simulation/run_test.cpp
#include "run_folder/space_frame.hpp"

#include "run_folder/gradient_strain.hpp"

namespace berm::run_folder {
namespace {

Vec<3> of_node(const std::vector<Real>& displacement, Index node)
{
  return {displacement[3 * node], displacement[3 * node + 1], displacement[3 * node + 2]};
}

/// du/dx at a point of integration; `displacement` by unknown.
Matrix<3> gradient_at(const fem::ElementPoint<3>& shape, const fem::AtElementNodes<3, Index>& nodes, const std::vector<Real>& displacement)
{
  Matrix<3> gradient = Matrix<3>::Zero();
  for (int k = 0; k < fem::element_nodes<3>; ++k) gradient += of_node(displacement, nodes[k]) * shape.gradient[k].transpose();
  return gradient;
}

/// Sums over the elements at a node, by their volume.
struct NodalSums {
  Real volume = 0, deviatoric_strain = 0, overstress = 0;
  SymTensor<3> stress{};
  Matrix<3> gradient = Matrix<3>::Zero(), gradient_since_last = Matrix<3>::Zero();  ///< of the displacement
};

}  // namespace

SpaceFrameMaker::SpaceFrameMaker(const fem::SpaceModel& model)
    : model_(model),
      last_displacement_(static_cast<std::size_t>(model.unknowns()), 0.),
      zero_(static_cast<std::size_t>(model.unknowns()), 0.)
{
}

void SpaceFrameMaker::archive(Archive& k)
{
  k.fixed("last_displacement", last_displacement_);
  k.fixed("zero_of_nodes", zero_);
}

Frame<3> SpaceFrameMaker::make(const fem::SpaceState& state)
{
  const fem::SpaceMesh& mesh = model_.mesh;
  std::vector<FieldInfo> infos = common_fields<3>(displacements_since(model_.model.stages));
  infos.push_back({"accumulated_deviatoric_strain", "accumulated deviatoric strain", "", 1, to_frame});
  infos.push_back({"overstress", "overstress: stress beyond the strength", "Pa", 1, to_frame});
  Frame<3> frame;
  frame.allocate(static_cast<std::size_t>(mesh.node_count()), infos);
  frame.time = state.state.time;
  frame.tetrahedra.assign(mesh.nodes.begin(), mesh.nodes.end());
  NodeField<NodalSums> sums(mesh.node_count());
  for (Index cell = 0; cell < mesh.cell_count(); ++cell) {
    NodalSums here;
    for (int q = 0; q < fem::element_points<3>; ++q) {
      const fem::ElementPoint<3>& shape = model_.shape[cell][q];
      const fem::ElementSoil<3>& point = state.points[cell][q];
      const Matrix<3> now = gradient_at(shape, mesh.nodes[cell], state.displacement);
      here.volume += shape.area;
      here.deviatoric_strain += shape.area * point.deviatoric_strain;
      here.overstress += shape.area * point.overstress;
      for (int c = 0; c < tensor_size<3>; ++c) here.stress[c] += shape.area * point.stress[c];
      here.gradient += shape.area * (now - gradient_at(shape, mesh.nodes[cell], zero_));
      here.gradient_since_last += shape.area * (now - gradient_at(shape, mesh.nodes[cell], last_displacement_));
    }
    for (const Index node : mesh.nodes[cell]) {
      NodalSums& sum = sums[node];
      sum.volume += here.volume;
      sum.deviatoric_strain += here.deviatoric_strain;
      sum.overstress += here.overstress;
      for (int c = 0; c < tensor_size<3>; ++c) sum.stress[c] += here.stress[c];
      sum.gradient += here.gradient;
      sum.gradient_since_last += here.gradient_since_last;
      frame.body[node] = mesh.body[cell];
    }
  }
  for (Index node = 0; node < mesh.node_count(); ++node) {
    const NodalSums& sum = sums[node];
    frame.id[node] = node;
    frame.points[node] = mesh.position[node] + of_node(state.displacement, node);
    frame.volume[node] = sum.volume / fem::element_nodes<3>;
    for (int c = 0; c < tensor_size<3>; ++c) frame.field("stress").at(node, c) = sum.stress[c] / sum.volume;
    frame.field("mean_stress").at(node) = trace(sum.stress) / (3 * sum.volume);
    frame.field("accumulated_deviatoric_strain").at(node) = sum.deviatoric_strain / sum.volume;
    frame.field("overstress").at(node) = sum.overstress / sum.volume;
    const Vec<3> moved = of_node(state.displacement, node) - of_node(zero_, node);
    for (int d = 0; d < 3; ++d) frame.field("displacement").at(node, d) = moved[d];
    const GradientStrain strain = gradient_strain<3>(Matrix<3>::Identity() + sum.gradient / sum.volume);
    frame.field("deviatoric_strain").at(node) = strain.deviatoric;
    frame.field("volumetric_strain").at(node) = strain.volumetric;
    frame.field("incremental_deviatoric_strain").at(node) =
        gradient_strain<3>(Matrix<3>::Identity() + sum.gradient_since_last / sum.volume).deviatoric;
  }
  last_displacement_ = state.displacement;
  frame.rigid_bodies = frame_rigids(model_.model, state.state.rigid_bodies);
  return frame;
}

}  // namespace berm::run_folder
