// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/desk/desk_test.cpp
#include "desk/runs.hpp"

#include "desk/digest.hpp"
#include "io/atomic_file.hpp"
#include "io/folder_lock.hpp"
#include "os/control_characters.hpp"
#include "record/logged_end.hpp"
#include "run_folder/json_file.hpp"
#include "run_folder/summary_file.hpp"
#include "simulation/run_place.hpp"

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <fcntl.h>
#include <fmt/format.h>
#include <set>
#include <unistd.h>

namespace berm::desk {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t log_bytes = 6000, most_known = 20000, most_places_tried = 20;
constexpr std::chrono::seconds between_looks{3};

/// The process that has the folder, as its lock says, where it is one of this machine that has that file open; 0 where it is none.
int process_in(const fs::path& run)
{
  const std::string owner = io::FolderLock::owner_of(run);
  constexpr std::string_view before = "process ", between = " on ";
  int process = 0;
  if (!owner.starts_with(before)) return 0;
  const auto [end, error] = std::from_chars(owner.data() + before.size(), owner.data() + owner.size(), process);
  char host[256] = "";
  ::gethostname(host, sizeof host - 1);
  if (error != std::errc() || std::string_view(end) != fmt::format("{}{}", between, host)) return 0;
  std::error_code none;
  for (auto file = fs::directory_iterator(fmt::format("/proc/{}/fd", process), none); !none && file != fs::end(file); file.increment(none))
    if (std::error_code gone; fs::read_symlink(file->path(), gone) == run / io::FolderLock::file_name) return process;
  return 0;
}

/// Of a run that nobody is at work on: what it is, and why it did not come to its end. One that an error ended would come to the same error again.
std::pair<WorkState, std::string> state_at_rest(const Folder& folder, const fs::path& run)
{
  try {
    for (const char* read : {"summary.json", "run.log", "checkpoint"}) folder.real(run / read);
    const auto summary = run_folder::read_summary(run);
    if (!summary) return {WorkState::stopped, "The run did not finish: it was killed, or it crashed."};
    if (summary->finished()) return {WorkState::finished, ""};
    const record::LoggedEnd end = record::logged_end(run);
    return {end.stopped && simulation::has_checkpoint(run) ? WorkState::stopped : WorkState::failed, end.words};
  } catch (const std::exception& error) {
    return {WorkState::failed, error.what()};
  }
}

std::string last_line(const std::string& text)
{
  const std::size_t end = text.find_last_not_of("\n ");
  return end == std::string::npos ? "" : text.substr(text.rfind('\n', end) + 1, end - text.rfind('\n', end));
}

/// Whether what a piece of work came to still says how its folder is: nobody else was at work there since.
bool is_of_now(const Queue::Entry& entry)
{
  return entry.left == identity_with_log(entry.work.folder);
}

std::string case_of(const Folder& folder, const fs::path& run)
{
  try {
    return run_folder::read_json(folder.real(run / "origin.json"), 10'000'000).value("case", "");
  } catch (const std::exception&) {
    return "";
  }
}

}  // namespace

std::vector<std::string> changes_in(const Json& body)
{
  std::vector<std::string> words;
  for (const std::string& change : texts_in(body, "set")) {
    const std::string key = change.substr(0, change.find('='));
    const bool right = key.size() < change.size() && !key.empty() && std::isalpha(static_cast<unsigned char>(key[0])) != 0 &&
                       change.size() < 10000 && !has_control_character(change) && std::all_of(key.begin(), key.end(), [](unsigned char c) {
                         return std::isalnum(c) != 0 || c == '_' || c == '.' || c == '-' || c == '*' || c == '[' || c == ']';
                       });
    if (!right) throw Refusal(400, fmt::format("{} is not KEY=VALUE", one_line(change)), {{"key", "set"}});
    words.insert(words.end(), {"--set", change});
  }
  return words;
}

int threads_in(const Json& body, int otherwise)
{
  const auto found = body.find("threads");
  if (found == body.end() || found->is_null()) return otherwise;
  if (!found->is_number_integer() || *found < 1 || *found > 1024)
    throw Refusal(400, "threads must be a number from 1 to 1024", {{"key", "threads"}});
  return std::min(found->get<int>(), otherwise);
}

fs::path Runs::free_place(const fs::path& case_file, const std::set<fs::path>& taken) const
{
  const fs::path first = folder_.inside(place_(folder_.name_of(case_file)).generic_string());
  for (int k = 1;; ++k) {
    const fs::path place = k == 1 ? first : fs::path(fmt::format("{}_{}", first.string(), k));
    const auto entry = queue_->find(folder_.name_of(place));
    if (!fs::exists(place) && taken.count(place) == 0 &&
        !(entry && (entry->state == WorkState::queued || entry->state == WorkState::running)))
      return place;
  }
}

