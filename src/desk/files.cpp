// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/desk/desk_test.cpp
#include "desk/files.hpp"

#include "desk/desk_files.hpp"
#include "io/atomic_file.hpp"

#include <algorithm>
#include <cctype>
#include <fmt/format.h>

namespace berm::desk {
namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t most_bytes = 256 << 20;
constexpr std::size_t most_shown = 100;

struct FileType {
  const char *ending, *type;
};

constexpr FileType file_types[] = {{".html", "text/html; charset=utf-8"},
                                   {".pdf", "application/pdf"},
                                   {".png", "image/png"},
                                   {".svg", "image/svg+xml"},
                                   {".csv", "text/csv; charset=utf-8"},
                                   {".json", "application/json"},
                                   {".txt", "text/plain; charset=utf-8"},
                                   {".log", "text/plain; charset=utf-8"},
                                   {".toml", "text/plain; charset=utf-8"},
                                   {".md", "text/plain; charset=utf-8"},
                                   {".yml", "text/plain; charset=utf-8"},
                                   {".inp", "text/plain; charset=utf-8"},
                                   {".tcl", "text/plain; charset=utf-8"},
                                   {".py", "text/plain; charset=utf-8"},
                                   {".xlsx", "application/octet-stream"},
                                   {".fmu", "application/octet-stream"},
                                   {".vtu", "application/octet-stream"},
                                   {".zip", "application/octet-stream"}};

/// How often a word of HTML, whose letters may be small or not, stands in a page.
std::ptrdiff_t count_of(std::string_view word, std::string_view page)
{
  const auto same = [](char a, char b) { return std::tolower(static_cast<unsigned char>(a)) == b; };
  std::ptrdiff_t count = 0;
  for (auto at = page.begin(); (at = std::search(at, page.end(), word.begin(), word.end(), same)) != page.end(); ++at) ++count;
  return count;
}

/// Whether a page says that it runs the script of this program's reports only, and has nothing that goes elsewhere by itself where scripts are allowed, as a refresh does.
bool is_report(std::string_view page)
{
  constexpr std::size_t longest_begin = 2000;
  return page.substr(0, longest_begin).find(fmt::format("script-src {};", report_script_source)) != std::string_view::npos &&
         count_of("http-equiv", page) == 1 && count_of("<link", page) == 0;
}

/// Of a page in an origin of its own. Scripts run where they are those of reports: another has none, and nothing in it goes anywhere by itself.
std::string policy_of(std::string_view page)
{
  const std::string scripts =
      is_report(page) ? fmt::format("sandbox allow-scripts allow-downloads; script-src {}", report_script_source) : "sandbox";
  return scripts + "; default-src 'none'; style-src 'unsafe-inline'; img-src data: blob:; font-src data:; webrtc 'block'; base-uri 'none'; "
                   "form-action 'none'";
}

}  // namespace

Answer file_answer(const fs::path& file)
{
  const auto type =
      std::find_if(std::begin(file_types), std::end(file_types), [&](const FileType& one) { return file.extension() == one.ending; });
  if (type == std::end(file_types)) throw Refusal(403, fmt::format("files like {} are not served", file.filename().string()));
  if (!fs::is_regular_file(file)) throw Refusal(404, fmt::format("there is no {}", file.filename().string()));
  if (fs::file_size(file) > most_bytes) throw Refusal(413, fmt::format("{} is too large to be shown", file.filename().string()));
  return {.body = io::read_text_file(file, most_bytes), .type = type->type};
}

ShownFiles::Shown ShownFiles::add(const std::string& name)
{
  const std::string page = file_answer(folder_.inside(name)).body;
  const std::lock_guard lock(mutex_);
  names_.emplace_back("/shown/" + random_word(16), name);
  if (names_.size() > most_shown) names_.pop_front();
  return {names_.back().first, !is_report(page) && page.find("<script") != std::string::npos};
}

Answer ShownFiles::answer(const std::string& address) const
{
  std::string name;
  {
    const std::lock_guard lock(mutex_);
    const auto found = std::find_if(names_.begin(), names_.end(), [&](const auto& one) { return one.first == address; });
    if (found == names_.end()) throw Refusal(404, "there is no such address");
    name = found->second;
  }
  Answer answer = file_answer(folder_.inside(name));
  answer.policy = policy_of(answer.body);
  return answer;
}

}  // namespace berm::desk
