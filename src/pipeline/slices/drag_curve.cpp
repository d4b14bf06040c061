// SPDX-License-Identifier: BSD-3-Clause
#include "slices/drag_curve.hpp"

#include "mpm/diagnose.hpp"
#include "mpm/step.hpp"
#include "os/error.hpp"
#include "problem/stages.hpp"

#include <algorithm>

namespace berm::slices {
namespace {

constexpr Real first_piece = 0.01, longest_piece = 0.05, growth = 1.15;  // of the diameter; each piece over the one before
constexpr BigIndex steps_between_questions = 16;                         // whether to stop

std::vector<Real> ends_of_pieces(Real travel, Real diameter)
{
  std::vector<Real> ends;
  for (Real piece = first_piece * diameter, end = 0; end < travel; piece = std::min(growth * piece, longest_piece * diameter))
    ends.push_back(end = std::min(travel, end + piece));
  return ends;
}

}  // namespace

std::optional<DragCurve> drag_sideways(const problem::Model<2>& model, const problem::State<2>& laid, Real weight,
                                       const settings::SpringsBeside& drag, const std::function<bool()>& stop)
{
  problem::State<2> state = laid;
  state.stable_dt_holds = false;
  mpm::Workspace<2> workspace(model, state);
  const bodies::RigidState<2>& pipe = state.rigid_bodies[0];
  const Real diameter = bodies::width_of<2>(model.rigid_bodies[0].shape), ramp = longest_piece * diameter / drag.velocity;
  const auto travel = [&] { return pipe.displacement[0] - laid.rigid_bodies[0].displacement[0]; };
  drive_otherwise(model, state, 1, true, -weight);
  std::vector<beam::CurvePoint> measured;
  Real from = 0;
  for (const Real end : ends_of_pieces(drag.travel, diameter)) {
    Real work = 0;
    while (travel() < end) {
      if (state.step % steps_between_questions == 0 && stop()) return {};
      mpm::find_stable_time_step(model, state, workspace);
      const Real since = state.time + std::min(state.stable_dt, state.max_dt) - laid.time, before = state.ledger.contact_sums[0].impulse[0];
      drive_otherwise(model, state, 0, false, drag.velocity * std::min(Real(1), since / ramp));
      mpm::take_step(model, state, workspace);
      mpm::refuse_rigid_outside_mesh(model, state);
      work += (state.ledger.contact_sums[0].impulse[0] - before) * pipe.velocity[0];
    }
    measured.push_back({(from + travel()) / 2, work / (travel() - from)});
    from = travel();
  }
  return curve_through(measured);
}

DragCurve curve_through(const std::vector<beam::CurvePoint>& measured)
{
  DragCurve curve;
  curve.measured = static_cast<Index>(measured.size());
  const auto softer = [](const beam::CurvePoint& a, const beam::CurvePoint& b) {
    return a.force / a.displacement < b.force / b.displacement;
  };
  const auto first = std::max_element(measured.begin(), measured.end(), softer);
  if (first == measured.end() || !(first->force > 0)) throw RunError("the pipe met no resistance");
  std::vector<beam::CurvePoint>& points = curve.backbone.points;
  for (auto point = first; point != measured.end(); ++point) {
    if (!(point->force > 0)) continue;
    points.push_back(*point);
    if (points.size() == 1) continue;
    const beam::CurvePoint& last = points[points.size() - 2];
    const Real most = last.force + curve.backbone.stiffness() * (point->displacement - last.displacement);
    if (point->force > most) points.back().force = most, ++curve.lowered;
  }
  curve.left_out = curve.measured - static_cast<Index>(points.size());
  return curve;
}

}  // namespace berm::slices
