// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/desk/desk_guards_test.cpp
#include "desk/connection.hpp"

#include <algorithm>
#include <cstring>
#include <poll.h>
#include <sys/socket.h>

namespace berm::desk {
namespace {

constexpr std::chrono::seconds time_to_send{10}, time_to_take{60}, time_between{20};

}  // namespace

bool Connection::wait_for(short events, Clock::time_point until) const
{
  pollfd ready{socket_, events, 0};
  const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(until - Clock::now()).count();
  return left > 0 && ::poll(&ready, 1, static_cast<int>(left)) > 0;
}

bool Connection::next_request()
{
  if (given_ == held_.size() && !wait_for(POLLIN, Clock::now() + time_between)) return false;
  sent_by_ = Clock::now() + time_to_send;
  taken_by_ = {};
  return true;
}

void Connection::take_leave()
{
  ::shutdown(socket_, SHUT_WR);
  const auto until = Clock::now() + std::chrono::seconds(1);
  char some[16384];
  while (wait_for(POLLIN, until) && ::recv(socket_, some, sizeof some, MSG_DONTWAIT) > 0) {
  }
}

bool Connection::is_readable() const
{
  return given_ < held_.size() || wait_for(POLLIN, sent_by_);
}

bool Connection::is_writable() const
{
  return wait_for(POLLOUT, Clock::now() + time_to_take);
}

ssize_t Connection::read(char* to, size_t size)
{
  if (given_ == held_.size()) {
    if (!wait_for(POLLIN, sent_by_)) return -1;
    held_.resize(16384);
    const ssize_t count = ::recv(socket_, held_.data(), held_.size(), 0);
    held_.resize(static_cast<std::size_t>(std::max<ssize_t>(count, 0)));
    given_ = 0;
    if (count <= 0) return count;
  }
  const std::size_t count = std::min(size, held_.size() - given_);
  std::memcpy(to, held_.data() + given_, count);
  given_ += count;
  return static_cast<ssize_t>(count);
}

ssize_t Connection::write(const char* from, size_t size)
{
  if (taken_by_ == Clock::time_point{}) taken_by_ = Clock::now() + time_to_take;  // the answer begins
  return wait_for(POLLOUT, taken_by_) ? ::send(socket_, from, size, MSG_NOSIGNAL | MSG_DONTWAIT) : -1;
}

void Connection::get_remote_ip_and_port(std::string& ip, int& port) const
{
  get_local_ip_and_port(ip, port);
}

void Connection::get_local_ip_and_port(std::string& ip, int& port) const
{
  ip = "127.0.0.1";
  port = 0;
}

}  // namespace berm::desk
