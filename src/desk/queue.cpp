// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/desk/desk_test.cpp
#include "desk/queue.hpp"

#include "desk/live.hpp"
#include "io/atomic_file.hpp"
#include "jobs/outcome.hpp"
#include "os/error.hpp"

#include <algorithm>
#include <csignal>
#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <thread>
#include <unistd.h>

namespace berm::desk {
namespace {

constexpr std::size_t most_queue_entries = 1000;
constexpr std::ptrdiff_t most_at_work = 300;  // each that waits has a file open

bool at_work(const Queue::Entry& entry)
{
  return entry.state == WorkState::queued || entry.state == WorkState::running;
}

}  // namespace

MessagesFile::MessagesFile(const Work& work) : path_(work.messages())
{
  try {
    io::make_folder(path_.parent_path());
    file_ = io::open_for_one(path_, O_WRONLY);
  } catch (const RunError& error) {
    throw Refusal(409, error.what());
  }
  if (file_ < 0) throw Refusal(409, fmt::format("{} is being written by a command of another desk", work.name));
}

/// Of work that never began no empty file is left.
MessagesFile::~MessagesFile()
{
  struct stat about {};
  if (!given_ && ::fstat(file_, &about) == 0 && about.st_size == 0) ::unlink(path_.c_str());
  ::close(file_);
}

int MessagesFile::given()
{
  if (::ftruncate(file_, 0) != 0) io::throw_errno(fmt::format("cannot write {}", path_.string()));
  given_ = true;
  return file_;
}

void MessagesFile::end(bool kept)
{
  if (!kept) ::unlink(path_.c_str());
  ::flock(file_, LOCK_UN);  // what the process left behind may have it open still
}

const char* word_of(WorkState state)
{
  constexpr const char* words[] = {"queued", "running", "stopped", "failed", "finished"};
  return words[static_cast<int>(state)];
}

void Queue::add(Work work)
{
  const std::lock_guard lock(mutex_);
  const auto same = [&](const Entry& entry) { return entry.work.name == work.name; };
  if (std::any_of(entries_.begin(), entries_.end(), [&](const Entry& entry) { return same(entry) && at_work(entry); }))
    throw Refusal(409, fmt::format("{} is being written", work.name));
  if (std::count_if(entries_.begin(), entries_.end(), at_work) >= most_at_work) throw Refusal(409, "the queue is full");
  messages_.erase(work.name);
  messages_.try_emplace(work.name, work);
  entries_.remove_if(same);
  if (entries_.size() >= most_queue_entries) {
    const auto oldest = std::find_if_not(entries_.begin(), entries_.end(), at_work);
    entries_.erase(oldest);
  }
  work.threads = std::clamp(work.threads, 1, threads_);
  entries_.push_back({.work = std::move(work)});
  start_what_fits();
}

void Queue::start_what_fits()
{
  for (Entry& entry : entries_) {
    if (entry.state != WorkState::queued) continue;
    if (entry.work.threads > free_) return;  // none overtakes another
    try {
      entry.process = std::make_shared<Process>(entry.work.words, folder_, messages_.at(entry.work.name).given(), true);
    } catch (const std::exception& error) {
      entry.state = WorkState::failed;
      entry.why = error.what();
      entry.left = identity_with_log(entry.work.folder);
      messages_.erase(entry.work.name);
      continue;
    }
    entry.state = WorkState::running;
    free_ -= entry.work.threads;
    std::thread([self = shared_from_this(), process = entry.process, name = entry.work.name] {
      self->ended(name, process->wait());
    }).detach();
  }
}

void Queue::ended(const std::string& name, int status)
{
  const std::lock_guard lock(mutex_);
  for (Entry& entry : entries_) {
    if (entry.work.name != name || entry.state != WorkState::running) continue;
    entry.state = status == jobs::status_of(jobs::Outcome::done)         ? WorkState::finished
                  : status == jobs::status_of(jobs::Outcome::unfinished) ? WorkState::stopped
                  : entry.asked_to_stop                                  ? WorkState::stopped
                                                                         : WorkState::failed;
    entry.process.reset();
    entry.left = identity_with_log(entry.work.folder);
    free_ += entry.work.threads;
    messages_.at(name).end(entry.state != WorkState::finished || entry.work.kind != "run");
    messages_.erase(name);
  }
  start_what_fits();
}

bool Queue::stop(const std::string& name)
{
  const std::lock_guard lock(mutex_);
  const auto found =
      std::find_if(entries_.begin(), entries_.end(), [&](const Entry& entry) { return entry.work.name == name && at_work(entry); });
  if (found == entries_.end()) return false;
  found->asked_to_stop = true;
  if (found->process)
    found->process->send(SIGINT);
  else
    found->state = WorkState::stopped, messages_.erase(name);
  return true;
}

void Queue::forget(const std::string& name)
{
  const std::lock_guard lock(mutex_);
  std::erase_if(entries_, [&](const Entry& entry) { return entry.work.name == name && !at_work(entry); });
}

std::optional<Queue::Entry> Queue::find(const std::string& name) const
{
  const std::lock_guard lock(mutex_);
  const auto found = std::find_if(entries_.begin(), entries_.end(), [&](const Entry& entry) { return entry.work.name == name; });
  return found == entries_.end() ? std::nullopt : std::optional(*found);
}

std::vector<Queue::Entry> Queue::entries() const
{
  const std::lock_guard lock(mutex_);
  return {entries_.begin(), entries_.end()};
}

}  // namespace berm::desk
