// SPDX-License-Identifier: BSD-3-Clause
#include "mpm/move.hpp"

#include "core/rotate.hpp"
#include "mpm/flow.hpp"
#include "mpm/hoop.hpp"
#include "mpm/linear_field.hpp"
#include "mpm/transfer.hpp"

#include <algorithm>

namespace berm::mpm {
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
      for (int b = a; b < dim; ++b) strain[tensor_index(a, b)] = 0.5 * dt * (velocity.slope[a][b] + velocity.slope[b][a]);
      for (int b = 0; b < dim; ++b) rotation[a][b] = 0.5 * dt * (velocity.slope[a][b] - velocity.slope[b][a]);
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
    for (int a = 0; a < directions; ++a) strain[a] += (projected - dilation) / directions;
    dilation = projected;
  }
};

/// A point that round-off put beyond a face is moved onto it: negative shape functions become zero. True where it was no more than that.
template <int dim>
bool clamp_to_cell(const mesh::Mesh<dim>& mesh, Index cell, Vec<dim>& x)
{
  constexpr Real round_off = 1e-9;  // of a cell's height
  const mesh::Shape<dim> shape = mesh.shape(cell);
  Real n[dim + 1], total = 0;
  for (int k = 0; k <= dim; ++k) {
    n[k] = shape.value(k, x);
    if (n[k] < -round_off) return false;
    total += n[k] = std::max(n[k], Real(0));
  }
  x.setZero();
  for (int k = 0; k <= dim; ++k) x += n[k] / total * mesh.position[mesh.nodes[cell][k]];
  return true;
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

/// The soil of a body whose particles keep strength, stiffness or material for themselves.
template <class Law>
struct OwnSoil {
  const std::vector<material::PreparedMaterial>&laws, &laws_without_dilation;  ///< by material
  const std::vector<VolumeRule>& rules;
  int number_offset;  ///< of the material's number among a particle's extra numbers, or none
  static constexpr int own_size = material::own_size<Law>(), first_own = Law::state_size;  ///< its strength and stiffness there
};

/// Bounds of the particles' volume over their mass.
template <class V>
struct VolumeBounds {
  V min{}, max{};
};

/// The law of each particle: its material's, with its own strength and stiffness. One pass for each material in the part, which is one but at the edges of
/// layers.
template <int dim, class Law, class P, class V>
[[gnu::always_inline]] inline VolumeBounds<V>
update_by_own_soil(const OwnSoil<Law>& soils, const P& part, const Lanes* low, const Lanes* high, const V& mass, const V& volume,
                   SymTensor<dim, V>& stress, material::Increment<dim, V>& increment, V* state)
{
  using Mask = typename Part<V>::Mask;
  constexpr int own_size = OwnSoil<Law>::own_size, first_own = OwnSoil<Law>::first_own;
  V own[own_size + 1], number{};
  for (int k = 0; k < own_size; ++k) own[k] = part.get(low[first_own + k], high[first_own + k]);
  if (soils.number_offset != none) number = part.get(low[soils.number_offset], high[soils.number_offset]);
  const SymTensor<dim, V> begin = stress;
  V begin_state[Law::state_size + 1];
  const int state_variables = state_count(std::get<Law>(soils.laws.front()));
  std::copy_n(state, state_variables, begin_state);
  VolumeBounds<V> bounds;
  for (Mask left = part.alive(); any(left);) {
    int first = 0;
    while (!left[first]) ++first;
    const auto n = static_cast<std::size_t>(number[first]);
    const Mask these = left & (number == number[first]);
    left &= ~these;
    const VolumeRule& rule = soils.rules[n];
    SymTensor<dim, V> s = begin;
    V of_law[Law::state_size + 1];
    std::copy_n(begin_state, state_variables, of_law);
    increment.active = these;
    const auto& here = with_own(std::get<Law>(soils.laws[n]), own);
    const Mask fully_dilated = these & (volume >= mass * rule.max_volume);
    if (rule.dilates && any(fully_dilated)) {
      const auto& without_dilation = with_own(std::get<Law>(soils.laws_without_dilation[n]), own);
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

/// What a pass over the particles takes to the totals, J.
struct WorkDone {
  Real internal = 0;
  Real filtered = 0;  ///< kinetic energy that the filter takes out

  WorkDone& operator+=(const WorkDone& other)
  {
    internal += other.internal;
    filtered += other.filtered;
    return *this;
  }
};

/// The kinetic energy that the particles of a cell have gained once they have the velocity v + dt a.
template <int dim>
Real kinetic_gain(const LinearField<dim>& acceleration, const Moments<dim>& t, Real dt)
{
  Real ma[dim], max[dim][dim];
  for (int d = 0; d < dim; ++d) ma[d] = acceleration.momentum(d, t, max[d]);
  return dt * (acceleration.dot(t.mv, t.mvx) + 0.5 * dt * acceleration.dot(ma, max));
}

/// Finds the new cell of a particle that has left its own, and notes the change. A call here would change what the compiler does to the loop around it, and
/// the last bits.
template <int dim>
[[gnu::always_inline]] inline void note_cell_change(const mesh::Mesh<dim>& mesh, Work<dim>& work, Index cell, Index index,
                                                    bodies::Block<dim>& block, int lane)
{
  Vec<dim> at;
  for (int d = 0; d < dim; ++d) at[d] = block.x[d][lane];
  const mesh::Location found = locate(mesh, at, cell);
  const bool in_mesh = found.inside || clamp_to_cell(mesh, found.cell, at);
  for (int d = 0; d < dim; ++d) block.x[d][lane] = at[d];
  if (!in_mesh || found.cell != cell) work.cell_changes[omp_get_thread_num()].push_back({cell, index, in_mesh ? found.cell : none});
}

/// Notes which particles of a part have left their cell: those whose smallest shape function is negative.
template <class P, class V, int dim>
[[gnu::always_inline]] inline void note_cell_changes(const P& part, const V& min_shape, const mesh::Mesh<dim>& mesh, Work<dim>& work,
                                                     Index cell, bodies::Block<dim>& p, bodies::Block<dim>& q)
{
  const typename Part<V>::Mask leaves = part.alive() & (min_shape < V{});
  if (any(leaves)) [[unlikely]]
    for (int l = 0; l < part.size; ++l)
      if (leaves[l]) note_cell_change(mesh, work, cell, part.index + l, l < lanes ? p : q, (part.first + l) % lanes);
}

/// The dilation that the cells of a patch share, over their volume; of their water, or of the soil.
Real patch_dilation(const mesh::Patches& patches, const CellField<VolumeChange>& of_cells, Index cell)
{
  Real volume = 0, change = 0;
  mesh::for_each_in_patch(patches, cell, [&](Index member) {
    volume += of_cells[member].volume;
    change += of_cells[member].change;
  });
  return change / volume;
}

/// N_k of a cell where all coordinates are zero.
template <int dim>
[[gnu::always_inline]] inline void shape_at_zero(const mesh::Shape<dim>& shape, Real (&at_zero)[dim])
{
  for (int k = 0; k < dim; ++k)
    for (int d = 0; d < dim; ++d) at_zero[k] -= shape.gradients[k][d] * shape.origin[d];
}

// Numbers are handed to these parts of the pass by reference: by value the compiler fuses other multiplications with additions, and the last bits change.
// The strain is not cut out for the same reason; where the bits stay, its law is not inlined and the pass takes a quarter longer.

/// Moves a part of a cell's particles and gives their smallest shape function where they are then; adds the kinetic energy that the filter takes. at_zero is
/// N_k where all coordinates are zero.
template <class V, int dim, class P>
[[gnu::always_inline]] inline V move_part(const P& part, bodies::Block<dim>& p, bodies::Block<dim>& q, const mesh::Shape<dim>& shape,
                                          const Real (&at_zero)[dim], const LinearField<dim>& gain, const LinearField<dim>& velocity,
                                          const Real& dt, const Real& filtered, const Real& unfiltered, WorkDone& done)
{
  const typename Part<V>::Mask alive = part.alive();
  V old_x[dim], x[dim], kinetic_loss{};
  for (int d = 0; d < dim; ++d) old_x[d] = part.get(p.x[d], q.x[d]);
  for (int d = 0; d < dim; ++d) {
    const V v = part.get(p.v[d], q.v[d]);
    const V new_v = alive ? unfiltered * v + gain.at(d, old_x) : v;
    part.set(p.v[d], q.v[d], new_v);
    if (filtered > 0) kinetic_loss += part.get(p.mass, q.mass) * (v * v - new_v * new_v);
    x[d] = alive ? old_x[d] + dt * velocity.at(d, old_x) : old_x[d];
    part.set(p.x[d], q.x[d], x[d]);
  }
  if (filtered > 0) done.filtered += 0.5 * sum(kinetic_loss);
  V min_shape = 1 - V{}, of_corner_0 = 1 - V{};
  for (int k = 0; k < dim; ++k) {
    V n = at_zero[k] + shape.gradients[k][0] * x[0];
    for (int d = 1; d < dim; ++d) n += shape.gradients[k][d] * x[d];
    of_corner_0 -= n;
    min_shape = smaller(min_shape, n);
  }
  return smaller(min_shape, of_corner_0);
}

/// law_without_dilation is null where the law does not dilate. Where particles keep their own soil, both are not used. Particles move for the time `motion` (s).
template <bool own_soil, mesh::Metric metric, int dim, class Law>
void move_and_strain_with(const Law& law, const Law* law_without_dilation, Real motion, const problem::Model<dim>& model,
                          problem::State<dim>& state, Work<dim>& work, Index body)
{
  const mesh::Mesh<dim>& mesh = model.mesh;
  BodyGrid<dim>& grid = work.grids[body];
  bodies::Particles<dim>& particles = state.particles[body];
  const Real dt = state.dt, time = state.time, per_density = 1 / model.bodies[body].waves.mean_density;
  const Real min_volume = model.mpm.min_volume_ratio * per_density, max_volume = model.mpm.max_volume_ratio * per_density;
  const Real filtered = grid.filtered_part(motion), unfiltered = 1 - filtered;
  for (auto& list : work.cell_changes) list.clear();
  [[maybe_unused]] const OwnSoil<Law> soils{work.laws[body], work.laws_without_dilation[body], work.volume_rules[body],
                                            work.number_offset[body]};

  const auto move_in_cell = [&](Index c) {
    const Index cell = particles.active()[c];
    particles.prefetch_after(c);
    const auto& nodes = mesh.nodes[cell];
    const mesh::Shape<dim> shape = grid.shape(mesh, cell);
    Real at_zero[dim] = {};
    shape_at_zero(shape, at_zero);
    const LinearField<dim> gain(shape, nodes, [&](Index i, int d) { return grid.gain(i, d, motion, filtered); }),
        velocity(shape, nodes, grid.mapped_velocity);
    CellStrain<dim> cell_strain(velocity, dt);
    if constexpr (metric == mesh::Metric::axisymmetric)
      cell_strain.add_hoop(dt * hoop_rate(shape, nodes, grid, cell, grid.mapped_velocity));
    if (model.mpm.volumetric_projection)
      cell_strain.template project<strained_directions<dim, metric>>(patch_dilation(model.patches, grid.volume_change, cell));
    const Real deviatoric = equivalent_deviatoric_strain(cell_strain.strain), stretch = 1 + cell_strain.dilation;

    Real outflow = 0, exchange = 0, level = 0;
    if (grid.water.flows()) {
      outflow = patch_dilation(model.patches, grid.water.outflow, cell);
      exchange = dt * leveling_rate<dim>(grid.water.cells[cell], mesh.section(cell));
      level = grid.water.cells[cell].pressure;
    }
    Real cell_size = 0;
    if constexpr (requires { law.softening_length; })
      if (law.softening_length > 0) cell_size = dim == 2 ? std::sqrt(mesh.section(cell)) : std::cbrt(mesh.section(cell));

    WorkDone done;
    particles.parts(cell, [&](const auto& part) {
      using V = typename std::decay_t<decltype(part)>::Vector;
      using Mask = typename Part<V>::Mask;
      bodies::Block<dim>&p = particles.block(part.block), &q = particles.block(part.other);
      const Mask alive = part.alive();
      const V min_shape = move_part<V>(part, p, q, shape, at_zero, gain, velocity, motion, filtered, unfiltered, done);
      const V mass = part.get(p.mass, q.mass), volume = part.get(p.volume, q.volume);
      material::Increment<dim, V> increment{.strain = {},
                                            .dt = dt,
                                            .time = time,
                                            .cell_size = cell_size,
                                            .outflow = outflow,
                                            .exchange = exchange,
                                            .level = level,
                                            .active = alive};
      SymTensor<dim, V>& strain = increment.strain;
      SymTensor<dim, V> stress, both_stresses;
      for (int k = 0; k < tensor_size<dim>; ++k) {
        strain[k] = cell_strain.strain[k] - V{};
        stress[k] = both_stresses[k] = part.get(p.stress[k], q.stress[k]);
      }
      rotate(stress, cell_strain.rotation);
      [[maybe_unused]] VolumeBounds<V> bounds;
      if constexpr (own_soil) {
        const Lanes *low = particles.extra(part.block), *high = particles.extra(part.other);
        part.template change<Law::state_size>(
            particles.state(part.block), particles.state(part.other), state_count(law),
            [&](V* law_state) { bounds = update_by_own_soil<dim>(soils, part, low, high, mass, volume, stress, increment, law_state); });
      } else {
        const Mask fully_dilated = alive & (volume >= mass * max_volume);
        part.template change<Law::state_size>(
            particles.state(part.block), particles.state(part.other), state_count(law),
            [&](V* law_state) { update_stress_of<dim>(law, law_without_dilation, fully_dilated, stress, increment, law_state); });
      }
      for (int k = 0; k < tensor_size<dim>; ++k) {
        const V kept = alive ? stress[k] : V{};
        both_stresses[k] += kept;
        part.set(p.stress[k], q.stress[k], kept);
      }
      done.internal += sum(0.5 * volume * double_dot(both_stresses, strain));
      if constexpr (own_soil)
        part.set(p.volume, q.volume, smaller(larger(volume * stretch, bounds.min), bounds.max));
      else
        part.set(p.volume, q.volume, smaller(larger(volume * stretch, mass * min_volume), mass * max_volume));
      part.set(p.deviatoric_strain, q.deviatoric_strain, part.get(p.deviatoric_strain, q.deviatoric_strain) + deviatoric);

      if (motion > 0) note_cell_changes(part, min_shape, mesh, work, cell, p, q);
    });
    if (filtered > 0) done.filtered += kinetic_gain(LinearField<dim>(shape, nodes, grid.acceleration), grid.moments[cell], motion);
    if (grid.full_cells) done.internal *= grid.weight[cell];
    done.internal += grid.moments[cell].volume * grid.viscous_stress[cell] * cell_strain.dilation;
    return done;
  };
  // The particles are in the cache still where their moments follow at once.
  const WorkDone work_done = sum_of<WorkDone>("move and strain particles", particles.active_chunks(), move_in_cell,
                                              [&](Index c) { sum_moments_of(mesh, particles, particles.active()[c], grid); });
  state.totals.internal += work_done.internal;
  state.totals.damping += work_done.filtered;
}

/// Steps 5 and 9-11 of the paper; 10 and 11 alone where particles move for no time.
template <int dim>
void pass_over_particles(Real motion, const problem::Model<dim>& model, problem::State<dim>& state, Work<dim>& work, Index body)
{
  const bool own_soil = work.own_soil[body] != 0, dilates = material::dilates(model.bodies[body].soil.materials.front());
  std::visit(
      [&](const auto& law) {
        const auto& law_without_dilation = std::get<std::decay_t<decltype(law)>>(work.laws_without_dilation[body].front());
        const auto* without_dilation = dilates ? &law_without_dilation : nullptr;
        with_metric(model.mesh, [&](auto metric) {
          if (own_soil)
            move_and_strain_with<true, metric(), dim>(law, without_dilation, motion, model, state, work, body);
          else
            move_and_strain_with<false, metric(), dim>(law, without_dilation, motion, model, state, work, body);
        });
      },
      work.laws[body].front());
}

}  // namespace

template <int dim>
void move_and_strain(const problem::Model<dim>& model, problem::State<dim>& state, Work<dim>& work, Index body)
{
  pass_over_particles(state.dt, model, state, work, body);
}

template <int dim>
void strain_particles(const problem::Model<dim>& model, problem::State<dim>& state, Work<dim>& work, Index body)
{
  pass_over_particles(0, model, state, work, body);
}

template <int dim>
void move_particles(const problem::Model<dim>& model, problem::State<dim>& state, Work<dim>& work, Index body)
{
  const mesh::Mesh<dim>& mesh = model.mesh;
  BodyGrid<dim>& grid = work.grids[body];
  bodies::Particles<dim>& particles = state.particles[body];
  for (auto& list : work.cell_changes) list.clear();
  const auto move_in_cell = [&](Index c) {
    const Index cell = particles.active()[c];
    const auto& nodes = mesh.nodes[cell];
    const mesh::Shape<dim> shape = grid.shape(mesh, cell);
    Real at_zero[dim] = {};
    shape_at_zero(shape, at_zero);
    const LinearField<dim> gain(shape, nodes, [&](Index i, int d) { return grid.gain(i, d, state.dt, 0); }),
        velocity(shape, nodes, grid.mapped_velocity);
    WorkDone done;
    particles.parts(cell, [&](const auto& part) {
      using V = typename std::decay_t<decltype(part)>::Vector;
      bodies::Block<dim>&p = particles.block(part.block), &q = particles.block(part.other);
      const V min_shape = move_part<V>(part, p, q, shape, at_zero, gain, velocity, state.dt, 0, 1, done);
      note_cell_changes(part, min_shape, mesh, work, cell, p, q);
    });
    sum_moments_of(mesh, particles, cell, grid);
  };
  for_each("move particles", particles.active_chunks(), move_in_cell);
}

#define BERM_INSTANTIATE(dim)                                                                                                              \
  template void move_and_strain(const problem::Model<dim>&, problem::State<dim>&, Work<dim>&, Index);                                      \
  template void strain_particles(const problem::Model<dim>&, problem::State<dim>&, Work<dim>&, Index);                                     \
  template void move_particles(const problem::Model<dim>&, problem::State<dim>&, Work<dim>&, Index);
BERM_INSTANTIATE(2)
BERM_INSTANTIATE(3)
#undef BERM_INSTANTIATE

}  // namespace berm::mpm
