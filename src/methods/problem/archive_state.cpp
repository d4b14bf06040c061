// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/simulation/checkpoints_state_test.cpp
#include "problem/archive_state.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::problem {

constexpr BigIndex max_steps = BigIndex(1) << 60;  // no run gets so far, and the next ones can still be counted

namespace {

void archive(Archive& k, const std::string& name, bodies::Orientation<2>& orientation)
{
  k(name, orientation.angle);
}
void archive(Archive& k, const std::string& name, bodies::Orientation<3>& orientation)
{
  std::vector<Real> q = {orientation.w, orientation.x, orientation.y, orientation.z};
  k.fixed(name, q);
  orientation = {q[0], q[1], q[2], q[3]};
}

template <int dim>
void archive(Archive& k, const std::string& name, NodeField<Vec<dim>>& vectors)
{
  if (vectors.size() == 0) return;
  std::vector<Real> numbers(static_cast<std::size_t>(vectors.size()) * dim);
  for (Index node = 0; node < vectors.size(); ++node)
    for (int d = 0; d < dim; ++d) numbers[node * dim + d] = vectors[node][d];
  k.fixed(name, numbers);
  for (Index node = 0; node < vectors.size(); ++node)
    for (int d = 0; d < dim; ++d) vectors[node][d] = numbers[node * dim + d];
}

void archive(Archive& k, const std::string& name, CellField<Real>& sums)
{
  if (sums.size() == 0) return;
  std::vector<Real> numbers(sums.begin(), sums.end());
  k.fixed(name, numbers);
  std::copy(numbers.begin(), numbers.end(), sums.begin());
}

}  // namespace

template <int dim>
void archive(Archive& k, bodies::Pose<dim>& pose)
{
  k("displacement", pose.displacement);
  archive(k, "orientation", pose.orientation);
}

namespace {

// The sizes reveal a member that is not archived yet.
template <int dim>
void archive(Archive& k, bodies::RigidState<dim>& rigid)
{
  static_assert(sizeof(rigid) == (dim == 2 ? 6 * 2 + 6 : 10 * 3 + 4) * sizeof(Real));
  problem::archive(k, static_cast<bodies::Pose<dim>&>(rigid));
  k("velocity", rigid.velocity);
  k("angular_velocity", rigid.angular_velocity);
  k("reaction", rigid.reaction);
  k("torque", rigid.torque);
  k.table("recent", [&] {
    k("way", rigid.recent.way);
    k("lag", rigid.recent.lag);
    k("variance", rigid.recent.variance);
    k("mean_force", rigid.recent.mean_force);
    k("force_covariance", rigid.recent.force_covariance);
    k("mean_torque", rigid.recent.mean_torque);
    k("torque_covariance", rigid.recent.torque_covariance);
  });
}

}  // namespace

// The sizes reveal a sum that has no row yet.
template <int dim>
void archive(Archive& k, Ledger<dim>& ledger)
{
  static_assert(sizeof(ledger) == sizeof(Totals<dim>) + 6 * sizeof(std::vector<Real>));
  static_assert(sizeof(Totals<dim>) == (6 + 7 * dim) * sizeof(Real));
  static_assert(sizeof(contact::ContactSums<dim>) == (dim == 2 ? 2 * 2 + 5 : 3 * 3 + 4) * sizeof(Real));
  for_each_sum<dim>(
      [&](const auto& row, std::size_t owner, auto& sum) {
        k.table(fmt::format("{}_{}", words_of_owners[static_cast<int>(row.owner)], owner), [&] {
          if constexpr (std::is_same_v<decltype(sum), std::vector<Real>&>) {
            std::vector<Real> numbers = sum;  // of another length they are refused, and the ledger keeps its own
            k.fixed(row.name, numbers);
            sum = std::move(numbers);
          } else {
            k(row.name, sum);
          }
        });
      },
      ledger);
}

