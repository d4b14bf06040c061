// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/desk/desk_test.cpp
#include "desk/queue.hpp"

#include "desk/refusal.hpp"
#include "io/atomic_file.hpp"
#include "jobs/outcome.hpp"

#include <algorithm>
#include <csignal>
#include <fmt/format.h>
#include <thread>

namespace berm::desk {
namespace {

constexpr std::size_t most_entries = 1000;

bool at_work(const Queue::Entry& entry)
{
  return entry.state == WorkState::queued || entry.state == WorkState::running;
}

}  // namespace

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
    throw Refusal(409, fmt::format("{} is being filled", work.name));
  entries_.remove_if(same);
  if (entries_.size() >= most_entries) {
    const auto oldest = std::find_if_not(entries_.begin(), entries_.end(), at_work);
    if (oldest == entries_.end()) throw Refusal(409, "the queue is full");
    entries_.erase(oldest);
  }
  work.threads = std::clamp(work.threads, 1, threads_);
  entries_.push_back({std::move(work)});
  start_what_fits();
}

void Queue::start_what_fits()
{
  for (Entry& entry : entries_) {
    if (entry.state != WorkState::queued) continue;
    if (entry.work.threads > free_) return;  // none overtakes another
    try {
      io::make_folder(entry.work.folder.parent_path());
      entry.process = std::make_shared<Process>(entry.work.words, folder_, entry.work.messages(), true);
    } catch (const std::exception&) {
      entry.state = WorkState::failed;
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
    free_ += entry.work.threads;
    std::error_code none;
    if (entry.state == WorkState::finished && entry.work.kind == "run") std::filesystem::remove(entry.work.messages(), none);
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
    found->state = WorkState::stopped;
  return true;
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
