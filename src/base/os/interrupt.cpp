// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/commands/run_faults_test.cpp
#include "os/interrupt.hpp"

#include <csignal>
#include <fmt/format.h>

namespace berm {
namespace {

volatile std::sig_atomic_t asked_to_stop = 0;

extern "C" void ask_to_stop(int signal)
{
  asked_to_stop = 1;
  if (signal != SIGHUP) std::signal(signal, SIG_DFL);
}

extern "C" void let_the_write_fail(int) {}

/// A signal that was ignored as the program began, as by nohup, stays so. A program that this one starts does not inherit the handler.
void handle(int signal, void (*handler)(int))
{
  if (std::signal(signal, handler) == SIG_IGN) std::signal(signal, SIG_IGN);
}

}  // namespace

void catch_interrupts()
{
  std::signal(SIGINT, ask_to_stop);
  std::signal(SIGTERM, ask_to_stop);
  std::signal(SIGUSR1, ask_to_stop);
  handle(SIGHUP, ask_to_stop);
}

void survive_failed_writes()
{
  handle(SIGXFSZ, let_the_write_fail);
  handle(SIGPIPE, let_the_write_fail);
}

bool interrupted()
{
  return asked_to_stop != 0;
}

void stop_if_asked(const char* what)
{
  if (interrupted()) throw Interrupted(fmt::format("stopped while {}", what));
}

}  // namespace berm