namespace {

void archive(Archive& k, PressureMeans& means)
{
  static_assert(sizeof(means) == 7 * sizeof(Real));
  k("begin", means.begin);
  k("weight", means.weight);
  k("count", means.count);
  k("last", means.last);
  k("before", means.before);
  k("largest", means.largest);
  k("now", means.now);
}

template <int dim>
void archive(Archive& k, const Model<dim>& model, StageState<dim>& stage)
{
  k("index", stage.index);
  if (stage.index < 0 || stage.index >= static_cast<Index>(model.stages.size())) k.refuse(fmt::format("there is no stage {}", stage.index));
  k("begin_time", stage.begin_time);
  k("begin_displacement", stage.begin_displacement);
  archive(k, "begin_orientation", stage.begin_orientation);
  if (model.stages[stage.index].until.force)
    k.table("approach", [&] {
      k("begin", stage.approach.begin);
      k("travel", stage.approach.travel);
      k("mean_travel", stage.approach.mean_travel);
    });
  k("excess_pressure", stage.excess_pressure);
  k.table("pressure_means", [&] { archive(k, stage.pressure_means); });
  for (int d = 0; d < bodies::freedoms<dim>; ++d)
    k.table(fmt::format("drive_{}", d), [&] {
      k("by_force", stage.drive[d].by_force);
      k("from", stage.drive[d].from);
      k("to", stage.drive[d].to);
      k("spring", stage.drive[d].spring);
    });
}

void archive(Archive& k, TractionState& traction)
{
  static_assert(sizeof(traction) == 3 * sizeof(Real));
  k("begin_time", traction.begin_time);
  k("from", traction.from);
  k("to", traction.to);
}

template <int dim>
void archive(Archive& k, ActiveSoil<dim>& active, std::size_t rigid_bodies)
{
  k("everywhere", active.everywhere);
  k("stopped", active.stopped);
  if (active.everywhere) return;
  active.poses.resize(rigid_bodies);
  for (std::size_t r = 0; r < rigid_bodies; ++r) k.table(fmt::format("pose_{}", r), [&] { problem::archive(k, active.poses[r]); });
}

template <int dim>
void archive_earthworks(Archive& k, const Model<dim>& model, State<dim>& state)
{
  for (std::size_t w = 0; w < state.earthworks.size(); ++w)
    k.table(model.earthworks[w].name, [&] {
      EarthworkState<dim>& work = state.earthworks[w];
      static_assert(sizeof(work) == (6 + dim) * sizeof(Real));
      k("lifts", work.lifts);
      k("first", work.first);
      k("particles", work.particles);
      k("volume", work.volume);
      k("mass", work.mass);
      k("room", work.room);
      k("momentum", work.momentum);
      k("kinetic", work.kinetic);
      if (work.lifts < 0 || work.lifts > model.earthworks[w].lifts) k.refuse(fmt::format("there is no lift {}", work.lifts));
    });
  for (std::size_t b = 0; b < state.numbered.size(); ++b) {
    const std::int32_t at_start = state.numbered[b];
    k(fmt::format("numbered_{}", b), state.numbered[b]);
    if (state.numbered[b] < at_start || state.numbered[b] > std::numeric_limits<std::int32_t>::max() / 2)
      k.refuse(fmt::format("a body cannot have had {} particles", state.numbered[b]));
  }
}

template <int dim>
void archive(Archive& k, const Model<dim>& model, std::vector<LoadPointState<dim>>& points)
{
  std::vector<Index> cells;
  std::vector<Real> x;
  for (const LoadPointState<dim>& point : points) {
    cells.push_back(point.cell);
    x.insert(x.end(), point.x.begin(), point.x.end());
  }
  k.fixed("cells", cells);
  k.fixed("positions", x);
  for (std::size_t l = 0; l < points.size(); ++l) {
    if (k.reads() && (cells[l] < 0 || cells[l] >= model.mesh.cell_count())) k.refuse(fmt::format("the mesh has no cell {}", cells[l]));
    points[l].cell = cells[l];
    for (int d = 0; d < dim; ++d) points[l].x[d] = x[l * dim + d];
  }
}

}  // namespace

template <int dim>
void archive(Archive& k, const Model<dim>& model, State<dim>& state)
{
  k("time", state.time);
  k("step", state.step);
  if (k.reads() && (state.step < 0 || state.step > max_steps)) k.refuse(fmt::format("there is no step {}", state.step));
  k("dt", state.dt);
  k("stable_dt", state.stable_dt);
  k("default_dt", state.default_dt);
  k("stable_dt_holds", state.stable_dt_holds);
  k("max_dt", state.max_dt);
  k.table("stage", [&] { archive(k, model, state.stage); });
  if (model.mpm.active_distance) k.table("active_soil", [&] { archive(k, state.active_soil, state.rigid_bodies.size()); });
  k.table("ledger", [&] { archive(k, state.ledger); });
  for (std::size_t r = 0; r < state.rigid_bodies.size(); ++r)
    k.table(fmt::format("rigid_{}", r), [&] { archive(k, state.rigid_bodies[r]); });
  for (std::size_t r = 0; r < state.listed_poses.size(); ++r)
    k.table(fmt::format("listed_pose_{}", r), [&] { archive(k, state.listed_poses[r]); });
  for (std::size_t t = 0; t < state.tractions.size(); ++t) k.table(fmt::format("traction_{}", t), [&] { archive(k, state.tractions[t]); });
  for (std::size_t h = 0; h < state.heads.size(); ++h) k.table(fmt::format("head_{}", h), [&] { archive(k, state.heads[h]); });
  if (!state.load_points.empty()) k.table("load_points", [&] { archive(k, model, state.load_points); });
  for (std::size_t b = 0; b < state.flux.size(); ++b) archive(k, fmt::format("flux_{}", b), state.flux[b]);
  for (std::size_t b = 0; b < state.held_forces.size(); ++b) archive(k, fmt::format("held_forces_{}", b), state.held_forces[b]);
  for (std::size_t b = 0; b < state.pressure_sums.size(); ++b) archive(k, fmt::format("pressure_sums_{}", b), state.pressure_sums[b]);
  if (!model.earthworks.empty()) k.table("earthworks", [&] { archive_earthworks(k, model, state); });
  k("lengthened", state.lengthened);
  for (std::size_t b = 0; state.lengthened && b < state.particles.size(); ++b) k(fmt::format("numbered_{}", b), state.numbered[b]);
  for (std::size_t b = 0; b < state.particles.size(); ++b) {
    const bool any = state.lengthened || !model.earthworks.empty();
    const std::optional<Index> numbered = any ? std::optional<Index>(state.numbered[b]) : std::nullopt;
    k.table(fmt::format("body_{}", b), [&] { state.particles[b].archive(k, numbered); });
  }
}

template void archive(Archive&, bodies::Pose<2>&);
template void archive(Archive&, bodies::Pose<3>&);
template void archive(Archive&, Ledger<2>&);
template void archive(Archive&, Ledger<3>&);
template void archive(Archive&, const Model<2>&, State<2>&);
template void archive(Archive&, const Model<3>&, State<3>&);

}  // namespace berm::problem
