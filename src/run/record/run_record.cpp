// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/commands/report_test.cpp
#include "record/run_record.hpp"

#include "input/read_case.hpp"
#include "input/write_case.hpp"
#include "io/atomic_file.hpp"
#include "io/sha256.hpp"
#include "os/control_characters.hpp"
#include "os/error.hpp"
#include "record/logged_end.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <sstream>
#include <unistd.h>

namespace berm::record {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

enum class Found { nothing, unreadable, file };

/// What a path is, without throwing where it may not be looked at.
Found look_for(const fs::path& path)
{
  std::error_code error;
  if (fs::status(path, error).type() == fs::file_type::not_found) return Found::nothing;
  return !error && fs::is_regular_file(path, error) && ::access(path.c_str(), R_OK) == 0 ? Found::file : Found::unreadable;
}

void take_summary(RunRecord& run)
{
  try {
    run.summary = run_folder::read_summary(run.folder);
  } catch (const RunError&) {
    run.faults.emplace_back("summary.json is damaged or cannot be read: how the run ended is not known");
    run.end = RunEnd::unknown;
    return;
  }
  if (run.summary) run.end = run.summary->finished() ? RunEnd::finished : RunEnd::stopped;
}

void take_history(RunRecord& run)
{
  const fs::path file = run.folder / "history.csv";
  try {
    if (look_for(file) == Found::nothing)
      run.faults.emplace_back("history.csv is missing: there are no curves");
    else
      run.history = run_folder::read_history(file);
  } catch (const RunError& error) {
    run.faults.push_back(fmt::format("the history cannot be read: {}", error.what()));
  }
  if (run.history.rows() == 0) {
    if (run.faults.empty()) run.faults.emplace_back("history.csv has no rows: the run ended before its first step");
    run.history = {};
  }
}

/// A finished run whose history does not reach its last stage was cut.
void compare_history_with_end(RunRecord& run)
{
  if (run.end != RunEnd::finished || run.history.rows() == 0 || run.settings.stage.empty()) return;
  if (run.history.stage.back() != run.settings.stage.back().name)
    run.faults.push_back(
        fmt::format("history.csv ends in stage \"{}\", although the run finished: it was truncated", run.history.stage.back()));
}

/// How a run says that it was asked to stop.
constexpr std::string_view stopped_at = "stopped at t = ";

/// run.log: "2026-01-31 12:00:00 words" a line; messages of several lines go on without a time.
void take_log(RunRecord& run)
{
  constexpr std::size_t time_length = 19;
  const fs::path file = run.folder / "run.log";
  std::istringstream lines(look_for(file) == Found::file ? io::read_text_file(file) : "");
  const std::string warning = "warning: ";
  for (std::string line; std::getline(lines, line);) {
    const bool timed = line.size() > time_length + 1 && line[4] == '-' && line[time_length] == ' ';
    if (!timed) continue;
    const std::string words = one_line(line.substr(time_length + 1));
    if (run.begun.empty()) run.begun = one_line(line.substr(0, time_length));
    if (words.starts_with(warning)) run.warnings.push_back(words.substr(warning.size()));
    run.last_log_line = words;
  }
  // A run that was stopped says so, and then writes its results, of which it may warn.
  if (run.last_log_line.starts_with("everything is in ") && !run.warnings.empty()) {
    const auto said =
        std::find_if(run.warnings.rbegin(), run.warnings.rend(), [](const std::string& words) { return words.starts_with(stopped_at); });
    run.last_log_line = said == run.warnings.rend() ? run.warnings.back() : *said;
  }
  if (run.begun.empty()) run.faults.emplace_back("run.log is missing, empty or cannot be read");
}

/// The line of ground.csv: two corners at least, from left to right; empty where it is damaged.
std::optional<mesh::GroundLine> read_ground(const fs::path& file)
{
  std::istringstream lines(io::read_text_file(file));
  std::string line;
  std::getline(lines, line);
  mesh::GroundLine ground;
  while (std::getline(lines, line)) {
    std::istringstream words(line);
    Vec<2> corner;
    char comma = 0;
    if (!(words >> corner[0] >> comma >> corner[1]) || comma != ',' || !(words >> std::ws).eof() || !corner.allFinite()) return {};
    if (!ground.corners.empty() && corner[0] < ground.corners.back()[0]) return {};
    ground.corners.push_back(corner);
  }
  return ground.corners.size() < 2 ? std::nullopt : std::optional(ground);
}

/// The surface that a mesh of the user has.
void take_ground(RunRecord& run)
{
  run.ground = problem::ground_of(run.settings);
  const fs::path file = run.folder / "ground.csv";
  if (!run.ground.line.level() || look_for(file) != Found::file) return;
  if (const std::optional<mesh::GroundLine> found = read_ground(file))
    run.ground.take_found(*found);
  else
    run.faults.emplace_back("ground.csv is damaged: the ground is taken to be level");
}

/// Compares the files of the folder with what origin.json noted of them when the run began.
void take_changes(RunRecord& run)
{
  const run_folder::FileHashes& noted = run.origin->input;
  const auto has = [&](const std::string& name, const std::string& hash) {
    return std::find(noted.begin(), noted.end(), std::pair(name, hash)) != noted.end();
  };
  for (const auto& [name, hash] : noted) {
    const fs::path file = run.folder / name;
    if (file.filename() != name || look_for(file) != Found::file || io::sha256_of_file(file) == hash) continue;
    if (name == "resolved.toml" && has(run_folder::without_report_entry, io::sha256_of(input::without_report(io::read_text_file(file)))))
      continue;
    run.changed.push_back(name);
    run.faults.push_back(words_of_change(name));
  }
}

void take_origin(RunRecord& run)
{
  try {
    run.origin = run_folder::read_origin(run.folder);
  } catch (const RunError&) {
    run.faults.emplace_back("origin.json is damaged: the input of the run is not known");
  }
  if (run.origin) take_changes(run);
  if (run.origin && run.origin->begins() && !run.origin->sessions.front().begun.empty()) run.begun = run.origin->sessions.front().begun;
}

Real value_in(const std::map<std::string, Real>& table, const std::string& name)
{
  const auto found = table.find(name);
  return found == table.end() ? nan : found->second;
}

}  // namespace

