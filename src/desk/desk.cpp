// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/desk/desk_test.cpp
#include "desk/desk.hpp"

#include "desk/actions.hpp"
#include "desk/desk_files.hpp"
#include "desk/files.hpp"
#include "desk/http.hpp"
#include "desk/runs.hpp"
#include "io/revision.hpp"
#include "os/threads.hpp"
#include "sandbox/sandbox.hpp"

#include <charconv>
#include <cstdlib>
#include <fmt/format.h>

namespace berm::desk {
namespace {

Answer json(const Json& value)
{
  return {.body = value.dump(-1, ' ', false, Json::error_handler_t::replace)};
}

Answer svg(std::string text)
{
  return {.body = std::move(text), .type = "image/svg+xml"};
}

std::string query(const Request& request, const char* key)
{
  const auto found = request.query.find(key);
  return found == request.query.end() ? "" : found->second;
}

long number(const Request& request, const char* key, long otherwise)
{
  const std::string word = query(request, key);
  long value = otherwise;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (!word.empty() && (error != std::errc() || end != word.data() + word.size() || value < -1))
    throw Refusal(400, fmt::format("{} is not a number", key));
  return value;
}

/// The page; its style has a nonce, which the editor's needs, too.
Answer page()
{
  const std::string nonce = random_word(16);
  return {.body = fmt::format(
              "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><meta name=\"viewport\" content=\"width=device-width, "
              "initial-scale=1\">"
              "<title>berm desk</title><link rel=\"icon\" href=\"data:,\"><link rel=\"stylesheet\" href=\"desk.css\" nonce=\"{}\">"
              "<script src=\"desk.js\" defer></script></head><body><header><nav><strong class=\"brand\">berm "
              "desk</strong></nav></header></body></html>\n",
              nonce),
          .type = "text/html; charset=utf-8",
          .policy = fmt::format("default-src 'none'; script-src 'self'; style-src 'self' 'nonce-{}'; connect-src 'self'; img-src 'self' "
                                "blob: data:; frame-src 'self' blob:; "
                                "base-uri 'none'; form-action 'none'; frame-ancestors 'none'",
                                nonce)};
}

/// Programs that a case brings run in a sandbox, as berm does it; where there is none a case that brings one is refused, unless the user has said that none is wanted.
std::vector<std::string> options_of_cases()
{
  const char* none_wanted = std::getenv("BERM_NO_SANDBOX");
  const bool wanted = none_wanted == nullptr || std::string_view(none_wanted) != "1";
  return wanted && !sandbox::why_there_is_none().empty() ? std::vector<std::string>{"--no-programs"} : std::vector<std::string>{};
}

}  // namespace

struct Desk::Parts {
  Folder folder;
  std::shared_ptr<Queue> queue;
  Questions questions;
  Runs runs;
  Actions actions;
  ShownFiles shown;
  std::map<std::string, Handler> routes;  ///< "GET /api/about"
  HttpServer server;

  explicit Parts(const DeskSettings& settings)
      : folder(settings.folder),
        queue(std::make_shared<Queue>(folder.root(), settings.threads > 0 ? settings.threads : processor_count())),
        questions(folder.root()),
        runs(folder, queue, settings.place, options_of_cases()),
        actions(folder, queue, questions, options_of_cases()),
        shown(folder),
        routes(all_routes()),
        server(
            settings.listen, settings.proxy, [this](const Request& request) { return open(request); },
            [this](const Request& request) { return api(request); })
  {
  }

