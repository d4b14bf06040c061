// SPDX-License-Identifier: BSD-3-Clause
// A law that does, once in a run, what its third property says: the sandbox is tried with it.
#include <berm/law.h>

#include <cstdio>
#include <cstdlib>
#include <fcntl.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

namespace {

/// victim lies in the folder that berm works in, beside the run folder.
void act(int what)
{
  [[maybe_unused]] int result = 0;
  switch (what) {
  case 1:
    if (std::FILE* file = std::fopen("victim", "w")) std::fclose(file);
    break;
  case 2:
    result = ::socket(AF_INET, SOCK_STREAM, 0);
    break;
  case 3:
    result = ::socket(AF_UNIX, SOCK_STREAM, 0);
    break;
  case 4:
    result = std::system("rm victim");
    break;
  case 5:
    result = ::unlink("victim");
    break;
  case 6:
    result = std::rename("victim", "results/victim");
    break;
  case 7:
    result = ::truncate("victim", 0);
    break;
  case 8:
    result = ::chmod("victim", 0);
    break;
  case 9:
    result = ::mkdir("made", 0777);
    break;
  case 10:
    result = ::symlink("victim", "made");
    break;
  case 11:
    result = static_cast<int>(::syscall(SYS_open, "victim", O_RDONLY | O_TRUNC));
    break;
  case 12:
    result = ::execl("/usr/bin/touch", "touch", "made", nullptr);
    break;
  case 13:
    if (const int file = ::open("victim", O_RDONLY); file >= 0) result = ::fchmod(file, 0);
    break;
  case 14:
    if (const int file = ::open("results", O_PATH); file >= 0) result = ::unlinkat(file, "../victim", 0);
    break;
  case 20:
    ::_exit(0);
  default:
    break;
  }
}

}  // namespace

/// Linear elasticity; properties: E, nu, what to do.
extern "C" int berm_law(berm_law_increment* i)
{
  const double e = i->properties[0], nu = i->properties[1], shear = e / (2 * (1 + nu)), lame = e * nu / ((1 + nu) * (1 - 2 * nu));
  const double trace = i->strain[0] + i->strain[1] + i->strain[2];
  for (int k = 0; k < 6; ++k) i->stress[k] += k < 3 ? lame * trace + 2 * shear * i->strain[k] : shear * i->strain[k];
  static bool done = false;
  if (!done && i->time > 1e-3) {
    done = true;
    act(static_cast<int>(i->properties[2]));
  }
  return berm_law_done;
}
