// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/element/run_test_test.cpp
#include "element/specimen.hpp"

#include "material/laws.hpp"

#include <algorithm>

namespace berm::element {
namespace {

/// The state of a law at the start, under this stress.
std::vector<Real> state_at_start(const material::Material& material, const SymTensor<3>& stress)
{
  std::vector<Real> state(static_cast<std::size_t>(material::state_size(material)), 0.);
  material::initial_state(material, stress, state.data());
  return state;
}

}  // namespace

Specimen::Specimen(const material::Material& material, const SymTensor<3>& stress)
    : law_(std::make_shared<material::PreparedMaterial>(material::prepare(material))),
      stress_(stress),
      state_(state_at_start(material, stress))
{
}

void Specimen::update(SymTensor<3>& stress, const SymTensor<3>& strain, Real dt, std::vector<Real>& state) const
{
  const material::Increment<3, Real> increment{strain, dt, time_};
  std::visit([&](const auto& law) { material::update(law, stress, increment, state.data()); }, *law_);
}

SymTensor<3> Specimen::stress_after(const SymTensor<3>& strain, Real dt) const
{
  SymTensor<3> stress = stress_;
  std::vector<Real> state = state_;
  update(stress, strain, dt, state);
  return stress;
}

void Specimen::deform(const SymTensor<3>& strain, Real dt)
{
  update(stress_, strain, dt, state_);
  for (int k = 0; k < tensor_size<3>; ++k) strain_[k] += strain[k];
  time_ += dt;
}

namespace {

struct Point {
  Real x, excess;
};

/// An interval whose ends have excesses of different signs, low.excess < 0 < high.excess; or one point that solves it.
struct Bracket {
  Point low, high;
};

std::optional<Bracket> find_bracket(const std::function<Real(Real)>& excess, const BalanceRequest& request, const Point& first)
{
  const Real direction = first.excess < 0 ? 1 : -1;
  Point near = first;
  for (Real step = request.step;; step *= 2) {
    const Real x = std::clamp(first.x + direction * step, -request.limit, request.limit);
    if (x == near.x) return std::nullopt;
    const Point far{x, excess(x)};
    if (!std::isfinite(far.excess)) return std::nullopt;
    if (far.excess * direction >= 0) return direction > 0 ? Bracket{near, far} : Bracket{far, near};
    near = far;
  }
}

}  // namespace

std::optional<Real> balance(const std::function<Real(Real)>& excess, const BalanceRequest& request)
{
  const Real guess = std::clamp(request.guess, -request.limit, request.limit);
  const Point first{guess, excess(guess)};
  if (std::abs(first.excess) <= request.tolerance) return first.x;
  if (!std::isfinite(first.excess)) return std::nullopt;
  std::optional<Bracket> bracket = find_bracket(excess, request, first);
  if (!bracket) return std::nullopt;
  auto [low, high] = *bracket;
  if (std::abs(low.excess) <= request.tolerance) return low.x;
  if (std::abs(high.excess) <= request.tolerance) return high.x;
  Real low_weight = low.excess, high_weight = high.excess;
  constexpr int most = 200;
  for (int n = 0; n < most; ++n) {
    constexpr int every = 8;  // of them bisects
    const bool bisect = n % every == every - 1;
    const Real x = bisect ? (low.x + high.x) / 2 : low.x - low_weight * (high.x - low.x) / (high_weight - low_weight);
    const Point point{x, excess(x)};
    if (!std::isfinite(point.excess)) return std::nullopt;
    if (std::abs(point.excess) <= request.tolerance) return point.x;
    if (point.excess < 0) {
      low = point;
      low_weight = point.excess;
      high_weight /= 2;
    } else {
      high = point;
      high_weight = point.excess;
      low_weight /= 2;
    }
  }
  const Point& best = std::abs(low.excess) < std::abs(high.excess) ? low : high;
  return std::abs(best.excess) <= request.jump ? std::optional(best.x) : std::nullopt;
}

}  // namespace berm::element
