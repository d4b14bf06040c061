// SPDX-License-Identifier: BSD-3-Clause
#include "mpm/change_cells.hpp"
#include "mpm/move.hpp"

#include "mpm/internal_forces.hpp"
#include "mpm/moments.hpp"
#include "os/error.hpp"
#include "sample_problem.hpp"

#include <Eigen/Geometry>
#include <cstring>
#include <gtest/gtest.h>

namespace berm::mpm::this_file {
namespace {

/// A body whose nodes move as the test says.
template <int dim>
struct Moved {
  problem::Problem<dim> problem;
  Workspace<dim> workspace;
  std::vector<std::array<CornerSums<dim>, dim + 1>> forces;  ///< internal forces of the cells on their corners before the move

  Moved(problem::Problem<dim> given, bool project) : problem(std::move(given)), workspace(problem.model, problem.state)
  {
    problem.model.mpm.volumetric_projection = project;
  }
  Moved(const mesh::Mesh<dim>& mesh, const material::Material& material, int particles_per_cell, bool project)
      : Moved(problem_on<dim>(mesh, material, particles_per_cell), project)
  {
  }
  bodies::Particles<dim>& particles() { return problem.state.particles[0]; }
  const mesh::Mesh<dim>& mesh() const { return problem.model.mesh; }
  BodyGrid<dim>& grid() { return workspace.grids[0]; }

