// SPDX-License-Identifier: BSD-3-Clause
#include "user_law/trial.hpp"

#include "os/error.hpp"

#include <algorithm>
#include <bit>
#include <chrono>
#include <fmt/format.h>
#include <sched.h>
#include <thread>

namespace berm::user_law {
namespace {

using material::UserIncrement;

constexpr int increments = 64;

/// A point on its way through the trial's increments of strain, which two points have in other directions; what it came to, bit for bit.
class TrialPoint {
public:
  TrialPoint(const LoadedLaw& law, const TrialStart& start, int number) : law_(law), number_(number)
  {
    increment_.dimension = start.dimension;
    increment_.dt = 1e-3;
    for (int k = 0; k < 3; ++k) increment_.stress[k] = -start.pressure;
    std::copy(start.state.begin(), start.state.end(), increment_.state);
  }

  /// The next increment; a tenth of them is unloading. Where the law has failed it is not called again.
  void advance()
  {
    if (std::isnan(increment_.stress[0])) return;
    constexpr Real size = 2e-5;
    const Real sign = count_ % 10 == 9 ? -1 : 1, other = number_ == 0 ? 1 : -0.7;
    const Real strain[6] = {-1, 0.3 * other, 0, 0.8 * other, 0.5, -0.2 * other};
    for (int k = 0; k < 6; ++k) increment_.strain[k] = increment_.dimension == 2 && k > 3 ? 0 : size * sign * strain[k];
    law_.advance(increment_);
    increment_.time += increment_.dt;
    ++count_;
    const auto note = [&](Real x) { bits_.push_back(std::bit_cast<std::uint64_t>(x)); };
    std::for_each_n(increment_.stress, 6, note);
    std::for_each_n(increment_.state, law_.constants().state_variables, note);
  }
  const std::vector<std::uint64_t>& bits() const { return bits_; }

private:
  const LoadedLaw& law_;
  int number_, count_ = 0;
  UserIncrement increment_;
  std::vector<std::uint64_t> bits_;
};

std::vector<std::uint64_t> path_of(const LoadedLaw& law, const TrialStart& start, int number)
{
  TrialPoint point(law, start, number);
  for (int k = 0; k < increments; ++k) point.advance();
  return point.bits();
}

}  // namespace

void refuse_failing(const LoadedLaw& law, const TrialStart& start)
{
  UserIncrement increment;
  increment.dimension = start.dimension;
  increment.dt = 1e-3;
  for (int k = 0; k < 3; ++k) increment.stress[k] = -start.pressure;
  std::copy(start.state.begin(), start.state.end(), increment.state);
  law.advance(increment);
  const std::string failure = law.failure();
  law.forget_failure();
  if (!failure.empty()) throw InputError(fmt::format("a trial without strain fails: {}", failure));
}

void refuse_memory(const LoadedLaw& law, const TrialStart& start)
{
  const std::vector<std::uint64_t> one = path_of(law, start, 0), other = path_of(law, start, 1);
  TrialPoint first(law, start, 0), second(law, start, 1);
  for (int k = 0; k < increments; ++k) {
    first.advance();
    second.advance();
  }
  law.forget_failure();
  if (first.bits() != one || second.bits() != other)
    throw InputError(
        fmt::format("{} gives other results when calls for different points alternate: it keeps variables from one call to the next (SAVE, "
                    "COMMON, DATA, static), which all points would share; keep them in its state variables",
                    law.words()));
}

void refuse_unknown_arguments(const LoadedLaw& law, const TrialStart& start)
{
  const Umat* const umat = std::get_if<Umat>(&law.function());
  if (umat == nullptr) return;
  struct Argument {
    const char* name;
    Unknown changed;
  };
  const Argument arguments[] = {{"STRAN, the total strain", {.stran = 1e-3}},
                                {"COORDS", {.coords = 1}},
                                {"CELENT", {.celent = 1}},
                                {"TEMP", {.temp = 1}},
                                {"PREDEF", {.predef = 1}},
                                {"DFGRD0 or DFGRD1, the deformation gradient", {.stretch = 1.001}},
                                {"NOEL or NPT", {.number = 1}}};
  const std::vector<std::uint64_t> expected = path_of(law, start, 0);
  law.forget_failure();
  for (const Argument& argument : arguments) {
    const LoadedLaw changed(Umat{umat->function, argument.changed}, law.constants(), law.words(), true);
    if (path_of(changed, start, 0) != expected)
      throw InputError(fmt::format("{} uses {}, which berm does not give it; keep what it needs in its state variables or properties",
                                   law.words(), argument.name));
  }
}

namespace {

/// OpenMP binds the first thread to a processor, which the threads that it starts inherit: there they would never run at a time.
void leave_the_processor_of_the_first_thread()
{
  cpu_set_t all;
  CPU_ZERO(&all);
  for (int k = 0; k < CPU_SETSIZE; ++k) CPU_SET(k, &all);
  sched_setaffinity(0, sizeof all, &all);
}

}  // namespace

bool safe_in_threads(const LoadedLaw& law, const TrialStart& start)
{
  const std::vector<std::uint64_t> expected[2] = {path_of(law, start, 0), path_of(law, start, 1)};
  std::atomic<int> done[2] = {0, 0};
  std::atomic<bool> same = true;
  const auto go_on = [&](int number) {
    constexpr int paths = 150;
    constexpr std::chrono::milliseconds least(30), most(1000);
    const auto begin = std::chrono::steady_clock::now();
    // Each goes on until the other has done its part too, so that they meet also where the processor is shared with others.
    while (same) {
      const auto passed = std::chrono::steady_clock::now() - begin;
      if ((std::min<int>(done[0], done[1]) >= paths && passed > least) || passed > most) return;
      if (path_of(law, start, number) != expected[number]) same = false;
      ++done[number];
    }
  };
  std::thread beside([&] {
    leave_the_processor_of_the_first_thread();
    go_on(1);
  });
  go_on(0);
  beside.join();
  law.forget_failure();
  return same;
}

}  // namespace berm::user_law
