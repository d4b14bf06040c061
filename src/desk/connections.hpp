// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <condition_variable>
#include <list>
#include <mutex>

namespace berm::desk {

/// One connection of a client; its flags are those of Connections.
struct Connection {
  using Clock = std::chrono::steady_clock;

  int socket;
  Clock::time_point deadline;  ///< of what the client does next
  bool has_token = false, is_answered = false, is_cut = false;
};

/// The connections of a server. There are so many places; where all are taken the oldest connection without the token gives way, else the oldest that waits for a request, else
/// the newcomer. A client that does not keep its deadline loses its connection: one that sends a byte now and then holds nothing for long.
class Connections {
public:
  static constexpr std::size_t places = 128;
  static constexpr std::chrono::seconds time_of_head{10}, time_of_body{20}, time_to_take{60};

  Connection* add(int socket);
  void remove(const Connection* connection);
  void trust(Connection& connection);
  void wait_for_request(Connection& connection) { set(connection, Connection::Clock::now() + time_of_head, false); }
  void wait_for_body(Connection& connection) { set(connection, Connection::Clock::now() + time_of_body, true); }
  void work_on_answer(Connection& connection) { set(connection, Connection::Clock::time_point::max(), true); }
  void wait_until_taken(Connection& connection) { set(connection, Connection::Clock::now() + time_to_take, true); }

  /// Cuts those that are late, until stop() and until none is left.
  void watch();
  /// Those that wait for a request end at once, others once they are answered.
  void stop();
  bool is_stopping() const;

private:
  void set(Connection& connection, Connection::Clock::time_point deadline, bool is_answered);
  bool one_gives_way();

  mutable std::mutex mutex_;
  std::condition_variable changed_;
  std::list<Connection> open_;  ///< the oldest first; some are cut and about to end
  bool stopping_ = false;
};

}  // namespace berm::desk