Json Runs::start(const Json& body)
{
  // Another request, or another desk, may take a free place before this one does.
  const bool place_is_free = !body.contains("resume") && text_in(body, "out", "").empty();
  std::set<fs::path> taken;
  while (true) {
    Work work = work_of(body, taken);
    const Json answer = {{"path", work.name}};
    const fs::path place = work.folder;
    try {
      queue_->add(std::move(work));
      return answer;
    } catch (const Refusal& refusal) {
      if (!place_is_free || refusal.status != 409 || taken.size() >= most_places_tried) throw;
    }
    taken.insert(place);
  }
}

Work Runs::work_of(const Json& body, const std::set<fs::path>& taken)
{
  Work work;
  work.kind = "run";
  work.threads = threads_in(body, queue_->threads());
  if (body.contains("resume")) {
    work.folder = folder_.run(text_in(body, "resume"));
    folder_.refuse_links_out(work.folder);
    if (!io::FolderLock::owner_of(work.folder).empty()) throw Refusal(409, "the run is in progress");
    work.case_file = at_rest(work.folder).case_file;
    work.words = {"run", "--resume", folder_.name_of(work.folder)};
  } else {
    const fs::path file = folder_.input(text_in(body, "case"));
    if (!fs::is_regular_file(file)) throw Refusal(404, fmt::format("there is no {}", text_in(body, "case")));
    const std::string out = text_in(body, "out", "");
    work.folder = out.empty() ? free_place(file, taken) : folder_.inside(out);
    if (work.folder == folder_.root() || fs::exists(work.folder))
      throw Refusal(409, fmt::format("{} already exists: name another folder", out));
    work.case_file = folder_.name_of(file);
    work.words = {"run", work.case_file, "-o", folder_.name_of(work.folder)};
    const std::vector<std::string> changes = changes_in(body);
    work.words.insert(work.words.end(), changes.begin(), changes.end());
  }
  work.words.insert(work.words.end(), {"--threads", std::to_string(work.threads)});
  work.words.insert(work.words.end(), more_.begin(), more_.end());
  work.name = folder_.name_of(work.folder);
  return work;
}

void Runs::stop(const std::string& name)
{
  const fs::path run = folder_.inside(name);
  if (queue_->stop(folder_.name_of(run))) return;
  const int process = process_in(run);
  if (process == 0) throw Refusal(409, fmt::format("no process of this machine runs in {}", name));
  ::kill(process, SIGINT);
}

/// Its folder, where nobody is at work on it.
fs::path Runs::at_hand(const std::string& name) const
{
  const fs::path run = folder_.run(name);
  if (run == folder_.root()) throw Refusal(403, "this is the folder of the desk");
  const auto entry = queue_->find(folder_.name_of(run));
  if (!io::FolderLock::owner_of(run).empty() || (entry && (entry->state == WorkState::queued || entry->state == WorkState::running)))
    throw Refusal(409, "the run is in progress");
  return run;
}

void Runs::look_again()
{
  const std::lock_guard guard(mutex_);
  looked_ = {};
}

void Runs::remove(const std::string& name)
{
  const fs::path run = folder_.inside(name);
  const auto entry = queue_->find(folder_.name_of(run));
  const bool has_ended = entry && entry->state != WorkState::queued && entry->state != WorkState::running;
  if (!has_ended || fs::exists(run)) {  // else it failed or was stopped before it made its folder
    const io::FolderLock lock(at_hand(name));
    fs::remove_all(run);
  }
  std::error_code none;
  fs::remove(run.string() + ".messages", none);
  queue_->forget(folder_.name_of(run));
  look_again();
}

Json Runs::rename(const std::string& name, const std::string& new_name)
{
  const fs::path run = at_hand(name);
  if (fs::path(new_name).has_parent_path() || new_name.empty() || new_name == ".")
    throw Refusal(400, fmt::format("{} is not a name of a folder", one_line(new_name)), {{"key", "name"}});
  const fs::path next = folder_.inside(folder_.name_of(run.parent_path() / new_name));
  const io::FolderLock lock(run);
  // Takes no place that became another's since it was looked at.
  if (::renameat2(AT_FDCWD, run.c_str(), AT_FDCWD, next.c_str(), RENAME_NOREPLACE) != 0) {
    if (errno == EEXIST) throw Refusal(409, fmt::format("{} exists", folder_.name_of(next)));
    throw Refusal(409, fmt::format("cannot rename {}: {}", name, std::strerror(errno)));
  }
  std::error_code none;
  fs::remove(next / io::FolderLock::file_name, none);
  fs::rename(run.string() + ".messages", next.string() + ".messages", none);
  queue_->forget(folder_.name_of(run));
  look_again();
  return {{"path", folder_.name_of(next)}};
}

