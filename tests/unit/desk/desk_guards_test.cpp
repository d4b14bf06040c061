// SPDX-License-Identifier: BSD-3-Clause
// What a desk refuses: requests of other pages, of programs without the token, and of its own page that reach for more than its folder.
#include "samples/desk_client.hpp"
#include "samples/small_cases.hpp"

#include <gtest/gtest.h>

namespace berm::desk::this_file {
namespace {

namespace fs = std::filesystem;

/// A folder to serve beside one that is not, with links from the first to the second.
class DeskGuards : public testing::Test {
protected:
  DeskGuards()
  {
    fs::create_directories(served() / "bay");
    fs::create_directories(place_ / "secret");
    std::ofstream(served() / "bay/case.toml") << test::small_case;
    std::ofstream(served() / "page.html") << "<p>page";
    std::ofstream(served() / ".hidden.toml") << "x = 1";
    std::ofstream(place_ / "secret/case.toml") << "x = 1";
    fs::create_directory_symlink(place_ / "secret", served() / "out_of_it");
    fs::create_symlink(place_ / "secret/case.toml", served() / "link.toml");
    fs::create_symlink(place_ / "secret/new.toml", served() / "dangling.toml");
    desk_.emplace(served());
  }

  fs::path served() const { return place_ / "served"; }
  std::vector<std::string> all_files() const
  {
    std::vector<std::string> files;
    for (const auto& entry : fs::recursive_directory_iterator(place_.path()))
      files.push_back(entry.path().string() + " " + (entry.is_regular_file() ? text_of_file(entry.path()) : ""));
    std::sort(files.begin(), files.end());
    return files;
  }