  /// Moves all nodes with velocity(x) for a time dt.
  template <class Velocity>
  void move(Real dt, Velocity&& velocity_at)
  {
    problem.state.dt = dt;
    sum_moments(mesh(), particles(), grid());
    gather_mass_and_momentum(mesh(), grid());
    spread_internal_forces(problem.model, particles(), 0, grid());
    forces.clear();
    for (Index cell = 0; cell < mesh().cell_count(); ++cell) forces.push_back(grid().corners[cell]);
    for (Index i = 0; i < mesh().node_count(); ++i) grid().mapped_velocity[i] = velocity_at(mesh().position[i]);
    if (problem.model.mpm.volumetric_projection) sum_volume_changes(mesh(), particles(), dt, grid());
    move_and_strain(problem.model, problem.state, workspace, 0);
  }
  void change_cells() { mpm::change_cells(problem.model, problem.state, workspace, 0); }
};

template <int dim>
Matrix<3> full(const Matrix<dim>& m)
{
  Matrix<3> result = Matrix<3>::Zero();
  result.template topLeftCorner<dim, dim>() = m;
  return result;
}

/// Every particle has the position, volume, stress and strain that a uniform velocity gradient gives it in one step.
template <int dim>
void expect_uniform_strain(const mesh::Mesh<dim>& mesh)
{
  std::mt19937 random(5);
  for (const bool project : {false, true})
    for (const int n : {1, 3}) {
      const material::LinearElastic law = sample_solid();
      Moved<dim> body(mesh, law, dim == 2 ? n * n : n * n * n, project);
      const Matrix<dim> gradient = random_matrix<dim>(random);
      constexpr Real dt = 1e-3;
      std::vector<bodies::Particle<dim>> before(body.particles().size());
      body.particles().visit([&](Index, Index b, int l) { before[body.particles().block(b).id[l]] = body.particles().read(b, l); });
      const Vec<dim> drift = Vec<dim>::Constant(0.1);
      body.move(dt, [&](const Vec<dim>& x) { return Vec<dim>(drift + gradient * x); });

      const Matrix<3> strain = dt / 2 * (full<dim>(gradient) + full<dim>(gradient).transpose());
      const material::Elasticity elastic = elasticity(law);
      const Matrix<3> stress = elastic.lame * strain.trace() * Matrix<3>::Identity() + 2 * elastic.shear * strain;
      const Matrix<3> deviator = strain - strain.trace() / 3 * Matrix<3>::Identity();
      body.particles().visit([&](Index, Index b, int l) {
        const bodies::Particle<dim> p = body.particles().read(b, l);
        const bodies::Particle<dim>& was = before[p.id];
        EXPECT_NEAR((p.x - was.x - dt * (drift + gradient * was.x)).norm(), 0, 1e-15);
        EXPECT_NEAR(p.volume / was.volume, 1 + strain.trace(), 1e-14);
        for (int a = 0; a < dim; ++a)
          for (int c = 0; c < dim; ++c) EXPECT_NEAR(p.stress[tensor_index(a, c)], stress(a, c), 1e-12 * stress.norm());
        EXPECT_NEAR(p.stress[2], stress(2, 2), 1e-12 * stress.norm());
        EXPECT_NEAR(p.deviatoric_strain, std::sqrt(2. / 3) * deviator.norm(), 1e-12 * dt);
        EXPECT_EQ(p.v, was.v);
      });
    }
}

TEST(PatchTest, a_uniform_velocity_gradient_strains_all_particles_alike_in_irregular_triangles)
{
  expect_uniform_strain(shaken_box<2>());
}
TEST(PatchTest, a_uniform_velocity_gradient_strains_all_particles_alike_in_a_criss_cross_mesh)
{
  expect_uniform_strain(criss_cross<2>());
}
TEST(PatchTest, a_uniform_velocity_gradient_strains_all_particles_alike_in_irregular_tetrahedra)
{
  expect_uniform_strain(shaken_box<3>());
}

template <class Dimension>
class Move : public testing::Test {
};
using Dimensions = testing::Types<std::integral_constant<int, 2>, std::integral_constant<int, 3>>;
TYPED_TEST_SUITE(Move, Dimensions);

TYPED_TEST(Move, projection_gives_the_cells_of_a_patch_one_dilation_and_keeps_the_volume_of_the_patch)
{
  constexpr int dim = TypeParam::value;
  std::mt19937 random(5);
  Moved<dim> projected(shaken_box<dim>(), sample_solid(), 0, true);
  CellField<Real> before(projected.mesh().cell_count(), 0), after(projected.mesh().cell_count(), 0);
  const auto sum_volumes = [&](CellField<Real>& of_cell) {
    std::fill(of_cell.begin(), of_cell.end(), 0);
    projected.particles().visit([&](Index cell, Index b, int l) { of_cell[cell] += projected.particles().block(b).volume[l]; });
  };
  NodeField<Vec<dim>> velocities;
  for (Index i = 0; i < projected.mesh().node_count(); ++i)
    velocities.push_back(random_point<dim>(random, Vec<dim>::Constant(-1), Vec<dim>::Constant(1)));
  auto velocity_at = [&, i = 0](const Vec<dim>&) mutable { return velocities[i++]; };
  constexpr Real dt = 1e-3;
  sum_volumes(before);
  projected.move(dt, velocity_at);
  sum_volumes(after);
  for (Index cell = 0; cell < before.size(); ++cell) {
    Real patch_before = 0, patch_after = 0, plain_after = 0;
    mesh::for_each_in_patch(projected.problem.model.patches, cell, [&](Index member) {
      patch_before += before[member];
      patch_after += after[member];
      Real divergence = 0;
      for (int k = 0; k <= dim; ++k)
        divergence += projected.mesh().shape(member).gradient(k).dot(velocities[projected.mesh().nodes[member][k]]);
      plain_after += before[member] * (1 + dt * divergence);
    });
    EXPECT_NEAR(patch_after / plain_after, 1, 1e-13);
    EXPECT_NEAR(after[cell] / before[cell], patch_after / patch_before, 1e-13);
  }
}

TYPED_TEST(Move, work_of_the_stress_is_that_of_the_internal_forces_with_and_without_projection)
{
  // Strain and force are projected by the same operator: sum V sigma : strain = -dt sum f . v for any stress and any velocity.
  constexpr int dim = TypeParam::value;
  for (const bool project : {false, true}) {
    std::mt19937 random(6);
    std::uniform_real_distribution<Real> number(-1, 1);
    Moved<dim> body(shaken_box<dim>(), sample_solid(), 0, project);
    for_each_particle(body.particles(), [&](bodies::Block<dim>& p, int l) {
      for (int k = 0; k < tensor_size<dim>; ++k) p.stress[k][l] = 1e3 * number(random);
      const Real larger = 2 + number(random);
      p.volume[l] *= larger, p.mass[l] *= larger;  // at bounds of its volume a particle would not keep it
    });
    // So short that the stress hardly changes: the work is counted with the mean of old and new stress.
    constexpr Real dt = 1e-13;
    body.move(dt, [&](const Vec<dim>&) { return random_point<dim>(random, Vec<dim>::Constant(-1), Vec<dim>::Constant(1)); });
    Real power = 0, size = 0;
    const mesh::Mesh<dim>& mesh = body.mesh();
    for (Index e = 0; e < static_cast<Index>(mesh.entries.size()); ++e) {
      const Index cell = e / (dim + 1), corner = e % (dim + 1);
      const Real term =
          Eigen::Map<const Vec<dim>>(body.forces[cell][corner].sum).dot(body.grid().mapped_velocity[mesh.nodes[cell][corner]]);
      power += term;
      size += std::abs(term);
    }
    EXPECT_GT(std::abs(power), 1e-3 * size);
    EXPECT_NEAR(body.problem.state.ledger.totals.internal, -dt * power, 1e-7 * dt * size) << "projection " << project;
  }
}

TYPED_TEST(Move, particles_keep_their_numbers_and_state_when_they_change_cell)
{
  constexpr int dim = TypeParam::value;
  material::MohrCoulomb law;
  law.density = 1500;
  law.young_modulus = 2e6;
  law.poisson_ratio = 0.3;
  law.friction_angle = 0.6;
  Moved<dim> body(shaken_box<dim>(), law, 0, true);
  body.particles().visit([&](Index, Index b, int l) { body.particles().state(b)[0][l] = 1e-3 * body.particles().block(b).id[l]; });
  std::vector<Real> mass(body.particles().size());
  for_each_particle(body.particles(), [&](bodies::Block<dim>& p, int l) { mass[p.id[l]] = p.mass[l] *= 1 + 1e-3 * p.id[l]; });
  // Nodes inside stir, those at the walls stay: nothing leaves.
  const auto swirl = [&](const Vec<dim>& x) {
    Vec<dim> v = Vec<dim>::Zero();
    Real inside = 1;
    for (int d = 0; d < dim; ++d) inside *= (x[d] - body.mesh().lower[d]) * (body.mesh().upper[d] - x[d]);
    v[0] = -inside * (x[1] - 0.8);
    v[1] = inside * (x[0] - 0.75);
    return v;
  };
  std::vector<Index> first_cell(body.particles().size()), last_cell(body.particles().size());
  body.particles().visit([&](Index cell, Index b, int l) { first_cell[body.particles().block(b).id[l]] = cell; });
  for (int n = 0; n < 50; ++n) {
    body.move(0.1, swirl);
    body.change_cells();
  }
  Index seen = 0, moved_on = 0;
  body.particles().visit([&](Index cell, Index b, int l) {
    const bodies::Block<dim>& p = body.particles().block(b);
    EXPECT_EQ(p.mass[l], mass[p.id[l]]);
    for (int k = 0; k <= dim; ++k) EXPECT_GE(body.mesh().shape(cell).value(k, position(p, l)), -1e-9);
    moved_on += cell != first_cell[p.id[l]];
    mass[p.id[l]] = 0;
    ++seen;
  });
  EXPECT_EQ(seen, body.particles().size());
  EXPECT_GT(moved_on, seen / 4);
  EXPECT_EQ(std::count(mass.begin(), mass.end(), 0), seen);
}

TYPED_TEST(Move, a_particle_that_leaves_the_mesh_ends_the_run_with_its_number_body_place_time_and_advice)
{
  constexpr int dim = TypeParam::value;
  Moved<dim> body(shaken_box<dim>(), sample_solid(), 0, true);
  body.problem.state.time = 0.25;
  body.problem.state.step = 77;
  const auto out_of_the_top = [](const Vec<dim>& x) { return Vec<dim>((x[1] > 1 ? 3 : 0) * Vec<dim>::UnitY()); };
  body.move(0.05, out_of_the_top);
  try {
    body.change_cells();
    FAIL() << "nothing was thrown";
  } catch (const RunError& error) {
    const std::string message = error.what();
    int id = -1;
    ASSERT_EQ(std::sscanf(message.c_str(), "particle %d of body", &id), 1) << message;
    EXPECT_GE(id, 0);
    EXPECT_LT(id, body.particles().size() + 1);
    for (const char* part :
         {"body \"body\"", "left the mesh at (", "t = 0.25 s", "step 77", "make the mesh larger", "[support.NAME]", "mpm.courant"})
      EXPECT_NE(message.find(part), std::string::npos) << part << " is not in: " << message;
  }
}

TYPED_TEST(Move, a_particle_that_slides_out_of_a_boundary_that_absorbs_is_not_told_to_have_none)
{
  constexpr int dim = TypeParam::value;
  Moved<dim> body(shaken_box<dim>(), sample_solid(), 0, true);
  boundary::Dashpots<dim> everywhere;
  everywhere.of_node.assign(body.mesh().node_count(), 0);
  body.problem.model.conditions.dashpots.push_back(everywhere);
  body.move(0.05, [](const Vec<dim>& x) { return Vec<dim>((x[1] > 1 ? 3 : 0) * Vec<dim>::UnitY()); });
  try {
    body.change_cells();
    FAIL() << "nothing was thrown";
  } catch (const RunError& error) {
    const std::string message = error.what();
    EXPECT_NE(message.find("the boundary there absorbs waves"), std::string::npos) << message;
    EXPECT_EQ(message.find("hold that boundary with a [support.NAME]"), std::string::npos) << message;
  }
}

TYPED_TEST(Move, a_cell_that_gets_its_first_particle_gets_its_shape)
{
  constexpr int dim = TypeParam::value;
  problem::Problem<dim> problem = problem_on<dim>(shaken_box<dim>(), sample_solid(), 0);
  const mesh::Mesh<dim>& mesh = problem.model.mesh;
  bodies::Particles<dim>& particles = problem.state.particles[0];
  const Index empty = 0, next = std::max(mesh.neighbor(empty, 0), mesh.neighbor(empty, 1));
  while (particles.count_in(empty) > 0) particles.take(empty, 0);
  particles.sort_occupied();
  Workspace<dim> workspace(problem.model, problem.state);
  workspace.cell_changes[0].push_back({next, 0, empty});
  mpm::change_cells(problem.model, problem.state, workspace, 0);
  ASSERT_EQ(particles.count_in(empty), 1);
  for (const Index cell : particles.occupied()) EXPECT_EQ(workspace.grids[0].gradients[cell], mesh.shape(cell).gradients) << cell;
}

TYPED_TEST(Move, leaves_the_sums_of_the_particles_as_they_are_then_also_where_particles_changed_cell)
{
  constexpr int dim = TypeParam::value;
  for (const Real part : {0.3, 0.6}) {  // of the way to the middle of the mesh, where there is a hole
    problem::Problem<dim> with_hole = problem_on<dim>(shaken_box<dim>(), sample_solid(), 0);
    const mesh::Mesh<dim>& mesh = with_hole.model.mesh;
    const Vec<dim> center = (mesh.lower + mesh.upper) / 2;
    bodies::Particles<dim>& particles = with_hole.state.particles[0];
    const Index hole = locate(mesh, center, 0).cell;
    while (particles.count_in(hole) > 0) particles.take(hole, 0);
    particles.sort_occupied();
    Moved<dim> body(std::move(with_hole), true);
    const auto counts = [&] {
      std::vector<Index> in_cells;
      for (Index cell = 0; cell < body.mesh().cell_count(); ++cell) in_cells.push_back(body.particles().count_in(cell));
      return in_cells;
    };
    const std::vector<Index> before = counts();
    body.move(1, [&](const Vec<dim>& x) { return Vec<dim>(part * (center - x)); });
    body.change_cells();
    const std::vector<Index> after = counts();
    int emptied = 0;
    for (std::size_t cell = 0; cell < before.size(); ++cell) emptied += before[cell] > 0 && after[cell] == 0;
    EXPECT_GT(emptied, 0);
    EXPECT_GT(after[hole], 0);
    const Workspace<dim> fresh(body.problem.model, body.problem.state);
    for (Index cell = 0; cell < body.mesh().cell_count(); ++cell) {
      const BodyGrid<dim>& anew = fresh.grids[0];
      EXPECT_TRUE(after[cell] > 0 || body.grid().volume_change[cell].change == 0) << cell;
      EXPECT_EQ(std::memcmp(&body.grid().moments[cell], &anew.moments[cell], sizeof(Moments<dim>)), 0) << cell;
      EXPECT_EQ(std::memcmp(&body.grid().corners[cell], &anew.corners[cell], sizeof(anew.corners[cell])), 0) << cell;
    }
  }
}

TYPED_TEST(Move, a_particle_that_round_off_put_beyond_a_wall_is_brought_back_to_it)
{
  constexpr int dim = TypeParam::value;
  const auto mesh = make_box<dim>(sample_box<dim>());
  Moved<dim> body(mesh, sample_solid(), 0, true);
  // The highest particle is put onto the top wall, and the nodes rise by a billionth of a cell.
  bodies::Particles<dim>& particles = body.particles();
  Index block = none;
  int lane = 0;
  particles.visit([&](Index, Index b, int l) {
    if (block == none || particles.block(b).x[1][l] > particles.block(block).x[1][lane]) block = b, lane = l;
  });
  particles.block(block).x[1][lane] = mesh.upper[1];
  const Real height = mesh.height(0);
  body.move(1, [&](const Vec<dim>&) { return Vec<dim>(1e-9 * height * Vec<dim>::UnitY()); });
  EXPECT_NO_THROW(body.change_cells());
  Real highest = -infinity;
  for_each_particle(particles, [&](bodies::Block<dim>& p, int l) { highest = std::max(highest, p.x[1][l]); });
  EXPECT_NEAR(highest, mesh.upper[1], 1e-15);
}

TYPED_TEST(Move, a_particle_beyond_a_wall_by_the_least_there_is_does_not_end_the_run)
{
  constexpr int dim = TypeParam::value;
  const std::vector<Real> lower(dim, 0), size(dim, 1), cells(dim, 3);
  Moved<dim> body(mesh::make_box<dim>({.lower = lower, .size = size, .cells = cells}), sample_solid(), 0, true);
  bodies::Particles<dim>& particles = body.particles();
  for (const Real beyond : {1e-18, 1e-12}) {
    Index block = none;
    int lane = 0;
    particles.visit([&](Index, Index b, int l) {
      if (block == none || particles.block(b).x[1][l] < particles.block(block).x[1][lane]) block = b, lane = l;
    });
    particles.block(block).x[1][lane] = -beyond;
    body.move(1e-3, [](const Vec<dim>&) { return Vec<dim>(Vec<dim>::Zero()); });
    EXPECT_NO_THROW(body.change_cells());
    for_each_particle(particles, [&](bodies::Block<dim>& p, int l) {
      for (int d = 0; d < dim; ++d) EXPECT_GE(p.x[d][l], -1e-13);  // of a cell of 1/3 m: less than that is inside to locate()
    });
  }
}

TYPED_TEST(Move, a_rigid_turn_makes_no_stress)
{
  // A whole turn in 500 steps; nodes take the velocity of the turn, so nothing but the step itself could make stress.
  constexpr int dim = TypeParam::value;
  std::vector<Real> lower(dim, -1.2), size(dim, 2.4), cells(dim, 8), middle(dim, 0), side(dim, 1);
  auto problem = problem_on<dim>(mesh::make_box<dim>({.lower = lower, .size = size, .cells = cells}), sample_solid(), 1);
  bodies::BodySettings settings;
  settings.block = bodies::BlockSettings{middle, side, 0, 0.1};
  problem.state.particles[0] = fill<dim>(problem.model.mesh, "body", settings, {1500, 0, 0});
  Moved<dim> body(std::move(problem), true);
  const int steps = 500;
  const Real angle = 2 * pi / steps;
  for (int n = 0; n < steps; ++n) {
    body.move(1, [&](const Vec<dim>& x) {
      Vec<dim> v = Vec<dim>::Zero();
      v[0] = -angle * x[1], v[1] = angle * x[0];
      return v;
    });
    body.change_cells();
  }
  // Round-off of the strain, some 1e-16 a step, times the stiffness.
  for_each_particle(body.particles(), [&](bodies::Block<dim>& p, int l) {
    for (int k = 0; k < tensor_size<dim>; ++k) EXPECT_NEAR(p.stress[k][l], 0, 2e6 * 1e-16 * steps);
    EXPECT_NEAR(p.deviatoric_strain[l], 0, 1e-16 * 10 * steps);
  });
}

TYPED_TEST(Move, stress_turns_with_the_body_and_keeps_its_invariants)
{
  // First order in the angle of a step: after a turn by theta in n steps the deviator has grown by (1 + (2 theta / n)^2)^(n/2) = exp(2 theta^2 / n).
  constexpr int dim = TypeParam::value;
  constexpr Real theta = 0.3 * pi;
  const Vec<3> axis = dim == 2 ? Vec<3>(0, 0, 1) : Vec<3>(Vec<3>(2, -1, 3).normalized());
  for (const int steps : {200, 400}) {
    Moved<dim> body(make_box<dim>(sample_box<dim>()), sample_solid(), 1, false);
    const Real angle = theta / steps;
    const Vec<dim> middle = 0.5 * (body.mesh().lower + body.mesh().upper);
    const Real first[6] = {300, -100, 40, 70, 20, -60};
    for_each_particle(body.particles(), [&](bodies::Block<dim>& p, int l) {
      for (int k = 0; k < tensor_size<dim>; ++k) p.stress[k][l] = first[k];
    });
    for (int n = 0; n < steps; ++n) {
      body.move(1, [&](const Vec<dim>& x) {
        Vec<3> arm = Vec<3>::Zero();
        arm.template head<dim>() = x - middle;
        return Vec<dim>(angle * axis.cross(arm).template head<dim>());
      });
      body.workspace.cell_changes.front().clear();  // where the particles are does not matter here
    }
    Matrix<3> was = Matrix<3>::Zero();
    const Matrix<3> turn = Eigen::AngleAxis<Real>(theta, axis).toRotationMatrix();
    for (int a = 0; a < 3; ++a)
      for (int b = 0; b < 3; ++b) was(a, b) = dim == 2 && a != b && a + b != 1 ? 0 : first[tensor_index(a, b)];
    const Matrix<3> turned = turn * was * turn.transpose();
    const Real error = 1.1 * (std::exp(2 * theta * theta / steps) - 1) * was.norm();
    for_each_particle(body.particles(), [&](bodies::Block<dim>& p, int l) {
      Matrix<3> now = Matrix<3>::Zero();
      for (int a = 0; a < 3; ++a)
        for (int b = 0; b < 3; ++b) now(a, b) = dim == 2 && a != b && a + b != 1 ? 0 : p.stress[tensor_index(a, b)][l];
      EXPECT_NEAR((now - turned).norm(), 0, error);
      EXPECT_NEAR(now.norm(), was.norm(), error);
      EXPECT_NEAR(now.trace(), was.trace(), 2e6 * 1e-16 * steps);  // round-off of the strain, times the stiffness
    });
  }
}

}  // namespace
}  // namespace berm::mpm::this_file
