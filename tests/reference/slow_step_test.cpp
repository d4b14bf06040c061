// SPDX-License-Identifier: BSD-3-Clause
#include "reference/slow_step.hpp"

#include "mpm/step.hpp"
#include "samples/sample_meshes.hpp"
#include "unit/mpm/sample_problem.hpp"

#include <gtest/gtest.h>
#include <omp.h>

namespace berm::reference::this_file {
namespace {

using mesh::Metric;

/// Sand that yields at random stresses and opens where it is pulled.
material::MohrCoulomb weak_sand()
{
  material::MohrCoulomb law = mpm::sample_sand();
  law.cohesion = 1e3;
  return law;
}

/// A body at random, for the fast step and for the slow one: in some inner cells of a mesh, which no particle leaves in a few steps,
/// particles with random places, masses, volumes, velocities and stresses; supports and damping of random nodes.
template <int dim, class Law>
struct DrawnBody {
  std::mt19937 random;
  problem::Problem<dim> fast;
  SlowStep<dim, decltype(prepare(Law()))> slow;

  DrawnBody(unsigned seed, Metric metric, const Law& material, bool with_contact)
      : random(seed),
        fast(mpm::problem_on<dim>(drawn_mesh(metric), material, 0)),
        slow{fast.model.mesh, prepare(material), 0.8 / material.density, 1.2 / material.density, {}, {}, {}, {}, {}}
  {
    problem::Model<dim>& model = fast.model;
    model.mpm.volumetric_projection = false;  // what berm adds to the paper's step
    model.mpm.velocity_filter = model.mpm.bulk_viscosity = 0;
    model.gravity = slow.gravity = random_point<dim>(random, Vec<dim>::Constant(-20), Vec<dim>::Constant(20));
    slow.damping_factor = NodeField<Real>(model.mesh.node_count(), 0);
    for (Real& factor : slow.damping_factor) factor = number(0, 0.5);
    model.bodies[0].damping = slow.damping_factor;
    for (std::uint8_t& held : model.conditions.tables[0].held)
      held = static_cast<std::uint8_t>(number(0, 1) < 0.3 ? number(1, 1 << dim) : 0);
    fill(material, with_contact ? 0 : 1.5);
    model.conditions.tables[0].held[model.mesh.nodes[slow.particles[0].cell][0]] = (1 << dim) - 1;  // some node of the body at least
    if (with_contact) add_contact();
    slow.held = model.conditions.tables[0].held;
    copy_particles(material);
  }

  Real number(Real from, Real to) { return std::uniform_real_distribution<Real>(from, to)(random); }