Real RunRecord::check(const std::string& check_name) const
{
  return summary ? value_in(summary->checks, check_name) : nan;
}

Real RunRecord::timing(const std::string& timing_name) const
{
  return summary ? value_in(summary->timing, timing_name) : nan;
}

const run_folder::Quantity* RunRecord::quantity(const std::string& quantity_name) const
{
  const auto found =
      std::find_if(quantities.begin(), quantities.end(), [&](const run_folder::Quantity& q) { return q.name == quantity_name; });
  return found == quantities.end() ? nullptr : &*found;
}

LoggedEnd logged_end(const fs::path& folder)
{
  RunRecord run;
  run.folder = folder;
  take_log(run);
  return {run.last_log_line, run.last_log_line.find(stopped_at) <= std::string_view("warning: ").size()};
}

std::string file_name_of(const std::string& name)
{
  std::string safe;
  for (const char c : name) {
    const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '.' || c == '-' || c == '_';
    safe += plain ? c : '_';
  }
  return safe;
}

void write_ground(const fs::path& folder, const mesh::GroundLine& line)
{
  std::string text = "x_m,y_m\n";
  for (const Vec<2>& corner : line.corners) text += fmt::format("{},{}\n", corner[0], corner[1]);
  io::write_atomically(folder / "ground.csv", text);
}

std::string words_of_change(const std::string& file)
{
  return fmt::format("{} was changed after the run began: the run used an earlier version", file);
}

bool is_run_folder(const fs::path& folder)
{
  return look_for(folder / "resolved.toml") == Found::file;
}

RunRecord read_run(const fs::path& folder)
{
  RunRecord run;
  run.folder = folder;
  const fs::path whole = fs::absolute(folder).lexically_normal();
  const std::string name = (whole.has_filename() ? whole : whole.parent_path()).filename().string();
  run.name = one_line(Json::parse(Json(name).dump(-1, ' ', false, Json::error_handler_t::replace)).get<std::string>());
  run.settings = input::read_case(folder / "resolved.toml");
  take_ground(run);
  take_history(run);
  take_summary(run);
  take_log(run);
  take_origin(run);
  compare_history_with_end(run);
  if (!run.summary) return run;
  if (run.history.rows() > 0)
    run.quantities = run.summary->quantities;
  else if (!run.summary->quantities.empty())
    run.faults.emplace_back("the results in summary.json are left out: the rows that they are of are not there");
  return run;
}

}  // namespace berm::record
