// SPDX-License-Identifier: BSD-3-Clause
#include "user_law/crash_guard.hpp"

#include <array>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <mutex>
#include <sys/syscall.h>
#include <unistd.h>

namespace berm::user_law {
namespace {

constexpr int crashes[] = {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT};
constexpr std::size_t crash_count = std::size(crashes);

const pid_t own_process = ::getpid();

/// What is said of the law whose call this thread is in; null outside.
thread_local const char* called = nullptr;

void say(const char* text)
{
  // A message that stderr does not take is lost: there is nothing left to do about it.
  [[maybe_unused]] const auto written = ::write(STDERR_FILENO, text, std::strlen(text));
}

[[noreturn]] void end(const char* what)
{
  say("berm: error: ");
  say(called);
  say(what);
  say("; the files in the run folder are complete\n");
  ::syscall(SYS_exit_group, EXIT_FAILURE);
  ::abort();
}

const char* words_of(int signal)
{
  switch (signal) {
  case SIGSEGV:
  case SIGBUS:
    return " crashed: it accessed invalid memory, or overflowed the stack";
  case SIGFPE:
    return " crashed: division of integers by zero, or a trapped error of floating point numbers";
  case SIGILL:
    return " crashed: an instruction not supported by this processor";
  default:
    return " crashed: it aborted";
  }
}

extern "C" void end_or_pass_on(int signal)
{
  if (called != nullptr) end(words_of(signal));
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}

extern "C" void end_of_exit()
{
  if (called != nullptr) end(" ended the program (STOP or exit)");
}

/// Signals as they were before the first guard, and the number of guards.
struct Installed {
  std::mutex mutex;
  int guards = 0;
  std::array<struct sigaction, crash_count> before;
};
Installed installed;

/// A stack of this thread for the handler, which a law that has used up its own leaves none; nothing where there is one already.
class HandlerStack {
public:
  HandlerStack()
  {
    stack_t present;
    if (::sigaltstack(nullptr, &present) != 0 || (present.ss_flags & SS_DISABLE) == 0) return;
    constexpr std::size_t bytes = 65536;
    memory_ = std::make_unique<char[]>(bytes);
    stack_t own{};
    own.ss_sp = memory_.get();
    own.ss_size = bytes;
    ::sigaltstack(&own, nullptr);
  }
  ~HandlerStack()
  {
    if (!memory_) return;
    stack_t none_left{};
    none_left.ss_flags = SS_DISABLE;
    ::sigaltstack(&none_left, nullptr);
  }
  HandlerStack(const HandlerStack&) = delete;
  HandlerStack& operator=(const HandlerStack&) = delete;

private:
  std::unique_ptr<char[]> memory_;
};

}  // namespace

CrashGuard::CrashGuard()
{
  const std::lock_guard lock(installed.mutex);
  if (installed.guards++ > 0) return;
  struct sigaction action {};
  action.sa_handler = end_or_pass_on;
  action.sa_flags = SA_ONSTACK;
  ::sigemptyset(&action.sa_mask);
  for (std::size_t k = 0; k < crash_count; ++k) ::sigaction(crashes[k], &action, &installed.before[k]);
  static const int registered = std::atexit(end_of_exit);
  static_cast<void>(registered);
}

CrashGuard::~CrashGuard()
{
  const std::lock_guard lock(installed.mutex);
  if (--installed.guards > 0) return;
  for (std::size_t k = 0; k < crash_count; ++k) ::sigaction(crashes[k], &installed.before[k], nullptr);
}

InsideCall::InsideCall(const std::string& law)
{
  thread_local const HandlerStack stack;
  static_cast<void>(&stack);
  called = law.c_str();
}

InsideCall::~InsideCall()
{
  called = nullptr;
}

}  // namespace berm::user_law

// The program offers its own _exit and _Exit, so that those of a law are noticed: the C library's ask nobody.
extern "C" [[noreturn]] void _exit(int status)
{
  if (berm::user_law::called != nullptr && ::getpid() == berm::user_law::own_process) berm::user_law::end(" ended the program (_exit)");
  ::syscall(SYS_exit_group, status);
  ::abort();
}

extern "C" [[noreturn]] void _Exit(int status) noexcept
{
  ::_exit(status);
}