  TemporaryFolder place_;
  std::optional<DeskClient> desk_;
};

std::string replaced(std::string text, const std::string& what, const std::string& by)
{
  return text.replace(text.find(what), what.size(), by);
}

std::string nested(int levels)
{
  return "{\"a\":" + std::string(levels, '[') + std::string(levels, ']') + "}";
}

std::string many_lines(int count)
{
  std::string lines;
  for (int k = 0; k < count; ++k) lines += "a: b\r\n";
  return lines;
}

TEST_F(DeskGuards, refuses_and_writes_nothing)
{
  const DeskClient& desk = *desk_;
  ASSERT_GT(desk.port, 0);
  const std::string about = desk.head("GET", "/api/about"), host = fmt::format("127.0.0.1:{}", desk.port);
  const std::string start = desk.head("POST", "/api/runs"), json = "Content-Type: application/json\r\n",
                    run = R"({"case":"bay/case.toml"})";
  const auto length = [](const std::string& body) { return fmt::format("Content-Length: {}\r\n\r\n{}", body.size(), body); };
  const auto post = [&](const char* target, const std::string& body) { return desk.head("POST", target) + json + length(body); };
  const auto put = [&](const char* path) {
    return desk.head("PUT", fmt::format("/api/case?path={}", path)) + json + length(R"({"text":"x = 1"})");
  };
  std::ofstream(served() / "bay/kept.toml") << "x = 1";
  fs::permissions(served() / "bay/kept.toml", fs::perms::owner_read);
  const std::string mark = desk.get("/api/case?path=bay/kept.toml").json().value("modified", "");
  const auto get = [&](const char* target) { return desk.head("GET", target) + "\r\n"; };
  const struct {
    int status;
    const char* what;
    std::string request;
  } table[] = {
      {401, "no token", replaced(about, "Authorization: Bearer " + desk.token + "\r\n", "") + "\r\n"},
      {401, "a wrong token", replaced(about, desk.token, std::string(64, 'a')) + "\r\n"},
      {401, "a part of the token", replaced(about, desk.token, desk.token.substr(0, 32)) + "\r\n"},
      {401, "a token and more", replaced(about, desk.token, desk.token + "0") + "\r\n"},
      {401, "a token without its word", replaced(about, "Bearer ", "") + "\r\n"},
      {401, "the token in the address",
       replaced(replaced(about, "Authorization: Bearer " + desk.token + "\r\n", ""), "about", "about?token=" + desk.token) + "\r\n"},
      {401, "the token in a cookie", replaced(about, "Authorization: Bearer ", "Cookie: token=") + "\r\n"},
      {401, "a run without the token", replaced(start, desk.token, "x") + json + length(run)},
      {403, "the name of another host", replaced(about, host, "evil.example") + "\r\n"},
      {403, "another host with this port", replaced(about, host, fmt::format("evil.example:{}", desk.port)) + "\r\n"},
      {403, "a name that begins like this one", replaced(about, host, "127.0.0.1.evil.example") + "\r\n"},
      {403, "a name that begins like this one, with the port",
       replaced(about, host, fmt::format("localhost.evil.example:{}", desk.port)) + "\r\n"},
      {403, "a port that is none", replaced(about, host, "127.0.0.1:80.evil.example") + "\r\n"},
      {403, "another address of this machine", replaced(about, host, fmt::format("127.0.0.2:{}", desk.port)) + "\r\n"},
      {403, "two hosts", about + "Host: " + host + "\r\n\r\n"},
      {403, "the page itself by another name", replaced(replaced(about, host, "evil.example"), "/api/about", "/") + "\r\n"},
      {403, "a page of another origin", about + "Origin: http://evil.example\r\n\r\n"},
      {403, "a page without an origin", about + "Origin: null\r\n\r\n"},
      {403, "a page of another port", about + "Origin: http://127.0.0.1:1\r\n\r\n"},
      {403, "a page of the server's port through a tunnel", replaced(about, host, "127.0.0.1:1") + "Origin: http://" + host + "\r\n\r\n"},
      {403, "a page of another scheme", about + "Origin: https://" + host + "\r\n\r\n"},
      {405, "DELETE", desk.head("DELETE", "/api/case?path=bay/case.toml") + "\r\n"},
      {405, "OPTIONS", desk.head("OPTIONS", "/api/runs") + "Origin: http://" + host + "\r\n\r\n"},
      {405, "PATCH", desk.head("PATCH", "/api/case") + json + length(run)},
      {405, "POST to the page", post("/", "{}")},
      {404, "GET of what is posted", get("/api/report")},
      {404, "POST of what is got", post("/api/about", "{}")},
      {404, "an address that there is not", get("/api/nothing")},
      {404, "a file of the folder as an address", get("/bay/case.toml")},
      {404, "an address of a shown file that nobody was given", get("/shown/00000000000000000000000000000000")},
      {404, "a very long address", get(("/api/" + std::string(4000, 'a')).c_str())},
      {415, "a form", start + "Content-Type: application/x-www-form-urlencoded\r\n" + length("case=bay/case.toml")},
      {415, "plain text, which any page may send", start + "Content-Type: text/plain\r\n" + length(run)},
      {415, "a body without a type", start + length(run)},
      {415, "a compressed body", start + json + "Content-Encoding: gzip\r\n" + length("\x1f\x8b")},
      {413, "a length of five million", start + json + "Content-Length: 5000000\r\n\r\n"},
      {411, "a body in chunks", start + json + "Transfer-Encoding: chunked\r\n\r\n2\r\n{}\r\n0\r\n\r\n"},
      {400, "two lengths", start + json + "Content-Length: 2\r\nContent-Length: 3\r\n\r\n{}"},
      {431, "lines that are too long", about + "X: " + std::string(16300, 'a') + "\r\n\r\n"},
      {400, "JSON of a thousand levels", post("/api/runs", nested(1000))},
      {400, "no JSON", post("/api/runs", "case=x")},
      {400, "JSON that is no object", post("/api/runs", "[1]")},
      {400, "no UTF-8", post("/api/runs", "{\"case\":\"\xff\xfe\"}")},
      {400, "no case", post("/api/runs", "{}")},
      {400, "a case that is a number", post("/api/runs", R"({"case":1})")},
      {400, "a change without a value", post("/api/runs", R"({"case":"bay/case.toml","set":["title"]})")},
      {400, "a change that is an option", post("/api/runs", R"({"case":"bay/case.toml","set":["--output=/tmp/x"]})")},
      {400, "a change with a command of a shell", post("/api/runs", R"({"case":"bay/case.toml","set":["$(touch x)=1"]})")},
      {400, "a change with a new line", post("/api/runs", R"({"case":"bay/case.toml","set":["title=1\ngravity=2"]})")},
      {400, "no number of threads", post("/api/runs", R"({"case":"bay/case.toml","threads":"1; touch x"})")},
      {400, "a kind that is an option", post("/api/new", R"({"kind":"--help","path":"new.toml"})")},
      {400, "a soil that is a command", post("/api/new", R"({"kind":"pipe-in-sand","soil":"; touch x","path":"new.toml"})")},
      {400, "a format that is a path", post("/api/export", R"({"runs":["bay"],"to":"../../x"})")},
      {400, "a row that is not a number", get("/api/run?path=bay&from_row=1e9")},
      {403, "out into another folder", post("/api/runs", R"({"case":"bay/case.toml","out":"../secret/run"})")},
      {403, "out to a whole path", post("/api/runs", R"({"case":"bay/case.toml","out":"/tmp/berm_desk_run"})")},
      {403, "out by a link", post("/api/runs", R"({"case":"bay/case.toml","out":"out_of_it/run"})")},
      {403, "out that is an option", post("/api/runs", R"({"case":"bay/case.toml","out":"--force"})")},
      {403, "a case that is an option", post("/api/runs", R"({"case":"--out=/etc/x.toml"})")},
      {403, "a report of what lies outside", post("/api/report", R"({"runs":["../secret"]})")},
      {403, "a study outside", post("/api/study", R"({"path":"../secret/case.toml"})")},
      {403, "a check as of a file outside", post("/api/check", R"({"path":"../secret/case.toml","text":""})")},
      {403, "a folder above", get("/api/folder?path=..")},
      {403, "a folder above in other letters", get("/api/folder?path=%2e%2e")},
      {403, "a case above", get("/api/case?path=../secret/case.toml")},
      {403, "a case above with a way around", get("/api/case?path=bay/../../secret/case.toml")},
      {403, "a case above in other letters", get("/api/case?path=%2e%2e%2fsecret%2fcase.toml")},
      {403, "a whole path", get("/api/file?path=/etc/passwd")},
      {403, "/proc", get("/api/file?path=/proc/self/environ")},
      {403, "NUL", get("/api/file?path=page.html%00.toml")},
      {403, "no UTF-8 in a path", get("/api/file?path=%ff.toml")},
      {403, "a link to a file outside", get("/api/case?path=link.toml")},
      {403, "a link to a folder outside", get("/api/case?path=out_of_it/case.toml")},
      {403, "a hidden file", get("/api/case?path=.hidden.toml")},
      {403, "writing above", put("../secret/new.toml")},
      {403, "writing through a folder's link", put("out_of_it/new.toml")},
      {403, "writing through a file's link", put("link.toml")},
      {403, "writing through a link to nothing", put("dangling.toml")},
      {403, "writing what is no case", put("page.html")},
      {403, "writing a file that is write-protected",
       desk.head("PUT", "/api/case?path=bay/kept.toml") + json + length(fmt::format(R"({{"text":"y","modified":"{}"}})", mark))},
      {403, "writing a hidden file", put(".bashrc.toml")},
      {409, "writing over a file without having read it", put("bay/case.toml")},
      {409, "stopping what nobody runs", post("/api/runs/stop", R"({"path":"bay"})")},
  };
  const std::vector<std::string> before = all_files();
  for (const auto& row : table) {
    const Response response = desk.raw(row.request);
    EXPECT_EQ(response.status, row.status) << row.what << "\n" << response.head << "\n" << response.body.substr(0, 300);
    EXPECT_TRUE(response.json().contains("error")) << row.what;
    EXPECT_EQ(response.head.find("Access-Control"), std::string::npos) << row.what;
  }
  // What libmicrohttpd refuses by itself.
  const std::pair<int, std::string> of_library[] = {
      {400, replaced(about, "Host: " + host + "\r\n", "") + "\r\n"},
      {413, start + json + "Content-Length: 99999999999999999999\r\n\r\n"},
      {400, start + json + "Content-Length: -1\r\n\r\n{}"},
      {431, about + "X: " + std::string(20000, 'a')},
      {431, about + many_lines(7000)},
      {0, "hello\r\n\r\n"},
  };
  for (const auto& [status, request] : of_library) EXPECT_EQ(desk.raw(request).status, status) << request.substr(0, 400);
  EXPECT_EQ(all_files(), before);
  EXPECT_EQ(desk.get("/api/about").status, 200);
}

// ssh -L 8081:127.0.0.1:8080, editors that choose a port: the browser names the port where the tunnel begins.
TEST_F(DeskGuards, answers_behind_a_tunnel_that_begins_at_another_port)
{
  const std::string host = fmt::format("127.0.0.1:{}", desk_->port), about = desk_->head("GET", "/api/about");
  for (const std::string tunnel : {"127.0.0.1:1", "localhost:65535", "[::1]:8081", "localhost"}) {
    const std::string through = replaced(about, host, tunnel);
    EXPECT_EQ(desk_->raw(through + "\r\n").status, 200) << tunnel;
    EXPECT_EQ(desk_->raw(through + "Origin: http://" + tunnel + "\r\n\r\n").status, 200) << tunnel;
    EXPECT_EQ(desk_->raw(replaced(through, desk_->token, std::string(64, 'a')) + "\r\n").status, 401) << tunnel;
  }
}

TEST(DeskBehindAProxy, answers_to_its_name_and_below_its_prefix_and_to_no_other_name)
{
  const TemporaryFolder folder;
  const DeskClient desk(folder.path(), {"--name", "soil.example", "--prefix", "/berm"});
  const std::string host = fmt::format("127.0.0.1:{}", desk.port);
  const auto status = [&](const std::string& name, const std::string& target, const std::string& origin = "") {
    const std::string lines = replaced(desk.head("GET", target), host, name);
    return desk.raw(lines + (origin.empty() ? "" : "Origin: " + origin + "\r\n") + "\r\n").status;
  };
  for (const std::string target : {"/api/about", "/berm/api/about", "/berm/", "/berm/desk.js"})
    EXPECT_EQ(status("soil.example", target), 200) << target;
  EXPECT_EQ(status("soil.example:8443", "/api/about", "https://soil.example:8443"), 200);
  EXPECT_EQ(status(host, "/api/about", "http://" + host), 200);
  EXPECT_EQ(status("soil.example", "/bermuda/api/about"), 404);
  EXPECT_EQ(status("soil.example", "/berm/api/about", "https://other.example"), 403);
  EXPECT_EQ(status(host, "/api/about", "https://" + host), 403);
  for (const std::string other : {"other.example", "soil.example.other", "a.soil.example", "soil.example:x"})
    EXPECT_EQ(status(other, "/api/about"), 403) << other;
  const std::string wrong = replaced(replaced(desk.head("GET", "/berm/api/about"), host, "soil.example"), desk.token, std::string(64, 'a'));
  EXPECT_EQ(desk.raw(wrong + "\r\n").status, 401);
}

// As in a container, whose port is forwarded under another number. 127.0.0.2 is an address of this machine, and not the one that a desk has by itself.
TEST(DeskOfAContainer, listens_where_it_is_told_to_and_asks_for_the_same_name_and_token)
{
  const TemporaryFolder folder;
  const DeskClient own(folder.path()), open(folder.path(), {"--listen", "0.0.0.0"});
  EXPECT_FALSE(Caller(own.port, "127.0.0.2").connected());
  const std::string about = open.head("GET", "/api/about"), host = fmt::format("127.0.0.1:{}", open.port);
  const auto status = [&](const std::string& head) {
    const Caller caller(open.port, "127.0.0.2");
    caller.send(head + "\r\n");
    return caller.answer().status;
  };
  for (const std::string forwarded : {"127.0.0.1:9090", "localhost:9090"}) {
    EXPECT_EQ(status(replaced(about, host, forwarded)), 200) << forwarded;
    EXPECT_EQ(status(replaced(replaced(about, host, forwarded), open.token, std::string(64, 'a'))), 401) << forwarded;
  }
  EXPECT_EQ(status(replaced(about, host, "127.0.0.2:9090")), 403);
  for (const std::string wrong : {"everywhere", "127.1", "::", "1.2.3.4.5"}) {
    const Ended ended = run_program(folder.path(), {"desk", "--no-browser", "--listen", wrong});
    EXPECT_EQ(ended.status, 2) << wrong;
    EXPECT_NE(ended.err.find("as 0.0.0.0"), std::string::npos) << ended.err;
  }
}

TEST_F(DeskGuards, does_not_open_a_case_whose_bytes_it_would_change)
{
  const fs::path file = served() / "bay/latin.toml";
  const std::string text = "x = 1\n# K\xf6ln\n";
  std::ofstream(file, std::ios::binary) << text;
  const Response response = desk_->get("/api/case?path=bay/latin.toml");
  EXPECT_EQ(response.status, 422);
  const std::string why = response.json().value("error", "");
  EXPECT_NE(why.find("bay/latin.toml is not in UTF-8: line 2"), std::string::npos) << why;
  EXPECT_EQ(desk_->get("/api/folder?path=bay").status, 200) << "others are there";
  EXPECT_EQ(text_of_file(file), text);
}

TEST_F(DeskGuards, its_pages_fetch_nothing_and_are_not_framed)
{
  const Response page = desk_->get("/");
  EXPECT_EQ(page.status, 200);
  for (const char* part : {"Content-Security-Policy: default-src 'none'; script-src 'self'", "frame-ancestors 'none'",
                           "X-Content-Type-Options: nosniff", "Cache-Control: no-store"})
    EXPECT_NE(page.head.find(part), std::string::npos) << part << "\n" << page.head;
  EXPECT_EQ(page.body.find(desk_->token), std::string::npos);
  EXPECT_EQ(desk_->get("/desk.js").body.find(desk_->token), std::string::npos);
  // Bytes that are asked for in many ranges are given once.
  const Response whole = desk_->get("/desk.js");
  std::string ranges = "Range: bytes=0-";
  for (int k = 0; k < 1000; ++k) ranges += ",0-";
  EXPECT_EQ(desk_->raw(desk_->head("GET", "/desk.js") + ranges + "\r\n\r\n").body.size(), whole.body.size());
}

TEST_F(DeskGuards, scripts_of_others_do_not_run_in_pages_that_it_shows)
{
  const auto shown = [&](const char* path) {
    const Response about = desk_->post("/api/show", {{"path", path}});
    EXPECT_EQ(about.status, 200) << about.body;
    return std::pair{desk_->get(about.json().value("address", "")), about.json().value("without_scripts", false)};
  };
  const auto [page, of_page] = shown("page.html");
  EXPECT_EQ(page.body, "<p>page");
  EXPECT_NE(page.head.find("Content-Security-Policy: sandbox; default-src 'none';"), std::string::npos) << page.head;
  EXPECT_FALSE(of_page);
  std::ofstream(served() / "hostile.html") << "<script>location.href = 'http://127.0.0.1:1/'</script>";
  const auto [hostile, of_hostile] = shown("hostile.html");
  EXPECT_NE(hostile.head.find("Content-Security-Policy: sandbox; default-src 'none';"), std::string::npos) << hostile.head;
  EXPECT_TRUE(of_hostile);
  // A report: its script by its hash.
  ASSERT_EQ(run_program(served(), {"run", "bay/case.toml", "-o", "run"}).status, 0);
  ASSERT_EQ(run_program(served(), {"report", "run"}).status, 0);
  const auto [report, of_report] = shown("run/report.html");
  EXPECT_FALSE(of_report);
  const std::size_t at = report.body.find("script-src 'sha256-");
  ASSERT_NE(at, std::string::npos);
  const std::string source = report.body.substr(at, report.body.find(';', at) - at);
  EXPECT_NE(report.head.find("Content-Security-Policy: sandbox allow-scripts allow-downloads; " + source + "; default-src 'none';"),
            std::string::npos)
      << report.head;
  // A page that says so too, and would go elsewhere by itself.
  for (const char* more :
       {"<META HTTP-EQUIV=refresh content='0;url=http://127.0.0.1:1/'>", "<Link rel=preconnect href='http://127.0.0.1:1'>"}) {
    std::ofstream(served() / "claims.html") << report.body << more;
    const Response claims = shown("claims.html").first;
    EXPECT_NE(claims.head.find("Content-Security-Policy: sandbox; default-src 'none';"), std::string::npos) << claims.head;
  }
  for (const Response& one : {page, hostile, report}) {
    EXPECT_NE(one.head.find("webrtc 'block'"), std::string::npos) << one.head;
    EXPECT_EQ(one.head.find("unsafe-inline' blob"), std::string::npos) << one.head;
  }
}

// MIT asks for the licence in all copies.
TEST_F(DeskGuards, what_it_serves_has_the_licences_of_what_it_holds_of_others)
{
  const std::string script = desk_->get("/desk.js").body, style = desk_->get("/desk.css").body;
  for (const char* held : {"@codemirror/view", "uplot", "Permission is hereby granted"})
    EXPECT_NE(script.substr(0, script.find("*/")).find(held), std::string::npos) << held;
  EXPECT_NE(style.substr(0, style.find("*/")).find("uplot"), std::string::npos);
}

TEST_F(DeskGuards, a_case_that_is_saved_keeps_its_mode)
{
  const fs::path file = served() / "bay/case.toml";
  const fs::perms own = fs::perms::owner_read | fs::perms::owner_write;
  fs::permissions(file, own);
  const std::string mark = desk_->get("/api/case?path=bay/case.toml").json().value("modified", "");
  EXPECT_EQ(desk_->put("/api/case?path=bay/case.toml", {{"text", "x = 2"}, {"modified", mark}}).status, 200);
  EXPECT_EQ(text_of_file(file), "x = 2");
  EXPECT_EQ(fs::status(file).permissions(), own);
}

TEST_F(DeskGuards, clients_that_are_slow_block_nobody)
{
  std::vector<std::unique_ptr<Caller>> slow;
  for (int k = 0; k < 60; ++k) {
    slow.push_back(std::make_unique<Caller>(desk_->port));
    slow.back()->send("GET /api/about HTTP/1.1\r\nHost: ");
  }
  const auto begin = std::chrono::steady_clock::now();
  EXPECT_EQ(desk_->get("/api/about").status, 200);
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(2));
  // It ends at once, though their requests have not.
  desk_->program().signal(SIGINT);
  EXPECT_EQ(desk_->program().wait().status, 0);
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(5));
}

}  // namespace
}  // namespace berm::desk::this_file
