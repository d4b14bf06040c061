// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <httplib.h>

namespace berm::desk {

/// A connection whose client must have sent a request, and taken its answer, within some seconds: one that sends a byte now and then holds nothing for long.
class Connection : public httplib::Stream {
public:
  explicit Connection(int socket) : socket_(socket) {}

  /// Waits until the next request begins. False where none does in time.
  bool next_request();
  /// Says that nothing more comes, and takes what the client is still sending, for a second: else the system would throw away the answer with it.
  void take_leave();

  bool is_readable() const override;
  bool is_writable() const override;
  ssize_t read(char* to, size_t size) override;
  ssize_t write(const char* from, size_t size) override;
  void get_remote_ip_and_port(std::string& ip, int& port) const override;
  void get_local_ip_and_port(std::string& ip, int& port) const override;
  int socket() const override { return socket_; }

private:
  using Clock = std::chrono::steady_clock;
  bool wait_for(short events, Clock::time_point until) const;

  int socket_;
  Clock::time_point sent_by_{}, taken_by_{};
  std::string held_;  ///< read from the socket, and not given on
  std::size_t given_ = 0;
};

}  // namespace berm::desk
