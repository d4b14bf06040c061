// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/desk/desk_test.cpp
#include "desk/files.hpp"

#include "io/atomic_file.hpp"

#include <algorithm>
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

std::string ShownFiles::add(const std::string& name)
{
  const fs::path file = folder_.inside(name);
  if (!fs::is_regular_file(file)) throw Refusal(404, fmt::format("there is no {}", name));
  const std::lock_guard lock(mutex_);
  names_.emplace_back("/shown/" + random_word(16), name);
  if (names_.size() > most_shown) names_.pop_front();
  return names_.back().first;
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
  answer.policy = "sandbox allow-scripts allow-downloads; default-src 'none'; script-src 'unsafe-inline' blob:; style-src 'unsafe-inline'; "
                  "img-src data: blob:; font-src data:; worker-src blob:";
  return answer;
}

}  // namespace berm::desk
