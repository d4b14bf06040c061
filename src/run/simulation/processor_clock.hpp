// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/types.hpp"

#include <ctime>

namespace berm::simulation {

/// The time that a processor has worked for this thread since the clock was made, s: that which other programs take from it does not count.
class ProcessorClock {
public:
  Real passed() const { return now() - begin_; }

private:
  static Real now()
  {
    timespec t{};
    ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
    return static_cast<Real>(t.tv_sec) + 1e-9 * static_cast<Real>(t.tv_nsec);
  }
  Real begin_ = now();
};

}  // namespace berm::simulation
