// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/types.hpp"

#include <chrono>
#include <string>
#include <vector>

namespace berm {

/// Time spent under one label, over all calls.
struct Timing {
  std::string label;
  Real seconds = 0;
  BigIndex calls = 0;
};

/// All timings since the last reset, in order of first use.
std::vector<Timing> timings();
void reset_timings();

/// Adds the life of this object to the timing of its label, a string literal. For the main thread only.
class Timer {
public:
  explicit Timer(const char* label);
  ~Timer();
  Timer(const Timer&) = delete;
  Timer& operator=(const Timer&) = delete;

private:
  Index slot_;
  std::chrono::steady_clock::time_point start_;
};

}  // namespace berm
