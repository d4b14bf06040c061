// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/desk/desk_guards_test.cpp
#include "desk/http.hpp"

#include "desk/connections.hpp"
#include "os/control_characters.hpp"
#include "os/error.hpp"

#include <algorithm>
#include <arpa/inet.h>
#include <cctype>
#include <fmt/format.h>
#include <microhttpd.h>
#include <sys/random.h>

namespace berm::desk {
namespace {

constexpr std::size_t longest_path = 200, longest_head = 16 << 10;
constexpr std::size_t memory_of_connection = 18 << 10;  ///< for the lines of a request and of its answer
constexpr unsigned most_waiting = 1024;                 ///< connections at once; others would try again a second later
constexpr const char* policy_of_data = "default-src 'none'; frame-ancestors 'none'; sandbox";

/// Whether a host is this machine as the machine calls itself. With any port: a tunnel may begin at another than it ends at, and what a page of a foreign name would need is
/// the name.
bool is_host(const std::string& host, const std::vector<std::string>& names)
{
  for (const std::string& name : names) {
    if (name.empty() || !host.starts_with(name)) continue;
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
    if (!json.is_object()) throw Refusal(400, "the body is not a JSON object");
    return json;
  } catch (const Json::exception&) {
    throw Refusal(400, "the body is not JSON");
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

std::string in_small_letters(std::string word)
{
  for (char& c : word) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return word;
}

/// The lines of a request before its body.
struct Head {
  std::string method, path;
  std::map<std::string, std::string> query;
  std::multimap<std::string, std::string> fields;  ///< by their names in small letters

  /// The first one of that name; "" where there is none.
  std::string field(const std::string& name) const
  {
    const auto found = fields.lower_bound(name);
    return found == fields.end() || found->first != name ? "" : found->second;
  }
  bool has(const std::string& name) const { return fields.count(name) > 0; }
  bool is_api() const { return path.starts_with("/api/"); }
};

using Words = std::vector<std::pair<std::string, std::string>>;

/// Names and values of the address or of the lines below it.
Words words_of(MHD_Connection* client, MHD_ValueKind kind)
{
  Words all;
  const MHD_KeyValueIteratorN add = [](void* to, MHD_ValueKind, const char* name, std::size_t name_size, const char* value,
                                       std::size_t size) {
    static_cast<Words*>(to)->emplace_back(std::string(name, name_size), std::string(value == nullptr ? "" : value, size));
    return MHD_YES;
  };
  MHD_get_connection_values_n(client, kind, add, &all);
  return all;
}

/// Throws Refusal 400 where names are none, or what can be said once is said twice; 431 where the lines are too long.
Head head_of(MHD_Connection* client, const char* method, const char* path)
{
  if (MHD_get_connection_info(client, MHD_CONNECTION_INFO_REQUEST_HEADER_SIZE)->header_size > longest_head)
    throw Refusal(431, fmt::format("the lines of the request have more than {} bytes", longest_head));
  Head head{method, path, {}, {}};
  for (const auto& [name, value] : words_of(client, MHD_GET_ARGUMENT_KIND))
    if (!head.query.emplace(name, value).second) throw Refusal(400, fmt::format("the address gives {} twice", one_line(name)));
  for (const auto& [name, value] : words_of(client, MHD_HEADER_KIND)) {
    if (name.empty() || std::any_of(name.begin(), name.end(), [](unsigned char c) { return std::isgraph(c) == 0; }) ||
        std::any_of(value.begin(), value.end(), [](unsigned char c) { return std::iscntrl(c) != 0 && c != '\t'; }))
      throw Refusal(400, "a line of the request is not NAME: VALUE");
    head.fields.emplace(in_small_letters(name), value.substr(0, value.find_last_not_of(" \t") + 1));
  }
  for (const char* once : {"authorization", "content-length", "content-type", "origin"})
    if (head.fields.count(once) > 1) throw Refusal(400, fmt::format("the request gives {} twice", once));
  return head;
}

/// Throws Refusal where the body that follows cannot be taken.
void check_size_of_body(const Head& head)
{
  if (head.has("transfer-encoding")) throw Refusal(411, "the request does not give the length of its body");
  const std::string digits = head.field("content-length");
  if (digits.find_first_not_of("0123456789") != std::string::npos) throw Refusal(400, "the length of the body is not a number");
  if (digits.size() > 9 || (!digits.empty() && std::stoul(digits) > most_bytes_of_body))
    throw Refusal(413, fmt::format("the body has more than {} bytes", most_bytes_of_body));
}

/// `closes`: the client may send no other request.
MHD_Result give(MHD_Connection* client, Answer answer, bool closes)
{
  auto held = std::make_unique<Answer>(std::move(answer));
  const std::string_view bytes = held->bytes();
  MHD_Response* const response = MHD_create_response_from_buffer_with_free_callback_cls(
      bytes.size(), const_cast<char*>(bytes.data()), [](void* one) { delete static_cast<Answer*>(one); }, held.get());
  if (response == nullptr) return MHD_NO;
  const Answer& given = *held.release();
  const auto say = [&](const char* name, const std::string& value) { MHD_add_response_header(response, name, value.c_str()); };
  say("Content-Security-Policy", given.policy.empty() ? policy_of_data : given.policy);
  say("X-Content-Type-Options", "nosniff");
  say("X-DNS-Prefetch-Control", "off");
  say("Cache-Control", "no-store");
  say("Referrer-Policy", "no-referrer");
  say("Cross-Origin-Resource-Policy", "same-origin");
  if (closes) say("Connection", "close");
  if (given.status != 204) say("Content-Type", given.type);
  const MHD_Result result = MHD_queue_response(client, static_cast<unsigned>(given.status), response);
  MHD_destroy_response(response);
  return result;
}

/// A request whose body is coming.
struct Coming {
  Request request;
  std::string body = {};
};

Connection& connection_of(MHD_Connection* client)
{
  return *static_cast<Connection*>(MHD_get_connection_info(client, MHD_CONNECTION_INFO_SOCKET_CONTEXT)->socket_context);
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
  Proxy proxy;
  Handler open, with_token;
  std::string token = random_word(32);
  Connections connections = {};
  std::unique_ptr<MHD_Daemon, decltype(&MHD_stop_daemon)> daemon{nullptr, &MHD_stop_daemon};

  /// Throws Refusal where the request may not be answered; before its body is read.
  void guard(const Head& head) const
  {
    const std::string host = head.field("host"), origin = head.field("origin");
    const bool by_proxy = is_host(host, {proxy.name});
    if (head.fields.count("host") != 1 || (!by_proxy && !is_host(host, {"127.0.0.1", "localhost", "[::1]"})))
      throw Refusal(403, "this server answers to 127.0.0.1, localhost and [::1] only: open the address that berm desk prints");
    if (head.has("origin") && origin != "http://" + host && !(by_proxy && origin == "https://" + host))
      throw Refusal(403, "the request comes from a page of another site");
    if (head.method != "GET" && head.method != "POST" && head.method != "PUT") throw Refusal(405, "only GET, POST and PUT are answered");
    if (head.path.size() > longest_path) throw Refusal(404, "there is no such address");
    if (!head.is_api()) {
      if (head.method != "GET") throw Refusal(405, "only GET is answered here");
      return;
    }
    if (!same_word(head.field("authorization"), "Bearer " + token))
      throw Refusal(401, "the token is missing or wrong: open the address that berm desk prints");
    if (head.method == "GET") return;
    if (head.field("content-type") != "application/json") throw Refusal(415, "the body must be application/json");
    if (head.has("content-encoding")) throw Refusal(415, "the body must not be compressed");
  }

  /// Called with the head of a request, with each part of its body, and at its end.
  MHD_Result take(MHD_Connection* client, const char* path, const char* method, std::string_view part, void** of_request)
  {
    Connection& connection = connection_of(client);
    auto* const coming = static_cast<Coming*>(*of_request);
    if (coming == nullptr) {
      connections.wait_for_body(connection);
      const Answer refusal = answer_of([&] {
        const std::string_view address(path);
        const bool has_prefix = !proxy.prefix.empty() && address.starts_with(proxy.prefix + "/");
        const Head head = head_of(client, method, path + (has_prefix ? proxy.prefix.size() : 0));
        guard(head);
        if (head.is_api()) connections.trust(connection);
        check_size_of_body(head);
        *of_request = new Coming{{head.method, head.path, head.query}};
        return Answer{};
      });
      return *of_request == nullptr ? give(client, refusal, true) : MHD_YES;
    }
    if (!part.empty()) {
      coming->body += part;
      return MHD_YES;
    }
    connections.work_on_answer(connection);
    Answer answer = answer_of([&] {
      Request& request = coming->request;
      if (request.method != "GET") request.body = json_of(coming->body);
      return (request.path.starts_with("/api/") ? with_token : open)(request);
    });
    connections.wait_until_taken(connection);
    return give(client, std::move(answer), connections.is_stopping());
  }

  /// With a thread for each connection, so that one that waits keeps no other from its answer.
  void listen(const Listen& at)
  {
    const MHD_AccessHandlerCallback taken = [](void* parts, MHD_Connection* client, const char* path, const char* method, const char*,
                                               const char* part, std::size_t* size, void** of_request) {
      try {
        return static_cast<Parts*>(parts)->take(client, path, method, {part, std::exchange(*size, 0)}, of_request);
      } catch (const std::exception&) {  // the machine has no memory for it: it ends without an answer
        return MHD_NO;
      }
    };
    const MHD_RequestCompletedCallback done = [](void* parts, MHD_Connection* client, void** of_request, MHD_RequestTerminationCode) {
      delete static_cast<Coming*>(*of_request);
      static_cast<Parts*>(parts)->connections.wait_for_request(connection_of(client));
    };
    const MHD_NotifyConnectionCallback changed = [](void* parts, MHD_Connection* client, void** connection,
                                                    MHD_ConnectionNotificationCode code) {
      Connections& all = static_cast<Parts*>(parts)->connections;
      if (code == MHD_CONNECTION_NOTIFY_STARTED)
        *connection = all.add(MHD_get_connection_info(client, MHD_CONNECTION_INFO_CONNECTION_FD)->connect_fd);
      else
        all.remove(static_cast<Connection*>(*connection));
    };
    sockaddr_in here{};
    here.sin_family = AF_INET;
    here.sin_port = htons(static_cast<std::uint16_t>(at.port));
    here.sin_addr.s_addr = inet_addr(at.address.c_str());
    // Those that are cut end as soon as the system lets them, whatever their clients do: newcomers wait for that, but for no client.
    constexpr auto most = static_cast<unsigned>(2 * Connections::places);
    daemon.reset(MHD_start_daemon(MHD_USE_THREAD_PER_CONNECTION | MHD_USE_POLL_INTERNAL_THREAD | MHD_USE_ITC, 0, nullptr, nullptr, taken,
                                  this,  //
                                  MHD_OPTION_SOCK_ADDR, &here, MHD_OPTION_LISTEN_BACKLOG_SIZE, most_waiting, MHD_OPTION_CONNECTION_LIMIT,
                                  most, MHD_OPTION_CONNECTION_MEMORY_LIMIT, memory_of_connection, MHD_OPTION_STRICT_FOR_CLIENT, 1,
                                  MHD_OPTION_NOTIFY_COMPLETED, done, this, MHD_OPTION_NOTIFY_CONNECTION, changed, this, MHD_OPTION_END));
    if (daemon == nullptr)
      throw RunError(at.port == 0 ? fmt::format("no port of {} is free", at.address)
                                  : fmt::format("port {} of {} is taken, or the machine has no such address", at.port, at.address));
  }
};

HttpServer::HttpServer(const Listen& at, Proxy proxy, Handler open, Handler with_token)
    : parts_(new Parts{std::move(proxy), std::move(open), std::move(with_token)})
{
  parts_->listen(at);
}

HttpServer::~HttpServer() = default;

int HttpServer::port() const
{
  return MHD_get_daemon_info(parts_->daemon.get(), MHD_DAEMON_INFO_BIND_PORT)->port;
}

const std::string& HttpServer::token() const
{
  return parts_->token;
}

std::string HttpServer::address() const
{
  return fmt::format("http://127.0.0.1:{}/#{}", port(), parts_->token);
}

void HttpServer::serve()
{
  parts_->connections.watch();
}

void HttpServer::stop()
{
  parts_->connections.stop();
}

}  // namespace berm::desk
