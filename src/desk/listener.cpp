// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/desk/desk_listener_test.cpp
#include "desk/listener.hpp"

#include "os/error.hpp"

#include <algorithm>
#include <arpa/inet.h>
#include <cerrno>
#include <cstring>
#include <fmt/format.h>
#include <netinet/tcp.h>
#include <sys/socket.h>
#include <system_error>
#include <thread>
#include <unistd.h>

namespace berm::desk {
namespace {

/// Where many connect at once none waits for the system to try again, a second later.
constexpr int most_waiting = 1024;

}  // namespace

Listener::Listener(int port) : socket_(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0))
{
  const int yes = 1;
  ::setsockopt(socket_, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
  sockaddr_in here{};
  here.sin_family = AF_INET;
  here.sin_port = htons(static_cast<std::uint16_t>(port));
  here.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  socklen_t size = sizeof here;
  auto* const address = reinterpret_cast<sockaddr*>(&here);
  if (::bind(socket_, address, size) != 0 || ::listen(socket_, most_waiting) != 0 || ::getsockname(socket_, address, &size) != 0) {
    ::close(socket_);
    throw RunError(port == 0 ? "no port of this machine is free" : fmt::format("port {} of this machine is taken", port));
  }
  port_ = ntohs(here.sin_port);
}

Listener::~Listener()
{
  ::close(socket_);
}

void Listener::listen(const std::function<void(Connection&)>& serve)
{
  while (!stopping_) {
    const int socket = ::accept4(socket_, nullptr, nullptr, SOCK_CLOEXEC);  // a run that goes on holds no connection
    if (socket >= 0) {
      take(socket, serve);
    } else if (errno == EMFILE || errno == ENFILE || errno == ENOMEM || errno == ENOBUFS) {
      {
        const std::lock_guard lock(mutex_);
        one_gives_way();
      }
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    } else if (!stopping_ && (errno == EINVAL || errno == EBADF)) {
      throw RunError(fmt::format("the server cannot listen: {}", std::strerror(errno)));
    }
  }
  std::unique_lock lock(mutex_);
  ended_.wait(lock, [&] { return open_.empty(); });
}

/// False where none does.
bool Listener::one_gives_way()
{
  const auto first = [&](const auto& of_kind) {
    return std::find_if(open_.begin(), open_.end(), [&](const Connection& one) { return !one.is_cut() && of_kind(one); });
  };
  auto found = first([](const Connection& one) { return !one.is_trusted(); });
  if (found == open_.end()) found = first([](const Connection& one) { return !one.is_at_work(); });
  if (found == open_.end()) return false;
  found->cut();
  return true;
}

void Listener::take(int socket, const std::function<void(Connection&)>& serve)
{
  const int yes = 1;
  ::setsockopt(socket, IPPROTO_TCP, TCP_NODELAY, &yes, sizeof yes);
  std::unique_lock lock(mutex_);
  // Those that are cut end as soon as the system lets them, whatever their clients do: newcomers wait for that, but for no client.
  ended_.wait(lock, [&] { return stopping_ || open_.size() < 2 * places; });
  const auto uncut = std::count_if(open_.begin(), open_.end(), [](const Connection& one) { return !one.is_cut(); });
  const bool full = static_cast<std::size_t>(uncut) >= places;
  if (stopping_ || (full && !one_gives_way())) {
    ::close(socket);
    return;
  }
  const Open one = open_.emplace(open_.end(), socket);
  try {
    std::thread([this, one, &serve] {
      serve(*one);
      end(one);
    }).detach();
  } catch (const std::system_error&) {  // the system has no thread for it
    open_.erase(one);
  }
}

void Listener::end(Open connection)
{
  const std::lock_guard lock(mutex_);
  open_.erase(connection);
  ended_.notify_all();
}

void Listener::stop()
{
  const std::lock_guard lock(mutex_);
  stopping_ = true;
  ended_.notify_all();
  ::shutdown(socket_, SHUT_RDWR);
  for (Connection& one : open_) one.is_trusted() ? one.read_no_more() : one.cut();
}

}  // namespace berm::desk
