// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/mpm/move_test.cpp
#pragma once

#include "core/rotate.hpp"
#include "material/law_list.hpp"
#include "mpm/flow.hpp"
#include "mpm/hoop.hpp"
#include "mpm/moments.hpp"
#include "mpm/move_by_law.hpp"
#include "mpm/particle_motion.hpp"
#include "mpm/small_mass_nodes.hpp"

#include <tuple>

namespace berm::mpm {

// Of one file each: with names that other files may share, the compiler would inline otherwise, and the last bits change.
namespace {

/// Increments of strain, rotation and dilation, uniform in a cell.
template <int dim>
struct CellStrain {
  SymTensor<dim> strain{};
  Real rotation[dim][dim] = {};
  Real dilation = 0;

  [[gnu::always_inline]] CellStrain(const LinearField<dim>& velocity, Real dt)
  {
    for (int a = 0; a < dim; ++a) {
      dilation += velocity.slope[a][a] * dt;
      for (int b = a; b < dim; ++b) strain[tensor_index(a, b)] = 0.5 * dt * (velocity.slope[b][a] + velocity.slope[a][b]);
      for (int b = 0; b < dim; ++b) rotation[a][b] = 0.5 * dt * (velocity.slope[b][a] - velocity.slope[a][b]);
    }
  }
  /// Adds the strain around the axis.
  [[gnu::always_inline]] void add_hoop(Real hoop)
  {
    strain[2] = hoop;
    dilation += hoop;
  }
  /// Takes over the projected dilation: the change is shared by as many directions, so that plane strain stays plane.
  template <int directions>
  [[gnu::always_inline]] void project(Real projected)
  {
    for (int a = 0; a < directions; ++a) strain[a] += (projected - dilation) * (1. / directions);
    dilation = projected;
  }
};

/// Rotates the tensor among the state variables of a law that has one in use.
template <int dim, class Law, class V>
[[gnu::always_inline]] inline void rotate_state([[maybe_unused]] const Law& law, [[maybe_unused]] V* state,
                                                [[maybe_unused]] const Real (&rotation)[dim][dim])
{
  if constexpr (constexpr int first = material::rotating_state<Law>; first >= 0) {
    if (state_count(law) < first + 6) return;
    SymTensor<dim, V> tensor;
    for (int k = 0; k < tensor_size<dim>; ++k) tensor[k] = state[first + k];
    rotate(tensor, rotation);
    for (int k = 0; k < tensor_size<dim>; ++k) state[first + k] = tensor[k];
  }
}

/// The law, but for particles that have grown to their largest volume: these dilate no more.
template <int dim, class Law, class V>
[[gnu::always_inline]] inline void update_stress_of(const Law& law, const Law* law_without_dilation, typename Part<V>::Mask fully_dilated,
                                                    SymTensor<dim, V>& stress, const material::Increment<dim, V>& increment, V* state)
{
  if (law_without_dilation == nullptr || !any(fully_dilated)) {
    update(law, stress, increment, state);
    return;
  }
  SymTensor<dim, V> dilated_stress = stress;
  const int state_variables = state_count(law);
  V dilated_state[std::max(Law::state_size, 1)];
  std::copy_n(state, state_variables, dilated_state);
  update(law, stress, increment, state);
  update(*law_without_dilation, dilated_stress, increment, dilated_state);
  for (int k = 0; k < tensor_size<dim>; ++k) stress[k] = fully_dilated ? dilated_stress[k] : stress[k];
  for (int k = 0; k < state_variables; ++k) state[k] = fully_dilated ? dilated_state[k] : state[k];
}

/// Bounds of the particles' volume over their mass.
template <class V>
struct VolumeBounds {
  V min{}, max{};
};

/// The law of each particle: its material's, with its own strength and stiffness. One pass for each material in the part, which is one but at the edges of
/// layers.
template <int dim, class Law, class P, class V>
[[gnu::always_inline]] inline VolumeBounds<V>
update_by_local_strength(const SoilOf<Law>& soil, Index first_law, const P& part, const Lanes* low, const Lanes* high, const V& mass,
                         const V& volume, SymTensor<dim, V>& stress, material::Increment<dim, V>& increment, V* state)
{
  using Mask = typename Part<V>::Mask;
  constexpr int local_size = SoilOf<Law>::local_size, first_local = SoilOf<Law>::first_local;
  V own[local_size + 1], number{};
  for (int k = 0; k < local_size; ++k) own[k] = part.get(low[first_local + k], high[first_local + k]);
  if (soil.material_index_offset != none) number = part.get(low[soil.material_index_offset], high[soil.material_index_offset]);
  const SymTensor<dim, V> begin = stress;
  V begin_state[Law::state_size + 1];
  const int state_variables = state_count(soil.law(0));
  std::copy_n(state, state_variables, begin_state);
  VolumeBounds<V> bounds;
  for (Mask left = part.alive(); any(left);) {
    int first = 0;
    while (!left[first]) ++first;
    const auto n = static_cast<Index>(number[first]);
    const Mask these = left & (number == number[first]);
    left &= ~these;
    const VolumeRule& rule = soil.rules[static_cast<std::size_t>(n)];
    SymTensor<dim, V> s = begin;
    V of_law[Law::state_size + 1];
    std::copy_n(begin_state, state_variables, of_law);
    increment.active = these;
    const auto& here = with_local(soil.law(first_law + n), own);
    const Mask fully_dilated = these & (volume >= mass * rule.max_volume);
    if (rule.dilates && any(fully_dilated)) {
      const auto& without_dilation = with_local(soil.law_without_dilation(first_law + n), own);
      update_stress_of<dim>(here, &without_dilation, fully_dilated, s, increment, of_law);
    } else {
      update(here, s, increment, of_law);
    }
    for (int k = 0; k < tensor_size<dim>; ++k) stress[k] = these ? s[k] : stress[k];
    for (int k = 0; k < state_variables; ++k) state[k] = these ? of_law[k] : state[k];
    bounds.min = these ? mass * rule.min_volume : bounds.min;
    bounds.max = these ? mass * rule.max_volume : bounds.max;
  }
  return bounds;
}

/// The kinetic energy that the particles of a cell have gained once they have the velocity v + dt a.
template <int dim>
[[gnu::always_inline]] inline Real kinetic_gain(const AtCorners<dim>& acceleration, const Moments<dim>& t, Real dt)
{
  const AtCorners<dim> gained = momentum_with(t, acceleration);
  Components<dim> power{};
  for (int k = 0; k <= dim; ++k) power += acceleration[k] * (components<dim>(t.momentum[k]) + 0.5 * dt * gained[k]);
  return dt * sum_of_components<dim>(power);
}

/// What the energies after the move of a cell's particles need from before it.
template <int dim>
struct BeforeMove {
  SymTensor<dim> strain;  ///< of the cell
  Real weight;            ///< of its particles in the quadrature
};

/// The stress of a cell, summed over its volume, times the strain: work in the strained directions, J.
template <mesh::Metric metric, int dim>
[[gnu::always_inline]] inline Real work_of(const BodyGrid<dim>& grid, Index cell, const SymTensor<dim>& strain)
{
  const Moments<dim>& t = grid.moments[cell];
  Real work = 0;
  for (int a = 0; a < dim; ++a)
    for (int b = a; b < dim; ++b) work += (a == b ? 1 : 2) * t.stress[Moments<dim>::pair(a, b)] * strain[tensor_index(a, b)];
  if constexpr (metric == mesh::Metric::axisymmetric) work += grid.hoop[cell].stress * strain[2];
  return work;
}

/// The dilation that the cells of a patch share, over their volume; of their water, or of the soil.
inline Real patch_dilation(const mesh::Patches& patches, const CellField<VolumeChange>& of_cells, Index cell)
{
  Real volume = 0, change = 0;
  mesh::for_each_in_patch(patches, cell, [&](Index member) {
    volume += of_cells[member].volume;
    change += of_cells[member].change;
  });
  return change / volume;
}

/// Particles move for the time `motion` (s).
template <bool local_strength, mesh::Metric metric, int dim, class Law>
void move_and_strain_with(const SoilOf<Law>& soil, Real motion, const problem::Model<dim>& model, problem::State<dim>& state,
                          Workspace<dim>& workspace, Index body)
{
  const mesh::Mesh<dim>& mesh = model.mesh;
  BodyGrid<dim>& grid = workspace.grids[body];
  bodies::Particles<dim>& particles = state.particles[body];
  const settings::SoilWaves& soil_waves = model.bodies[body].waves;
  const Real dt = state.dt, time = state.time, per_density = 1 / soil_waves.mean_density;
  const Real min_volume = model.mpm.min_volume_ratio * per_density, max_volume = model.mpm.max_volume_ratio * per_density;
  for (auto& list : workspace.cell_changes) list.clear();

  const bool filters = motion > 0 && grid.filters();
  // The law is a copy, as is what is captured by value: no particle that is written can change them.
  const auto move_in_cell = [&, dt, time, motion, filters, min_volume, max_volume, law = soil.law(0),
                             number = Index(0)](Index c, BeforeMove<dim>& before, WorkDone& done) mutable {
    const Index cell = particles.active()[c];
    particles.prefetch_after(c);
    const Index first_law = soil.first_in(cell);
    if (first_law != number) law = soil.law(number = first_law);
    [[maybe_unused]] const Law* law_without_dilation = soil.dilates ? &soil.law_without_dilation(first_law) : nullptr;
    const auto& nodes = mesh.nodes[cell];
    const mesh::Shape<dim> shape = grid.shape(mesh, cell);
    const FilterOfCell<dim> filter = filters ? grid.filter_of(cell, motion) : FilterOfCell<dim>{};
    const Real unfiltered = 1 - filter.fraction;
    const AtCorners<dim> acceleration = at_corners(nodes, grid.acceleration);
    const LinearField<dim> gain(shape.gradients, velocity_gain(acceleration, nodes, grid, motion, filter)),
        velocity(shape.gradients, at_corners(nodes, grid.mapped_velocity));
    CellStrain<dim> cell_strain(velocity, dt);
    if constexpr (metric == mesh::Metric::axisymmetric)
      cell_strain.add_hoop(dt * hoop_rate(shape, nodes, grid, cell, grid.mapped_velocity));
    if (model.mpm.volumetric_projection)
      cell_strain.template project<strained_directions<dim, metric>>(patch_dilation(model.patches, grid.volume_change, cell));
    const SymTensor<dim> followed =
        grid.stiffness_limit.empty() ? cell_strain.strain : limited_strain<dim>(cell_strain.strain, soil_waves, grid.stiffness_limit[cell]);
    const Real deviatoric = equivalent_deviatoric_strain(cell_strain.strain), stretch = 1 + cell_strain.dilation;

    const Real shift = !grid.pressure_shift.empty() ? grid.pressure_shift[cell] : 0, shift_across = grid.shift_across * shift;
    Real outflow = 0, exchange = 0, level = 0;
    if (grid.water.flows()) {
      outflow = patch_dilation(model.patches, grid.water.outflow, cell);
      exchange = dt * leveling_rate<dim>(grid.water.cells[cell], mesh.section(cell));
      level = grid.water.cells[cell].pressure;
    }
    Real cell_size = 0;
    if constexpr (requires { law.softening_length; })
      if (law.softening_length > 0) cell_size = dim == 2 ? std::sqrt(mesh.section(cell)) : std::cbrt(mesh.section(cell));

    before = {cell_strain.strain, grid.weight(cell)};
    const Real viscous = grid.moments[cell].volume * grid.viscous_stress[cell] * cell_strain.dilation;
    done.internal += 0.5 * work_of<metric>(grid, cell, before.strain) + viscous;
    done.viscous += viscous;
    if (filters) done.filtered += 0.5 * grid.kinetic[cell] + kinetic_gain(acceleration, grid.moments[cell], motion);
    particles.parts(cell, [&](const auto& part) {
      using V = typename std::decay_t<decltype(part)>::Vector;
      using Mask = typename Part<V>::Mask;
      bodies::Block<dim>&p = particles.block(part.block), &q = particles.block(part.other);
      const Mask alive = part.alive();
      const V min_shape = move_part<V>(part, p, q, shape, gain, velocity, motion, unfiltered);
      const V mass = part.get(p.mass, q.mass), volume = part.get(p.volume, q.volume);
      material::Increment<dim, V> increment{.strain = {},
                                            .dt = dt,
                                            .time = time,
                                            .cell_size = cell_size,
                                            .outflow = outflow,
                                            .exchange = exchange,
                                            .level = level,
                                            .active = alive};
      SymTensor<dim, V> stress;
      for (int k = 0; k < tensor_size<dim>; ++k) {
        increment.strain[k] = alive ? followed[k] - V{} : V{};  // lanes without a particle must not make a law iterate
        stress[k] = part.get(p.stress[k], q.stress[k]);
      }
      for (int a = 0; a < 2; ++a) stress[a] += shift;
      stress[2] += shift_across;
      rotate(stress, cell_strain.rotation);
      [[maybe_unused]] VolumeBounds<V> bounds;
      if constexpr (local_strength) {
        const Lanes *low = particles.extra(part.block), *high = particles.extra(part.other);
        part.template change<Law::state_size>(
            particles.state(part.block), particles.state(part.other), state_count(law), [&](V* law_state) {
              rotate_state<dim>(law, law_state, cell_strain.rotation);
              bounds = update_by_local_strength<dim>(soil, first_law, part, low, high, mass, volume, stress, increment, law_state);
            });
      } else {
        const Mask fully_dilated = alive & (volume >= mass * max_volume);
        part.template change<Law::state_size>(
            particles.state(part.block), particles.state(part.other), state_count(law), [&](V* law_state) {
              rotate_state<dim>(law, law_state, cell_strain.rotation);
              update_stress_of<dim>(law, law_without_dilation, fully_dilated, stress, increment, law_state);
            });
      }
      for (int k = 0; k < tensor_size<dim>; ++k) part.set(p.stress[k], q.stress[k], alive ? stress[k] : V{});
      if constexpr (local_strength)
        part.set(p.volume, q.volume, smaller(larger(volume * stretch, bounds.min), bounds.max));
      else
        part.set(p.volume, q.volume, smaller(larger(volume * stretch, mass * min_volume), mass * max_volume));
      part.set(p.deviatoric_strain, q.deviatoric_strain, part.get(p.deviatoric_strain, q.deviatoric_strain) + deviatoric);

      if (motion > 0) note_cell_changes(part, min_shape, mesh, workspace, cell, p, q);
    });
  };
  // The particles are in the cache still where their moments follow at once. Energies are sums of cells before the move and after it.
  const auto sum_in_cell = [&, filters](Index c, const BeforeMove<dim>& before, WorkDone& done) {
    const Index cell = particles.active()[c];
    sum_moments_of(mesh, particles, cell, grid);
    done.internal += 0.5 * before.weight * work_of<metric>(grid, cell, before.strain);
    if (filters) done.filtered -= 0.5 * grid.kinetic[cell];
  };
  const WorkDone work_done =
      sum_in_two_steps<WorkDone, BeforeMove<dim>>("move and strain particles", particles.active_chunks(), move_in_cell, sum_in_cell);
  state.ledger.totals.internal += work_done.internal;
  state.ledger.totals.viscosity += work_done.viscous;
  state.ledger.totals.filter += work_done.filtered;
}

}  // namespace

template <int dim, class Law>
void move_by_law(const SoilOf<Law>& soil, Real motion, const problem::Model<dim>& model, problem::State<dim>& state,
                 Workspace<dim>& workspace, Index body)
{
  with_metric(model.mesh, [&](auto metric) {
    if (soil.local_strength)
      move_and_strain_with<true, metric(), dim>(soil, motion, model, state, workspace, body);
    else
      move_and_strain_with<false, metric(), dim>(soil, motion, model, state, workspace, body);
  });
}

/// Its explicit instantiation compiles the passes of these laws, without and with water in their pores; some have the same for both.
template <material::Law... Ls>
struct MovesOf {
  template <int dim>
  static constexpr auto in_space = std::tuple(&move_by_law<dim, material::PreparedLaw<Ls>>...,
                                              &move_by_law<dim, material::PreparedWithWater<Ls>>...);
  static constexpr auto all = std::tuple_cat(in_space<2>, in_space<3>);
};

}  // namespace berm::mpm
