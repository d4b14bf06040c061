// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/desk/desk_guards_test.cpp
#include "desk/http.hpp"

#include "core/error.hpp"
#include "desk/connection.hpp"

#include <condition_variable>
#include <fcntl.h>
#include <fmt/format.h>
#include <mutex>
#include <set>
#include <sys/random.h>
#include <sys/socket.h>
#include <thread>
#include <unistd.h>

namespace berm::desk {
namespace {

constexpr int most_connections = 128;
constexpr std::size_t longest_path = 200;
constexpr const char* policy_of_data = "default-src 'none'; frame-ancestors 'none'; sandbox";

/// A thread for each connection, so that one that waits keeps no other from its answer.
class Connections : public httplib::TaskQueue {
public:
  void enqueue(std::function<void()> serve) override
  {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return open_ < most_connections; });
    ++open_;
    std::thread([this, serve = std::move(serve)] {
      serve();
      const std::lock_guard ends(mutex_);
      --open_;
      changed_.notify_all();
    }).detach();
  }
  void shutdown() override
  {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return open_ == 0; });
  }

private:
  std::mutex mutex_;
  std::condition_variable changed_;
  int open_ = 0;
};

class Listener : public httplib::Server {
public:
  /// Where many connect at once none waits for the system to try again, a second later.
  void take_many() { ::listen(svr_sock_, most_connections); }
  /// Those that wait for a request end at once, others once they are answered.
  void stop_all()
  {
    {
      const std::lock_guard lock(mutex_);
      stopping_ = true;
      for (const socket_t socket : sockets_) ::shutdown(socket, SHUT_RD);
    }
    stop();
  }

private:
  bool process_and_close_socket(socket_t socket) override
  {
    {
      const std::lock_guard lock(mutex_);
      sockets_.insert(socket);
    }
    ::fcntl(socket, F_SETFD, FD_CLOEXEC);  // a run that goes on holds no connection
    Connection connection(socket);
    bool closed = false;
    while (!closed && !stopping_ && connection.next_request())
      if (!process_request(connection, stopping_, closed, &not_compressed)) break;
    connection.take_leave();
    const std::lock_guard lock(mutex_);
    sockets_.erase(socket);
    ::close(socket);
    return true;
  }

  /// To press a page together takes a second, to send it to the same machine a millisecond.
  static void not_compressed(httplib::Request& request) { request.headers.erase("Accept-Encoding"); }

  std::mutex mutex_;
  std::set<socket_t> sockets_;
  std::atomic<bool> stopping_{false};
};

/// Whether a host is this machine as the machine calls itself. With any port: a tunnel may begin at another than it ends at, and what a page of a foreign name would need is
/// the name.
bool is_this_machine(const std::string& host)
{
  for (const std::string name : {"127.0.0.1", "localhost", "[::1]"}) {
    if (!host.starts_with(name)) continue;
    const std::string rest = host.substr(name.size());
    return rest.empty() ||
           (rest[0] == ':' && rest.size() > 1 && rest.size() <= 6 && rest.find_first_not_of("0123456789", 1) == std::string::npos);
  }
  return false;
}

/// In a time that tells nothing of where they differ.
bool same_word(const std::string& a, const std::string& b)
{
  if (a.size() != b.size()) return false;
  unsigned char differ = 0;
  for (std::size_t k = 0; k < a.size(); ++k) differ = static_cast<unsigned char>(differ | (a[k] ^ b[k]));
  return differ == 0;
}

Json json_of(const std::string& text)
{
  const auto not_too_deep = [](int depth, Json::parse_event_t, Json&) {
    if (depth > deepest_body) throw Refusal(400, fmt::format("the body has more than {} levels", deepest_body));
    return true;
  };
  try {
    Json json = Json::parse(text, not_too_deep);
    if (!json.is_object()) throw Refusal(400, "the body is no JSON object");
    return json;
  } catch (const Json::exception&) {
    throw Refusal(400, "the body is no JSON");
  }
}

Request request_of(const httplib::Request& from)
{
  Request request{from.method, from.path, {}, Json::object()};
  for (const auto& [name, value] : from.params)
    if (!request.query.emplace(name, value).second) throw Refusal(400, fmt::format("the address says {} twice", name));
  return request;
}

Answer refused(int status, const std::string& why, Json more = Json::object())
{
  more["error"] = why;
  return {.body = more.dump(-1, ' ', false, Json::error_handler_t::replace), .status = status};
}

/// What a handler answers, or why it does not.
Answer answer_of(const std::function<Answer()>& handler)
{
  try {
    return handler();
  } catch (const Refusal& refusal) {
    return refused(refusal.status, refusal.what(), refusal.more);
  } catch (const InputError& error) {
    return refused(400, error.what());
  } catch (const std::exception& error) {
    return refused(500, error.what());
  }
}

void give(const Answer& answer, httplib::Response& to)
{
  to.status = answer.status;
  to.set_header("Content-Security-Policy", answer.policy.empty() ? policy_of_data : answer.policy);
  to.set_header("X-Content-Type-Options", "nosniff");
  to.set_header("Cache-Control", "no-store");
  to.set_header("Referrer-Policy", "no-referrer");
  to.set_header("Cross-Origin-Resource-Policy", "same-origin");
  if (answer.status != 204) to.set_content(answer.body, answer.type);
}

}  // namespace

