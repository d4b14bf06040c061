// SPDX-License-Identifier: BSD-3-Clause
#include "os/child_process.hpp"

#include "os/error.hpp"
#include "os/interrupt.hpp"
#include "os/write_file.hpp"

#include <cerrno>
#include <chrono>
#include <fcntl.h>
#include <fmt/format.h>
#include <sched.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <system_error>
#include <thread>
#include <unistd.h>
#include <utility>

namespace berm {
namespace {

std::vector<char*> pointers(const std::vector<std::string>& words)
{
  std::vector<char*> list;
  for (const std::string& word : words) list.push_back(const_cast<char*>(word.data()));
  list.push_back(nullptr);
  return list;
}

std::vector<std::string> environment_with(const std::vector<std::string>& changes)
{
  std::vector<std::string> all = changes;
  for (char** entry = environ; *entry != nullptr; ++entry) {
    const std::string word = *entry, name = word.substr(0, word.find('=') + 1);
    bool changed = false;
    for (const std::string& change : changes) changed = changed || change.starts_with(name);
    if (!changed) all.push_back(word);
  }
  return all;
}

/// What the child does before it becomes another program. It has the memory of its parent, which waits: it may call only what a signal handler may.
struct Launch {
  const char* program;
  char* const* words;
  char* const* environment;
  const char* folder;
  int in, out, end_by;
  const cpu_set_t* processors;  ///< null: those of its parent
  bool outlives;
  pid_t parent;
  const sigset_t* signals;

  [[noreturn]] void operator()(volatile int& error) const
  {
    if (become()) execvpe(program, words, environment);
    error = errno;
    _exit(127);
  }

private:
  bool become() const
  {
    for (const int signal : {SIGINT, SIGTERM, SIGUSR1, SIGPIPE, SIGXFSZ}) ::signal(signal, SIG_DFL);
    if (sigprocmask(SIG_SETMASK, signals, nullptr) != 0 || setpgid(0, 0) != 0) return false;
    if (processors != nullptr && sched_setaffinity(0, sizeof *processors, processors) != 0) return false;
    if (!outlives && prctl(PR_SET_PDEATHSIG, end_by) != 0) return false;
    if (!outlives && getppid() != parent) _exit(128 + end_by);  // it ended before this was asked for
    const int nothing = in < 0 ? open("/dev/null", O_RDONLY | O_CLOEXEC) : in;
    if (nothing < 0 || dup2(nothing, STDIN_FILENO) < 0) return false;
    const int where = out < 0 ? STDERR_FILENO : out;
    if (dup2(where, STDOUT_FILENO) < 0 || dup2(where, STDERR_FILENO) < 0) return false;
    return *folder == '\0' || chdir(folder) == 0;
  }
};

/// The child's memory is not copied: a run may fill the machine's. By itself, so that the child changes no variable of who calls it.
[[gnu::noinline]] pid_t start_child(const Launch& launch, volatile int& error)
{
  const pid_t process = vfork();
  if (process == 0) launch(error);
  return process;
}

/// -1 where there is none.
int opened_messages(const std::string& file)
{
  if (file.empty()) return -1;
  std::string fault;
  const int out = open_to_write(file, O_WRONLY | O_TRUNC, fault);
  if (out < 0) throw RunError(fmt::format("cannot write {}: {}", file, fault));
  return out;
}

}  // namespace

ChildProcess::ChildProcess(const ChildStart& start) : end_by_(start.end_by)
{
  const std::vector<std::string> environment = environment_with(start.environment);
  const std::vector<char*> words = pointers(start.words), variables = pointers(environment);
  cpu_set_t allowed;
  CPU_ZERO(&allowed);
  for (const int processor : start.processors) CPU_SET(processor, &allowed);
  sigset_t all, before;
  sigfillset(&all);
  const int opened = opened_messages(start.messages), out = opened < 0 ? start.out : opened;
  const Launch launch{start.program.empty() ? words[0] : start.program.c_str(),
                      words.data(),
                      variables.data(),
                      start.folder.c_str(),
                      start.in,
                      out,
                      start.end_by,
                      start.processors.empty() ? nullptr : &allowed,
                      start.outlives,
                      getpid(),
                      &before};
  volatile int error = 0;
  // No handler of this program runs in the child.
  pthread_sigmask(SIG_SETMASK, &all, &before);
  const pid_t process = start_child(launch, error);
  if (process < 0) error = errno;
  pthread_sigmask(SIG_SETMASK, &before, nullptr);
  if (opened >= 0) close(opened);
  if (process > 0 && error != 0) waitpid(process, nullptr, 0);
  if (error != 0) throw std::system_error(error, std::generic_category(), start.words[0]);
  process_ = process;
}

ChildProcess::ChildProcess(ChildProcess&& other) noexcept
    : process_(std::exchange(other.process_, 0)),
      end_by_(other.end_by_),
      status_(other.status_)
{
}

ChildProcess::~ChildProcess()
{
  if (process_ == 0 || status_ >= 0) return;
  send(end_by_);
  reap(0);
}

bool ChildProcess::reap(int options)
{
  if (status_ >= 0) return true;
  int status = 0;
  pid_t ended = 0;
  do ended = waitpid(process_, &status, options);
  while (ended < 0 && errno == EINTR);
  if (ended == 0) return false;
  // Where somebody else took note of its end, how it was is not known.
  status_ = ended < 0 ? 127 : WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
  return true;
}

bool ChildProcess::has_ended()
{
  return reap(WNOHANG);
}

int ChildProcess::wait()
{
  reap(0);
  return status_;
}

void ChildProcess::send(int signal) const
{
  kill(-process_, signal);
}

bool ChildProcess::group_lives() const
{
  while (waitpid(-process_, nullptr, WNOHANG) > 0) {
  }
  return kill(-process_, 0) == 0;
}

void adopt_orphans()
{
  prctl(PR_SET_CHILD_SUBREAPER, 1);
}

int wait_unless_interrupted(ChildProcess& child, const std::string& name)
{
  while (!child.has_ended()) {
    if (interrupted()) {
      child.send(SIGKILL);
      child.wait();
      throw Interrupted(fmt::format("stopped while {} was running", name));
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  return child.wait();
}

}  // namespace berm
