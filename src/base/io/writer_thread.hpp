// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "os/numbers.hpp"

#include <condition_variable>
#include <exception>
#include <functional>
#include <mutex>
#include <queue>
#include <thread>
#include <utility>

namespace berm::io {

/// A thread that does what it is handed, one piece after the other, while the thread that hands it over continues: it writes files, and waits for the disk. It begins with
/// the first piece; where the system gives no thread, pieces are done by the one that hands them over. Of pieces that throw, the first ends its work: those
/// behind it are left out, and what it threw is thrown once, by the next of the functions below.
class WriterThread {
public:
  WriterThread() = default;
  /// Does what was handed over before.
  ~WriterThread();
  WriterThread(const WriterThread&) = delete;
  WriterThread& operator=(const WriterThread&) = delete;

  /// Hands a piece over, and numbers it from 1 on.
  BigIndex hand_over(std::function<void()> piece);
  /// Waits until the piece of this number is done, and with it all before it.
  void wait_for(BigIndex piece);
  /// Waits until all are done.
  void finish();
  /// Does not wait.
  void check();
  /// Time that pieces took since it was asked for last, s; to be asked for when all are done.
  Real take_busy() { return std::exchange(busy_, 0); }
  /// Waits until all are done, and leaves what was thrown to the next function.
  void come_to_rest();

private:
  void work();
  void throw_failure(std::unique_lock<std::mutex>& lock);

  std::mutex mutex_;
  std::condition_variable more_, done_more_;
  std::queue<std::function<void()>> pieces_;
  BigIndex handed_over_ = 0, done_ = 0;
  bool ends_ = false, failed_ = false;
  std::exception_ptr failure_;
  Real busy_ = 0;  ///< s
  std::thread thread_;
};

}  // namespace berm::io
