// SPDX-License-Identifier: BSD-3-Clause
#include "user_law/loaded_law.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <span>

#include "os/text_of_list.hpp"

namespace berm::user_law {

using material::UserIncrement;

namespace {

bool finite(const UserIncrement& increment, int state_variables)
{
  const auto is_finite = [](Real x) { return std::isfinite(x); };
  return std::all_of(increment.stress, increment.stress + 6, is_finite) &&
         std::all_of(increment.state, increment.state + state_variables, is_finite);
}

}  // namespace

LoadedLaw::LoadedLaw(const Function& function, const Constants& constants, const std::string& words, bool one_at_a_time)
    : function_(function),
      constants_(constants),
      words_(words),
      one_at_a_time_(one_at_a_time)
{
}

LoadedLaw::Before::Before(const UserIncrement& increment, int state_variables)
{
  std::copy_n(increment.stress, 6, stress);
  std::copy_n(increment.state, state_variables, state);
}

void LoadedLaw::Before::restore(UserIncrement& increment, int state_variables) const
{
  std::copy_n(stress, 6, increment.stress);
  std::copy_n(state, state_variables, increment.state);
}

void LoadedLaw::advance(UserIncrement& increment) const
{
  const Before before(increment, constants_.state_variables);
  bool tangent_given = false;
  const Answer answer = [&] {
    std::unique_lock lock(calls_, std::defer_lock);
    if (one_at_a_time_) lock.lock();
    const InsideCall inside(words_);
    const Answer followed = follow(increment, before, tangent_given, 0);
    if (followed == Answer::done && increment.with_tangent && !tangent_given) take_differences(before, increment);
    return followed;
  }();
  if (answer == Answer::done && finite(increment, constants_.state_variables)) return;
  note_failure(before, increment, answer);
  constexpr Real no_number = nan;
  std::fill_n(increment.stress, 6, no_number);
  std::fill_n(increment.state, constants_.state_variables, no_number);
  std::fill_n(increment.tangent, 36, no_number);
}

/// The increment, or as many equal parts of it as the law asks for; the tangent is that of the last.
Answer LoadedLaw::follow(UserIncrement& increment, const Before& before, bool& tangent_given, int halvings) const
{
  const Answer answer = std::visit([&](const auto& function) { return call(function, constants_, increment, tangent_given); }, function_);
  if (answer != Answer::smaller || halvings == max_halvings) return answer;
  before.restore(increment, constants_.state_variables);
  const Real time = increment.time;
  for (Real& strain : increment.strain) strain /= 2;
  increment.dt /= 2;
  const Answer of_halves = follow_halves(increment, tangent_given, halvings + 1);
  for (Real& strain : increment.strain) strain *= 2;
  increment.dt *= 2;
  increment.time = time;
  return of_halves;
}

Answer LoadedLaw::follow_halves(UserIncrement& increment, bool& tangent_given, int halvings) const
{
  const Answer first = follow(increment, Before(increment, constants_.state_variables), tangent_given, halvings);
  if (first != Answer::done) return first;
  increment.time += increment.dt;
  return follow(increment, Before(increment, constants_.state_variables), tangent_given, halvings);
}

/// One-sided differences of the law's own answer. The step is 1e-4 of the largest strain, and at least 1e-8, where round-off of a stress of E / 100 is
/// 1e-10 of the tangent.
void LoadedLaw::take_differences(const Before& before, UserIncrement& end) const
{
  Real step = 1e-8;
  for (const Real strain : end.strain) step = std::max(step, 1e-4 * std::abs(strain));
  std::fill_n(end.tangent, 36, 0.);
  for (int j = 0; j < (end.dimension == 2 ? 4 : 6); ++j) {
    UserIncrement beside;
    beside.dimension = end.dimension;
    beside.dt = end.dt;
    beside.time = end.time;
    std::copy_n(end.strain, 6, beside.strain);
    beside.strain[j] += step;
    before.restore(beside, constants_.state_variables);
    bool tangent_given = false;
    follow(beside, before, tangent_given, 0);
    for (int i = 0; i < 6; ++i) end.tangent[6 * i + j] = (beside.stress[i] - end.stress[i]) / step;
  }
}

void LoadedLaw::note_failure(const Before& before, const UserIncrement& increment, Answer answer) const
{
  const std::lock_guard lock(notes_);
  if (failed_) return;
  const char* why = answer == Answer::failed    ? "reports failure"
                    : answer == Answer::smaller ? "still asks for a smaller increment after ten halvings"
                                                : "gave a stress or a state variable that is not a number or infinite";
  failure_ = fmt::format("{} {}, for the stress ({}) Pa and the strain increment ({}) (xx, yy, zz, xy, yz, zx; engineering shear) "
                         "within {:.4g} s from t = "
                         "{:.6g} s",
                         words_, why, text_of_list(before.stress, ", ", "{:.6g}"), text_of_list(increment.strain, ", ", "{:.6g}"),
                         increment.dt, increment.time);
  if (constants_.state_variables > 0)
    failure_ += fmt::format("; state variables before: {}",
                            text_of_list(std::span(before.state, static_cast<std::size_t>(constants_.state_variables)), ", ", "{:.6g}"));
  failed_ = true;
}

std::string LoadedLaw::failure() const
{
  if (!failed_) return "";
  const std::lock_guard lock(notes_);
  return failure_;
}

void LoadedLaw::forget_failure() const
{
  const std::lock_guard lock(notes_);
  failed_ = false;
  failure_.clear();
}

}  // namespace berm::user_law
