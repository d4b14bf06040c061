// SPDX-License-Identifier: BSD-3-Clause
#include "io/writer_thread.hpp"

#include "os/threads.hpp"

#include <chrono>

namespace berm::io {

WriterThread::~WriterThread()
{
  if (!thread_.joinable()) return;
  {
    const std::lock_guard lock(mutex_);
    ends_ = true;
  }
  more_.notify_one();
  thread_.join();
}

BigIndex WriterThread::hand_over(std::function<void()> piece)
{
  std::unique_lock lock(mutex_);
  throw_failure(lock);
  pieces_.push(std::move(piece));
  ++handed_over_;
  if (!thread_.joinable()) try {
      thread_ = std::thread([this] {
        begin_lone_thread();
        work();
      });
    } catch (const std::exception&) {  // no thread, or no memory for one
      ends_ = true;
      lock.unlock();
      work();
      lock.lock();
      ends_ = false;
      throw_failure(lock);
      return handed_over_;
    }
  lock.unlock();
  more_.notify_one();
  return handed_over_;
}

void WriterThread::wait_for(BigIndex piece)
{
  std::unique_lock lock(mutex_);
  done_more_.wait(lock, [&] { return done_ >= piece; });
  throw_failure(lock);
}

void WriterThread::finish()
{
  wait_for(handed_over_);
}

void WriterThread::check()
{
  std::unique_lock lock(mutex_);
  throw_failure(lock);
}

void WriterThread::come_to_rest()
{
  std::unique_lock lock(mutex_);
  done_more_.wait(lock, [&] { return done_ >= handed_over_; });
}

void WriterThread::throw_failure(std::unique_lock<std::mutex>& lock)
{
  if (!failure_) return;
  const std::exception_ptr failure = std::exchange(failure_, nullptr);
  lock.unlock();
  std::rethrow_exception(failure);
}

/// Until all pieces are done and no more come.
void WriterThread::work()
{
  std::unique_lock lock(mutex_);
  while (true) {
    more_.wait(lock, [&] { return ends_ || !pieces_.empty(); });
    if (pieces_.empty()) return;
    const std::function<void()> piece = std::move(pieces_.front());
    pieces_.pop();
    const bool failed = failed_;
    lock.unlock();
    std::exception_ptr failure;
    const auto start = std::chrono::steady_clock::now();
    if (!failed) try {
        piece();
      } catch (...) {
        failure = std::current_exception();
      }
    lock.lock();
    busy_ += std::chrono::duration<Real>(std::chrono::steady_clock::now() - start).count();
    if (failure) failure_ = failure, failed_ = true;
    ++done_;
    done_more_.notify_all();
  }
}

}  // namespace berm::io
