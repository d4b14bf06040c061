// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/run_folder/history_test.cpp
#include "run_folder/history_schema.hpp"

#include "core/error.hpp"
#include "io/atomic_file.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace berm::run_folder {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::uintmax_t max_schema_bytes = 10'000'000;

Json json_of(const Column& column)
{
  return {{"name", column.name}, {"label", column.label}, {"unit", column.unit}, {"meaning", column.meaning}, {"of", column.of}};
}

const Json stage = {{"name", "stage"}, {"label", "stage"}, {"unit", nullptr}, {"meaning", "name of the stage"}, {"of", "run"}};

}  // namespace

std::filesystem::path schema_path(const std::filesystem::path& history)
{
  return std::filesystem::path(history).replace_extension(".schema.json");
}

void write_schema(const std::filesystem::path& history, const std::vector<Column>& columns)
{
  Json all = Json::array();
  for (const Column& column : columns) {
    all.push_back(json_of(column));
    if (all.size() == 1) all.push_back(stage);
  }
  io::write_atomically(schema_path(history), Json({{"columns", all}}).dump(1, ' ', false, Json::error_handler_t::replace) + '\n');
}

std::vector<Column> read_schema(const std::filesystem::path& history)
{
  const std::filesystem::path path = schema_path(history);
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error))
    throw RunError(fmt::format("{}: there is no {} beside it, which has its units", history.string(), path.filename().string()));
  if (std::filesystem::file_size(path, error) > max_schema_bytes)
    throw RunError(fmt::format("{} is damaged: it is too long", path.string()));
  try {
    std::vector<Column> columns;
    const Json schema = Json::parse(io::read_text_file(path));
    for (const Json& entry : schema.at("columns")) {
      if (entry.at("unit").is_null()) continue;
      const auto text = [&](const char* key) { return entry.at(key).get<std::string>(); };
      columns.push_back({text("name"), text("label"), text("unit"), text("meaning"), text("of")});
    }
    return columns;
  } catch (const Json::exception& why) {
    throw RunError(fmt::format("{} is damaged: {}", path.string(), why.what()));
  }
}

}  // namespace berm::run_folder
