// SPDX-License-Identifier: BSD-3-Clause
#include "macro_element_fit/fit.hpp"

#include "core/for_each_task.hpp"
#include "fit/least_squares.hpp"
#include "formulas/axial.hpp"
#include "macro_element/under_force.hpp"
#include "os/error.hpp"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <limits>

namespace berm::macro_element_fit {
namespace {

using Vector = Eigen::VectorXd;

/// H counts on a path where it is more than this part of V: elsewhere it is noise.
constexpr Real least_H_over_V = 0.1;

bool is_dragged(const Path& path)
{
  return path.largest_H() > least_H_over_V * path.largest_V();
}

/// V0 of fresh soil at some embedments: the mean of what all pushes had there.
struct Backbone {
  std::vector<Real> w, V;
};

Backbone backbone_of(const std::vector<Path>& paths)
{
  constexpr Real depths_over_D[] = {0.02, 0.05, 0.1, 0.15, 0.2, 0.25, 0.3, 0.4, 0.5, 0.6, 0.8, 1, 1.25, 1.5, 2, 2.5, 3, 4, 5};
  Backbone backbone;
  Real deepest = 0;
  for (const Path& path : paths)
    for (const PathPoint& p : path.push) deepest = std::max(deepest, p.w);
  const Real D = paths[0].diameter;
  const auto add = [&](Real w) {
    const Real reach = std::max(0.1 * w, 0.01 * D);
    Real n = 0, x = 0, xx = 0, y = 0, xy = 0;
    for (const Path& path : paths)
      for (const PathPoint& p : path.push)
        if (const Real d = p.w - w; std::abs(d) <= reach) n += 1, x += d, xx += d * d, y += p.V, xy += d * p.V;
    if (n < 1) return;
    const Real var = n * xx - x * x;  // a straight line through them, at w
    const Real V = n > 2 && var > 0 ? (xx * y - x * xy) / var : y / n;
    if (V > 0 && (backbone.V.empty() || V >= backbone.V.back())) backbone.w.push_back(w), backbone.V.push_back(V);
  };
  for (const Real depth : depths_over_D)
    if (depth * D < deepest * 0.98) add(depth * D);
  add(deepest);
  return backbone;
}

/// A parameter that is fitted, as a number without bounds.
struct Unknown {
  double Parameters::*member;
  Real low, high, unit;  ///< of the parameter over the unit; high infinite: only positive
  Real begin;
  Real inside(Real x) const { return unit * (std::isinf(high) ? low + std::exp(x) : low + (high - low) / (1 + std::exp(-x))); }
  Real outside(Real value) const
  {
    const Real v = value / unit - low;
    return std::isinf(high) ? std::log(v) : -std::log((high - low) / v - 1);
  }
};

/// Points on the way: of all paths' misfits by all unknowns.
class Problem {
public:
  Problem(const std::vector<Path>& paths) : paths_(paths), backbone_(backbone_of(paths))
  {
    constexpr Real any = std::numeric_limits<Real>::infinity();
    const Real D = paths[0].diameter;
    Real V = 0, lift = 0;
    for (const Path& path : paths) {
      V = std::max(V, path.largest_V());
      for (const PathPoint& p : path.points) lift = std::max(lift, -p.V);
    }
    base_ = {};
    base_.version = BERM_MACRO_ELEMENT_VERSION;
    base_.diameter = D;
    base_.uplift_ratio = lift > 0.01 * V ? lift / V : 0;
    base_.axial_friction = paths[0].friction;
    base_.axial_mobilisation = formulas::f114_axial_breakout_displacement(D).best.value;
    using P = Parameters;
    unknowns_ = {
        {&P::vertical_stiffness, 0, any, V / D, 40},
        {&P::horizontal_stiffness, 0, any, V / D, 25},
        {&P::peak_ratio, 0, any, 1, 0.4},
        {&P::surface_beta, base_.uplift_ratio, 0.5 + base_.uplift_ratio, 1, 0.05 + base_.uplift_ratio},
        {&P::surface_b1, 0.05, 0.98, 1, 0.5},
        {&P::surface_b2, 0.05, 0.98, 1, 0.5},
        {&P::flow_slope, 0, 20, 1, 1},
        {&P::flow_zero, -1, 0.9, 1, 0.4},
        {&P::flow_climb, 0, 3, 1, 0.2},
        {&P::first_yield, 0.5, 1, 1, 0.7},
        {&P::mobilisation_length, 1e-4, 1, D, 0.02},
        {&P::residual_ratio, 0.02, 1, 1, 0.7},
        {&P::softening_length, 0.01, 20, D, 0.5},
        {&P::berm_rate, 0, any, V / D / D, 0.5},
        {&P::berm_length, 0.05, 50, D, 2},
        {&P::berm_reach, 0.02, 3, D, 0.3},
    };
    Index count = 0;
    for (const Path& path : paths) count += 2 * static_cast<Index>(path.points.size());
    values_ = count;
  }

