// SPDX-License-Identifier: BSD-3-Clause
#include "report/run_record.hpp"

#include "core/error.hpp"
#include "input/read_case.hpp"
#include "output/whole_file.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <sstream>

namespace berm {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr Real unknown = std::numeric_limits<Real>::quiet_NaN();

Real number_of(const Json& json)
{
  return json.is_number() ? json.get<Real>() : json.is_boolean() ? Real(json.get<bool>()) : unknown;
}

/// Throws Json::exception where it is no summary.
RunSummary summary_of(const Json& json)
{
  RunSummary summary;
  for (const auto& [name, entry] : json.at("quantities").items())
    summary.quantities.push_back({name, number_of(entry.at("value")), entry.at("unit").get<std::string>()});
  for (const auto& [name, entry] : json.at("timing").items())
    if (name != "loops") summary.timing[name] = number_of(entry);
  for (const auto& [name, entry] : json.at("checks").items()) summary.checks[name] = number_of(entry);
  for (const auto& [name, entry] : json.at("text").items()) summary.text[name] = entry.get<std::string>();
  return summary;
}

void take_summary(RunRecord& run)
{
  const fs::path file = run.folder / "summary.json";
  if (!fs::exists(file)) return;
  try {
    run.summary = summary_of(Json::parse(read_whole(file)));
  } catch (const Json::exception&) {
    run.faults.emplace_back("summary.json is damaged and was not read");
    return;
  }
  const bool finished = run.check("finished") == 1;
  run.end = finished ? RunEnd::finished : RunEnd::stopped;
}

void take_history(RunRecord& run)
{
  const fs::path file = run.folder / "history.csv";
  try {
    if (fs::exists(file))
      run.history = read_history(file);
    else
      run.faults.emplace_back("history.csv is missing: there are no curves");
  } catch (const RunError& error) {
    run.faults.push_back(fmt::format("the history cannot be read: {}", error.what()));
  }
  if (run.history.rows() == 0) {
    if (fs::exists(file) && run.faults.empty()) run.faults.emplace_back("history.csv has no rows: the run ended before its first step");
    run.history = {};
  }
}

/// run.log: "2026-01-31 12:00:00 words" a line; messages of several lines go on without a time.
void take_log(RunRecord& run)
{
  constexpr std::size_t time_length = 19;
  std::istringstream lines(read_whole(run.folder / "run.log"));
  const std::string warning = "warning: ";
  for (std::string line; std::getline(lines, line);) {
    const bool timed = line.size() > time_length + 1 && line[4] == '-' && line[time_length] == ' ';
    if (!timed) continue;
    const std::string words = line.substr(time_length + 1);
    if (run.begun.empty()) run.begun = line.substr(0, time_length);
    if (words.starts_with(warning)) run.warnings.push_back(words.substr(warning.size()));
    run.last_words = words;
  }
  if (run.begun.empty()) run.faults.emplace_back("run.log is missing or empty");
}

Real value_in(const std::map<std::string, Real>& table, const std::string& name)
{
  const auto found = table.find(name);
  return found == table.end() ? unknown : found->second;
}

}  // namespace

Real RunRecord::check(const std::string& check_name) const
{
  return summary ? value_in(summary->checks, check_name) : unknown;
}

Real RunRecord::timing(const std::string& timing_name) const
{
  return summary ? value_in(summary->timing, timing_name) : unknown;
}

const Quantity* RunRecord::quantity(const std::string& quantity_name) const
{
  const auto found = std::find_if(quantities.begin(), quantities.end(), [&](const Quantity& q) { return q.name == quantity_name; });
  return found == quantities.end() ? nullptr : &*found;
}

bool is_run_folder(const fs::path& folder)
{
  return fs::exists(folder / "resolved.toml");
}

RunRecord read_run(const fs::path& folder)
{
  RunRecord run;
  run.folder = folder;
  run.name = fs::absolute(folder).lexically_normal().filename().string();
  if (run.name.empty()) run.name = fs::absolute(folder).lexically_normal().parent_path().filename().string();
  run.settings = read_case(folder / "resolved.toml");
  run.scale = pipe_scale(run.settings);
  run.stages = pipe_stages(run.settings);
  take_history(run);
  take_summary(run);
  take_log(run);
  if (run.summary)
    run.quantities = run.summary->quantities;
  else if (run.has_pipe() && run.history.rows() > 0)
    run.quantities = pipe_quantities(run.history, run.scale, run.stages);
  return run;
}

}  // namespace berm