void Runs::note(const std::string& name, const std::string& text)
{
  write_notes(folder_, folder_.run(name), text);
}

Runs::AtRest Runs::at_rest(const fs::path& run)
{
  const std::string of = identity_with_log(run);
  {
    const std::lock_guard lock(mutex_);
    const auto known = at_rest_.find(run.string());
    if (known != at_rest_.end() && known->second.of == of) return known->second;
  }
  const auto [state, why] = state_at_rest(folder_, run);
  AtRest seen{of, case_of(folder_, run), state, why, digest_of(folder_, run)};
  if (io::FolderLock::owner_of(run).empty())
    seen.summary["bytes"] = bytes_in(run);  // of one at work it would be counted at each line of its log
  const std::lock_guard lock(mutex_);
  if (at_rest_.size() >= most_known) at_rest_.clear();
  return at_rest_[run.string()] = seen;
}

/// A page asks once a second: the folders are not walked through as often.
std::vector<fs::path> Runs::found()
{
  const std::lock_guard lock(mutex_);
  const auto now = std::chrono::steady_clock::now();
  if (now - looked_ > between_looks) {
    found_ = folder_.runs();
    looked_ = now;
  }
  return found_;
}

Json Runs::state_of(const std::string& name, const std::optional<Queue::Entry>& entry)
{
  const fs::path run = folder_.root() / name;
  const AtRest rest = at_rest(run);
  const bool at_work = entry && (entry->state == WorkState::queued || entry->state == WorkState::running);
  WorkState state = WorkState::running;
  if (at_work || (entry && !fs::exists(run / "resolved.toml")))
    state = entry->state;
  else if (io::FolderLock::owner_of(run).empty())
    state = entry && entry->state == WorkState::failed && is_of_now(*entry) ? WorkState::failed : rest.state;
  Json answer = {{"path", name},
                 {"case", entry && !entry->work.case_file.empty() ? entry->work.case_file : rest.case_file},
                 {"status", word_of(state)},
                 {"progress", nullptr},
                 {"time_left_s", nullptr},
                 {"can_resume", (state == WorkState::stopped && fs::exists(run)) ||
                                    (state == WorkState::failed && rest.state == WorkState::stopped && simulation::can_be_resumed(run))},
                 {"began_here", entry.has_value()}};
  if (!at_work) answer.update(rest.summary);
  if (std::string notes = notes_of(folder_, run); !notes.empty()) answer["notes"] = std::move(notes);
  if (state == WorkState::finished) answer["progress"] = 1;
  if (const auto advance =
          state == WorkState::queued || state == WorkState::finished ? std::nullopt : advance_in(tail_of(run / "run.log", log_bytes))) {
    answer["progress"] = advance->done;
    if (state == WorkState::running && std::isfinite(advance->left_s)) answer["time_left_s"] = advance->left_s;
  }
  return answer;
}

Json Runs::list()
{
  Json all = Json::array();
  std::set<std::string> seen;
  for (const Queue::Entry& entry : queue_->entries())
    if (entry.work.kind == "run" && (entry.state != WorkState::finished || fs::exists(entry.work.folder)) &&
        seen.insert(entry.work.name).second)
      all.push_back(state_of(entry.work.name, entry));
  for (const fs::path& run : found())
    if (seen.insert(folder_.name_of(run)).second) all.push_back(state_of(folder_.name_of(run), std::nullopt));
  return all;
}

Json Runs::one(const std::string& name, std::size_t from_row)
{
  const fs::path run = folder_.inside(name);
  const std::string known = folder_.name_of(run);
  const auto entry = queue_->find(known);
  if (!entry) folder_.run(name);
  Json answer = state_of(known, entry);
  answer.update(live_.rows(run, from_row));
  const std::string messages = tail_of(run.string() + ".messages", log_bytes);
  const std::string log = tail_of(run / "run.log", log_bytes);
  answer["log_tail"] = log.empty() || answer["status"] == "failed" ? log + messages : log;
  if (const std::string status = answer["status"]; status == "failed" || status == "stopped") {
    const std::string said = last_line(messages);
    const bool begun = fs::exists(run / "resolved.toml"), ended = fs::exists(run / "summary.json"),
               is_error = said.starts_with("berm: ") && !said.starts_with("berm: warning: "), is_now = !entry || is_of_now(*entry);
    answer["why"] = !begun && !is_error && status == "stopped"   ? "It was stopped before it began."
                    : is_now && entry && !entry->why.empty()     ? entry->why
                    : is_now && (!begun || (!ended && is_error)) ? said
                                                                 : at_rest(run).why;
  }
  if (answer["status"] != "running" && fs::exists(run / "summary.json"))
    answer["summary"] = run_folder::read_json(folder_.real(run / "summary.json"), 10'000'000);
  return answer;
}

}  // namespace berm::desk
