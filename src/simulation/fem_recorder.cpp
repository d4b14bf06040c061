// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/commands/run_fem_test.cpp
#include "simulation/fem_recorder.hpp"

#include "problem/stages.hpp"

#include <fmt/format.h>

namespace berm::simulation {
namespace {

constexpr Real unknown = std::numeric_limits<Real>::quiet_NaN();

}  // namespace

std::vector<std::string> FemRecorder::columns(const fem::FemModel& model)
{
  std::vector<std::string> names = run_folder::common_columns();
  names.insert(names.end(), {"iterations", "unbalance", "overstress", "strength_lag"});
  for (const problem::Traction& traction : model.model.tractions)
    for (const char* column : {"Fx_N_m", "Fy_N_m", "ux_m", "uy_m"}) names.push_back(fmt::format("{}_{}", traction.name, column));
  for (const fem::FemWatch& watch : model.watches)
    for (const char* column : {"ux_m", "uy_m", "sxx_Pa", "syy_Pa", "szz_Pa", "sxy_Pa"})
      names.push_back(fmt::format("{}_{}", watch.name, column));
  return names;
}

FemRecorder::FemRecorder(const std::filesystem::path& path, const fem::FemModel& model) : file_(path, columns(model)) {}

void FemRecorder::add_row(const fem::FemModel& model, fem::FemState& state, const fem::IncrementEnd& end)
{
  const problem::State<2>& now = state.state;
  const problem::Totals<2>& t = now.totals;
  const Real error = t.internal + t.friction - t.external;
  largest_error_ = std::max(largest_error_, std::abs(error));
  largest_work_ = std::max({largest_work_, std::abs(t.external), std::abs(t.internal)});
  std::vector<Real> row(4, unknown);
  Real moment = unknown, angle = unknown, overlap = unknown;
  if (model.rigid != none) {
    bodies::RigidState<2>& rigid = state.state.rigid_bodies[model.rigid];
    const problem::PipeMotion motion = pipe_motion(model.model, now, model.rigid);
    horizontal_ = -drag_direction(model.model, now) * rigid.reaction[0] + 0.;
    vertical_ = rigid.reaction[1];
    row = {motion.u, motion.w, horizontal_, vertical_};
    moment = rigid.torque;
    angle = rigid.angle;
    overlap = rigid.max_overlap;
    rigid.max_overlap = 0;
    if (model.model.driven[now.stage.index] != none && end.iterations > 0) {
      largest_unbalance_ = std::max(largest_unbalance_, end.unbalance);
      largest_overstress_ = std::max(largest_overstress_, state.overstress);
      lag_.missing += std::abs(end.lag.missing);
      lag_.dissipated += end.lag.dissipated;
    }
  }
  row.insert(row.end(), {0, t.internal, 0, t.friction, t.external, error, state.unbalanced / (model.weight > 0 ? model.weight : unknown), 0,
                         overlap, 0, moment, angle, static_cast<Real>(end.iterations), end.unbalance, state.overstress, end.lag.part()});
  for (std::size_t k = 0; k < model.loads.size(); ++k) {
    Vec<2> force = Vec<2>::Zero(), moved_by = Vec<2>::Zero();
    Real area = 0;
    for (const fem::NodalLoad& load : model.loads[k]) {
      force += load.force;
      moved_by += load.area * Vec<2>(state.displacement[2 * load.node], state.displacement[2 * load.node + 1]);
      area += load.area;
    }
    force *= state.tractions[k];
    moved_by /= area;
    row.insert(row.end(), {force[0], force[1], moved_by[0], moved_by[1]});
  }
  for (const fem::FemWatch& watch : model.watches) {
    row.insert(row.end(), {state.displacement[2 * watch.node], state.displacement[2 * watch.node + 1]});
    const SymTensor<2>& stress = state.points[watch.cell][watch.point].stress;
    row.insert(row.end(), stress.c, stress.c + 4);
  }
  file_.add(now.time, model.model.stages[now.stage.index].name, row);
}

}  // namespace berm::simulation
