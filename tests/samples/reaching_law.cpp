// SPDX-License-Identifier: BSD-3-Clause
// A law that does, once in a run, what its third property says: the sandbox is tried with it.
#include <berm/law.h>

#include <atomic>
#include <cerrno>
#include <climits>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <sched.h>
#include <string>
#include <sys/ioctl.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/timex.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

namespace {

/// A process that nobody waits for, in a session of its own: once berm has ended, which closes the pipe, it writes into the run folder.
void leave_somebody_behind()
{
  int ends[2];
  if (::pipe2(ends, O_CLOEXEC) != 0) std::abort();
  if (::fork() != 0) return;
  ::setsid();
  if (::fork() != 0) ::_exit(0);
  ::close(ends[1]);
  char byte = 0;
  if (::read(ends[0], &byte, 1) != 0) std::abort();
  if (const int file = ::open("results/late", O_WRONLY | O_CREAT, 0666); file >= 0) ::close(file);
  ::_exit(0);
}

/// Tries to have the loader start a shell: its name stands where that of a program that may be started was looked at.
void race_for_a_shell()
{
  char berm[PATH_MAX] = "", path[PATH_MAX] = "";
  if (::readlink("/proc/self/exe", berm, sizeof berm - 1) <= 0) std::abort();
  const char* const loader = "/lib64/ld-linux-x86-64.so.2";
  std::atomic<bool> stop = false;
  std::strcpy(path, berm);
  std::thread changes([&] {
    while (!stop) {
      std::strcpy(path, loader);
      std::strcpy(path, berm);
    }
  });
  char shell[] = "/bin/sh", option[] = "-c", command[] = "echo > results/by_a_shell";
  char* words[] = {berm, shell, option, command, nullptr};
  for (int k = 0; k < 300; ++k) {
    const pid_t child = ::vfork();
    if (child == 0) {
      ::execv(path, words);
      ::_exit(1);
    }
    ::waitpid(child, nullptr, 0);
  }
  stop = true;
  changes.join();
}

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
  case 15:
  case 16:
    if (const int file = ::open("victim", O_RDONLY); file >= 0)
      result = ::chmod(((what == 15 ? "/dev/fd/" : "/proc/thread-self/fd/") + std::to_string(file)).c_str(), 0);
    break;
  case 17: {
    const int here = ::open(".", O_PATH);
    if (::chdir("/proc") == 0) result = ::chmod("self/environ", 0);
    result = ::fchdir(here);
    break;
  }
  case 18:
    result = ::symlink("../made", "results/link");
    result = ::open("results/link", O_WRONLY | O_CREAT, 0666);
    break;
  case 22:
    result = ::open("/dev/shm/berm_reaching_law", O_WRONLY | O_CREAT, 0666);
    break;
  case 19:  // allowed
    if (::close(::open(std::getenv("TMPDIR"), O_TMPFILE | O_RDWR, 0600)) != 0) std::abort();
    break;
  case 21: {
    constexpr long fchmodat2 = 452;
    char byte = 'x';
    int pair[2];
    // Refused without a note: nothing that is honest asks for these.
    const bool refused = ::socketpair(AF_UNIX, SOCK_DGRAM, 0, pair) != 0 && ::unshare(CLONE_NEWUSER) != 0 && ::chroot(".") != 0 &&
                         ::ioctl(0, TIOCSTI, &byte) != 0 && errno == EPERM && ::syscall(fchmodat2, AT_FDCWD, "victim", 0, 0) != 0;
    // Below /proc the kernel's rules judge alone.
    if (!refused || ::open("/proc/self/comm", O_WRONLY) >= 0 || ::open("/proc/self/oom_score_adj", O_WRONLY) >= 0) std::abort();
    break;
  }
  case 23:
    leave_somebody_behind();
    break;
  case 24:
    leave_somebody_behind();
    ::_exit(0);
  case 25:
    race_for_a_shell();
    break;
  case 26: {
    // Of root, too.
    timex now{};
    if (::syscall(SYS_clock_adjtime, CLOCK_REALTIME, &now) >= 0 || errno != EPERM || ::acct(nullptr) == 0 || errno != EPERM ||
        ::syscall(SYS_syslog, 3, nullptr, 0) >= 0 || errno != EPERM || ::prctl(PR_SET_CHILD_SUBREAPER, 0) == 0)
      std::abort();
    break;
  }
  case 27: {
    // A name that leads into the run folder for whoever follows it from elsewhere, and to the victim from here.
    if (::mkdir("results/d", 0777) != 0 || ::mkdir("results/d/results", 0777) != 0 ||
        ::symlink("../../../victim", "results/d/results/s") != 0 || ::symlink("/proc/self/cwd/results/s", "results/l") != 0)
      std::abort();
    if (const int file = ::open("results/s", O_WRONLY | O_CREAT, 0666); file >= 0) ::close(file);
    if (::chdir("results/d") != 0 || ::chmod("../l", 0) == 0 || ::chdir("../..") != 0) std::abort();
    break;
  }
  case 28: {
    // Of whoever started berm; a limit of time or files would end the watcher.
    const rlimit none{0, 0};
    if (::prlimit(::getppid(), RLIMIT_CORE, &none, nullptr) == 0 || errno != EPERM) std::abort();
    break;
  }
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
