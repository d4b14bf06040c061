// SPDX-License-Identifier: BSD-3-Clause
#include "run_folder/origin.hpp"

#include "core/vector_unit.hpp"
#include "io/atomic_file.hpp"
#include "io/host_info.hpp"
#include "io/log.hpp"
#include "io/revision.hpp"
#include "io/sha256.hpp"
#include "os/control_characters.hpp"
#include "os/error.hpp"
#include "run_folder/json_file.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace berm::run_folder {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr const char* origin_name = "origin.json";
constexpr const char* not_recorded = "not recorded";
constexpr const char* input_names[] = {"case.toml", "resolved.toml", "mesh.msh", "expected.toml"};

#ifdef __OPTIMIZE__
constexpr const char* optimized = "optimized";
#else
constexpr const char* optimized = "not optimized";
#endif

FileHashes hashes_of(const std::vector<fs::path>& files)
{
  FileHashes hashes;
  for (const fs::path& file : files) hashes.emplace_back(file.filename().string(), io::sha256_of_file(file));
  return hashes;
}

/// A file that cannot be read, or is another one since the program began, is no reason to fail.
FileHashes hashes_of(const std::vector<io::ProgramFile>& files)
{
  FileHashes hashes;
  for (const io::ProgramFile& file : files) try {
      hashes.emplace_back(file.name, file.path.empty() ? not_recorded : io::sha256_of_file(file.path));
    } catch (const RunError&) {
      hashes.emplace_back(file.name, not_recorded);
    }
  return hashes;
}

Json json_of(const FileHashes& hashes)
{
  Json json = Json::object();
  for (const auto& [name, hash] : hashes) json[name] = hash;
  return json;
}

FileHashes hashes_in(const Json& json)
{
  FileHashes hashes;
  for (const auto& [name, hash] : json.items()) hashes.emplace_back(name, hash.get<std::string>());
  return hashes;
}

void write(const fs::path& run_folder, const Origin& origin)
{
  Json json = {{"case", origin.case_file}, {"set", origin.set}, {"input_sha256", json_of(origin.input)}, {"sessions", Json::array()}};
  if (origin.lengthened) json["lengthened"] = true;
  for (const RunSession& session : origin.sessions)
    json["sessions"].push_back({{"begun", session.begun},
                                {"resumption", session.resumption},
                                {"version", session.version},
                                {"build", session.build},
                                {"program_sha256", json_of(session.program)}});
  io::write_atomically(run_folder / origin_name, json.dump(2, ' ', false, Json::error_handler_t::replace) + '\n');
}

}  // namespace

RunSession this_session()
{
  return {io::utc_date(std::chrono::system_clock::now()), io::version_words(),
          fmt::format("{}, compiler {}, vector unit {}", optimized, __VERSION__, vector_unit()), hashes_of(io::program_files("libberm"))};
}

namespace {

FileHashes hashes_of_inputs(const fs::path& folder)
{
  std::vector<fs::path> inputs;
  std::error_code error;
  for (const char* name : input_names)
    if (const fs::path file = folder / name; fs::exists(file, error)) inputs.push_back(file);
  return hashes_of(inputs);
}

}  // namespace

void note_change(const fs::path& run_folder, const fs::path& changed, const std::vector<std::string>& set, const FileHashes& named)
{
  Origin origin = read_origin(run_folder).value_or(Origin());
  FileHashes hashes = hashes_of_inputs(changed);
  hashes.insert(hashes.end(), named.begin(), named.end());
  for (const auto& [name, hash] : hashes) {
    const auto same =
        std::find_if(origin.input.begin(), origin.input.end(), [&, &name = name](const auto& old) { return old.first == name; });
    if (same != origin.input.end()) same->second = hash;
  }
  for (const std::string& change : set) origin.set.push_back(one_line(change));
  origin.lengthened = true;
  write(changed, origin);
}

void note_origin(const fs::path& run_folder, const std::string& case_file, const std::vector<std::string>& set, const FileHashes& named)
{
  FileHashes hashes = hashes_of_inputs(run_folder);
  hashes.insert(hashes.end(), named.begin(), named.end());
  for (auto& entry : hashes) entry.first = one_line(entry.first);
  std::vector<std::string> changes;
  for (const std::string& change : set) changes.push_back(one_line(change));
  write(run_folder, {hashes, {this_session()}, one_line(case_file), changes});
}

void note_resumption(const fs::path& run_folder)
{
  Origin origin;
  try {
    origin = read_origin(run_folder).value_or(Origin());
  } catch (const RunError& error) {  // no reason not to resume the run
    io::warn("{}: what the run was begun with is not known", error.what());
  }
  origin.sessions.push_back(this_session());
  origin.sessions.back().resumption = true;
  write(run_folder, origin);
}

std::optional<Origin> read_origin(const fs::path& run_folder)
{
  std::error_code error;
  const fs::path file = run_folder / origin_name;
  if (!fs::exists(file, error)) return std::nullopt;
  try {
    const Json json = read_json(file);
    Origin origin{hashes_in(json.at("input_sha256")),
                  {},
                  json.value("case", ""),
                  json.value("set", std::vector<std::string>()),
                  json.value("lengthened", false)};
    for (const Json& session : json.at("sessions"))
      origin.sessions.push_back({session.at("begun").get<std::string>(), session.at("version").get<std::string>(),
                                 session.at("build").get<std::string>(), hashes_in(session.at("program_sha256")),
                                 session.value("resumption", !origin.sessions.empty())});
    return origin;
  } catch (const Json::exception&) {
    throw RunError(fmt::format("{} is damaged", file.string()));
  }
}

bool named_files_are_the_same(const fs::path& run_folder)
{
  try {
    const std::optional<Origin> origin = read_origin(run_folder);
    if (!origin || !origin->begins()) return false;
    return std::all_of(origin->input.begin(), origin->input.end(), [](const auto& file) {
      return !fs::path(file.first).is_absolute() || io::sha256_of_file(file.first) == file.second;
    });
  } catch (const RunError&) {
    return false;
  }
}

}  // namespace berm::run_folder