  std::map<std::string, Handler> all_routes()
  {
    std::map<std::string, Handler> all;
    all["GET /api/about"] = [this](const Request&) {
      return json({{"version", io::version_words()}, {"folder", folder.root().string()}, {"cores", queue->threads()}});
    };
    all["GET /api/schema"] = [this](const Request& r) { return json(actions.schema(query(r, "of"))); };
    all["GET /api/kinds"] = [this](const Request&) { return json(actions.printed({"new", "--json"})); };
    all["GET /api/soils"] = [this](const Request&) { return json(actions.printed({"new", "--soils", "--json"})); };
    all["POST /api/new"] = [this](const Request& r) { return json(actions.new_case(r.body)); };
    all["GET /api/folder"] = [this](const Request& r) { return json(folder.contents(query(r, "path"))); };
    all["GET /api/case"] = [this](const Request& r) { return json(folder.read(query(r, "path"))); };
    all["PUT /api/case"] = [this](const Request& r) { return json(folder.write(query(r, "path"), r.body)); };
    all["POST /api/check"] = [this](const Request& r) { return json(actions.check(r.body)); };
    all["POST /api/draw"] = [this](const Request& r) { return svg(actions.draw(r.body)); };
    all["GET /api/runs"] = [this](const Request&) { return json(runs.list()); };
    all["POST /api/runs"] = [this](const Request& r) { return json(runs.start(r.body)); };
    all["POST /api/runs/stop"] = [this](const Request& r) { return runs.stop(text_in(r.body, "path")), json(Json::object()); };
    all["POST /api/runs/remove"] = [this](const Request& r) { return runs.remove(text_in(r.body, "path")), json(Json::object()); };
    all["POST /api/runs/rename"] = [this](const Request& r) { return json(runs.rename(text_in(r.body, "path"), text_in(r.body, "name"))); };
    all["POST /api/runs/notes"] = [this](const Request& r) {
      return runs.note(text_in(r.body, "path"), text_in(r.body, "text")), json(Json::object());
    };
    all["GET /api/run"] = [this](const Request& r) {
      return json(runs.one(query(r, "path"), static_cast<std::size_t>(std::max(number(r, "from_row", 0), 0L))));
    };
    all["GET /api/run/soil"] = [this](const Request& r) {
      const auto soil = soil_of(folder, folder.run(query(r, "path")), number(r, "after", -1), query(r, "field"));
      return soil ? json(*soil) : Answer{.status = 204};
    };
    all["POST /api/report"] = [this](const Request& r) { return json(actions.report(r.body)); };
    all["POST /api/export"] = [this](const Request& r) { return json(actions.export_springs(r.body)); };
    all["GET /api/jobs"] = [this](const Request&) { return json(actions.jobs()); };
    all["POST /api/jobs/stop"] = [this](const Request& r) { return runs.stop(text_in(r.body, "job")), json(Json::object()); };
    all["GET /api/file"] = [this](const Request& r) { return file_answer(folder.inside(query(r, "path"))); };
    all["POST /api/show"] = [this](const Request& r) {
      const ShownFiles::Shown one = shown.add(text_in(r.body, "path"));
      return json({{"address", one.address}, {"without_scripts", one.without_scripts}});
    };
    return all;
  }

  Answer api(const Request& request)
  {
    constexpr std::string_view kinds = "/api/kinds/", picture = "/picture", jobs = "/api/";
    if (const auto found = routes.find(request.method + " " + request.path); found != routes.end()) return found->second(request);
    if (request.method == "GET" && request.path.starts_with(kinds) && request.path.ends_with(picture) &&
        request.path.size() > kinds.size() + picture.size())
      return svg(actions.picture(request.path.substr(kinds.size(), request.path.size() - kinds.size() - picture.size())));
    if (request.method == "POST" && Actions::is_job(request.path.substr(jobs.size())))
      return json(actions.start(request.path.substr(jobs.size()), request.body));
    throw Refusal(404, "there is no such address");
  }

  Answer open(const Request& request) const
  {
    if (request.path == "/") return page();
    if (request.path == "/desk.js") return {.type = "text/javascript; charset=utf-8", .held = desk_script};
    if (request.path == "/desk.css") return {.type = "text/css; charset=utf-8", .held = desk_style};
    return shown.answer(request.path);
  }
};

Desk::Desk(const DeskSettings& settings) : parts_(std::make_unique<Parts>(settings)) {}

Desk::~Desk() = default;

std::string Desk::address() const
{
  return parts_->server.address();
}

void Desk::serve()
{
  parts_->server.serve();
}

void Desk::stop()
{
  parts_->questions.end();
  parts_->server.stop();
}

}  // namespace berm::desk
