// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "material/linear_elastic.hpp"
#include "mpm/body_sums.hpp"
#include "mpm/moments.hpp"
#include "mpm/step.hpp"
#include "problem/stages.hpp"

namespace berm {

/// A case, built and stepped without files.
template <int dim>
struct Simulation {
  explicit Simulation(const settings::Case& c) : problem(problem::build<dim>(c, ".", ".")), workspace(problem.model, problem.state) {}

  problem::Model<dim>& model() { return problem.model; }
  problem::State<dim>& state() { return problem.state; }

  /// Gives each particle of the first body, at x with v, the velocity velocity(x, v).
  template <class Velocity>
  void set_velocities(const Velocity& velocity)
  {
    bodies::Particles<dim>& particles = state().particles[0];
    particles.visit([&](Index, Index b, int l) {
      const bodies::Particle<dim> p = particles.read(b, l);
      const Vec<dim> v = velocity(p.x, p.v);
      for (int d = 0; d < dim; ++d) particles.block(b).v[d][l] = v[d];
    });
    mpm::sum_moments(model().mesh, particles, workspace.grids[0]);
  }

  /// Steps until `end` (s); calls after_step() after each step.
  template <class After>
  void run_until(Real end, const After& after_step)
  {
    while (state().time < end) {
      step(model(), state(), workspace);
      after_step();
    }
  }
  void run_until(Real end)
  {
    run_until(end, [] {});
  }

  problem::Problem<dim> problem;
  mpm::Workspace<dim> workspace;
};

/// A case with one linear elastic body that fills a box mesh.
inline settings::Case elastic_box(int dim, std::vector<Real> size, std::vector<Real> cells, Real young_modulus, Real poisson_ratio,
                                  Real density)
{
  settings::Case c;
  c.geometry = dim == 2 ? settings::Geometry::plane_strain : settings::Geometry::space;
  mesh::BoxMesh box;
  box.size = size;
  box.cells = cells;
  c.mesh = box;
  material::LinearElastic law;
  law.young_modulus = young_modulus;
  law.poisson_ratio = poisson_ratio;
  law.density = density;
  c.material = {{"solid", law}};
  bodies::BodySettings body;
  body.material = "solid";
  body.regions = {"box"};
  c.body = {{"body", body}};
  settings::StageSettings stage;
  stage.name = "all";
  stage.until.time = infinity;
  c.stage = {stage};
  return c;
}

}  // namespace berm
