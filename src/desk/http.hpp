// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "desk/refusal.hpp"

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <string_view>

namespace berm::desk {

/// What a client asks for.
struct Request {
  std::string method, path;
  std::map<std::string, std::string> query;
  Json body = Json::object();
};

struct Answer {
  std::string body = {}, type = "application/json", policy = {};  ///< policy: its Content-Security-Policy, where it is not that of data
  int status = 200;
  std::string_view held = {};  ///< by the program: given for the body, without a copy

  std::string_view bytes() const { return held.empty() ? std::string_view(body) : held; }
};

using Handler = std::function<Answer(const Request&)>;

constexpr std::size_t most_bytes_of_body = 4 << 20;
constexpr int deepest_body = 16;  ///< levels of JSON

/// How a proxy in front of the server is called.
struct Proxy {
  std::string name = {};    ///< a host that the server answers to, too; "": none
  std::string prefix = {};  ///< "/berm": of addresses, taken away where they have it
};

/// Where the server listens.
struct Listen {
  std::string address = "127.0.0.1";  ///< IPv4 of one interface of the machine, or 0.0.0.0 for all
  int port = 0;                       ///< 0: any that is free
};

/// A server for programs of this machine: it answers who names it 127.0.0.1, and listens there unless a container's port is forwarded from outside. What lies below /api/ is for who has the token.
class HttpServer {
public:
  /// Throws RunError where address or port cannot be had.
  HttpServer(const Listen& at, Proxy proxy, Handler open, Handler with_token);
  ~HttpServer();

  int port() const;
  const std::string& token() const;
  /// http://127.0.0.1:PORT/#TOKEN. A browser sends no fragment to any server.
  std::string address() const;
  /// Answers requests, many at a time, until stop().
  void serve();
  void stop();

private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

/// So many random bytes of the system, as hexadecimal digits.
std::string random_word(int bytes);

}  // namespace berm::desk
