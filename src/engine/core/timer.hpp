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

/// The table that Timers write to. One is current on a thread at a time (Use); without one, Timers do nothing.
class Timings {
public:
  /// In the order of first use since the table was cleared.
  std::vector<Timing> table() const;
  void clear() { slots_.clear(); }

  /// Makes a table current on this thread for the life of this object; the one before is current again behind it.
  class Use {
  public:
    explicit Use(Timings& timings);
    ~Use();
    Use(const Use&) = delete;
    Use& operator=(const Use&) = delete;

  private:
    Timings* before_;
  };

private:
  friend class Timer;
  struct Slot {
    const char* label;
    std::chrono::steady_clock::duration total{};
    BigIndex calls = 0;
  };
  std::size_t slot_of(const char* label);

  std::vector<Slot> slots_;
  std::chrono::steady_clock::duration inner_{};  ///< within the innermost Timer that runs, of those that have ended
};

/// Adds the life of this object, but that of others within it, to the timing of its label, a string literal, in the table that is current on this thread: no
/// time is in two rows. No table is cleared or replaced in that time.
class Timer {
public:
  explicit Timer(const char* label);
  ~Timer();
  Timer(const Timer&) = delete;
  Timer& operator=(const Timer&) = delete;

private:
  Timings* timings_;
  std::size_t slot_ = 0;
  std::chrono::steady_clock::time_point start_;
  std::chrono::steady_clock::duration inner_before_{};
};

}  // namespace berm
