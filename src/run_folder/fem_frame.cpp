// SPDX-License-Identifier: BSD-3-Clause
#include "run_folder/fem_frame.hpp"

#include <algorithm>

namespace berm::run_folder {
namespace {

/// The weight of point of integration q in the value drawn out to node k: the linear function through the three points.
constexpr Real drawn_out(int k, int q)
{
  if (k < 3) return k == q ? 5. / 3 : -1. / 3;
  return (k - 3 == q || (k - 2) % 3 == q) ? 2. / 3 : -1. / 3;
}

struct NodalSums {
  Real area = 0;
  SymTensor<2> stress;
  Matrix<2> gradient = Matrix<2>::Zero(), gradient_since_last = Matrix<2>::Zero();  ///< of the displacement
  Real accumulated = 0;                                                             ///< deviatoric strain
};

/// du/dx at a point of integration; `displacement` by unknown.
Matrix<2> gradient_at(const fem::ShapeAtPoint& shape, const fem::AtSixNodes<Index>& nodes, const std::vector<Real>& displacement)
{
  Matrix<2> gradient = Matrix<2>::Zero();
  for (int k = 0; k < 6; ++k)
    gradient += Vec<2>(displacement[2 * nodes[k]], displacement[2 * nodes[k] + 1]) * shape.gradient[k].transpose();
  return gradient;
}

}  // namespace

FemFrameMaker::FemFrameMaker(const fem::FemModel& model) : model_(model), last_displacement_(model.unknowns(), 0.) {}

Frame<2> FemFrameMaker::make(const fem::FemState& state)
{
  const fem::QuadraticMesh& mesh = model_.mesh;
  NodeField<NodalSums> sums(mesh.node_count());
  NodeField<Index> body(mesh.node_count(), 0);
  for (Index cell = 0; cell < mesh.cell_count(); ++cell) {
    Real area = 0;
    for (const fem::ShapeAtPoint& shape : model_.shape[cell]) area += shape.area;
    std::array<Matrix<2>, fem::triangle_points> gradient, since_last;
    for (int q = 0; q < fem::triangle_points; ++q) {
      gradient[q] = gradient_at(model_.shape[cell][q], mesh.nodes[cell], state.displacement);
      since_last[q] = gradient[q] - gradient_at(model_.shape[cell][q], mesh.nodes[cell], last_displacement_);
    }
    for (int k = 0; k < 6; ++k) {
      NodalSums& sum = sums[mesh.nodes[cell][k]];
      sum.area += area;
      body[mesh.nodes[cell][k]] = mesh.body[cell];
      for (int q = 0; q < fem::triangle_points; ++q) {
        const fem::SoilPoint& point = state.points[cell][q];
        for (int c = 0; c < 4; ++c) sum.stress[c] += area * drawn_out(k, q) * point.stress[c];
        sum.gradient += area * drawn_out(k, q) * gradient[q];
        sum.gradient_since_last += area * drawn_out(k, q) * since_last[q];
        sum.accumulated += area * drawn_out(k, q) * point.deviatoric_strain;
      }
    }
  }
  Frame<2> frame;
  frame.time = state.state.time;
  for (Index node = 0; node < mesh.node_count(); ++node) {
    const NodalSums& sum = sums[node];
    FrameParticle<2> shown{};
    shown.displacement = Vec<2>(state.displacement[2 * node], state.displacement[2 * node + 1]);
    shown.body = body[node];
    shown.particle.id = node;
    shown.particle.x = mesh.position[node] + shown.displacement;
    shown.particle.v = Vec<2>::Zero();
    shown.particle.volume = sum.area / 6;
    for (int c = 0; c < 4; ++c) shown.particle.stress[c] = sum.stress[c] / sum.area;
    shown.particle.deviatoric_strain = std::max(Real(0), sum.accumulated / sum.area);
    shown.strain = gradient_strain<2>(Matrix<2>::Identity() + sum.gradient / sum.area);
    shown.strain_increment = gradient_strain<2>(Matrix<2>::Identity() + sum.gradient_since_last / sum.area).deviatoric;
    frame.particles.push_back(shown);
  }
  last_displacement_ = state.displacement;
  frame.triangles.assign(mesh.nodes.begin(), mesh.nodes.end());
  frame.rigid_bodies = frame_rigids(model_.model, state.state.rigid_bodies);
  return frame;
}

}  // namespace berm::run_folder
