// SPDX-License-Identifier: BSD-3-Clause
#include "fem/contact_step.hpp"

#include "core/timer.hpp"
#include "fem/contact_force.hpp"

#include <Eigen/LU>
#include <algorithm>

namespace berm::fem {
namespace {

constexpr int max_steps = 40, max_searches = 30;
constexpr Real rounding = 1e-10;  // relative to the forces: residual of the converged contact, whose law is piecewise linear
constexpr Real curved =
    1e-5;  // the same in large deformations, where gap and normal turn, and the residuals of the next iteration see what is left
constexpr Real shortest = 1e-3;        // of a direction, where the residual decides
constexpr Real enough_descent = 0.01;  // the line search ends at a slope of this fraction of the first one

}  // namespace

ContactStep::ContactStep(const FemModel& model) : model_(model)
{
  if (model.contact_count() == 0) return;
  for (const FemContactPoint& point : model.contact)
    for (int d = 0; d < 2; ++d) unknowns_.push_back(2 * point.node + d);
  for (Index unknown = model.rigid_unknown(); unknown < model.pressure_unknown(); ++unknown) unknowns_.push_back(unknown);
  const auto n = static_cast<Eigen::Index>(unknowns_.size());
  prescribed_.resize(n);
  for (Vector* v : {&change_, &force_, &step_, &first_step_, &direction_, &unbalanced_}) v->resize(n);
  for (RowMatrix* m : {&soil_, &matrix_, &stiffness_}) m->resize(n, n);
}

/// The forces of the interface on the unknowns that are not prescribed, and their derivative.
void ContactStep::evaluate(const FemState& begin, const Vector& step, bool with_stiffness)
{
  force_.setZero();
  if (with_stiffness) stiffness_.setZero();
  const auto points = static_cast<int>(model_.contact.size());
  for (int k = 0; k < points; ++k) {
    const int rigid = 2 * points + 3 * static_cast<int>(model_.contact[static_cast<std::size_t>(k)].contact);
    const int at[5] = {2 * k, 2 * k + 1, rigid, rigid + 1, rigid + 2};
    Eigen::Matrix<Real, 5, 1> moved;
    for (int i = 0; i < 5; ++i) moved[i] = change_[at[i]] + step[at[i]];
    const ContactForce now = contact_force(model_, static_cast<std::size_t>(k), begin, moved);
    for (int i = 0; i < 5; ++i) {
      if (prescribed_[at[i]]) continue;
      force_[at[i]] += now.force[i];
      if (!with_stiffness) continue;
      for (int j = 0; j < 5; ++j) stiffness_(at[i], at[j]) += now.stiffness(i, j);
    }
  }
}

/// Step length along the direction: where the slope of the energy has nearly vanished.
Real ContactStep::step_length(const FemState& begin, const Vector& load)
{
  const Real first = direction_.dot(unbalanced_), constant = direction_.dot(soil_ * step_ - load),
             linear = direction_.dot(soil_ * direction_);
  const auto slope = [&](Real at) {
    evaluate(begin, step_ + at * direction_, false);
    return constant + at * linear - direction_.dot(force_);
  };
  Real at = 1, low = 0, low_slope = first, high = 1, high_slope = slope(1), here = high_slope;
  if (here <= 0) return at;
  for (int k = 1; k < max_searches && std::abs(here) > enough_descent * std::abs(first); ++k) {
    // Regula falsi converges slowly at a kink of the slope: every third step bisects.
    at = k % 3 == 0 ? (low + high) / 2 : low + (high - low) * std::clamp(-low_slope / (high_slope - low_slope), 0.05, 0.95);
    here = slope(at);
    if (here < 0)
      low = at, low_slope = here;
    else
      high = at, high_slope = here;
  }
  return at;
}

/// The same of soil whose matrix has no energy: the residual becomes smaller, or as small as halves of the direction make it.
Real ContactStep::step_length_by_residual(const FemState& begin, const Vector& load)
{
  Real best = 1, least = infinity;
  for (Real at = 1; at > shortest; at /= 2) {
    evaluate(begin, step_ + at * direction_, false);
    const Real now = (soil_ * (step_ + at * direction_) - load - force_).norm();
    if (now < least) least = now, best = at;
    if (now < (1 - 0.1 * at) * unbalanced_.norm()) break;
  }
  return best;
}

bool ContactStep::find(const FemState& begin, const std::vector<Real>& change, const Assembly& assembly, std::span<const Real> soil,
                       std::span<Real> load_and_step)
{
  const Timer timer("solve contact");
  const auto n = static_cast<Eigen::Index>(unknowns_.size());
  for (Eigen::Index k = 0; k < n; ++k) {
    prescribed_[k] = static_cast<char>(assembly.prescribed(unknowns_[k]));
    change_[k] = change[unknowns_[k]];
  }
  const Eigen::Map<const RowMatrix> matrix(soil.data(), n, n);
  if (model_.unsymmetric)
    soil_ = matrix;
  else
    soil_ = matrix.selfadjointView<Eigen::Lower>();
  for (Eigen::Index k = 0; k < n; ++k)
    if (unknowns_[k] >= model_.rigid_unknown()) soil_(k, k) += assembly.inertia(unknowns_[k]);
  Eigen::Map<Vector> load(load_and_step.data(), n);
  bool prescribed_moves = false;
  for (Eigen::Index k = 0; k < n; ++k) prescribed_moves = prescribed_moves || (prescribed_[k] && load[k] != 0);
  step_.setZero();
  first_step_.setZero();
  bool converged = false;
  for (int k = 0; k < max_steps && !converged; ++k) {
    evaluate(begin, step_, true);
    unbalanced_ = soil_ * step_ - load - force_;
    converged = k > 0 && unbalanced_.norm() <= (model_.settings.large_deformation ? curved : rounding) * (load.norm() + force_.norm());
    if (converged) break;
    matrix_ = soil_ - stiffness_;
    direction_ = -matrix_.partialPivLu().solve(unbalanced_);
    if (!direction_.allFinite()) break;
    for (Eigen::Index i = 0; i < n; ++i)
      if (prescribed_[i]) direction_[i] = load[i] - step_[i];  // exact to the last bit
    if (k == 0) first_step_ = direction_;
    // In the first step, the slope does not include the work of moving prescribed unknowns.
    const bool whole = k == 0 && prescribed_moves;
    step_ += (whole ? 1 : model_.unsymmetric ? step_length_by_residual(begin, load) : step_length(begin, load)) * direction_;
  }
  load = converged ? step_ : first_step_;
  return converged;
}

}  // namespace berm::fem
