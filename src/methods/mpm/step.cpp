// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/physics/momentum.cpp
#include "mpm/step.hpp"

#include "mpm/balance.hpp"
#include "mpm/change_cells.hpp"
#include "mpm/contact.hpp"
#include "mpm/cut_cells.hpp"
#include "mpm/exchange.hpp"
#include "mpm/flow.hpp"
#include "mpm/inactive.hpp"
#include "mpm/internal_forces.hpp"
#include "mpm/loads.hpp"
#include "mpm/moments.hpp"
#include "mpm/move.hpp"
#include "mpm/quadrature.hpp"
#include "mpm/stress_first.hpp"
#include "mpm/time_step.hpp"
#include "mpm/velocities.hpp"
#include "problem/stages.hpp"

namespace berm::mpm {
namespace {

// Numbers in brackets are the paper's equations. Each body has nodal fields of its own, so the loops over bodies come first. Step 1 begins with sums over the
// particles of each cell: these are made where the particles change last, when they are in the cache. Calls marked "water" do something where water flows
// through the soil, those marked "ranks" where several processes share the mesh; the others are the paper's box.
template <int dim>
void update_stress_last(const problem::Model<dim>& model, problem::State<dim>& state, Workspace<dim>& workspace)
{
  const Index bodies = static_cast<Index>(model.bodies.size());
  for (Index b = 0; b < bodies; ++b) {
    const bodies::Particles<dim>& particles = state.particles[b];
    BodyGrid<dim>& grid = workspace.grids[b];
    average_water(model, particles, b, grid);                  // water
    exchange_moments(model.mesh, particles, grid);             // ranks
    gather_mass_and_momentum(model.mesh, grid);                // 1: (1), and velocities before the step
    find_cut_cells(model, state, b, grid);                     // cells at rigid bodies
    prepare_cells(model, particles, state.dt, grid);           // quadrature of full cells, small-mass nodes
    smooth_velocities(model.mesh, grid);                       // target of the filter
    spread_internal_forces(model, particles, state.dt, grid);  // 1: (2), viscous stress, filter
    exchange_corner_sums(grid);                                // ranks
    spread_water_forces(model, particles, grid);               // water
    exchange_water_forces(grid);                               // water, ranks
    gather_water(model, state.dt, grid);                       // water
    apply_heads(model, state, grid);                           // water
  }
  spread_tractions(model, state, workspace);  // 1: forces on boundaries of the soil

  find_contacts(model, state, workspace);                                                                          // 4: contact detection
  mark_impermeable_surfaces(model, workspace);                                                                     // water
  if (model.water_flows() && state.step % steps_between_time_steps == 0) note_pressures(model, state, workspace);  // water

  for (Index b = 0; b < bodies; ++b) solve_momentum_balance(model, state, workspace, b);  // 1-4: (3), (4), (6), supports
  exchange_at_contacts(workspace, &BodyGrid<dim>::acceleration);                          // ranks
  correct_accelerations(model, state, workspace);                                         // 4: (8)-(14)

  for (Index b = 0; b < bodies; ++b) {
    BodyGrid<dim>& grid = workspace.grids[b];
    spread_new_momentum(model.mesh, state.particles[b], state.dt, grid);  // 5-6: (14)-(16) from the moments
    exchange_corner_sums(grid);                                           // ranks
    gather_new_velocities(model, workspace.motion_after, grid);           // 7-8: (18), supports
    advance_flux(model, state, workspace, b);                             // water
  }
  exchange_at_contacts(workspace, &BodyGrid<dim>::mapped_velocity);  // ranks
  correct_velocities(model, state, workspace);                       // 8: (8)-(13) again

  move_load_points(model, state, workspace);  // 9: with the soil
  for (Index b = 0; b < bodies; ++b) {
    if (model.mpm.volumetric_projection) sum_volume_changes(model.mesh, state.particles[b], state.dt, workspace.grids[b]);
    sum_outflows(model, state, workspace.grids[b], b);  // water
    move_and_strain(model, state, workspace, b);        // 5, 9-11: (14), (19)-(23)
    change_cells(model, state, workspace, b);
  }
}

}  // namespace

template <int dim>
void find_stable_time_step(const problem::Model<dim>& model, problem::State<dim>& state, Workspace<dim>& workspace)
{
  if (state.stable_dt_holds) return;
  update_inactive_cells(model, state, workspace);
  const TimeSteps found = stable_time_steps(model, state, workspace);
  state.stable_dt = found.stable;
  state.default_dt = found.by_default;
  refuse_overlap(model, state);
  state.stable_dt_holds = true;
}

template <int dim>
void take_step(const problem::Model<dim>& model, problem::State<dim>& state, Workspace<dim>& workspace)
{
  state.dt = std::min(state.stable_dt, state.max_dt);
  for (BodyGrid<dim>& grid : workspace.grids) grid.table = model.conditions.table_of_stage[state.stage.index];
  hold_inactive_cells(model, state, workspace);
  drive_rigids(model, state, state.dt);
  prescribe_velocities(model, state, workspace);
  if (model.update_stress_first)
    update_stress_first(model, state, workspace);
  else
    update_stress_last(model, state, workspace);
  move_rigids(model, state);
  state.time += state.dt;
  ++state.step;
  state.stable_dt_holds = state.step % steps_between_time_steps != 0;
}

template <int dim>
void step(const problem::Model<dim>& model, problem::State<dim>& state, Workspace<dim>& workspace)
{
  find_stable_time_step(model, state, workspace);
  take_step(model, state, workspace);
}

#define BERM_INSTANTIATE(dim)                                                                                                              \
  template void find_stable_time_step(const problem::Model<dim>&, problem::State<dim>&, Workspace<dim>&);                                  \
  template void take_step(const problem::Model<dim>&, problem::State<dim>&, Workspace<dim>&);                                              \
  template void step(const problem::Model<dim>&, problem::State<dim>&, Workspace<dim>&);
BERM_INSTANTIATE(2)
BERM_INSTANTIATE(3)
#undef BERM_INSTANTIATE

}  // namespace berm::mpm
