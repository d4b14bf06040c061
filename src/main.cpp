// SPDX-License-Identifier: BSD-3-Clause
#include "commands/commands.hpp"
#include "os/interrupt.hpp"
#include "os/threads.hpp"

#include <fcntl.h>
#include <unistd.h>

namespace {

/// What is opened later must not be taken for a standard stream that was closed before berm was started.
void open_standard_streams()
{
  int file = 0;
  while (file >= 0 && file <= STDERR_FILENO) file = ::open("/dev/null", O_RDWR);
  if (file > STDERR_FILENO) ::close(file);
}

}  // namespace

int main(int argc, char** argv)
{
  open_standard_streams();
  berm::reexec_with_openmp_environment(argv);
  berm::survive_failed_writes();
  return berm::commands::run_commands(argc, argv);
}
