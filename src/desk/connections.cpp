// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/desk/desk_connections_test.cpp
#include "desk/connections.hpp"

#include <algorithm>
#include <sys/socket.h>

namespace berm::desk {
namespace {

/// Ends it whatever its client does; the thread that serves it closes the socket.
void cut(Connection& connection)
{
  connection.is_cut = true;
  ::shutdown(connection.socket, SHUT_RDWR);
}

}  // namespace

/// False where none does.
bool Connections::one_gives_way()
{
  const auto first = [&](const auto& of_kind) {
    return std::find_if(open_.begin(), open_.end(), [&](const Connection& one) { return !one.is_cut && of_kind(one); });
  };
  auto found = first([](const Connection& one) { return !one.has_token; });
  if (found == open_.end()) found = first([](const Connection& one) { return !one.is_answered; });
  if (found == open_.end()) return false;
  cut(*found);
  return true;
}

Connection* Connections::add(int socket)
{
  const std::lock_guard lock(mutex_);
  const auto uncut = std::count_if(open_.begin(), open_.end(), [](const Connection& one) { return !one.is_cut; });
  const bool is_refused = stopping_ || (static_cast<std::size_t>(uncut) >= places && !one_gives_way());
  Connection& one = open_.emplace_back(Connection{socket, Connection::Clock::now() + time_of_head});
  if (is_refused) cut(one);
  return &one;
}

void Connections::remove(const Connection* connection)
{
  const std::lock_guard lock(mutex_);
  open_.remove_if([&](const Connection& one) { return &one == connection; });
  changed_.notify_all();
}

void Connections::trust(Connection& connection)
{
  const std::lock_guard lock(mutex_);
  connection.has_token = true;
}

void Connections::set(Connection& connection, Connection::Clock::time_point deadline, bool is_answered)
{
  const std::lock_guard lock(mutex_);
  connection.deadline = deadline;
  connection.is_answered = is_answered;
}

void Connections::watch()
{
  std::unique_lock lock(mutex_);
  while (!stopping_ || std::any_of(open_.begin(), open_.end(), [](const Connection& one) { return !one.is_cut; })) {
    for (Connection& one : open_)
      if (!one.is_cut && one.deadline < Connection::Clock::now()) cut(one);
    changed_.wait_for(lock, std::chrono::seconds(1));
  }
}

void Connections::stop()
{
  const std::lock_guard lock(mutex_);
  stopping_ = true;
  for (Connection& one : open_) one.has_token ? void(::shutdown(one.socket, SHUT_RD)) : cut(one);
  changed_.notify_all();
}

bool Connections::is_stopping() const
{
  const std::lock_guard lock(mutex_);
  return stopping_;
}

}  // namespace berm::desk
