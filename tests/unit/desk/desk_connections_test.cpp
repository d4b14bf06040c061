// SPDX-License-Identifier: BSD-3-Clause
// Places of a desk's connections: who has no token keeps nobody from them.
#include "desk/connections.hpp"

#include "desk/http.hpp"
#include "os/error.hpp"

#include "samples/desk_client.hpp"

#include <gtest/gtest.h>

namespace berm::desk::this_file {
namespace {

constexpr int places = Connections::places;

std::vector<std::unique_ptr<Caller>> callers(int port, int count, const std::string& text)
{
  std::vector<std::unique_ptr<Caller>> all;
  for (int k = 0; k < count; ++k) {
    all.push_back(std::make_unique<Caller>(port));
    all.back()->send(text);
  }
  return all;
}

TEST(DeskConnections, connections_without_the_token_give_way_the_oldest_first)
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

TEST(DeskConnections, of_connections_with_the_token_those_give_way_that_wait)
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

TEST(DeskConnections, clients_that_are_late_lose_theirs)
{
  int late[2], in_time[2];
  ASSERT_EQ(::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, late), 0);
  ASSERT_EQ(::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, in_time), 0);
  Connections all;
  Connection* const first = all.add(late[0]);
  Connection* const second = all.add(in_time[0]);
  EXPECT_LE(first->deadline, Connection::Clock::now() + Connections::time_of_head);
  all.wait_for_body(*first);
  EXPECT_LE(first->deadline, Connection::Clock::now() + Connections::time_of_body);
  all.trust(*second);
  all.work_on_answer(*second);
  first->deadline = Connection::Clock::now();
  std::jthread watch([&] { all.watch(); });
  pollfd end{late[1], POLLRDHUP, 0}, none{in_time[1], POLLRDHUP, 0};
  EXPECT_EQ(::poll(&end, 1, 5000), 1);
  EXPECT_EQ(::poll(&none, 1, 0), 0);
  // It ends once the one that is answered has its answer.
  all.stop();
  ASSERT_EQ(::write(in_time[0], "answer", 6), 6);
  all.remove(second);
  watch.join();
  for (const int socket : {late[0], late[1], in_time[0], in_time[1]}) ::close(socket);
}

TEST(DeskConnections, a_head_that_comes_a_byte_at_a_time_is_cut_within_its_time)
{
  const TemporaryFolder folder;
  const DeskClient desk(folder.path());
  const Caller caller(desk.port);
  const auto begin = std::chrono::steady_clock::now();
  caller.send("GET / HTTP/1.1\r\nX: ");
  while (!caller.has_ended(200) && std::chrono::steady_clock::now() - begin < 2 * Connections::time_of_head) caller.send("a");
  EXPECT_LT(std::chrono::steady_clock::now() - begin, Connections::time_of_head + std::chrono::seconds(3));
}

TEST(DeskConnections, who_is_being_answered_at_the_end_gets_the_answer)
{
  std::atomic<bool> at_work = false;
  HttpServer server(
      {}, {}, [](const Request&) { return Answer{}; },
      [&](const Request&) {
        at_work = true;
        std::this_thread::sleep_for(std::chrono::milliseconds(500));
        return Answer{.body = "{\"done\":1}"};
      });
  EXPECT_THROW(HttpServer({.port = server.port()}, {}, {}, {}), RunError) << "its port is taken";
  std::jthread serve([&] { server.serve(); });
  const Caller waits(server.port()), caller(server.port());
  caller.send(fmt::format("GET /api/x HTTP/1.1\r\nHost: localhost\r\nAuthorization: Bearer {}\r\n\r\n", server.token()));
  ASSERT_TRUE(wait_until([&] { return at_work.load(); }));
  server.stop();
  EXPECT_TRUE(caller.reads("done"));
  EXPECT_TRUE(waits.ends());
  serve.join();
}

/// Kilobytes of memory that a process has.
int memory_of(pid_t process)
{
  const std::string status = text_of_file(fmt::format("/proc/{}/status", process));
  const std::size_t at = status.find("VmHWM:");
  return at == std::string::npos ? 0 : std::atoi(status.c_str() + at + 6);
}

TEST(DeskConnections, a_head_without_end_takes_no_memory)
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
