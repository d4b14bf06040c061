// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/commands/run_sandbox_test.cpp
#include "sandbox/filter.hpp"

#include "sandbox/judge.hpp"

#include <cerrno>
#include <fcntl.h>
#include <linux/fs.h>
#include <sched.h>
#include <seccomp.h>
#include <sys/ioctl.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <system_error>

namespace berm::sandbox {
namespace {

/// Calls that no solver, mesh or picture makes: they lead out of the sandbox or change the machine.
const int refused_calls[] = {
    SCMP_SYS(connect),
    SCMP_SYS(bind),
    SCMP_SYS(listen),
    SCMP_SYS(unshare),
    SCMP_SYS(setns),
    SCMP_SYS(chroot),
    SCMP_SYS(pivot_root),
    SCMP_SYS(mount),
    SCMP_SYS(umount2),
    SCMP_SYS(move_mount),
    SCMP_SYS(open_tree),
    SCMP_SYS(fsopen),
    SCMP_SYS(fsmount),
    SCMP_SYS(mount_setattr),
    SCMP_SYS(open_by_handle_at),
    SCMP_SYS(bpf),
    SCMP_SYS(init_module),
    SCMP_SYS(finit_module),
    SCMP_SYS(delete_module),
    SCMP_SYS(kexec_load),
    SCMP_SYS(clock_settime),
    SCMP_SYS(settimeofday),
    SCMP_SYS(swapon),
    SCMP_SYS(swapoff),
    SCMP_SYS(reboot),
    SCMP_SYS(keyctl),
    SCMP_SYS(add_key),
    SCMP_SYS(request_key),
    SCMP_SYS(perf_event_open),
    SCMP_SYS(userfaultfd),
    SCMP_SYS(quotactl),
    SCMP_SYS(sethostname),
    SCMP_SYS(setdomainname),
    SCMP_SYS(kexec_file_load),
    SCMP_SYS(clock_adjtime),
    SCMP_SYS(adjtimex),
    SCMP_SYS(acct),
    SCMP_SYS(fanotify_init),
    SCMP_SYS(syslog),
    SCMP_SYS(vhangup),
    SCMP_SYS(iopl),
    SCMP_SYS(ioperm),
    SCMP_SYS(nfsservctl),
    SCMP_SYS(quotactl_fd),
    SCMP_SYS(fsconfig),
    SCMP_SYS(fspick),
    SCMP_SYS(pidfd_getfd),
    SCMP_SYS(process_madvise),
    SCMP_SYS(process_vm_writev),
};

/// What the filter cannot see into, or does not know yet: programs that ask for it take what they took before it was there.
const int unknown_calls[] = {SCMP_SYS(openat2), SCMP_SYS(io_uring_setup), SCMP_SYS(clone3)};
constexpr int first_newer_call = 452, last_newer_call = 511;  // the same numbers on all processors: fchmodat2 and what came after it

void check(int result)
{
  if (result < 0) throw std::system_error(-result, std::generic_category());
}

class Filter {
public:
  Filter()
  {
    if (context_ == nullptr) throw std::system_error(ENOMEM, std::generic_category());
    check(seccomp_attr_set(context_, SCMP_FLTATR_ACT_BADARCH, SCMP_ACT_KILL_PROCESS));
  }
  ~Filter() { seccomp_release(context_); }
  Filter(const Filter&) = delete;
  Filter& operator=(const Filter&) = delete;

  void add(std::uint32_t action, int call) { check(seccomp_rule_add(context_, action, call, 0)); }
  /// Where the bits of `mask` of an argument are those of `value`.
  void add(std::uint32_t action, int call, unsigned argument, std::uint64_t mask, std::uint64_t value)
  {
    check(seccomp_rule_add(context_, action, call, 1, SCMP_CMP64(argument, SCMP_CMP_MASKED_EQ, mask, value)));
  }
  /// Where an argument is not zero.
  void add(std::uint32_t action, int call, unsigned argument)
  {
    check(seccomp_rule_add(context_, action, call, 1, SCMP_CMP64(argument, SCMP_CMP_NE, 0)));
  }
  int load()
  {
    check(seccomp_load(context_));
    const int asks = seccomp_notify_fd(context_);
    check(asks);
    return asks;
  }

private:
  scmp_filter_ctx context_ = seccomp_init(SCMP_ACT_ALLOW);
};

}  // namespace

int install_filter()
{
  Filter filter;
  for (const int call : watched_calls()) filter.add(SCMP_ACT_NOTIFY, call);
  // Opening a file is looked at where it is opened to write, made or cut.
  for (const auto& [call, flags] : {std::pair{SCMP_SYS(openat), 2U}, {SCMP_SYS(open), 1U}}) {
    for (const unsigned way : {O_WRONLY, O_RDWR, O_ACCMODE}) filter.add(SCMP_ACT_NOTIFY, call, flags, O_ACCMODE, way);
    for (const unsigned change : {O_CREAT, O_TRUNC}) filter.add(SCMP_ACT_NOTIFY, call, flags, change | O_ACCMODE, change);
  }
  const std::uint32_t refuse = SCMP_ACT_ERRNO(EPERM), unknown = SCMP_ACT_ERRNO(ENOSYS);
  for (const int call : refused_calls) filter.add(refuse, call);
  for (const int call : unknown_calls) filter.add(unknown, call);
  for (int call = first_newer_call; call <= last_newer_call; ++call) filter.add(unknown, call);
  // The kernel looks at the lower half of a request only.
  constexpr std::uint64_t lower_half = 0xffffffff;
  for (const std::uint64_t request :
       {static_cast<std::uint64_t>(TIOCSTI), static_cast<std::uint64_t>(TIOCLINUX), static_cast<std::uint64_t>(TIOCCONS),
        static_cast<std::uint64_t>(FS_IOC_SETFLAGS), static_cast<std::uint64_t>(FS_IOC_FSSETXATTR), static_cast<std::uint64_t>(FIFREEZE),
        static_cast<std::uint64_t>(FITHAW), static_cast<std::uint64_t>(FITRIM)})
    filter.add(refuse, SCMP_SYS(ioctl), 1, lower_half, request & lower_half);
  // Limits of another process, as the watcher, would end it: 0 is the one that asks.
  filter.add(refuse, SCMP_SYS(prlimit64), 0);
  // What a process leaves behind becomes a child of the program, where the watcher finds it.
  filter.add(refuse, SCMP_SYS(prctl), 0, lower_half, PR_SET_CHILD_SUBREAPER);
  // Pairs of datagram sockets send to any other; those of streams are connected for good.
  constexpr std::uint64_t kind = 0xf;
  for (const std::uint64_t type : {SOCK_DGRAM, SOCK_RAW, SOCK_RDM}) filter.add(refuse, SCMP_SYS(socketpair), 1, kind, type);
  for (const std::uint64_t space : {CLONE_NEWNS, CLONE_NEWUSER, CLONE_NEWPID, CLONE_NEWNET, CLONE_NEWIPC, CLONE_NEWUTS, CLONE_NEWCGROUP,
                                    CLONE_PARENT})  // whose child would be nobody's here
    filter.add(refuse, SCMP_SYS(clone), 0, space, space);
  return filter.load();
}

}  // namespace berm::sandbox
