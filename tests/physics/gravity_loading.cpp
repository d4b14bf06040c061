// SPDX-License-Identifier: BSD-3-Clause
// initial_state = "gravity_loading": soil under its own weight that is in equilibrium from the first step, whatever its surface and its layers.
#include "os/error.hpp"
#include "simulate.hpp"

#include <gtest/gtest.h>

namespace berm::this_file {
namespace {

constexpr Real gravity = 10, density_of_all = 1000;

/// A bed of 4 m x 2 m in a box of 4 m x 3 m, on rollers and a fixed base, whose surface is y = 2 m + slope (x - 2 m).
template <int dim>
settings::Case bed(Real k0)
{
  std::vector<Real> size(dim, 3), cells(dim, dim == 2 ? 12 : 6);
  size[0] = 4;
  cells[0] = dim == 2 ? 16 : 8;
  settings::Case c = elastic_box(dim, size, cells, 1e6, 0.3, density_of_all);
  c.gravity.assign(dim, 0);
  c.gravity[1] = -gravity;
  c.surface = 2;
  c.body[0].second.regions = {"soil"};
  c.body[0].second.k0 = k0;
  c.support = {{"left", {"left", {"x"}}}, {"right", {"right", {"x"}}}, {"base", {"bottom", {"x", "y"}}}};
  if (dim == 3) c.support.insert(c.support.end(), {{"back", {"back", {"z"}}}, {"front", {"front", {"z"}}}});
  c.initial_state = settings::InitialState::gravity_loading;
  return c;
}
template <int dim>
mesh::Mesh<dim> mesh_of_bed(const settings::Case& c, Real slope)
{
  mesh::Mesh<dim> mesh = make_box<dim>(std::get<mesh::BoxMesh>(c.mesh));
  for (Vec<dim>& x : mesh.position) x[1] += slope * (x[0] - 2) * (x[1] < 2 ? x[1] / 2 : 3 - x[1]);
  mesh.region_names = {"soil", "space"};
  const mesh::Mesh<dim> straight = make_box<dim>(std::get<mesh::BoxMesh>(c.mesh));
  for (Index cell = 0; cell < mesh.cell_count(); ++cell) mesh.region[cell] = straight.centroid(cell)[1] < 2 ? 0 : 1;
  return mesh;
}

/// Sum of the unbalanced nodal forces over the weight, in the first step.
template <int dim>
Real out_of_balance(problem::Problem<dim>& problem)
{
  mpm::Workspace<dim> workspace(problem.model, problem.state);
  step(problem.model, problem.state, workspace);
  return workspace.unbalanced / workspace.weight;
}

template <int dim>
void expect_level_ground(Real k0)
{
  SCOPED_TRACE(testing::Message() << dim << "D, k0 " << k0);
  const settings::Case c = bed<dim>(k0);
  problem::Problem<dim> problem = problem::build<dim>(c, mesh_of_bed<dim>(c, 0));
  const bodies::Particles<dim>& particles = problem.state.particles[0];
  // Stress is one a cell, and the volumetric projection averages it over patches, of which some join two rows: the error is a part of what the stress changes
  // by from row to row, and falls with the size of the cells.
  Real horizontal_error = 0;
  constexpr Real thickness = dim == 2 ? 0.25 : 0.5;
  std::vector<Real> volume(20, 0.), vertical(20, 0.);
  particles.visit([&](Index, Index b, int l) {
    const bodies::Block<dim>& p = particles.block(b);
    const auto row = static_cast<std::size_t>(p.x[1][l] / thickness);
    volume[row] += p.volume[l];
    vertical[row] += p.volume[l] * p.stress[1][l];
    for (const int k : {0, 2}) horizontal_error = std::max(horizontal_error, std::abs(p.stress[k][l] - k0 * p.stress[1][l]));
  });
  const Real of_row = gravity * density_of_all * thickness;
  for (std::size_t row = 0; static_cast<Real>(row) * thickness < 2; ++row)
    EXPECT_NEAR(vertical[row] / volume[row], -gravity * density_of_all * (2 - (static_cast<Real>(row) + 0.5) * thickness), 0.1 * of_row)
        << "row " << row;
  EXPECT_LT(horizontal_error, 0.5 * of_row);
  EXPECT_LT(out_of_balance(problem), 1e-8);
}

TEST(GravityLoading, is_the_k0_state_below_level_ground)
{
  for (const Real k0 : {0., 0.5, 0.8, 1., 1.5}) {
    expect_level_ground<2>(k0);
    expect_level_ground<3>(k0);
  }
}

TEST(GravityLoading, leaves_a_slope_in_balance)
{
  settings::Case c = bed<2>(0.5);
  problem::Problem<2> problem = problem::build<2>(c, mesh_of_bed<2>(c, 0.2));
  EXPECT_LT(out_of_balance(problem), 1e-8);
  // Under the high side more soil presses on the base than under the low one, by the weight of the columns.
  Real high = 0, low = 0;
  const bodies::Particles<2>& particles = problem.state.particles[0];
  particles.visit([&](Index, Index b, int l) {
    const bodies::Block<2>& p = particles.block(b);
    if (p.x[1][l] < 0.2 && p.x[0][l] < 0.25) low = p.stress[1][l];
    if (p.x[1][l] < 0.2 && p.x[0][l] > 3.75) high = p.stress[1][l];
  });
  EXPECT_GT(high / low, 1.2);
}

TEST(GravityLoading, carries_layers_that_a_contact_joins)
{
  settings::Case c = bed<2>(0.5);
  material::LinearElastic heavy = c.material[0].second.get<material::LinearElastic>();
  heavy.density = 2500;
  c.material.push_back({"heavy", heavy});
  c.body.push_back({"upper", c.body[0].second});
  c.body[1].second.material = "heavy";
  c.body[1].second.regions = {"upper"};
  contact::ContactSettings bond;
  bond.body = "upper";
  bond.other_body = "body";
  bond.scheme = contact::Scheme::tied;
  c.contact = {{"bond", bond}};
  mesh::Mesh<2> mesh = mesh_of_bed<2>(c, 0);
  mesh.region_names.push_back("upper");
  for (Index cell = 0; cell < mesh.cell_count(); ++cell)
    if (const Real y = mesh.centroid(cell)[1]; y > 1.5 && y < 2) mesh.region[cell] = 2;
  const auto vertical_at_base = [&](const problem::Problem<2>& problem) {
    Real sum = 0, volume = 0;
    problem.state.particles[0].visit([&](Index, Index b, int l) {
      const bodies::Block<2>& p = problem.state.particles[0].block(b);
      if (p.x[1][l] < 0.25) sum += p.volume[l] * p.stress[1][l], volume += p.volume[l];
    });
    return sum / volume;
  };
  EXPECT_NEAR(vertical_at_base(problem::build<2>(c, mesh)), -gravity * (2500 * 0.5 + 1000 * 1.375), 1e-3);

  const auto message_of = [&] {
    try {
      problem::build<2>(c, mesh);
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  c.initial_state = settings::InitialState::level_ground;
  EXPECT_EQ(message_of().find("body.body.k0: the ground is not level"), 0u) << message_of();
  EXPECT_NE(message_of().find("initial_state = \"gravity_loading\""), std::string::npos);
  c.initial_state = settings::InitialState::gravity_loading;
  c.contact.clear();
  EXPECT_EQ(message_of().find("initial_state: body.upper does not reach equilibrium"), 0u) << message_of();
}

TEST(LevelGround, is_asked_of_k0)
{
  settings::Case c = bed<2>(0.5);
  c.initial_state = settings::InitialState::level_ground;
  EXPECT_NO_THROW(problem::build<2>(c, mesh_of_bed<2>(c, 0)));
  EXPECT_THROW(problem::build<2>(c, mesh_of_bed<2>(c, 0.1)), InputError);
  c.surface = 2.5;
  EXPECT_THROW(problem::build<2>(c, mesh_of_bed<2>(c, 0)), InputError);
  c.body[0].second.k0.reset();
  EXPECT_NO_THROW(problem::build<2>(c, mesh_of_bed<2>(c, 0.1)));
  settings::Case space = bed<3>(0.5);
  space.initial_state = settings::InitialState::level_ground;
  EXPECT_NO_THROW(problem::build<3>(space, mesh_of_bed<3>(space, 0)));
  EXPECT_THROW(problem::build<3>(space, mesh_of_bed<3>(space, 0.1)), InputError);
}

}  // namespace
}  // namespace berm::this_file