  Parameters parameters(const Vector& x) const
  {
    Parameters p = base_;
    for (std::size_t k = 0; k < unknowns_.size(); ++k) p.*unknowns_[k].member = unknowns_[k].inside(std::clamp<Real>(x[k], -30, 30));
    p.backbone_points = 0;
    for (std::size_t k = 0; k < backbone_.w.size() && p.backbone_points < BERM_MACRO_ELEMENT_MAX_POINTS; ++k) {
      const Real w = backbone_.w[k] - backbone_.V[k] / p.vertical_stiffness;
      if (!(w > (p.backbone_points > 0 ? p.backbone_w[p.backbone_points - 1] : 1e-4 * p.diameter))) continue;
      p.backbone_w[p.backbone_points] = w;
      p.backbone_V[p.backbone_points++] = backbone_.V[k];
    }
    return p;
  }

  Vector begin(Real flow_zero, Real berm_rate) const
  {
    Vector x(unknowns_.size());
    for (std::size_t k = 0; k < unknowns_.size(); ++k) {
      const Unknown& one = unknowns_[k];
      const Real value = one.member == &Parameters::flow_zero ? flow_zero : one.member == &Parameters::berm_rate ? berm_rate : one.begin;
      x[k] = one.outside(value * one.unit);
    }
    return x;
  }

