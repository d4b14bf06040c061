// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/jobs/jobs_test.cpp
#include "jobs/queue.hpp"

#include "io/atomic_file.hpp"
#include "jobs/queue_scripts.hpp"
#include "jobs/shell.hpp"
#include "os/error.hpp"
#include "os/text_of_list.hpp"

#include <algorithm>
#include <charconv>
#include <fmt/format.h>
#include <sstream>

namespace berm::jobs {
namespace {

namespace fs = std::filesystem;

fs::path status_file(const Job& job)
{
  return job.folder.string() + ".status";
}

fs::path whole(const fs::path& path)
{
  return fs::absolute(path).lexically_normal();
}

std::string this_program()
{
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error);
  if (error) throw RunError(fmt::format("the path of this program is not known: {}", error.message()));
  return program.string();
}

/// The command that does the job from anywhere.
std::string line_of(Job job, const fs::path& queue)
{
  job.case_file = whole(job.case_file);
  job.folder = whole(job.folder);
  job.resume = false;  // the script finds out
  std::string line = fmt::format("sh {} {} {}", quoted((queue / "run_job").string()), quoted(job.folder.string()), quoted(this_program()));
  for (const std::string& word : words_of(job)) line += ' ' + quoted(word);
  if (line.find('\n') != std::string::npos)
    throw InputError(fmt::format("{}: a path or a value with a line break cannot be passed to a scheduler", job.case_file.string()));
  return line;
}

}  // namespace

Queue::Queue(const fs::path& folder, const std::vector<Job>& jobs) : folder_(whole(folder)), jobs_(jobs)
{
  for (const Job& job : jobs_) lines_.push_back(line_of(job, folder_));
  std::istringstream open(io::read_text_file(folder_ / "open"));
  std::getline(open, handle_);
  for (std::string line; std::getline(open, line);) handed_over_.push_back(line);
}

bool Queue::was_handed_over(std::size_t job) const
{
  return std::find(handed_over_.begin(), handed_over_.end(), lines_[job]) != handed_over_.end();
}

std::optional<int> Queue::status_of_job(std::size_t job) const
{
  const std::string text = io::read_text_file(status_file(jobs_[job]));
  int status = 0;
  if (const auto end = std::from_chars(text.data(), text.data() + text.size(), status); end.ec != std::errc()) return std::nullopt;
  return status;
}

void Queue::check_holds_all() const
{
  for (std::size_t k = 0; k < jobs_.size(); ++k)
    if (!was_handed_over(k))
      throw RunError(fmt::format("{} has runs of an earlier command that are not done yet ({}), and {} is not among them: wait for them, "
                                 "or cancel them and remove that folder",
                                 folder_.string(), handle_, jobs_[k].folder.string()));
}

std::vector<std::size_t> Queue::to_do() const
{
  std::vector<std::size_t> order = by_time(jobs_);
  std::erase_if(order, [&](std::size_t k) { return was_handed_over(k) && end_of(k); });
  return order;
}

void Queue::write(const std::vector<std::size_t>& jobs)
{
  io::make_folder(folder_);
  std::string text;
  for (const std::size_t k : jobs) {
    const Job& job = jobs_[k];
    io::make_folder(whole(job.folder).parent_path());
    std::error_code ignored;
    fs::remove(status_file(job), ignored);
    if (goes_on(job)) {
      if (!fs::exists(messages_of(job), ignored)) io::write_atomically(messages_of(job), "");  // by which run_job knows that it has begun
    } else {
      fs::remove(messages_of(job), ignored);
      for (const char* name : {"summary.json", "checkpoint"}) fs::remove_all(job.folder / name, ignored);
    }
    text += lines_[k] + '\n';
  }
  io::write_atomically(folder_ / "run_job", run_job_script);
  io::write_atomically(folder_ / "jobs", text);
}

void Queue::hand_to(const std::string& handle)
{
  handle_ = handle;
  handed_over_ = lines_;
  io::write_atomically(folder_ / "open", fmt::format("{}\n{}\n", handle_, text_of_list(handed_over_, "\n")));
}

std::optional<JobEnd> Queue::end_of(std::size_t job) const
{
  if (const std::optional<int> status = status_of_job(job)) {
    const JobEnd end = end_with(jobs_[job], *status);
    return end.kind == JobEnd::Kind::failed ? std::optional(end) : std::nullopt;
  }
  const Job& of = jobs_[job];
  std::error_code error;
  if (fs::exists(messages_of(of), error) || !fs::exists(of.folder / "summary.json", error)) return std::nullopt;
  if (!of.is_run() || has_result(of)) return JobEnd{JobEnd::Kind::finished, ""};
  return JobEnd{JobEnd::Kind::failed, "ended well, but its folder has no result of this case by this build of berm: which berm ran it?"};
}

bool Queue::none_has_begun() const
{
  return std::all_of(jobs_.begin(), jobs_.end(), [](const Job& job) {
    std::error_code error;
    return !fs::exists(messages_of(job), error) && !fs::exists(job.folder / "summary.json", error);
  });
}

JobEnd Queue::left_over(std::size_t job) const
{
  if (const std::optional<JobEnd> end = end_of(job)) return *end;
  std::error_code error;
  if (status_of_job(job) || !fs::exists(messages_of(jobs_[job]), error)) return {};
  return {JobEnd::Kind::failed,
          "was ended from outside, by a limit of time or memory or with its machine; the same command continues from its last checkpoint"};
}

void Queue::close()
{
  std::error_code ignored;
  fs::remove(folder_ / "open", ignored);
  for (const Job& job : jobs_) fs::remove(status_file(job), ignored);
  handle_.clear();
  handed_over_.clear();
}

}  // namespace berm::jobs
