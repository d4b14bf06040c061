// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/run_folder/summary_test.cpp
#include "run_folder/summary_file.hpp"

#include "os/error.hpp"
#include "run_folder/json_file.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace berm::run_folder {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr std::uintmax_t max_bytes = 10'000'000;  // a summary has some thousands

[[noreturn]] void refuse(const std::string& why)
{
  throw RunError("is damaged: " + why);
}

const Json& member(const Json& json, const char* name)
{
  const auto found = json.find(name);
  if (found == json.end()) refuse(fmt::format("it has no \"{}\"", name));
  return *found;
}

const Json& table(const Json& json, const char* name)
{
  const Json& found = member(json, name);
  if (!found.is_object()) refuse(fmt::format("\"{}\" is not a table", name));
  return found;
}

Real number(const Json& json, const char* where)
{
  if (json.is_null()) return nan;
  if (json.is_boolean()) return json.get<bool>() ? 1 : 0;
  if (!json.is_number()) refuse(fmt::format("a value in \"{}\" is not a number", where));
  return json.get<Real>();
}

std::string words(const Json& json, const char* where)
{
  if (!json.is_string()) refuse(fmt::format("a value in \"{}\" is not a text", where));
  return json.get<std::string>();
}

/// Runs of earlier versions do not say it.
QuantityKind kind_of(const std::string& word)
{
  for (const QuantityKind kind : {QuantityKind::ratio, QuantityKind::quality, QuantityKind::prescribed})
    if (word == word_of(kind)) return kind;
  return QuantityKind::answer;
}

RunSummary summary_of(const Json& json)
{
  if (!json.is_object()) refuse("it is not a table");
  RunSummary summary;
  for (const auto& [name, entry] : table(json, "quantities").items()) {
    if (!entry.is_object()) refuse("a value in \"quantities\" is not a table");
    const auto words_at = [&entry = entry](const char* key) { return entry.contains(key) ? words(entry[key], "quantities") : ""; };
    summary.quantities.push_back({name, number(member(entry, "value"), "quantities"), words(member(entry, "unit"), "quantities"),
                                  words_at("meaning"), kind_of(words_at("kind")), words_at("of")});
  }
  for (const auto& [name, entry] : table(json, "timing").items())
    if (name != "loops") summary.timing[name] = number(entry, "timing");
  for (const auto& [name, entry] : table(json, "checks").items()) summary.checks[name] = number(entry, "checks");
  for (const auto& [name, entry] : table(json, "text").items()) summary.text[name] = words(entry, "text");
  for (const auto& [name, list] : {std::pair{"warnings", &summary.warnings}, {"invalid", &summary.invalid}})
    if (const auto found = json.find(name); found != json.end()) {
      if (!found->is_array()) refuse(fmt::format("\"{}\" is not a list", name));
      for (const Json& entry : *found) list->push_back(words(entry, name));
    }
  if (const auto uncertainty = json.find("uncertainty"); uncertainty != json.end()) summary.uncertainty = uncertainty_of(*uncertainty);
  return summary;
}

}  // namespace

bool RunSummary::finished() const
{
  const auto found = checks.find("finished");
  return found != checks.end() && found->second == 1;
}

std::optional<RunSummary> read_summary(const fs::path& run_folder)
{
  const fs::path file = run_folder / "summary.json";
  std::error_code error;
  if (fs::status(file, error).type() == fs::file_type::not_found) return std::nullopt;
  const Json json = read_json(file, max_bytes);
  try {
    return summary_of(json);
  } catch (const RunError& found) {
    throw RunError(fmt::format("{} {}", file.string(), found.what()));
  }
}

}  // namespace berm::run_folder
