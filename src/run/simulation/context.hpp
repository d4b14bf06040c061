// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/timer.hpp"
#include "os/error.hpp"
#include "os/threads.hpp"
#include "simulation/after_run.hpp"

#include <atomic>
#include <functional>
#include <memory>
#include <optional>
#include <spdlog/sinks/sink.h>

namespace berm::simulation {

/// What a run has from the program that calls it: threads, a table of timings, who may stop it, where its messages go, and what is made of it after its end. A process has one at a time that
/// works, since it has one set of OpenMP threads and one default logger: a second throws RunError. After it the calling thread is as it was. One of a single
/// thread can pause, and others work meanwhile.
class Context {
public:
  /// threads: 0 = one for each processor. `stop` is called after every step (by ranks: every sixteenth): once true it stays true, and the run ends with a checkpoint. Messages go to
  /// stderr, or to `messages`, and to the run's log.
  explicit Context(int threads = 0, std::function<bool()> stop = {}, std::shared_ptr<spdlog::sinks::sink> messages = {},
                   AfterRun after = {})
      : asked_threads_(threads),
        stop_(std::move(stop)),
        messages_(std::move(messages)),
        after_(std::move(after))
  {
    go_on();
  }

  int threads() const { return threads_; }
  bool asked_to_stop() const { return stop_ && stop_(); }
  Timings& timings() { return timings_; }
  const std::shared_ptr<spdlog::sinks::sink>& messages() const { return messages_; }
  const AfterRun& after() const { return after_; }

  /// Gives the calling thread back; of several threads, which are bound to their processors, it keeps them.
  void pause()
  {
    if (threads_ == 1) at_work_.reset();
  }
  void go_on()
  {
    if (!at_work_) threads_ = at_work_.emplace(asked_threads_, timings_).threads.count();
  }

private:
  struct AtWork {
    struct OnlyOne {
      static inline std::atomic<bool> exists{false};
      OnlyOne()
      {
        if (exists.exchange(true))
          throw RunError(
              "a process has one run at a time that works: the other must return or end first, and one of several threads must end");
      }
      ~OnlyOne() { exists = false; }
      OnlyOne(const OnlyOne&) = delete;
      OnlyOne& operator=(const OnlyOne&) = delete;
    };
    AtWork(int count, Timings& timings) : threads(count), use(timings) {}

    OnlyOne only_one;
    Threads threads;
    Timings::Use use;
  };

  int asked_threads_, threads_ = 0;
  Timings timings_;
  std::optional<AtWork> at_work_;
  std::function<bool()> stop_;
  std::shared_ptr<spdlog::sinks::sink> messages_;
  AfterRun after_;
};

/// "2 threads", or "4 ranks of 2 threads".
std::string words_of_workers(const Context& context);

}  // namespace berm::simulation
