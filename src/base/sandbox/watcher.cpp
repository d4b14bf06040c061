// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/commands/run_sandbox_test.cpp
#include "sandbox/watcher.hpp"

#include "sandbox/descendants.hpp"
#include "sandbox/filter.hpp"
#include "sandbox/judge.hpp"

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <fcntl.h>
#include <poll.h>
#include <seccomp.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/syscall.h>
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

/// Answers what the kernel asks.
class Answers {
public:
  Answers(int asks, const Judge& judge) : asks_(asks), judge_(judge) { has_memory_ = seccomp_notify_alloc(&call_, &reply_) == 0; }

  bool has_memory() const { return has_memory_; }

  /// One call; `alone`: the watched program has ended, and nothing that it left behind goes on.
  void give(bool alone, const auto& note)
  {
    std::memset(call_, 0, sizeof *call_);
    if (seccomp_notify_receive(asks_, call_) != 0) return;
    std::memset(reply_, 0, sizeof *reply_);
    reply_->id = call_->id;
    const Verdict verdict = alone ? Verdict{EACCES, "", true} : judge_(*call_);
    if (seccomp_notify_id_valid(asks_, call_->id) != 0) return;  // it has ended: what was read may be of another
    if (!verdict.note.empty()) note(verdict.note);
    if (verdict.ends) ::kill(static_cast<pid_t>(call_->pid), SIGKILL);
    reply_->flags = verdict.error == 0 ? SECCOMP_USER_NOTIF_FLAG_CONTINUE : 0;
    reply_->error = -verdict.error;
    seccomp_notify_respond(asks_, reply_);
  }

private:
  int asks_;
  const Judge& judge_;
  seccomp_notif* call_ = nullptr;
  seccomp_notif_resp* reply_ = nullptr;
  bool has_memory_ = false;
};

/// Until nobody is left who could be asked about. What the watched program started ends with it.
void answer(int asks, int line, pid_t watched, Descendants& started, const Judge& judge, const std::vector<std::filesystem::path>& made,
            const auto& note)
{
  using Clock = std::chrono::steady_clock;
  constexpr std::chrono::milliseconds look_each(100);
  Answers answers(asks, judge);
  bool alone = false;
  Clock::time_point looked = Clock::now();
  const int program = static_cast<int>(::syscall(SYS_pidfd_open, watched, 0));
  if (!answers.has_memory() || program < 0) return;
  const auto broken = [](const pollfd& of) { return (of.revents & (POLLHUP | POLLERR)) != 0; };
  for (pollfd all[3] = {{asks, POLLIN, 0}, {line, POLLIN, 0}, {program, POLLIN, 0}};
       ::poll(all, 3, alone ? -1 : static_cast<int>(look_each.count())) >= 0 || errno == EINTR;) {
    if ((all[1].revents & POLLIN) != 0) {
      char byte = 0;
      if (::read(line, &byte, 1) == 1) {
        started.end();
        for (const auto& folder : made) ::rmdir(folder.c_str());
        [[maybe_unused]] const auto told = ::send(line, &byte, 1, MSG_DONTWAIT | MSG_NOSIGNAL);  // who does not read waits for nothing
      } else {
        all[1].fd = -1;
      }
    } else if (broken(all[1])) {
      all[1].fd = -1;
    }
    if ((all[2].revents & POLLIN) != 0) {
      alone = true;
      all[2].fd = -1;
      started.end();
    }
    if (!alone && Clock::now() - looked >= look_each) {
      started.look();
      looked = Clock::now();
    }
    if ((all[0].revents & POLLIN) != 0)
      answers.give(alone, note);
    else if (broken(all[0]))
      return;
  }
}

constexpr int own_line = 3;

/// It has nothing of the program that it watches but the line to it, and no signal of a terminal reaches it.
void become_watcher(int line)
{
  ::setsid();
  ::prctl(PR_SET_NAME, "berm-sandbox");
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGUSR1, SIGPIPE}) ::signal(signal, SIG_IGN);
  rlimit files{};
  if (::getrlimit(RLIMIT_NOFILE, &files) == 0) {
    files.rlim_cur = files.rlim_max;  // one for each process that it may have to end
    ::setrlimit(RLIMIT_NOFILE, &files);
  }
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
    Descendants started(watched);  // before it goes on
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
    if (const int asks = received_file(own_line); asks >= 0)
      answer(asks, own_line, watched, started, Judge(allowed, watched), allowed.made, note);
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
