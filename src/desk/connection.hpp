// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <chrono>
#include <string>
#include <string_view>

namespace berm::desk {

/// A connection whose client must have sent a request, and taken its answer, within some seconds: one that sends a byte now and then holds nothing for long.
class Connection {
public:
  /// Takes the socket, and closes it at the end.
  explicit Connection(int socket) : socket_(socket) {}
  ~Connection();
  Connection(const Connection&) = delete;
  Connection& operator=(const Connection&) = delete;

  /// Waits until the next request begins. False where none does in time.
  bool next_request();
  /// Its lines up to the empty one. Throws Refusal 408 where they do not come in time, 431 where they are longer than `most` bytes.
  std::string head(std::size_t most);
  /// So many bytes of its body. Throws Refusal 400 where they do not come in time.
  std::string body(std::size_t size);
  /// False where the client does not take it in time.
  bool write(std::string_view text);
  /// Says that nothing more comes, and takes what the client is still sending, for a second: else the system would throw away the answer with it.
  void take_leave();

  /// Its client has the token.
  void trust() { trusted_ = true; }
  bool is_trusted() const { return trusted_; }
  bool is_at_work() const { return at_work_; }
  bool is_cut() const { return cut_; }
  /// Ends it whatever it does; of a thread that does not wait for it.
  void cut();
  /// Nothing more is read from it.
  void read_no_more();

private:
  using Clock = std::chrono::steady_clock;
  bool wait_for(short events, Clock::time_point until) const;
  bool read_more(Clock::time_point until);

  int socket_;
  Clock::time_point sent_by_{};
  std::string held_;  ///< read from the socket, and not given on
  std::atomic<bool> trusted_{false}, at_work_{false}, cut_{false};
};

}  // namespace berm::desk
