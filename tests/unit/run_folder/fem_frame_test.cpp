// SPDX-License-Identifier: BSD-3-Clause
#include "run_folder/fem_frame.hpp"

#include "samples/fem_sample_problem.hpp"
#include "samples/frame_particles.hpp"

#include <gtest/gtest.h>

namespace berm::run_folder::this_file {
namespace {

/// A block whose stress (Pa) and strain are linear in the place.
struct Stressed {
  fem::FemProblem problem = fem_problem_of(plate_on_block(elastic_soil()));

  static Real field(int component, const Vec<2>& x) { return 100 * (component + 1) - 30 * x[0] * component + 50 * x[1]; }

  Stressed()
  {
    const fem::QuadraticMesh& mesh = problem.model.mesh;
    for (Index cell = 0; cell < mesh.cell_count(); ++cell)
      for (int q = 0; q < fem::triangle_points; ++q) {
        Vec<2> x = Vec<2>::Zero();
        for (int k = 0; k < 6; ++k) x += problem.model.shape[cell][q].value[k] * mesh.positions_of(cell)[k];
        fem::SoilPoint& point = problem.state.points[cell][q];
        for (int k = 0; k < 4; ++k) point.stress[k] = field(k, x);
        point.deviatoric_strain = field(0, x) / 1000;
      }
  }
};

TEST(FemFrame, draws_linear_fields_out_to_the_nodes_exactly)
{
  Stressed s;
  const Frame<2> frame = FemFrameMaker(s.problem.model).make(s.problem.state);
  const fem::QuadraticMesh& mesh = s.problem.model.mesh;
  ASSERT_EQ(static_cast<Index>(frame.points.size()), mesh.node_count());
  ASSERT_EQ(static_cast<Index>(frame.triangles.size()), mesh.cell_count());
  const auto nodes = particles_of(frame);
  for (Index node = 0; node < mesh.node_count(); ++node) {
    // Numbers of some hundred, sums of a few dozen: 1e-11 is rounding.
    for (int k = 0; k < 4; ++k) EXPECT_NEAR(nodes[node].particle.stress[k], Stressed::field(k, mesh.position[node]), 1e-11);
    EXPECT_NEAR(nodes[node].particle.deviatoric_strain, Stressed::field(0, mesh.position[node]) / 1000, 1e-14);
  }
}

TEST(FemFrame, shows_nodes_where_they_are_with_the_strain_of_their_displacement)
{
  Stressed s;
  FemFrameMaker maker(s.problem.model);
  const auto frame_sheared_by = [&](Real gamma) {
    for (Index node = 0; node < s.problem.model.mesh.node_count(); ++node) {
      s.problem.state.displacement[2 * node] = 0.01 + gamma * s.problem.model.mesh.position[node][1];
      s.problem.state.displacement[2 * node + 1] = -0.02;
    }
    return maker.make(s.problem.state);
  };
  const auto exact = [](Real gamma) { return 2 / std::sqrt(3.) * std::asinh(gamma / 2); };
  frame_sheared_by(0.5);
  const auto nodes = particles_of(frame_sheared_by(0.75));
  for (Index node = 0; node < s.problem.model.mesh.node_count(); ++node) {
    const FrameParticle<2>& shown = nodes[node];
    EXPECT_NEAR(shown.strain.deviatoric, exact(0.75), 1e-13);
    EXPECT_NEAR(shown.strain.volumetric, 0, 1e-13);
    EXPECT_NEAR(shown.strain_increment, exact(0.25), 1e-13);
    const Vec<2> x = s.problem.model.mesh.position[node], u(0.01 + 0.75 * x[1], -0.02);
    EXPECT_EQ(shown.displacement, u);
    EXPECT_EQ(shown.particle.x, Vec<2>(x + u));
  }
}

TEST(FemFrame, nodes_share_the_area_of_the_soil)
{
  Stressed s;
  Real area = 0;
  for (const Real volume : FemFrameMaker(s.problem.model).make(s.problem.state).volume) area += volume;
  EXPECT_NEAR(area, 0.5, 1e-14);
}

// -(k / gamma_w) grad p of a linear pressure: differences of pressures of 1e3 Pa over a tenth of a metre, 1e-12 of the flux.
TEST(FemFrame, shows_the_flux_of_the_water_down_the_slope_of_its_pressure)
{
  material::LinearElastic soil = elastic_soil();
  soil.water.emplace().drainage = material::Drainage::consolidation;
  soil.water->porosity = 0.4;
  soil.water->permeability = 1e-5;
  fem::FemProblem problem = fem_problem_of(plate_on_block(soil));
  const fem::FemModel& model = problem.model;
  for (Index node = 0; node < model.mesh.node_count(); ++node)
    if (const Index unknown = model.flow.unknown[node]; unknown != none)
      problem.state.displacement[unknown] = 300 * model.mesh.position[node][0] - 1000 * model.mesh.position[node][1];
  const Frame<2> frame = FemFrameMaker(model).make(problem.state);
  const FieldValues<Real>& flux = frame.field("water_flux");
  const Real mobility = 1e-5 / material::unit_weight_of_water;
  for (Index node = 0; node < model.mesh.node_count(); ++node) {
    EXPECT_NEAR(flux.at(node, 0), -300 * mobility, 1e-10 * 300 * mobility);
    EXPECT_NEAR(flux.at(node, 1), 1000 * mobility, 1e-10 * 1000 * mobility);
  }
  EXPECT_EQ(find_field(FemFrameMaker(Stressed{}.problem.model).make(Stressed{}.problem.state).fields, "water_flux"), nullptr);
}

}  // namespace
}  // namespace berm::run_folder::this_file
