// SPDX-License-Identifier: BSD-3-Clause
#include "jobs/job.hpp"

#include "input/read_case.hpp"
#include "input/write_case.hpp"
#include "io/atomic_file.hpp"
#include "io/sha256.hpp"
#include "material/user_law.hpp"
#include "os/control_characters.hpp"
#include "os/error.hpp"
#include "os/text_of_list.hpp"
#include "run_folder/build.hpp"
#include "run_folder/origin.hpp"

#include <cstring>
#include <fmt/format.h>
#include <map>
#include <numeric>
#include <sstream>

namespace berm::jobs {
namespace {

namespace fs = std::filesystem;

/// The last line that a process wrote, without the program's name.
std::string last_message(const fs::path& file)
{
  std::istringstream lines(io::read_text_file(file));
  std::string line, last;
  while (std::getline(lines, line))
    if (line.find_first_not_of(" \t") != std::string::npos) last = line;
  return one_line(last.starts_with("berm: ") ? last.substr(6) : last);
}

/// Empty where it is damaged, too: the case is then run again.
std::optional<run_folder::RunSummary> summary_if_whole(const fs::path& folder)
{
  try {
    return run_folder::read_summary(folder);
  } catch (const RunError&) {
    return std::nullopt;
  }
}

/// A run notes what its libraries hold.
void note_libraries(std::vector<std::pair<std::string, material::Material>>& materials)
{
  const auto note = [](auto* law) {
    std::error_code error;
    if (law != nullptr && law->library_sha256.empty() && fs::exists(law->library, error))
      law->library_sha256 = io::sha256_of_file(law->library);
  };
  for (auto& entry : materials) {
    note(entry.second.get_if<material::UserLaw<material::Interface::umat>>());
    note(entry.second.get_if<material::UserLaw<material::Interface::own>>());
  }
}

/// Whether a run has begun and has not come to its end: it removes its checkpoints last of all, after its pictures.
bool is_under_way(const Job& job)
{
  std::error_code error;
  return fs::exists(job.folder / "checkpoint/case_file.txt", error);
}

/// Whether the run folder is of these settings, and of what is in the files that they name.
bool is_of(const fs::path& folder, settings::Case settings)
{
  if (!run_folder::named_files_are_the_same(folder)) return false;
  note_libraries(settings.material);
  const std::string found = io::read_text_file(folder / "resolved.toml"), asked = input::resolved_toml(settings);
  return input::without_report(found) == input::without_report(asked);
}

}  // namespace

bool is_of_case(const Job& job)
{
  return is_of(job.folder, input::read_case(job.case_file, job.set));
}

settings::Case with_whole_paths(settings::Case settings, const fs::path& case_file)
{
  if (auto* mesh = std::get_if<mesh::GmshFile>(&settings.mesh))
    mesh->file = fs::absolute(case_file.parent_path() / mesh->file).lexically_normal().string();
  return settings;
}

std::vector<std::string> words_of(const Job& job)
{
  std::vector<std::string> words = {job.command};
  if (job.resume)
    words.insert(words.end(), {"--resume", job.folder.string()});
  else
    words.insert(words.end(), {job.case_file.string(), "-o", job.folder.string(), "--force"});
  if (job.is_run()) words.insert(words.end(), {"--threads", std::to_string(job.threads)});
  if (job.uncertainty) words.emplace_back("--uncertainty");
  if (!job.resume)
    for (const std::string& set : job.set) words.insert(words.end(), {"--set", set});
  return words;
}

fs::path messages_of(const Job& job)
{
  return job.folder.string() + ".messages";
}

JobEnd end_with(const Job& job, int status)
{
  if (status == status_of(Outcome::done)) return {JobEnd::Kind::finished, ""};
  if (status == status_of(Outcome::unfinished)) return {JobEnd::Kind::interrupted, ""};
  if (status > 128) return {JobEnd::Kind::failed, fmt::format("ended by signal {} ({})", status - 128, strsignal(status - 128))};
  const std::string last = last_message(messages_of(job));
  return {JobEnd::Kind::failed, last.empty() ? fmt::format("ended with status {} without a message", status) : last};
}

bool has_result(const Job& job)
{
  if (is_under_way(job)) return false;
  const std::optional<run_folder::RunSummary> summary = summary_if_whole(job.folder);
  if (!summary || !summary->finished()) return false;
  const settings::Case settings = input::read_case(job.case_file, job.set);
  if (!run_folder::by_this_build(*summary, settings.method) || !is_of(job.folder, settings)) return false;
  return !job.uncertainty || (summary->uncertainty && summary->uncertainty->missing.empty());
}

bool has_ended_with_result(const Job& job)
{
  if (!has_result(job)) return false;
  std::error_code ignored;
  fs::remove(messages_of(job), ignored);
  return true;
}

bool goes_on(const Job& job)
{
  if (!job.is_run() || !is_under_way(job)) return false;
  const std::optional<run_folder::RunSummary> summary = summary_if_whole(job.folder);
  const settings::Case settings = input::read_case(job.case_file, job.set);
  if (summary && !run_folder::by_this_build(*summary, settings.method)) return false;
  return is_of(job.folder, settings);
}

Real wall_time_of(const fs::path& folder)
{
  const std::optional<run_folder::RunSummary> summary = summary_if_whole(folder);
  const std::map<std::string, Real> timing = summary ? summary->timing : std::map<std::string, Real>();
  const auto wall = timing.find("wall_s");
  if (wall == timing.end()) return nan;
  Real sum = wall->second;
  if (summary->uncertainty)
    for (const run_folder::BandRun& run : summary->uncertainty->runs) sum += run.wall_s;
  return sum;
}

Real expected_time(const Job& job)
{
  const std::optional<run_folder::RunSummary> summary = summary_if_whole(job.folder);
  const Real earlier = wall_time_of(job.folder);
  if (summary && summary->finished() && !std::isnan(earlier)) return earlier;
  return job.resume && job.estimate > earlier ? job.estimate - earlier : job.estimate;
}

std::vector<std::size_t> by_time(const std::vector<Job>& jobs)
{
  std::vector<Real> times;
  for (const Job& job : jobs) {
    const Real time = expected_time(job);
    times.push_back(std::isnan(time) ? infinity : time);
  }
  std::vector<std::size_t> order(jobs.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return times[a] > times[b]; });
  return order;
}

std::string mixed_vector_units(const std::vector<fs::path>& folders)
{
  std::map<std::string, int> count;
  for (const fs::path& folder : folders)
    if (const auto summary = summary_if_whole(folder)) ++count[run_folder::vector_unit_of(*summary)];
  if (count.size() < 2) return "";
  std::vector<std::string> words;
  for (const auto& [unit, runs] : count) words.push_back(fmt::format("{}: {}", unit, runs));
  return fmt::format("the runs were computed on several vector units ({}), between which results differ by round-off",
                     text_of_list(words, ", "));
}

}  // namespace berm::jobs
