// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/commands/run_faults_test.cpp
#include "core/interrupt.hpp"

#include <csignal>

namespace berm {
namespace {

volatile std::sig_atomic_t asked_to_stop = 0;

extern "C" void ask_to_stop(int signal)
{
  asked_to_stop = 1;
  std::signal(signal, SIG_DFL);
}

}  // namespace

void catch_interrupts()
{
  std::signal(SIGINT, ask_to_stop);
  std::signal(SIGTERM, ask_to_stop);
  std::signal(SIGUSR1, ask_to_stop);
}

bool interrupted()
{
  return asked_to_stop != 0;
}

}  // namespace berm
