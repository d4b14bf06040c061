// SPDX-License-Identifier: BSD-3-Clause
// Requests as browsers write them, and what is none.
#include "samples/desk_client.hpp"

#include <gtest/gtest.h>

namespace berm::desk::this_file {
namespace {

TEST(DeskRequestHead, is_read_as_browsers_write_it)
{
  const TemporaryFolder folder;
  const DeskClient desk(folder.path());
  std::filesystem::create_directories(folder / "my site&more");
  std::ofstream(folder / "my site&more/case.toml") << "x = 1";
  const std::string rest = fmt::format("Host: localhost\r\nAUTHORIZATION:Bearer {} \r\nX: 1\r\nx: 2\r\n", desk.token);
  for (const char* path : {"my+site%26more/case.toml", "my%20site%26more%2Fcase.toml"}) {
    const Response response = desk.raw(fmt::format("GET /api/case?path={}&empty= HTTP/1.0\r\n{}\r\n", path, rest));
    EXPECT_EQ(response.status, 200) << response.body;
    EXPECT_EQ(response.json().value("text", ""), "x = 1");
  }
  const auto request = [&](const char* line) { return fmt::format("GET /%61pi/about HTTP/1.1\r\n{}{}\r\n", rest, line); };
  EXPECT_EQ(desk.raw(request("Connection: Close\r\n")).status, 200);
  // The next request on the same connection.
  const Caller caller(desk.port);
  for (int k = 0; k < 3; ++k) {
    caller.send(request(""));
    ASSERT_TRUE(caller.reads("folder"));
  }
  caller.send(request("") + request("") + request("Connection: close\r\n"));
  EXPECT_TRUE(caller.reads("folder"));
  EXPECT_TRUE(caller.ends());
}

TEST(DeskRequestHead, is_refused_where_it_is_none)
{
  const TemporaryFolder folder;
  const DeskClient desk(folder.path());
  const std::string rest = fmt::format("Host: 127.0.0.1:{}\r\nAuthorization: Bearer {}\r\nConnection: close\r\n", desk.port, desk.token);
  const auto status = [&](const std::string& first, const std::string& more = "") {
    return desk.raw(first + "\r\n" + rest + more + "\r\n").status;
  };
  EXPECT_EQ(status("GET /api/about HTTP/1.1"), 200);
  EXPECT_EQ(status("GET"), 0) << "no answer";
  for (const char* first : {"", "GET /api/about", "GET /api/about HTTP/2", "GET /api/about HTTP/1.1 ", "GET /api/about?a=1&a=2 HTTP/1.1"})
    EXPECT_EQ(status(first), 400) << first;
  for (const char* first :
       {"GET api/about HTTP/1.1", "GET http://127.0.0.1/api/about HTTP/1.1", "GET /api/about\x01 HTTP/1.1", "GET /api/about\xff HTTP/1.1",
        "GET /api/about% HTTP/1.1", "GET /api/about%2 HTTP/1.1", "GET /api/%zzabout HTTP/1.1", "GET /api/%-1about HTTP/1.1"})
    EXPECT_EQ(status(first), 404) << first;
  EXPECT_EQ(status("G(T /api/about HTTP/1.1"), 405);
  for (const char* more : {"no field\r\n", "Host : x\r\n",
                           "X: a\x01"
                           "b\r\n",
                           "Content-Length: 1\r\ncontent-length: 2\r\n", "Origin: a\r\nOrigin: b\r\n", "Authorization: x\r\n"})
    EXPECT_EQ(status("GET /api/about HTTP/1.1", more), 400) << more;
  // RFC 9112 lets a server read these: blanks between words, a line that goes on, a line that ends without CR. A field without a name is no field.
  EXPECT_EQ(status("GET  /api/about HTTP/1.1"), 200);
  EXPECT_EQ(status("GET /api/about HTTP/1.1", "X: a\r\n b\r\n"), 200);
  EXPECT_EQ(status("GET /api/about HTTP/1.1", "X: a\nY: b\r\n"), 200);
  EXPECT_EQ(status("GET /api/about HTTP/1.1", ": x\r\n"), 200);
  EXPECT_EQ(status("GET /api/about HTTP/1.1", "X: a\nHost: evil.example\r\n"), 403) << "two hosts";
}

}  // namespace
}  // namespace berm::desk::this_file
