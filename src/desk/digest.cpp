// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/desk/desk_runs_test.cpp
#include "desk/digest.hpp"

#include "desk/live.hpp"
#include "io/atomic_file.hpp"
#include "run_folder/json_file.hpp"

#include <fmt/format.h>

namespace berm::desk {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t longest_notes = 10000;
constexpr const char* notes_file = "notes.txt";

}  // namespace

Json digest_of(const Folder& folder, const fs::path& run)
{
  Json digest = Json::object();
  try {
    if (!fs::exists(run / "summary.json")) return digest;
    const Json summary = run_folder::read_json(folder.real(run / "summary.json"), 10'000'000);
    const Json text = summary.value("text", Json::object()), quantities = summary.value("quantities", Json::object());
    for (const char* key : {"title", "date"})
      if (text.contains(key)) digest[key] = text[key];
    std::string name = text.value("key_number", "");
    for (const auto& [one, quantity] : quantities.items())
      if (name.empty() && quantity.value("kind", "") == "answer") name = one;
    if (quantities.contains(name))
      digest["answer"] = {{"name", name}, {"value", quantities.at(name).at("value")}, {"unit", quantities.at(name).at("unit")}};
  } catch (const std::exception&) {  // its page says what is wrong with the file
  }
  return digest;
}

std::uintmax_t bytes_in(const fs::path& folder)
{
  std::uintmax_t bytes = 0;
  std::error_code none;
  for (auto entry = fs::recursive_directory_iterator(folder, fs::directory_options::skip_permission_denied, none);
       !none && entry != fs::end(entry); entry.increment(none)) {
    std::error_code gone;
    if (const auto size = entry->is_symlink(gone) ? 0 : entry->file_size(gone); !gone) bytes += size;
  }
  return bytes;
}

std::string notes_of(const Folder& folder, const fs::path& run)
{
  return tail_of(folder.real(run / notes_file), longest_notes);
}

void write_notes(const Folder& folder, const fs::path& run, const std::string& text)
{
  if (text.size() > longest_notes) throw Refusal(413, fmt::format("notes have at most {} characters", longest_notes));
  const fs::path file = run / notes_file;
  if (fs::is_symlink(fs::symlink_status(file))) throw Refusal(403, fmt::format("{} is a link", folder.name_of(file)));
  if (text.empty())
    fs::remove(file);
  else
    io::write_atomically(file, text);
}

}  // namespace berm::desk
