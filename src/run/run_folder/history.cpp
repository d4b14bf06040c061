// SPDX-License-Identifier: BSD-3-Clause
#include "run_folder/history.hpp"

#include "io/atomic_file.hpp"
#include "os/control_characters.hpp"
#include "os/error.hpp"
#include "os/read_file.hpp"
#include "os/text_of_list.hpp"
#include "run_folder/csv_line.hpp"
#include "run_folder/json_file.hpp"

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <fcntl.h>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <unistd.h>

namespace berm::run_folder {
namespace {

constexpr const char* stage_column = "stage";

std::string csv_number(Real value)
{
  return std::isnan(value) ? "nan" : fmt::format("{}", value);
}

bool read_number(const std::string& field, Real& value)
{
  const char* end = field.data() + field.size();
  const auto [stop, error] = std::from_chars(field.data(), end, value);
  return error == std::errc() && stop == end && !field.empty();
}

/// A field in quotes on one line, as far as it is needed to find it.
std::string shown(const std::string& field)
{
  constexpr std::size_t max = 30;
  std::string text = field.substr(0, max);
  std::replace_if(
      text.begin(), text.end(), [](unsigned char c) { return c < 0x20 || c >= 0x7F; }, '?');
  return '"' + text + (field.size() > max ? "...\"" : "\"");
}

}  // namespace

HistoryFile::HistoryFile(const std::filesystem::path& path, BigIndex kept_bytes) : path_(path)
{
  file_ = io::open_to_write(path, O_WRONLY | O_APPEND);
  try {
    if (::lseek(file_, 0, SEEK_END) > kept_bytes && ::ftruncate(file_, kept_bytes) != 0)
      io::throw_errno(fmt::format("cannot write {}", path.string()));
    if (kept_bytes > 0) history_ = read_history(path);
  } catch (...) {
    ::close(file_);
    throw;
  }
}

HistoryFile::~HistoryFile()
{
  ::close(file_);
}

void HistoryFile::write(const std::string& line)
{
  const off_t before = ::lseek(file_, 0, SEEK_END);
  if (io::write_all(file_, line)) return;
  const int reason = errno;
  // Where even this fails, half a row is left, which readers leave out.
  if (before >= 0 && ::ftruncate(file_, before) != 0) errno = reason;
  errno = reason;
  io::throw_errno(fmt::format("cannot write {}", path_.string()));
}

/// Before the first row.
std::string HistoryFile::header(const std::vector<Column>& columns) const
{
  write_schema(path_, columns);
  std::string line = columns[0].name + ',' + stage_column;
  for (std::size_t k = 1; k < columns.size(); ++k) line += ',' + csv_field(columns[k].name);
  return line + '\n';
}

void HistoryFile::add(Row& row)
{
  row.end();
  const bool first = history_.columns.empty();
  if (!first && history_.columns != row.columns())
    throw RunError(
        fmt::format("{}: the resumed run has other columns than {} lists", path_.string(), schema_path(path_).filename().string()));
  std::string line = first ? header(row.columns()) : "";
  line += csv_number(row.values()[0]) + ',' + csv_field(row.stage());
  for (std::size_t k = 1; k < row.values().size(); ++k) line += ',' + csv_number(row.values()[k]);
  write(line + '\n');
  if (first) {
    history_.columns = row.columns();
    history_.values.resize(history_.columns.size());
  }
  history_.stage.push_back(row.stage());
  for (std::size_t k = 0; k < row.values().size(); ++k) history_.values[k].push_back(row.values()[k]);
}

BigIndex HistoryFile::bytes() const
{
  const off_t bytes = ::lseek(file_, 0, SEEK_END);
  if (bytes < 0) io::throw_errno(fmt::format("cannot write {}", path_.string()));
  return bytes;
}

void HistoryFile::sync() const
{
  if (::fsync(file_) != 0) io::throw_errno(fmt::format("cannot write {}", path_.string()));
}

bool History::has(const std::string& name) const
{
  return std::ranges::find(columns, name, &Column::name) != columns.end();
}

const Column& History::column(const std::string& name) const
{
  const auto found = std::ranges::find(columns, name, &Column::name);
  if (found == columns.end()) throw RunError(fmt::format("the history has no column {}; it has {}", name, text_of_list(names(), ", ")));
  return *found;
}

const std::vector<Real>& History::operator[](const std::string& name) const
{
  return values[&column(name) - columns.data()];
}

bool History::has_label(const std::string& label) const
{
  return std::ranges::find(columns, label, &Column::label) != columns.end();
}

const Column& History::column_by_label(const std::string& label) const
{
  const auto found = std::ranges::find(columns, label, &Column::label);
  if (found == columns.end())
    throw RunError(fmt::format("the history has no column for \"{}\"; it has {}", label, text_of_list(names(), ", ")));
  return *found;
}

const std::vector<Real>& History::by_label(const std::string& label) const
{
  return values[&column_by_label(label) - columns.data()];
}

std::vector<std::string> History::names() const
{
  std::vector<std::string> all;
  for (const Column& each : columns) all.push_back(each.name);
  return all;
}

History read_history(const std::filesystem::path& path)
{
  constexpr std::uintmax_t max_bytes = 5'000'000'000;
  const auto [text, fault] = read_file(path, max_bytes);
  if (!fault.empty()) throw RunError(fmt::format("{}: {}", path.string(), fault));

  History history;
  if (text.empty()) return history;
  std::vector<std::string> header, fields, columns;
  std::size_t at = 0;
  if (!next_csv_line(text, at, header)) throw RunError(fmt::format("{}: it has no header line", path.string()));
  const auto stage = static_cast<std::size_t>(std::find(header.begin(), header.end(), stage_column) - header.begin());
  if (stage == header.size()) throw RunError(fmt::format("{}: line 1: there is no column {}", path.string(), stage_column));
  for (const std::string& column : header)
    if (has_control_character(column))
      throw RunError(fmt::format("{}: line 1: {} is not a name of a column", path.string(), shown(column)));
  for (std::size_t k = 0; k < header.size(); ++k)
    if (k != stage) columns.push_back(header[k]);
  history.columns = read_schema(path);
  if (history.names() != columns)
    throw RunError(fmt::format("{}: {} is of another history", path.string(), schema_path(path).filename().string()));
  history.values.resize(history.columns.size());

  for (Index line = 2; next_csv_line(text, at, fields); ++line) {
    if (fields.size() != header.size())
      throw RunError(fmt::format("{}: line {}: {} fields for {} columns", path.string(), line, fields.size(), header.size()));
    if (has_control_character(fields[stage]))
      throw RunError(fmt::format("{}: line {}: {} is not a name of a stage", path.string(), line, shown(fields[stage])));
    history.stage.push_back(fields[stage]);
    for (std::size_t k = 0, column = 0; k < fields.size(); ++k) {
      if (k == stage) continue;
      Real value = 0;
      if (!read_number(fields[k], value))
        throw RunError(fmt::format("{}: line {}: {} is not a number", path.string(), line, shown(fields[k])));
      history.values[column++].push_back(value);
    }
  }
  return history;
}

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
  if (!std::filesystem::exists(path, error))
    throw RunError(fmt::format("{}: there is no {} beside it, which has its units", history.string(), path.filename().string()));
  try {
    std::vector<Column> columns;
    const Json schema = read_json(path, max_schema_bytes);
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
