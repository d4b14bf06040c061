// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/physics/momentum.cpp
#include "mpm/step.hpp"

#include "mpm/balance.hpp"
#include "mpm/change_cells.hpp"
#include "mpm/contact.hpp"
#include "mpm/flow.hpp"
#include "mpm/loads.hpp"
#include "mpm/move.hpp"
#include "mpm/quadrature.hpp"
#include "mpm/rest.hpp"
#include "mpm/share.hpp"
#include "mpm/time_step.hpp"
#include "mpm/transfer.hpp"
#include "problem/stages.hpp"

namespace berm::mpm {
namespace {

// Numbers in brackets are the paper's equations. Each body has nodal fields of its own, so the loops over bodies come first. Step 1 begins with sums over the
// particles of each cell: these are made where the particles change last, when they are in the cache.
template <int dim>
void update_stress_last(const problem::Model<dim>& model, problem::State<dim>& state, Work<dim>& work)
{
  const Index bodies = static_cast<Index>(model.bodies.size());
  for (Index b = 0; b < bodies; ++b) {
    average_water(model, state.particles[b], b, work.grids[b]);
    share_moments(model.mesh, state.particles[b], work.grids[b]);
    gather_mass_and_momentum(model.mesh, work.grids[b]);  // 1: (1), and velocities before the step
    integrate_full_cells(model, state.particles[b], work.grids[b]);
    smooth_velocities(model.mesh, state.particles[b], work.grids[b]);
    find_viscous_stress(model, state.particles[b], work.grids[b]);
    spread_internal_forces(model, state.particles[b], work.grids[b]);  // 1: (2)
    share_corner_sums(work.grids[b]);
    spread_water_forces(model, state.particles[b], work.grids[b]);
    share_water_forces(work.grids[b]);
    gather_water(model, state.dt, work.grids[b]);
  }
  spread_tractions(model, state, work);  // 1: forces on boundaries of the soil
  find_contacts(model, state, work);     // 4: contact detection
  seal_rigid_bodies(model, work);
  if (!model.closed.empty() && state.step % steps_between_time_steps == 0) note_pressures(model, state, work);
  for (Index b = 0; b < bodies; ++b) solve_momentum_balance(model, state, work, b);  // 1-4: (3), (4), (6), supports
  share_at_contacts(work, &BodyGrid<dim>::acceleration);
  correct_accelerations(model, state, work);  // 4: (8)-(14)

  for (Index b = 0; b < bodies; ++b) {
    spread_new_momentum(model.mesh, state.particles[b], state.dt, work.grids[b]);  // 5-6: (14)-(16) from the moments
    share_corner_sums(work.grids[b]);
    gather_new_velocities(model, work.grids[b]);  // 7-8: (18), supports
    advance_flux(model, state, work, b);
  }
  share_at_contacts(work, &BodyGrid<dim>::mapped_velocity);
  correct_velocities(model, state, work);  // 8: (8)-(13) again
  move_load_points(model, state, work);    // 9: with the soil

  for (Index b = 0; b < bodies; ++b) {
    if (model.mpm.volumetric_projection) sum_volume_changes(model.mesh, state.particles[b], state.dt, work.grids[b]);
    sum_outflows(model, state, work.grids[b], b);
    move_and_strain(model, state, work, b);  // 5, 9-11: (14), (19)-(23)
    change_cells(model, state, work, b);
  }
}

// SchemeRules::stress_first (Bardenhagen and others 2000, 2001): stress comes first, from the corrected velocities before the step.
template <int dim>
void update_stress_first(const problem::Model<dim>& model, problem::State<dim>& state, Work<dim>& work)
{
  const Index bodies = static_cast<Index>(model.bodies.size());
  for (Index b = 0; b < bodies; ++b) {
    share_moments(model.mesh, state.particles[b], work.grids[b]);
    gather_mass_and_momentum(model.mesh, work.grids[b]);
    integrate_full_cells(model, state.particles[b], work.grids[b]);
    find_viscous_stress(model, state.particles[b], work.grids[b]);
    predict_velocities(model, 0, work.grids[b]);  // those before the step, with the supports
  }
  spread_tractions(model, state, work);
  find_contacts(model, state, work);
  share_at_contacts(work, &BodyGrid<dim>::mapped_velocity);
  correct_velocities(model, state, work);

  for (Index b = 0; b < bodies; ++b) {
    if (model.mpm.volumetric_projection) sum_volume_changes(model.mesh, state.particles[b], state.dt, work.grids[b]);
    strain_particles(model, state, work, b);
    share_moments(model.mesh, state.particles[b], work.grids[b]);
    integrate_full_cells(model, state.particles[b], work.grids[b]);
    spread_internal_forces(model, state.particles[b], work.grids[b]);
    share_corner_sums(work.grids[b]);
    solve_momentum_balance(model, state, work, b);
  }
  share_at_contacts(work, &BodyGrid<dim>::acceleration);
  correct_accelerations(model, state, work);

  for (Index b = 0; b < bodies; ++b) predict_velocities(model, state.dt, work.grids[b]);
  move_load_points(model, state, work);
  for (Index b = 0; b < bodies; ++b) {
    move_particles(model, state, work, b);
    change_cells(model, state, work, b);
  }
}

}  // namespace

template <int dim>
void step(const problem::Model<dim>& model, problem::State<dim>& state, Work<dim>& work)
{
  if (state.step % steps_between_time_steps == 0) {
    update_resting_soil(model, state, work);
    state.dt = stable_time_step(model, state, work);
  }
  for (BodyGrid<dim>& grid : work.grids) grid.fixed = model.fixed_in[state.stage.index];
  hold_resting_soil(model, state, work);
  drive_rigids(model, state, state.dt);
  if (model.update_stress_first)
    update_stress_first(model, state, work);
  else
    update_stress_last(model, state, work);
  move_rigids(state);
  state.time += state.dt;
  ++state.step;
}

template void step(const problem::Model<2>&, problem::State<2>&, Work<2>&);
template void step(const problem::Model<3>&, problem::State<3>&, Work<3>&);

}  // namespace berm::mpm
