// SPDX-License-Identifier: BSD-3-Clause
#include "desk/request_head.hpp"

#include "desk/refusal.hpp"

#include <gtest/gtest.h>

namespace berm::desk::this_file {
namespace {

int status_of(const std::string& lines)
{
  try {
    head_of(lines);
    return 200;
  } catch (const Refusal& refusal) {
    return refusal.status;
  }
}

TEST(DeskRequestHead, is_read_as_browsers_write_it)
{
  const RequestHead head = head_of(
      "GET /api/a%20b?path=bay%2Fcase.toml&word=x+y&empty= HTTP/1.1\r\nHost: 127.0.0.1:8080\r\nAUTHORIZATION:Bearer a \r\nX: 1\r\nx: 2");
  EXPECT_EQ(head.method, "GET");
  EXPECT_EQ(head.path, "/api/a b");
  EXPECT_EQ(head.query, (std::map<std::string, std::string>{{"path", "bay/case.toml"}, {"word", "x y"}, {"empty", ""}}));
  EXPECT_EQ(head.field("host"), "127.0.0.1:8080");
  EXPECT_EQ(head.field("authorization"), "Bearer a");
  EXPECT_EQ(head.field("x"), "1");
  EXPECT_EQ(head.fields.count("x"), 2u);
  EXPECT_EQ(head.field("hos"), "");
  EXPECT_TRUE(head.keeps_open);
  EXPECT_FALSE(head_of("GET / HTTP/1.1\r\nConnection: Close").keeps_open);
  EXPECT_FALSE(head_of("GET / HTTP/1.0").keeps_open);
  EXPECT_TRUE(head_of("GET / HTTP/1.0\r\nConnection: Keep-Alive").keeps_open);
}

TEST(DeskRequestHead, is_refused_where_it_is_none)
{
  EXPECT_EQ(status_of("GET / HTTP/1.1\r\nHost: x"), 200);
  for (const char* lines : {"",
                            "GET",
                            "GET /",
                            "GET / HTTP/2",
                            "GET  / HTTP/1.1",
                            "GET / HTTP/1.1 ",
                            "GET x HTTP/1.1",
                            "GET http://127.0.0.1/ HTTP/1.1",
                            "G(T / HTTP/1.1",
                            "GET /\x01 HTTP/1.1",
                            "GET /\xff HTTP/1.1",
                            "GET /% HTTP/1.1",
                            "GET /%2 HTTP/1.1",
                            "GET /%zz HTTP/1.1",
                            "GET /%-1 HTTP/1.1",
                            "GET /?a=1&a=2 HTTP/1.1",
                            "GET / HTTP/1.1\r\nno field",
                            "GET / HTTP/1.1\r\n: x",
                            "GET / HTTP/1.1\r\nHost : x",
                            "GET / HTTP/1.1\r\nHost: x\r\n folded",
                            "GET / HTTP/1.1\r\nHost: x\ny: z",
                            "GET / HTTP/1.1\r\nContent-Length: 1\r\ncontent-length: 2",
                            "GET / HTTP/1.1\r\nOrigin: a\r\nOrigin: b"})
    EXPECT_EQ(status_of(lines), 400) << lines;
}

}  // namespace
}  // namespace berm::desk::this_file