std::string random_word(int bytes)
{
  std::string word;
  for (int k = 0; k < bytes; ++k) {
    unsigned char byte = 0;
    if (::getrandom(&byte, 1, 0) != 1) throw RunError("the system gives no random numbers");
    word += fmt::format("{:02x}", byte);
  }
  return word;
}

struct HttpServer::Parts {
  Listener server;
  Handler open, with_token;
  int port = 0;
  std::string token = random_word(32);

  /// Throws Refusal where the request may not be answered; before its body is read.
  void guard(const httplib::Request& request) const
  {
    const std::string host = request.get_header_value("Host"), origin = request.get_header_value("Origin");
    if (request.get_header_value_count("Host") != 1 || !is_this_machine(host))
      throw Refusal(403, "this server answers to 127.0.0.1, localhost and [::1] only: open the address that berm desk prints");
    if (request.has_header("Origin") && origin != "http://" + host) throw Refusal(403, "a page from elsewhere asks");
    if (request.method != "GET" && request.method != "POST" && request.method != "PUT")
      throw Refusal(405, "only GET, POST and PUT are answered");
    if (request.path.size() > longest_path) throw Refusal(404, "there is no such address");
    if (!is_api(request)) {
      if (request.method != "GET") throw Refusal(405, "only GET is answered here");
      return;
    }
    if (!same_word(request.get_header_value("Authorization"), "Bearer " + token))
      throw Refusal(401, "the token is missing or wrong: open the address that berm desk prints");
    if (request.method == "GET") return;
    if (request.get_header_value("Content-Type") != "application/json") throw Refusal(415, "the body must be application/json");
    if (request.has_header("Content-Encoding")) throw Refusal(415, "the body must not be compressed");
    if (request.has_header("Content-Length") && request.get_header_value("Content-Length").size() > 9) refuse_size();
    if (request.has_header("Content-Length") && std::stoul("0" + request.get_header_value("Content-Length")) > most_bytes_of_body)
      refuse_size();
  }
  static bool is_api(const httplib::Request& request) { return request.path.starts_with("/api/"); }
  [[noreturn]] static void refuse_size() { throw Refusal(413, fmt::format("the body has more than {} bytes", most_bytes_of_body)); }

  void answer(const httplib::Request& from, httplib::Response& to) const
  {
    give(answer_of([&] { return (is_api(from) ? with_token : open)(request_of(from)); }), to);
  }
  void answer_with_body(const httplib::Request& from, httplib::Response& to, const httplib::ContentReader& read) const
  {
    std::string text;
    bool too_long = false;
    const bool whole = read([&](const char* data, std::size_t size) {
      too_long = text.size() + size > most_bytes_of_body;
      if (!too_long) text.append(data, size);
      return !too_long;
    });
    if (!whole) to.set_header("Connection", "close");
    give(answer_of([&] {
           if (too_long) refuse_size();
           if (!whole) throw Refusal(400, "the body was cut off");
           Request request = request_of(from);
           request.body = json_of(text);
           return with_token(request);
         }),
         to);
  }
};

HttpServer::HttpServer(int port, Handler open, Handler with_token) : parts_(std::make_unique<Parts>())
{
  Parts& p = *parts_;
  p.open = std::move(open);
  p.with_token = std::move(with_token);
  p.server.new_task_queue = [] { return new Connections; };
  p.server.set_socket_options([](socket_t socket) {
    const int yes = 1;
    ::setsockopt(socket, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
    ::fcntl(socket, F_SETFD, FD_CLOEXEC);
  });
  p.server.set_payload_max_length(most_bytes_of_body);
  p.server.set_pre_routing_handler([&p](const httplib::Request& request, httplib::Response& response) {
    const Answer allowed = answer_of([&] { return p.guard(request), Answer{{}, {}, {}, 0}; });
    if (allowed.status == 0) return httplib::Server::HandlerResponse::Unhandled;
    give(allowed, response);
    response.set_header("Connection", "close");  // what is left of the body is not read
    return httplib::Server::HandlerResponse::Handled;
  });
  const auto with_body = [&p](const httplib::Request& request, httplib::Response& response, const httplib::ContentReader& read) {
    p.answer_with_body(request, response, read);
  };
  p.server.Get(".*", [&p](const httplib::Request& request, httplib::Response& response) { p.answer(request, response); });
  p.server.Post(".*", with_body);
  p.server.Put(".*", with_body);
  p.server.set_error_handler([](const httplib::Request&, httplib::Response& response) {
    if (response.body.empty()) give(refused(response.status, "this is no request that the server understands"), response);
  });
  p.port = port == 0 ? p.server.bind_to_any_port("127.0.0.1") : p.server.bind_to_port("127.0.0.1", port) ? port : -1;
  if (p.port < 0) throw RunError(port == 0 ? "no port of this machine is free" : fmt::format("port {} of this machine is taken", port));
  p.server.take_many();
}

HttpServer::~HttpServer() = default;

int HttpServer::port() const
{
  return parts_->port;
}

const std::string& HttpServer::token() const
{
  return parts_->token;
}

std::string HttpServer::address() const
{
  return fmt::format("http://127.0.0.1:{}/#{}", parts_->port, parts_->token);
}

void HttpServer::serve()
{
  parts_->server.listen_after_bind();
}

void HttpServer::stop()
{
  parts_->server.stop_all();
}

}  // namespace berm::desk
