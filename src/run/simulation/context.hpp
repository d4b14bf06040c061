// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/error.hpp"
#include "core/threads.hpp"
#include "core/timer.hpp"

#include <atomic>
#include <functional>
#include <memory>
#include <spdlog/sinks/sink.h>

namespace berm::simulation {

/// What a run has from the program that calls it: threads, a table of timings, who may stop it, and where its messages go. A process has one at a time,
/// since it has one set of OpenMP threads and one default logger: a second throws RunError. After it the calling thread is as it was.
class Context {
public:
  /// threads: 0 = one for each processor. `stop` is called after every step (by ranks: every sixteenth): once true it stays true, and the run ends with a checkpoint. Messages go to
  /// stderr, or to `messages`, and to the run's log.
  explicit Context(int threads = 0, std::function<bool()> stop = {}, std::shared_ptr<spdlog::sinks::sink> messages = {})
      : threads_(threads),
        stop_(std::move(stop)),
        messages_(std::move(messages))
  {
  }

  int threads() const { return threads_.count(); }
  bool asked_to_stop() const { return stop_ && stop_(); }
  Timings& timings() { return timings_; }
  const std::shared_ptr<spdlog::sinks::sink>& messages() const { return messages_; }

private:
  struct OnlyOne {
    static inline std::atomic<bool> exists{false};
    OnlyOne()
    {
      if (exists.exchange(true)) throw RunError("a process has one run at a time: the other must end first");
    }
    ~OnlyOne() { exists = false; }
    OnlyOne(const OnlyOne&) = delete;
    OnlyOne& operator=(const OnlyOne&) = delete;
  };

  OnlyOne only_one_;
  Threads threads_;
  Timings timings_;
  Timings::Use use_{timings_};
  std::function<bool()> stop_;
  std::shared_ptr<spdlog::sinks::sink> messages_;
};

/// "2 threads", or "4 ranks of 2 threads".
std::string words_of_workers(const Context& context);

}  // namespace berm::simulation
