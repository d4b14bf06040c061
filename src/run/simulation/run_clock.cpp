// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/simulation/run_place_resume_test.cpp
#include "simulation/run_clock.hpp"

#include <algorithm>
#include <ctime>
#include <sstream>

namespace berm::simulation {

std::vector<Timing> RunClock::loops() const
{
  std::vector<Timing> all = earlier_loops_;
  for (const Timing& loop : timings_.table()) {
    const auto same = std::find_if(all.begin(), all.end(), [&](const Timing& t) { return t.label == loop.label; });
    if (same == all.end()) {
      all.push_back(loop);
    } else {
      same->seconds += loop.seconds;
      same->calls += loop.calls;
    }
  }
  return all;
}

/// Of all threads of this process, s.
Real RunClock::processors_now()
{
  timespec now{};
  ::clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<Real>(now.tv_sec) + 1e-9 * static_cast<Real>(now.tv_nsec);
}

void RunClock::archive(Archive& k)
{
  Real wall = this->wall();
  std::string labels;
  std::vector<Real> seconds;
  std::vector<BigIndex> calls;
  for (const Timing& loop : loops()) {
    labels += loop.label + '\n';
    seconds.push_back(loop.seconds);
    calls.push_back(loop.calls);
  }
  Real processors = this->processors();
  k("wall", wall);
  k("processors", processors);
  for (const auto& [name, part] : {std::pair{"steps", &parts_.steps},
                                   {"rows", &parts_.rows},
                                   {"frames", &parts_.frames},
                                   {"checkpoints", &parts_.checkpoints},
                                   {"beside", &parts_.beside}})
    k(name, *part);
  k("loops", labels);
  k("seconds", seconds);
  k("calls", calls);
  if (!k.reads()) return;
  earlier_ = wall;
  earlier_processors_ = processors;
  earlier_loops_.clear();
  std::istringstream lines(labels);
  for (std::string label; std::getline(lines, label);) earlier_loops_.push_back({label, 0, 0});
  if (seconds.size() != earlier_loops_.size() || calls.size() != earlier_loops_.size()) k.refuse("its table of loops is incomplete");
  for (std::size_t n = 0; n < earlier_loops_.size(); ++n) {
    earlier_loops_[n].seconds = seconds[n];
    earlier_loops_[n].calls = calls[n];
  }
}

}  // namespace berm::simulation
