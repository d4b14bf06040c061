// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/desk/desk_guards_test.cpp
#include "desk/http.hpp"

#include "desk/listener.hpp"
#include "desk/request_head.hpp"
#include "os/error.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <sys/random.h>

namespace berm::desk {
namespace {

constexpr std::size_t longest_path = 200;
constexpr const char* policy_of_data = "default-src 'none'; frame-ancestors 'none'; sandbox";

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

/// The lines before an answer. `stays`: another request may come.
std::string lines_of(const Answer& answer, bool stays)
{
  std::string lines = fmt::format(
      "HTTP/1.1 {} {}\r\nContent-Security-Policy: {}\r\nX-Content-Type-Options: nosniff\r\nX-DNS-Prefetch-Control: off\r\n"
      "Cache-Control: no-store\r\nReferrer-Policy: no-referrer\r\nCross-Origin-Resource-Policy: same-origin\r\nConnection: {}\r\n",
      answer.status, answer.status < 400 ? "OK" : "Refused", answer.policy.empty() ? policy_of_data : answer.policy,
      stays ? "keep-alive" : "close");
  if (answer.status != 204) lines += fmt::format("Content-Type: {}\r\nContent-Length: {}\r\n", answer.type, answer.bytes().size());
  return lines + "\r\n";
}

bool is_api(const RequestHead& head)
{
  return head.path.starts_with("/api/");
}

/// Bytes of the body that follows.
std::size_t size_of_body(const RequestHead& head)
{
  if (head.has("transfer-encoding")) throw Refusal(411, "the request does not say beforehand how long its body is");
  const std::string digits = head.field("content-length");
  if (digits.find_first_not_of("0123456789") != std::string::npos) throw Refusal(400, "the length of the body is no number");
  const std::size_t size = digits.empty() ? 0 : digits.size() > 9 ? most_bytes_of_body + 1 : std::stoul(digits);
  if (size > most_bytes_of_body) throw Refusal(413, fmt::format("the body has more than {} bytes", most_bytes_of_body));
  return size;
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
  Listener listener;
  Handler open, with_token;
  std::string token = random_word(32);

  /// Throws Refusal where the request may not be answered; before its body is read.
  void guard(const RequestHead& head) const
  {
    const std::string host = head.field("host"), origin = head.field("origin");
    if (head.fields.count("host") != 1 || !is_this_machine(host))
      throw Refusal(403, "this server answers to 127.0.0.1, localhost and [::1] only: open the address that berm desk prints");
    if (head.has("origin") && origin != "http://" + host) throw Refusal(403, "a page from elsewhere asks");
    if (head.method != "GET" && head.method != "POST" && head.method != "PUT") throw Refusal(405, "only GET, POST and PUT are answered");
    if (head.path.size() > longest_path) throw Refusal(404, "there is no such address");
    if (!is_api(head)) {
      if (head.method != "GET") throw Refusal(405, "only GET is answered here");
      return;
    }
    if (!same_word(head.field("authorization"), "Bearer " + token))
      throw Refusal(401, "the token is missing or wrong: open the address that berm desk prints");
    if (head.method == "GET") return;
    if (head.field("content-type") != "application/json") throw Refusal(415, "the body must be application/json");
    if (head.has("content-encoding")) throw Refusal(415, "the body must not be compressed");
  }

  /// What the next request asks for. `stays` becomes true once all of it is read.
  Answer answer(Connection& client, bool& stays) const
  {
    const RequestHead head = head_of(client.head(longest_head));
    guard(head);
    if (is_api(head)) client.trust();
    const std::size_t size = size_of_body(head);
    Request request{head.method, head.path, head.query, Json::object()};
    if (head.method != "GET") {
      if (head.has("expect") && !client.write("HTTP/1.1 100 Continue\r\n\r\n")) throw Refusal(400, "the client is gone");
      const std::string text = client.body(size);
      stays = head.keeps_open;
      request.body = json_of(text);
    } else {
      stays = head.keeps_open && size == 0;
    }
    return (is_api(head) ? with_token : open)(request);
  }

  void serve(Connection& client) const
  {
    try {
      for (bool stays = true; stays && !listener.is_stopping() && client.next_request();) {
        stays = false;
        const Answer answered = answer_of([&] { return answer(client, stays); });
        stays = client.write(lines_of(answered, stays)) && client.write(answered.bytes()) && stays;
      }
      client.take_leave();
    } catch (const std::exception&) {  // the machine has no memory for it: it ends without an answer
    }
  }
};

HttpServer::HttpServer(int port, Handler open, Handler with_token)
    : parts_(new Parts{Listener(port), std::move(open), std::move(with_token)})
{
}

HttpServer::~HttpServer() = default;

int HttpServer::port() const
{
  return parts_->listener.port();
}

const std::string& HttpServer::token() const
{
  return parts_->token;
}

std::string HttpServer::address() const
{
  return fmt::format("http://127.0.0.1:{}/#{}", parts_->listener.port(), parts_->token);
}

void HttpServer::serve()
{
  parts_->listener.listen([this](Connection& client) { parts_->serve(client); });
}

void HttpServer::stop()
{
  parts_->listener.stop();
}

}  // namespace berm::desk
