// SPDX-License-Identifier: BSD-3-Clause
#include "verification/remaining.hpp"

#include <algorithm>

namespace berm::verification {
namespace {

/// Finished jobs tell how fast the machine is once they took more than this, s.
constexpr Real weight_of_expectation = 60;

/// Puts the mean of the known times in the place of those that are not known.
void fill_in(std::vector<Real>& times)
{
  Real sum = 0, known = 0;
  for (const Real time : times)
    if (!std::isnan(time)) sum += time, ++known;
  for (Real& time : times)
    if (std::isnan(time)) time = sum / known;
}

}  // namespace

Remaining::Remaining(const std::vector<jobs::Job>& jobs, int at_once)
    : order_(by_time(jobs)),
      begin_(jobs.size(), 0),
      ended_(jobs.size(), false),
      at_once_(static_cast<std::size_t>(at_once)),
      took_(weight_of_expectation),
      was_expected_(weight_of_expectation)
{
  for (const jobs::Job& job : jobs) expected_.push_back(expected_time(job));
  fill_in(expected_);
  while (begun_ < std::min(at_once_, order_.size())) begin_next(0);
}

void Remaining::begin_next(Real now)
{
  if (begun_ < order_.size()) begin_[order_[begun_++]] = now;
}

void Remaining::end(std::size_t job, bool finished, Real now)
{
  ended_[job] = true;
  if (finished) {
    took_ += now - begin_[job];
    was_expected_ += expected_[job];
  }
  begin_next(now);
}

std::size_t Remaining::running() const
{
  return begun_ - static_cast<std::size_t>(std::count(ended_.begin(), ended_.end(), true));
}

Real Remaining::seconds(Real now) const
{
  std::vector<Real> busy_for(at_once_, 0);
  for (std::size_t k = 0; k < order_.size(); ++k) {
    const std::size_t job = order_[k];
    if (ended_[job]) continue;
    const Real time = expected_[job] * took_ / was_expected_;
    Real& first_free = *std::min_element(busy_for.begin(), busy_for.end());
    first_free += k < begun_ ? std::max<Real>(0, time - (now - begin_[job])) : time;
  }
  return *std::max_element(busy_for.begin(), busy_for.end());
}

}  // namespace berm::verification
