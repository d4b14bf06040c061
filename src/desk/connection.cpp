// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/desk/desk_listener_test.cpp
#include "desk/connection.hpp"

#include "desk/refusal.hpp"

#include <algorithm>
#include <cerrno>
#include <fmt/format.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

namespace berm::desk {
namespace {

constexpr std::chrono::seconds time_of_head{10}, time_of_body{20}, time_to_take{60}, time_between{20};
constexpr std::size_t bytes_at_once = 16 << 10;

}  // namespace

Connection::~Connection()
{
  ::close(socket_);
}

bool Connection::wait_for(short events, Clock::time_point until) const
{
  while (true) {
    pollfd ready{socket_, events, 0};
    const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(until - Clock::now()).count();
    if (left <= 0) return false;
    const int count = ::poll(&ready, 1, static_cast<int>(left));
    if (count >= 0 || errno != EINTR) return count > 0;
  }
}

/// False where nothing comes in time, and at the end of the client.
bool Connection::read_more(Clock::time_point until)
{
  char some[bytes_at_once];
  ssize_t count = -1;
  do {
    if (!wait_for(POLLIN, until)) return false;
    count = ::recv(socket_, some, sizeof some, MSG_DONTWAIT);
  } while (count < 0 && (errno == EINTR || errno == EAGAIN));
  held_.append(some, static_cast<std::size_t>(std::max<ssize_t>(count, 0)));
  return count > 0;
}

bool Connection::next_request()
{
  at_work_ = false;
  while (true) {
    while (held_.starts_with("\r\n")) held_.erase(0, 2);  // some clients end a body with it
    if (!held_.empty() && held_ != "\r") break;
    if (!read_more(Clock::now() + time_between)) return false;
  }
  sent_by_ = Clock::now() + time_of_head;
  return true;
}

std::string Connection::head(std::size_t most)
{
  constexpr std::string_view end = "\r\n\r\n";
  std::size_t at = held_.find(end);
  for (std::size_t seen = 0; at == std::string::npos; at = held_.find(end, seen)) {
    if (held_.size() > most) break;
    seen = held_.size() < end.size() ? 0 : held_.size() - end.size();
    if (!read_more(sent_by_)) throw Refusal(408, "the lines of the request did not come in time");
  }
  if (at > most) throw Refusal(431, fmt::format("the lines of the request have more than {} bytes", most));
  const std::string lines = held_.substr(0, at);
  held_.erase(0, at + end.size());
  at_work_ = true;
  return lines;
}

std::string Connection::body(std::size_t size)
{
  for (const auto until = Clock::now() + time_of_body; held_.size() < size;)
    if (!read_more(until)) throw Refusal(400, "the body was cut off");
  std::string text = held_.substr(0, size);
  held_.erase(0, size);
  return text;
}

bool Connection::write(std::string_view text)
{
  for (const auto until = Clock::now() + time_to_take; !text.empty();) {
    if (!wait_for(POLLOUT, until)) return false;
    const ssize_t count = ::send(socket_, text.data(), text.size(), MSG_NOSIGNAL | MSG_DONTWAIT);
    if (count < 0 && (errno == EINTR || errno == EAGAIN)) continue;
    if (count < 0) return false;
    text.remove_prefix(static_cast<std::size_t>(count));
  }
  return true;
}

void Connection::take_leave()
{
  ::shutdown(socket_, SHUT_WR);
  const auto until = Clock::now() + std::chrono::seconds(1);
  char some[bytes_at_once];
  while (wait_for(POLLIN, until) && ::recv(socket_, some, sizeof some, MSG_DONTWAIT) > 0) {
  }
}

void Connection::cut()
{
  cut_ = true;
  ::shutdown(socket_, SHUT_RDWR);
}

void Connection::read_no_more()
{
  ::shutdown(socket_, SHUT_RD);
}

}  // namespace berm::desk
