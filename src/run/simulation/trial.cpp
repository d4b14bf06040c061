// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/simulation/trial_test.cpp
#include "simulation/trial.hpp"

#include "bodies/particle_position.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace berm::simulation {

void Trial::begin_stage(bool counts)
{
  counts_ = counts;
  times_.clear();
  movements_.clear();
}

void Trial::note(Real movement)
{
  movement_ = movement;
  failed_ = failed_ || (counts_ && movement > limit_);
}

void Trial::note(Real time, Real movement)
{
  note(movement);
  times_.push_back(time);
  movements_.push_back(movement);
}

bool Trial::flows_on() const
{
  constexpr Real flow = 0.1, least = 1e-3;  // of the movement, and of the limit
  if (times_.empty() || times_.front() == times_.back()) return false;
  const Real middle = (times_.front() + times_.back()) / 2;
  const std::size_t after = std::lower_bound(times_.begin(), times_.end(), middle) - times_.begin();
  const Real part = (middle - times_[after - 1]) / (times_[after] - times_[after - 1]);
  const Real half = movements_.back() - std::lerp(movements_[after - 1], movements_[after], part);
  return half > flow * movements_.back() && half > least * limit_;
}

void Trial::end_flow(Real overstress)
{
  constexpr Real of_yielding_soil =
      1e-4;  // soil whose strength is x too small has some x / 10 while it flows; soil that consolidates has next to none
  const bool flows = flows_on();
  flowed_ = flows && overstress > of_yielding_soil;
  end(!failed() && (!flows || overstress == 0));
}

run_folder::Summary::Checks Trial::checks() const
{
  run_folder::Summary::Checks checks = {
      {"soil_failed", failed()}, {"soil_at_rest", rests_ && !failed()}, {"soil_movement_m", movement_}, {"soil_movement_limit_m", limit_}};
  if (std::isfinite(time_factor_)) checks.emplace_back("time_factor_of_last_stage", time_factor_);
  return checks;
}

std::string Trial::words(Real factor) const
{
  const std::string what = no_equilibrium_ ? "it does not reach equilibrium"
                           : flowed_       ? fmt::format("it keeps flowing, after {:.3g} m", movement_)
                                           : fmt::format("it has moved by {:.3g} m, and counts as failed from {:.3g} m", movement_, limit_);
  const char* verdict = failed() ? "fails" : rests_ ? "stands" : "has not failed, and is still moving";
  return fmt::format("with its strength divided by {:.6g} the soil {}: {}{}", factor, verdict, what,
                     failed() || rests_ ? "" : "; give the last stage more time");
}

void Trial::archive(Archive& k)
{
  k("movement", movement_);
  k("counts", counts_);
  k("failed", failed_);
  k("no_equilibrium", no_equilibrium_);
  k("times", times_);
  k("movements", movements_);
  if (times_.size() != movements_.size()) k.refuse("its times and movements are not as many");
}

void WindowMeans::note(Real since, Real value)
{
  if (since < now_) *this = WindowMeans(length_);
  now_ = since;
  if (since - begin_ >= length_ && numbers_ > 0) {
    before_ = last_;
    last_ = sum_ / numbers_;
    ++count_;
    begin_ = since;
    sum_ = numbers_ = 0;
  }
  sum_ += value;
  ++numbers_;
}

void WindowMeans::archive(Archive& k)
{
  k("window_begin", begin_);
  k("window_now", now_);
  k("window_sum", sum_);
  k("window_numbers", numbers_);
  k("window_last", last_);
  k("window_before", before_);
  k("window_count", count_);
}

template <int dim>
void ParticlePlaces<dim>::note(const problem::State<dim>& state)
{
  places_.resize(state.particles.size());
  for (std::size_t body = 0; body < places_.size(); ++body) {
    const bodies::Particles<dim>& particles = state.particles[body];
    places_[body].resize(static_cast<std::size_t>(dim * particles.size()));
    particles.visit([&](Index, Index b, int l) {
      const bodies::Block<dim>& block = particles.block(b);
      const Vec<dim> x = position_of(block, l);
      for (int d = 0; d < dim; ++d) places_[body].at(static_cast<std::size_t>(dim * block.id[l] + d)) = x[d];
    });
  }
}

template <int dim>
Real ParticlePlaces<dim>::largest_movement(const problem::State<dim>& state) const
{
  Real largest = 0;
  for (std::size_t body = 0; body < places_.size(); ++body) {
    const bodies::Particles<dim>& particles = state.particles[body];
    particles.visit([&](Index, Index b, int l) {
      const bodies::Block<dim>& block = particles.block(b);
      Vec<dim> moved = position_of(block, l);
      for (int d = 0; d < dim; ++d) moved[d] -= places_[body][static_cast<std::size_t>(dim * block.id[l] + d)];
      largest = std::max(largest, moved.squaredNorm());
    });
  }
  return std::sqrt(largest);
}

template <int dim>
void ParticlePlaces<dim>::archive(Archive& k)
{
  for (std::size_t body = 0; body < places_.size(); ++body) k.fixed("places_" + std::to_string(body), places_[body]);
}

template class ParticlePlaces<2>;
template class ParticlePlaces<3>;

}  // namespace berm::simulation
