// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/commands/run_sandbox_test.cpp
#include "sandbox/watcher.hpp"

#include "sandbox/filter.hpp"
#include "sandbox/judge.hpp"

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <fcntl.h>
#include <poll.h>
#include <seccomp.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <system_error>
#include <unistd.h>

namespace berm::sandbox {

namespace {

[[noreturn]] void fail(int error)
{
  throw std::system_error(error, std::generic_category());
}

/// Sends an open file to the other end of a pair of sockets.
void send_file(int line, int file)
{
  char byte = 'f';
  iovec data{&byte, 1};
  alignas(cmsghdr) char space[CMSG_SPACE(sizeof file)] = {};
  msghdr message{};
  message.msg_iov = &data;
  message.msg_iovlen = 1;
  message.msg_control = space;
  message.msg_controllen = sizeof space;
  cmsghdr* const header = CMSG_FIRSTHDR(&message);
  header->cmsg_level = SOL_SOCKET;
  header->cmsg_type = SCM_RIGHTS;
  header->cmsg_len = CMSG_LEN(sizeof file);
  std::memcpy(CMSG_DATA(header), &file, sizeof file);
  if (::sendmsg(line, &message, MSG_NOSIGNAL) != 1) fail(errno);
}

/// -1 where the other end was closed.
int received_file(int line)
{
  char byte = 0;
  iovec data{&byte, 1};
  alignas(cmsghdr) char space[CMSG_SPACE(sizeof(int))] = {};
  msghdr message{};
  message.msg_iov = &data;
  message.msg_iovlen = 1;
  message.msg_control = space;
  message.msg_controllen = sizeof space;
  if (::recvmsg(line, &message, MSG_CMSG_CLOEXEC) != 1) return -1;
  const cmsghdr* const header = CMSG_FIRSTHDR(&message);
  int file = -1;
  if (header != nullptr) std::memcpy(&file, CMSG_DATA(header), sizeof file);
  return file;
}

/// A line for people: what moves a cursor is shown as a question mark.
std::string plain(std::string text)
{
  for (char& c : text)
    if (static_cast<unsigned char>(c) < ' ' || c == 127) c = '?';
  return text;
}

/// Until nobody is left who could be asked about.
void answer(int asks, int line, const Judge& judge, const std::vector<std::filesystem::path>& made, const auto& note)
{
  seccomp_notif* call = nullptr;
  seccomp_notif_resp* reply = nullptr;
  if (seccomp_notify_alloc(&call, &reply) != 0) return;
  for (pollfd both[2] = {{asks, POLLIN, 0}, {line, POLLIN, 0}}; ::poll(both, 2, -1) >= 0 || errno == EINTR;) {
    if ((both[1].revents & POLLIN) != 0) {
      char byte = 0;
      if (::read(line, &byte, 1) == 1) {
        for (const auto& folder : made) ::rmdir(folder.c_str());
        [[maybe_unused]] const auto told = ::write(line, &byte, 1);
      } else {
        both[1].fd = -1;
      }
    } else if ((both[1].revents & (POLLHUP | POLLERR)) != 0) {
      both[1].fd = -1;
    }
    if ((both[0].revents & POLLIN) == 0) {
      if ((both[0].revents & (POLLHUP | POLLERR)) != 0) return;
      continue;
    }
    std::memset(call, 0, sizeof *call);
    if (seccomp_notify_receive(asks, call) != 0) continue;
    std::memset(reply, 0, sizeof *reply);
    reply->id = call->id;
    const Verdict verdict = judge(*call);
    if (seccomp_notify_id_valid(asks, call->id) != 0) continue;  // it has ended: what was read may be of another
    if (!verdict.note.empty()) note(verdict.note);
    reply->flags = verdict.error == 0 ? SECCOMP_USER_NOTIF_FLAG_CONTINUE : 0;
    reply->error = -verdict.error;
    seccomp_notify_respond(asks, reply);
  }
}

constexpr int own_line = 3;

/// It has nothing of the program that it watches but the line to it, and no signal of a terminal reaches it.
void become_watcher(int line)
{
  ::setsid();
  ::prctl(PR_SET_NAME, "berm-sandbox");
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGUSR1, SIGPIPE}) ::signal(signal, SIG_IGN);
  const int nothing = ::open("/dev/null", O_RDWR);
  for (int file = 0; file < 3; ++file) ::dup2(nothing, file);
  ::dup2(line, own_line);
  ::close_range(own_line + 1, ~0U, 0);
}

}  // namespace

Watcher::Watcher(const Allowed& allowed)
{
  int line[2];
  if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, line) != 0) fail(errno);
  const int memory = ::memfd_create("berm-sandbox", MFD_CLOEXEC | MFD_ALLOW_SEALING);
  if (memory < 0 || ::ftruncate(memory, sizeof(Notes)) != 0) fail(errno);
  const pid_t watched = ::getpid(), watcher = ::fork();
  if (watcher < 0) fail(errno);
  char byte = 'r';
  if (watcher == 0) {
    void* const shared = ::mmap(nullptr, sizeof(Notes), PROT_READ | PROT_WRITE, MAP_SHARED, memory, 0);
    become_watcher(line[1]);
    if (shared == MAP_FAILED || ::write(own_line, &byte, 1) != 1) ::_exit(1);
    auto* const notes = new (shared) Notes{};
    std::string all;
    const auto note = [&](const std::string& what) {
      const std::string text = "\n" + plain(what) + "\n";
      if (("\n" + all).find(text) != std::string::npos || all.size() + text.size() > Notes::size) return;
      all += text.substr(1);
      std::memcpy(notes->text, all.data(), all.size());
      notes->length = all.size();
    };
    if (const int asks = received_file(own_line); asks >= 0) answer(asks, own_line, Judge(allowed, watched), allowed.made, note);
    ::_exit(0);
  }
  ::close(line[1]);
  line_ = line[0];
  // The watcher has its map to write to; nobody gets another one.
  if (::read(line_, &byte, 1) != 1 || ::fcntl(memory, F_ADD_SEALS, F_SEAL_FUTURE_WRITE | F_SEAL_SHRINK | F_SEAL_GROW) != 0) fail(EPERM);
  const void* const shared = ::mmap(nullptr, sizeof(Notes), PROT_READ, MAP_SHARED, memory, 0);
  ::close(memory);
  if (shared == MAP_FAILED) fail(errno);
  notes_ = static_cast<const Notes*>(shared);
  const int asks = install_filter();
  send_file(line_, asks);
  ::close(asks);
}

std::string Watcher::notes() const
{
  return {notes_->text, std::min(notes_->length.load(), Notes::size)};
}

void Watcher::tidy_up()
{
  char byte = 't';
  if (::write(line_, &byte, 1) == 1) [[maybe_unused]]
    const auto done = ::read(line_, &byte, 1);
}

}  // namespace berm::sandbox
