// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "desk/connection.hpp"

#include <condition_variable>
#include <functional>
#include <list>
#include <mutex>

namespace berm::desk {

/// Connections of programs of this machine: it listens at 127.0.0.1 only. Each has a thread of its own, so that one that waits keeps no other from its answer. There are so many
/// places; where all are taken the oldest connection without the token gives way, else the oldest that waits for a request, else the newcomer.
class Listener {
public:
  static constexpr std::size_t places = 128;

  /// Port 0: any that is free. Throws RunError where it cannot be had.
  explicit Listener(int port);
  ~Listener();
  Listener(const Listener&) = delete;
  Listener& operator=(const Listener&) = delete;

  int port() const { return port_; }
  bool is_stopping() const { return stopping_; }
  /// Gives each connection to `serve`, until stop() and until all have ended.
  void listen(const std::function<void(Connection&)>& serve);
  /// Those that wait for a request end at once, others once they are answered.
  void stop();

private:
  using Open = std::list<Connection>::iterator;
  void take(int socket, const std::function<void(Connection&)>& serve);
  void end(Open connection);
  bool one_gives_way();

  int socket_ = -1, port_ = 0;
  std::mutex mutex_;
  std::condition_variable ended_;
  std::list<Connection> open_;  ///< the oldest first; some are cut and about to end
  std::atomic<bool> stopping_{false};
};

}  // namespace berm::desk
