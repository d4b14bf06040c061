// SPDX-License-Identifier: BSD-3-Clause
// A library that nobody should load: it ends who does.
#include <unistd.h>

__attribute__((constructor)) static void end(void)
{
  _exit(99);
}