  int unknowns() const { return static_cast<int>(unknowns_.size()); }
  int values() const { return static_cast<int>(values_); }
  void operator()(const Vector& x, Vector& f) const
  {
    constexpr Real refused = 1;  // a misfit of all points as large as the run's own numbers
    const Parameters p = parameters(x);
    f.setZero(values_);
    Index at = 0;
    for (const Path& path : paths_) {
      const auto n = static_cast<Index>(path.points.size());
      const Real weight = 1 / std::sqrt(static_cast<Real>(n)), H = path.largest_H(), V = path.largest_V(), D = path.diameter;
      try {
        if (p.backbone_points < 1) throw RunError("no V0");
        const Response response = follow(p, path);
        for (Index k = 0; k < n; ++k) {
          const PathPoint& point = path.points[k];
          f[at + 2 * k] = is_dragged(path) ? weight * (response.H[k] - point.H) / H : 0;
          f[at + 2 * k + 1] = weight * (point.by_force ? (response.w[k] - point.w) / D : (response.V[k] - point.V) / V);
        }
      } catch (const RunError&) {
        f.segment(at, 2 * n).setConstant(refused * weight);
      }
      at += 2 * n;
    }
  }

private:
  const std::vector<Path>& paths_;
  Backbone backbone_;
  Parameters base_;
  std::vector<Unknown> unknowns_;
  Index values_ = 0;
};

}  // namespace

Response follow(const Parameters& p, const Path& path)
try {
  const PathPoint& first = path.points[0];
  const bool from_above = first.w < 0.05 * p.diameter;
  const Real w = from_above ? 0 : first.w, V = from_above ? 0 : std::max<Real>(first.V, 0);
  const double begin[3] = {0, first.u, w};
  berm_macro_element_state state;
  if (const int error = berm_macro_element_start(&p, begin, V, &state); error != BERM_MACRO_ELEMENT_OK)
    throw RunError(
        fmt::format("the macro-element cannot begin with V = {:.4g} N/m at w = {:.4g} m: {}", V, w, berm_macro_element_error(error)));
  Response response;
  for (const PathPoint& point : path.points) {
    const double to[3] = {0, point.u, point.w};
    double F[3];
    if (point.by_force)
      state = macro_element::moved_under(p, state, 0, point.u, point.V);
    else if (const int error = berm_macro_element_step(&p, &state, to, &state, F, nullptr); error != BERM_MACRO_ELEMENT_OK)
      throw RunError(berm_macro_element_error(error));
    response.w.push_back(state.w);
    response.H.push_back(state.H);
    response.V.push_back(state.V);
  }
  return response;
} catch (const RunError& error) {
  throw RunError(fmt::format("{}: {}", path.name, error.what()));
}

Misfit misfit_of(const Path& path, const Response& response)
{
  Real H = 0, V = 0, w = 0, largest = 0;
  std::size_t by_force = 0;
  for (std::size_t k = 0; k < path.points.size(); ++k) {
    const PathPoint& point = path.points[k];
    H += (response.H[k] - point.H) * (response.H[k] - point.H);
    largest = std::max(largest, std::abs(response.H[k]));
    by_force += point.by_force;
    if (point.by_force)
      w += (response.w[k] - point.w) * (response.w[k] - point.w);
    else
      V += (response.V[k] - point.V) * (response.V[k] - point.V);
  }
  const auto n = static_cast<Real>(path.points.size()), forced = static_cast<Real>(by_force);
  Misfit misfit;
  if (is_dragged(path)) misfit.H = std::sqrt(H / n) / path.largest_H(), misfit.largest = largest / path.largest_H();
  if (forced < n) misfit.V = std::sqrt(V / (n - forced)) / path.largest_V();
  if (forced > 0) misfit.w = std::sqrt(w / forced) / path.diameter;
  misfit.end = (response.w.back() - path.points.back().w) / path.diameter;
  return misfit;
}

Parameters fit(const std::vector<Path>& paths)
{
  for (const Path& path : paths)
    if (std::abs(path.diameter - paths[0].diameter) > 1e-6 * paths[0].diameter)
      throw RunError(fmt::format("{} is of a pipe of {:.6g} m, {} of {:.6g} m: a macro-element is for one pipe", path.run.string(),
                                 path.diameter, paths[0].run.string(), paths[0].diameter));
  if (std::none_of(paths.begin(), paths.end(), [](const Path& path) { return path.push.size() > 2; }))
    throw RunError("no run pushes its pipe into virgin soil at a velocity, which gives V0 against embedment: add one");
  if (std::none_of(paths.begin(), paths.end(), is_dragged))
    throw RunError("no run drags its pipe, which gives the resistance to lateral motion: add one");
  const Problem problem(paths);
  constexpr std::array<std::array<Real, 2>, 4> begins = {{{0.25, 0.3}, {0.25, 2}, {0.6, 0.3}, {0.6, 2}}};
  std::array<Vector, begins.size()> found;
  std::array<Real, begins.size()> left{};
  for_each_task("fit", begins.size(), [&](Index k) {
    const fit::LeastSquares least = fit::least_squares(problem, problem.begin(begins[k][0], begins[k][1]), problem.values(),
                                                       {.difference = 1e-6, .evaluations = 80 * problem.unknowns(), .tolerance = 1e-5});
    found[k] = least.unknowns, left[k] = least.norm;
  });
  return problem.parameters(found[std::min_element(left.begin(), left.end()) - left.begin()]);
}

}  // namespace berm::macro_element_fit