  mesh::Mesh<dim> drawn_mesh(Metric metric)
  {
    mesh::Mesh<dim> mesh = shaken_box<dim>(static_cast<unsigned>(random()));
    mesh.metric = metric;
    if (metric == Metric::axisymmetric)
      for (Vec<dim>& x : mesh.position) x[0] += 0.3;
    mesh.complete();
    return mesh;
  }
  /// Velocities of up to 10^fastest m/s.
  void fill(const material::Material& material, Real fastest)
  {
    const mesh::Mesh<dim>& mesh = fast.model.mesh;
    const NodeField<char> at_boundary = mpm::boundary_flags(mesh);
    const Real speed = std::pow(10, number(-1, fastest)), stress = std::pow(10, number(2, 4)), filled = number(0.5, 1);
    for (Index cell = 0; cell < mesh.cell_count(); ++cell) {
      const auto& nodes = mesh.nodes[cell];
      if (std::any_of(nodes.begin(), nodes.end(), [&](Index i) { return at_boundary[i] != 0; }) || number(0, 1) > filled) continue;
      for (int n = static_cast<int>(number(1, 7)); n > 0; --n) {
        Particle<dim> p{};
        p.cell = cell;
        p.x = place_in(nodes);
        p.v = random_point<dim>(random, Vec<dim>::Constant(-speed), Vec<dim>::Constant(speed));
        for (int k = 0; k < tensor_size<dim>; ++k) p.stress[k] = number(-stress, k < 3 ? 0 : stress);
        p.mass = number(1, 3);
        p.volume = p.mass / density(material) * number(0.95, 1.05);
        slow.particles.push_back(p);
      }
    }
  }
  /// A rigid half-space just below all particles in some direction, which no support is near.
  void add_contact()
  {
    problem::Model<dim>& model = fast.model;
    Vec<dim> normal = random_point<dim>(random, Vec<dim>::Constant(-1), Vec<dim>::Constant(1)).normalized(), point = slow.particles[0].x;
    for (const Particle<dim>& p : slow.particles)
      if (normal.dot(p.x - point) < 0) point = p.x;
    point -= 0.02 * normal;
    slow.rigid = {point, normal, number(0.1, 1)};
    for (Particle<dim>& p : slow.particles) p.v -= normal;
    model.rigid_bodies.push_back({.name = "rigid", .shape = bodies::HalfPlane<dim>{point, normal}});
    model.depth_slices.resize(1);
    model.contacts.push_back(
        {"contact", 0, 0, none, slow.rigid->friction, 0, contact::Scheme::musl_double, contact::Detection::overlap, 20});
    fast.state.rigid_bodies.resize(1);
    fast.state.ledger.contact_sums.resize(1);
    fast.state.ledger.pair_impulses.assign(1, Vec<dim>::Zero());
    fast.state.listed_poses.assign(1, bodies::Pose<dim>::nowhere());
    for (const auto& nodes : model.mesh.nodes)
      if (std::any_of(nodes.begin(), nodes.end(), [&](Index i) { return normal.dot(model.mesh.position[i] - point) < 0; }))
        for (const Index i : nodes) model.conditions.tables[0].held[i] = 0;
  }
  /// The fast step's particles.
  void copy_particles(const material::Material& material)
  {
    bodies::Particles<dim> particles(fast.model.mesh, static_cast<Index>(slow.particles.size()), state_fields(material));
    for (std::size_t n = 0; n < slow.particles.size(); ++n) {
      const Particle<dim>& p = slow.particles[n];
      particles.insert(p.cell, {.x = p.x, .v = p.v, .stress = p.stress, .volume = p.volume, .mass = p.mass, .id = static_cast<Index>(n)});
    }
    particles.sort_occupied();
    fast.state.particles[0] = std::move(particles);
  }
  Vec<dim> place_in(const std::array<Index, dim + 1>& nodes)
  {
    Real weight[dim + 1], sum = 0;
    for (Real& w : weight) sum += w = number(0.1, 1);
    Vec<dim> x = Vec<dim>::Zero();
    for (int k = 0; k <= dim; ++k) x += weight[k] / sum * fast.model.mesh.position[nodes[k]];
    return x;
  }
};

/// The largest differences between the steps, each over the largest magnitude of what is compared: of position, velocity and stress.
struct Difference {
  Real x = 0, v = 0, stress = 0, least_share = infinity;
  int changed_cells = 0;

