// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "samples/program.hpp"

#include <arpa/inet.h>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <poll.h>
#include <sys/socket.h>

namespace berm {

struct Response {
  int status = 0;  ///< 0: none came
  std::string head, body;

  nlohmann::json json() const { return nlohmann::json::parse(body, nullptr, false); }
};

/// A connection to a port of this machine, at one of its own addresses.
class Caller {
public:
  explicit Caller(int port, const char* address = "127.0.0.1") : socket_(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0))
  {
    sockaddr_in to{};
    to.sin_family = AF_INET;
    to.sin_port = htons(static_cast<std::uint16_t>(port));
    to.sin_addr.s_addr = inet_addr(address);
    connected_ = ::connect(socket_, reinterpret_cast<sockaddr*>(&to), sizeof to) == 0;
  }
  ~Caller() { ::close(socket_); }
  Caller(const Caller&) = delete;
  Caller& operator=(const Caller&) = delete;

  bool connected() const { return connected_; }
  void send(std::string_view text) const
  {
    while (!text.empty()) {
      const ssize_t count = ::send(socket_, text.data(), text.size(), MSG_NOSIGNAL);
      if (count <= 0) return;
      text.remove_prefix(static_cast<std::size_t>(count));
    }
  }
  /// Whether a text comes, at most within 20 s.
  bool reads(const std::string& wanted) const
  {
    std::string text;
    char some[4096];
    pollfd ready{socket_, POLLIN, 0};
    while (text.find(wanted) == std::string::npos) {
      if (::poll(&ready, 1, 20000) <= 0) return false;
      const ssize_t count = ::recv(socket_, some, sizeof some, 0);
      if (count <= 0) return false;
      text.append(some, static_cast<std::size_t>(count));
    }
    return true;
  }
  /// Whether the server has closed the connection; ends(): whether it does so within 5 s.
  bool has_ended(int wait_ms = 0) const
  {
    pollfd ready{socket_, POLLRDHUP, 0};
    return ::poll(&ready, 1, wait_ms) > 0;
  }
  bool ends() const { return has_ended(5000); }
  /// All that comes until the server closes the connection, at most for 20 s.
  Response answer() const
  {
    std::string text;
    char some[65536];
    pollfd ready{socket_, POLLIN, 0};
    while (::poll(&ready, 1, 20000) > 0) {
      const ssize_t count = ::recv(socket_, some, sizeof some, 0);
      if (count <= 0) break;
      text.append(some, static_cast<std::size_t>(count));
    }
    Response response;
    const std::size_t end = text.find("\r\n\r\n");
    if (end == std::string::npos || text.size() < 12) return response;
    return {std::atoi(text.c_str() + 9), text.substr(0, end), text.substr(end + 4)};
  }

private:
  int socket_;
  bool connected_;
};

/// `berm desk` in a folder, and requests to it.
class DeskClient {
public:
  explicit DeskClient(const std::filesystem::path& folder, const std::vector<std::string>& more = {}) : program_(folder, words(more))
  {
    wait_until([&] { return program_.out().find('\n') != std::string::npos; });
    const std::string address = program_.out();
    const std::size_t colon = address.rfind(':'), hash = address.find('#');
    if (hash == std::string::npos) return;
    port = std::atoi(address.c_str() + colon + 1);
    token = address.substr(hash + 1, address.find('\n') - hash - 1);
  }

  /// The lines that a client of its own page sends, but for the length of the body.
  std::string head(const std::string& method, const std::string& target) const
  {
    return fmt::format("{} {} HTTP/1.1\r\nHost: 127.0.0.1:{}\r\nAuthorization: Bearer {}\r\nConnection: close\r\n", method, target, port,
                       token);
  }
  Response raw(const std::string& text) const
  {
    const Caller caller(port);
    caller.send(text);
    return caller.answer();
  }
  Response get(const std::string& target) const { return raw(head("GET", target) + "\r\n"); }
  Response send(const std::string& method, const std::string& target, const std::string& body) const
  {
    return raw(head(method, target) + fmt::format("Content-Type: application/json\r\nContent-Length: {}\r\n\r\n{}", body.size(), body));
  }
  Response post(const std::string& target, const nlohmann::json& body) const { return send("POST", target, body.dump()); }
  Response put(const std::string& target, const nlohmann::json& body) const { return send("PUT", target, body.dump()); }

  Program& program() { return program_; }

  int port = 0;
  std::string token;

private:
  static std::vector<std::string> words(const std::vector<std::string>& more)
  {
    std::vector<std::string> all = {"desk", "--no-browser"};
    all.insert(all.end(), more.begin(), more.end());
    return all;
  }

  Program program_;
};

}  // namespace berm
