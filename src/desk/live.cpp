// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/desk/desk_live_test.cpp
#include "desk/live.hpp"

#include "run_folder/csv_line.hpp"
#include "run_folder/json_file.hpp"

#include <charconv>
#include <cmath>
#include <fcntl.h>
#include <fmt/format.h>
#include <sstream>
#include <sys/stat.h>
#include <unistd.h>

namespace berm::desk {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t most_bytes_at_once = 1 << 20, most_rows = 5000, most_places = 64;

struct Opened {
  int file;
  struct stat about {};

  explicit Opened(const fs::path& path) : file(::open(path.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC))
  {
    if (file >= 0 && (::fstat(file, &about) != 0 || !S_ISREG(about.st_mode))) ::close(file), file = -1;
  }
  ~Opened()
  {
    if (file >= 0) ::close(file);
  }
  Opened(const Opened&) = delete;
  Opened& operator=(const Opened&) = delete;

  std::uintmax_t size() const { return file < 0 ? 0 : static_cast<std::uintmax_t>(about.st_size); }
  std::string read(std::uintmax_t from, std::size_t most) const
  {
    std::string text(most, '\0');
    const ssize_t count = file < 0 ? 0 : ::pread(file, text.data(), most, static_cast<off_t>(from));
    text.resize(static_cast<std::size_t>(std::max<ssize_t>(count, 0)));
    return text;
  }
};

/// A number where it is one that JSON has, null for NaN, else the text.
Json value_of(const std::string& field)
{
  double number = 0;
  const auto [end, error] = std::from_chars(field.data(), field.data() + field.size(), number);
  if (error != std::errc() || end != field.data() + field.size()) return field;
  return std::isfinite(number) ? Json(number) : Json();
}

Json row_of(const std::vector<std::string>& fields)
{
  Json row = Json::array();
  for (const std::string& field : fields) row.push_back(value_of(field));
  return row;
}

/// "12 min 05 s" in s.
double seconds_in(const std::string& words)
{
  std::istringstream parts(words);
  double sum = 0, number = 0;
  for (std::string unit; parts >> number >> unit;) {
    const double scale = unit == "ms"      ? 1e-3
                         : unit == "s"     ? 1
                         : unit == "min"   ? 60
                         : unit == "h"     ? 3600
                         : unit == "years" ? 365.25 * 86400
                                           : std::nan("");
    sum += scale * number;
  }
  return parts.eof() && sum > 0 ? sum : std::nan("");
}

/// Of a line "DATE TIME STAGE  12 %  3.1 s left  ..."; stages may have any name.
std::optional<Advance> advance_of(const std::string& line)
{
  for (std::size_t at = line.find(" %  "); at != std::string::npos; at = line.find(" %  ", at + 1)) {
    const std::size_t begin = line.rfind("  ", at);
    if (begin == std::string::npos || begin + 2 >= at) continue;
    double percent = 0;
    const auto [end, error] = std::from_chars(line.data() + begin + 2, line.data() + at, percent);
    if (error != std::errc() || end != line.data() + at || percent < 0 || percent > 100) continue;
    const std::size_t left = line.find(" left", at);
    return Advance{percent / 100, left == std::string::npos ? std::nan("") : seconds_in(line.substr(at + 4, left - at - 4))};
  }
  return std::nullopt;
}

}  // namespace

std::string identity_of(const fs::path& run)
{
  std::string words;
  for (const char* name : {"resolved.toml", "origin.json", "summary.json"}) {
    struct stat about {};
    if (::lstat((run / name).c_str(), &about) == 0)
      words += fmt::format("{}.{}.{} ", about.st_ino, about.st_mtim.tv_sec, about.st_mtim.tv_nsec);
  }
  return words;
}

std::string identity_with_log(const fs::path& run)
{
  std::error_code none;
  const auto size = fs::file_size(run / "run.log", none);
  return identity_of(run) + (none ? "" : fmt::format("{}", size));
}

std::string tail_of(const fs::path& file, std::size_t bytes)
{
  const Opened opened(file);
  const bool cut = opened.size() > bytes;
  const std::string text = opened.read(cut ? opened.size() - bytes : 0, bytes);
  return cut ? text.substr(std::min(text.find('\n'), text.size() - 1) + 1) : text;
}

std::optional<Advance> advance_in(const std::string& log_tail)
{
  std::optional<Advance> last;
  std::istringstream lines(log_tail);
  for (std::string line; std::getline(lines, line);)
    if (const auto found = advance_of(line)) last = found;
  return last;
}

Json Live::rows(const fs::path& run, std::size_t from_row)
{
  const Opened history(run / "history.csv");
  Place place{0, 0, identity_of(run)};
  Json answer = {{"of", place.of}, {"columns", Json::array()}, {"from_row", from_row}, {"rows", Json::array()}, {"more", false}};
  const fs::path schema = folder_.real(run / "history.schema.json");
  if (history.size() == 0 || !fs::exists(schema)) return answer;
  answer["columns"] = run_folder::read_json(schema, 10'000'000).value("columns", Json::array());
  Json& rows = answer["rows"];
  {
    const std::lock_guard lock(mutex_);
    const auto known = places_.find(run.string());
    if (known != places_.end() && known->second.of == place.of && known->second.row <= from_row && known->second.offset <= history.size())
      place = known->second;
  }
  bool header = place.offset == 0;
  // Rows before the one asked for are passed over once: the next request begins at their end.
  for (std::size_t taken = 1; taken > 0 && rows.size() < most_rows; place.offset += taken) {
    const std::string text = history.read(place.offset, most_bytes_at_once);
    taken = 0;
    for (std::vector<std::string> fields; rows.size() < most_rows && run_folder::next_csv_line(text, taken, fields); header = false) {
      if (header) continue;
      if (place.row++ >= from_row) rows.push_back(row_of(fields));
    }
  }
  answer["more"] = rows.size() >= most_rows && place.offset < history.size();
  const std::lock_guard lock(mutex_);
  if (places_.size() >= most_places) places_.clear();
  places_[run.string()] = place;
  return answer;
}

}  // namespace berm::desk