  Real largest() const { return std::max({x, v, stress}); }
};

/// What some steps of both make of a body.
template <int dim, class Law>
Difference difference_of(unsigned seed, Metric metric, const Law& law, bool with_contact, Term without)
{
  DrawnBody<dim, Law> body(seed, metric, law, with_contact);
  mpm::Workspace<dim> workspace(body.fast.model, body.fast.state);
  const auto before = body.slow.particles;
  for (int n = static_cast<int>(body.number(3, 9)); n > 0; --n) {
    mpm::step(body.fast.model, body.fast.state, workspace);
    body.slow.step(body.fast.state.dt, without);
  }
  Difference difference{.least_share = body.slow.least_share};
  Real v = 0, stress = 0;
  const bodies::Particles<dim>& fast = body.fast.state.particles[0];
  fast.visit([&](Index cell, Index b, int l) {
    const bodies::Particle<dim> p = fast.read(b, l);
    const Particle<dim>& q = body.slow.particles[p.id];
    difference.x = std::max(difference.x, (p.x - q.x).norm());
    difference.v = std::max(difference.v, (p.v - q.v).norm());
    for (int k = 0; k < tensor_size<dim>; ++k) difference.stress = std::max(difference.stress, std::abs(p.stress[k] - q.stress[k]));
    for (int k = 0; k < tensor_size<dim>; ++k) stress = std::max(stress, std::abs(p.stress[k]));
    v = std::max(v, p.v.norm());
    difference.changed_cells += cell != before[p.id].cell;
  });
  if (body.slow.rigid) {
    EXPECT_GT(workspace.contact_points[0].nearest_particle, 0) << "particles inside would be moved out, which the paper does not do";
  }
  difference.v /= v, difference.stress /= stress;
  return difference;
}

/// Rounding makes errors of some 1e-16 in a shape function and in a sum. Those of the velocity of a node and of the strains around it are as
/// large divided by the part that the node has of the mass of its particles; those of sums of hundreds of particles over eight steps are some
/// ten times larger. The bound is 1e-12 where that part is a thousandth at least.
Real tolerance(const Difference& found)
{
  return 1e-12 * std::max(Real(1), 1e-3 / found.least_share);
}

template <int dim, class Law>
void compare(Metric metric, const Law& law, bool with_contact = false)
{
  constexpr int bodies = 200, bodies_without_terms = 20;
  const int threads = omp_get_max_threads();
  omp_set_num_threads(1);  // bodies are small: threads would wait for each other all the time
  int changed_cells = 0;
  for (unsigned seed = 0; seed < bodies; ++seed) {
    const Difference found = difference_of<dim>(seed, metric, law, with_contact, Term::none);
    EXPECT_LT(found.largest(), tolerance(found))
        << seed << ": " << found.x << " " << found.v << " " << found.stress << " share " << found.least_share;
    changed_cells += found.changed_cells;
  }
  EXPECT_GT(changed_cells, with_contact ? -1 : 10);  // soil that must not enter the rigid body is slower
  std::vector<Term> terms{Term::internal_force, Term::gravity,  Term::damping, Term::supports,
                          Term::remapping,      Term::rotation, Term::volume,  Term::law};
  if (metric == Metric::axisymmetric) terms.insert(terms.end(), {Term::hoop_stress, Term::hoop_strain});
  if (with_contact) terms.insert(terms.end(), {Term::first_contact, Term::second_contact, Term::friction});
  for (const Term term : terms)
    for (unsigned seed = 0; seed < bodies_without_terms; ++seed) {
      const Difference found = difference_of<dim>(seed, metric, law, with_contact, term);
      EXPECT_GT(found.largest(), 1e4 * tolerance(found)) << "without term " << static_cast<int>(term) << ", body " << seed;
    }
  omp_set_num_threads(threads);
}

TEST(SlowStep, is_the_fast_one_in_the_plane)
{
  compare<2>(Metric::cartesian, mpm::sample_solid());
  compare<2>(Metric::cartesian, weak_sand());
}

TEST(SlowStep, is_the_fast_one_around_an_axis)
{
  compare<2>(Metric::axisymmetric, mpm::sample_solid());
  compare<2>(Metric::axisymmetric, weak_sand());
}

TEST(SlowStep, is_the_fast_one_in_space)
{
  compare<3>(Metric::cartesian, mpm::sample_solid());
  compare<3>(Metric::cartesian, weak_sand());
}

TEST(SlowStep, is_the_fast_one_at_a_rigid_body)
{
  compare<2>(Metric::cartesian, weak_sand(), true);
  compare<2>(Metric::axisymmetric, weak_sand(), true);
  compare<3>(Metric::cartesian, weak_sand(), true);
}

}  // namespace
}  // namespace berm::reference::this_file
