// SPDX-License-Identifier: BSD-3-Clause
// Places of a desk's connections: who has no token keeps nobody from them.
#include "samples/desk_client.hpp"

#include <gtest/gtest.h>

namespace berm::desk::this_file {
namespace {

constexpr int places = 128;

std::vector<std::unique_ptr<Caller>> callers(int port, int count, const std::string& text)
{
  std::vector<std::unique_ptr<Caller>> all;
  for (int k = 0; k < count; ++k) {
    all.push_back(std::make_unique<Caller>(port));
    all.back()->send(text);
  }
  return all;
}

TEST(DeskListener, connections_without_the_token_give_way_the_oldest_first)
{
  const TemporaryFolder folder;
  const DeskClient desk(folder.path());
  const std::string stays =
      fmt::format("GET /api/about HTTP/1.1\r\nHost: 127.0.0.1:{}\r\nAuthorization: Bearer {}\r\n\r\n", desk.port, desk.token);
  const Caller page(desk.port);
  page.send(stays);
  ASSERT_TRUE(page.reads("folder"));
  const auto slow = callers(desk.port, 3 * places, "GET /api/about HTTP/1.1\r\nHost: ");
  EXPECT_EQ(desk.get("/api/about").status, 200);
  EXPECT_TRUE(slow.front()->ends());
  EXPECT_FALSE(slow.back()->has_ended());
  // The page of the desk, the oldest of all, still has its connection.
  page.send(stays);
  EXPECT_TRUE(page.reads("folder"));
}

TEST(DeskListener, of_connections_with_the_token_those_give_way_that_wait)
{
  const TemporaryFolder folder;
  const DeskClient desk(folder.path());
  const std::string stays =
      fmt::format("GET /api/about HTTP/1.1\r\nHost: 127.0.0.1:{}\r\nAuthorization: Bearer {}\r\n\r\n", desk.port, desk.token);
  const auto pages = callers(desk.port, places, stays);
  for (const auto& page : pages) ASSERT_TRUE(page->reads("folder"));
  EXPECT_EQ(desk.get("/api/about").status, 200);
  EXPECT_TRUE(pages.front()->ends());
}

/// Kilobytes of memory that a process has.
int memory_of(pid_t process)
{
  const std::string status = text_of_file(fmt::format("/proc/{}/status", process));
  const std::size_t at = status.find("VmHWM:");
  return at == std::string::npos ? 0 : std::atoi(status.c_str() + at + 6);
}

TEST(DeskListener, a_head_without_end_takes_no_memory)
{
  const TemporaryFolder folder;
  DeskClient desk(folder.path());
  const int before = memory_of(desk.program().id());
  ASSERT_GT(before, 0);
  std::vector<std::thread> clients;
  for (int k = 0; k < 8; ++k)
    clients.emplace_back([&] {
      const Caller caller(desk.port);
      caller.send("GET / HTTP/1.1\r\nX: ");
      const std::string more(1 << 20, 'a');
      for (int n = 0; n < 30; ++n) caller.send(more);
    });
  for (std::thread& client : clients) client.join();
  EXPECT_EQ(desk.get("/api/about").status, 200);
  EXPECT_LT(memory_of(desk.program().id()) - before, 20'000);
}

}  // namespace
}  // namespace berm::desk::this_file
