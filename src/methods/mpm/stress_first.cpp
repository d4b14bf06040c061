// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/physics/contact_schemes.cpp
#include "mpm/stress_first.hpp"

#include "mpm/balance.hpp"
#include "mpm/change_cells.hpp"
#include "mpm/contact.hpp"
#include "mpm/cut_cells.hpp"
#include "mpm/exchange.hpp"
#include "mpm/internal_forces.hpp"
#include "mpm/loads.hpp"
#include "mpm/moments.hpp"
#include "mpm/move.hpp"
#include "mpm/quadrature.hpp"
#include "mpm/velocities.hpp"

namespace berm::mpm {

template <int dim>
void update_stress_first(const problem::Model<dim>& model, problem::State<dim>& state, Workspace<dim>& workspace)
{
  const Index bodies = static_cast<Index>(model.bodies.size());
  for (Index b = 0; b < bodies; ++b) {
    BodyGrid<dim>& grid = workspace.grids[b];
    exchange_moments(model.mesh, state.particles[b], grid);  // ranks
    gather_mass_and_momentum(model.mesh, grid);
    find_cut_cells(model, state, b, grid);  // cells at rigid bodies
    prepare_cells(model, state.particles[b], state.dt, grid);
    find_viscous_stress(model, state.particles[b], grid);
    predict_velocities(model, 0, workspace.motion_before, grid);  // those before the step, with the supports
  }
  spread_tractions(model, state, workspace);
  find_contacts(model, state, workspace);
  exchange_at_contacts(workspace, &BodyGrid<dim>::mapped_velocity);  // ranks
  correct_velocities(model, state, workspace);

  for (Index b = 0; b < bodies; ++b) {
    BodyGrid<dim>& grid = workspace.grids[b];
    if (model.mpm.volumetric_projection) sum_volume_changes(model.mesh, state.particles[b], state.dt, grid);
    strain_particles(model, state, workspace, b);
    exchange_moments(model.mesh, state.particles[b], grid);  // ranks
    prepare_cells(model, state.particles[b], state.dt, grid);
    spread_internal_forces(model, state.particles[b], state.dt, grid);
    exchange_corner_sums(grid);  // ranks
    solve_momentum_balance(model, state, workspace, b);
  }
  exchange_at_contacts(workspace, &BodyGrid<dim>::acceleration);  // ranks
  correct_accelerations(model, state, workspace);

  for (Index b = 0; b < bodies; ++b) predict_velocities(model, state.dt, workspace.motion_after, workspace.grids[b]);
  move_load_points(model, state, workspace);
  for (Index b = 0; b < bodies; ++b) {
    move_particles(model, state, workspace, b);
    change_cells(model, state, workspace, b);
  }
}

template void update_stress_first(const problem::Model<2>&, problem::State<2>&, Workspace<2>&);
template void update_stress_first(const problem::Model<3>&, problem::State<3>&, Workspace<3>&);

}  // namespace berm::mpm
