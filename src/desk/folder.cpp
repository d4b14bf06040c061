// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/desk/desk_guards_test.cpp
#include "desk/folder.hpp"

#include "desk/http.hpp"
#include "io/atomic_file.hpp"
#include "io/sha256.hpp"
#include "os/control_characters.hpp"
#include "os/error.hpp"

#include <algorithm>
#include <chrono>
#include <fmt/format.h>
#include <mutex>
#include <sstream>
#include <unistd.h>

namespace berm::desk {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t longest_name = 1000;
constexpr int deepest_folder = 8;
constexpr std::size_t most_entries = 20000;  // of a folder, or of all that are looked at for runs

bool is_run(const fs::path& folder)
{
  std::error_code none;
  return fs::is_regular_file(folder / "resolved.toml", none);
}

bool is_hidden(const fs::path& path)
{
  return path.filename().string().starts_with('.');
}

/// Seconds since 1970.
double time_of(const fs::path& path)
{
  std::error_code none;
  const auto time = std::chrono::file_clock::to_sys(fs::last_write_time(path, none));
  return none ? 0 : std::chrono::duration<double>(time.time_since_epoch()).count();
}

/// What an input is by its first tables, without reading it as one: a study has cases, an input of element tests has tests, one of a fit measured ones, one of contours a storm, expected.toml has runs. Its title where it says one in a line.
struct Glance {
  std::string title;
  bool study = false, tests = false, other = false;
};

Glance glance_at(const fs::path& file)
{
  Glance seen;
  std::istringstream lines(io::read_text_file(file, most_bytes_of_body));
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("[[case]]")) seen.study = true;
    if (line.starts_with("[[test]]") || line.starts_with("[[measured]]") || line.starts_with("[storm]")) seen.tests = true;
    if (line.starts_with("[run.")) seen.other = true;
    if (!seen.title.empty() || !line.starts_with("title")) continue;
    const auto begin = line.find('"'), end = line.rfind('"');
    if (begin < end && end != std::string::npos) seen.title = line.substr(begin + 1, end - begin - 1);
  }
  return seen;
}

bool is_utf8(const std::string& text)
{
  try {
    (void)Json(text).dump();
    return true;
  } catch (const Json::exception&) {
    return false;
  }
}

/// Such a text would come to the page, and back from it, with other bytes.
void refuse_other_than_utf8(const std::string& text, const std::string& name)
{
  if (is_utf8(text)) return;
  std::istringstream lines(text);
  int number = 1;
  for (std::string line; std::getline(lines, line) && is_utf8(line);) ++number;
  throw Refusal(
      422, fmt::format("{0} is not in UTF-8: line {1} has other bytes, as of Latin-1. Save it as UTF-8 (iconv -f LATIN1 -t UTF-8 {0}), "
                       "then open it again",
                       name, number));
}

/// Whether nobody may write to a file, or this user may not; whoever may replace it does not ask the system for that.
bool is_protected(const fs::path& file)
{
  const fs::perms any_write = fs::perms::owner_write | fs::perms::group_write | fs::perms::others_write;
  return (fs::status(file).permissions() & any_write) == fs::perms::none || ::access(file.c_str(), W_OK) != 0;
}

void check_name(const std::string& name)
{
  const auto refuse = [&](const char* why) { throw Refusal(403, fmt::format("the path {} {}", one_line(name), why)); };
  if (name.size() > longest_name) throw Refusal(403, "the path is too long");
  if (has_control_character(name)) refuse("has control characters");
  if (!is_utf8(name)) throw Refusal(403, "the path is not UTF-8");
  if (name.starts_with('/')) refuse("is not relative to the folder");
  for (const fs::path& part : fs::path(name)) {
    if (part == "..") refuse("has ..");
    if (part.string().starts_with('.')) refuse("is hidden");
    if (part.string().starts_with('-')) refuse("could be an option");
    if (part.string().size() > 200) refuse("has a name that is too long");
  }
}

}  // namespace

Folder::Folder(const fs::path& root)
{
  std::error_code none;
  root_ = fs::canonical(root, none);
  if (none || !fs::is_directory(root_)) throw InputError(fmt::format("{} is not a folder", root.string()));
}

fs::path Folder::inside(const std::string& name) const
{
  check_name(name);
  return real(root_ / name);
}

fs::path Folder::real(const fs::path& path) const
{
  fs::path real = root_;
  for (const fs::path& part : path.lexically_relative(root_)) {
    if (part.empty() || part == ".") continue;
    if (part == "..") throw Refusal(403, "the path leads out of the folder");
    std::error_code none;
    const fs::path next = real / part;
    const bool link = fs::is_symlink(fs::symlink_status(next, none));
    real = link ? fs::canonical(next, none) : next;
    const auto [end, rest] = std::mismatch(root_.begin(), root_.end(), real.begin(), real.end());
    if ((link && none) || end != root_.end())
      throw Refusal(403, fmt::format("the link {} leads out of the folder", one_line(name_of(next))));
  }
  return real;
}

void Folder::refuse_links_out(const fs::path& inner) const
{
  std::error_code none;
  for (auto entry = fs::recursive_directory_iterator(inner, fs::directory_options::skip_permission_denied, none);
       !none && entry != fs::end(entry); entry.increment(none))
    if (entry->is_symlink()) real(entry->path());
}

fs::path Folder::input(const std::string& name) const
{
  const fs::path path = inside(name);
  if (path.extension() != ".toml") throw Refusal(403, fmt::format("{} is not a .toml file", name));
  return path;
}

fs::path Folder::run(const std::string& name) const
{
  const fs::path path = inside(name);
  if (!is_run(path)) throw Refusal(404, fmt::format("{} holds no run", name));
  return path;
}

std::string Folder::name_of(const fs::path& path) const
{
  const std::string name = path.lexically_relative(root_).generic_string();
  return name == "." ? "" : name;
}

Json Folder::contents(const std::string& name) const
{
  const fs::path folder = inside(name);
  if (!fs::is_directory(folder)) throw Refusal(404, fmt::format("{} is not a folder", name));
  Json cases = Json::array(), studies = Json::array(), tests = Json::array(), runs = Json::array(), folders = Json::array();
  std::vector<fs::path> entries;
  for (const auto& entry : fs::directory_iterator(folder, fs::directory_options::skip_permission_denied))
    if (!is_hidden(entry.path()) && entries.size() < most_entries) entries.push_back(entry.path());
  std::sort(entries.begin(), entries.end());
  for (const fs::path& path : entries) {
    std::error_code none;
    const fs::file_status status = fs::symlink_status(path, none);
    if (fs::is_directory(status)) {
      (is_run(path) ? runs : folders).push_back(name_of(path));
    } else if (fs::is_regular_file(status) && path.extension() == ".toml" && fs::file_size(path, none) <= most_bytes_of_body) {
      const Glance seen = glance_at(path);
      if (!seen.other)
        (seen.study   ? studies
         : seen.tests ? tests
                      : cases)
            .push_back({{"path", name_of(path)}, {"title", seen.title}, {"modified", time_of(path)}});
    }
  }
  return {{"path", name_of(folder)}, {"cases", cases}, {"studies", studies}, {"tests", tests}, {"runs", runs}, {"folders", folders}};
}

std::vector<fs::path> Folder::runs() const
{
  std::vector<fs::path> found;
  std::error_code none;
  std::size_t seen = 0;
  auto entry = fs::recursive_directory_iterator(root_, fs::directory_options::skip_permission_denied, none);
  for (; !none && entry != fs::end(entry) && seen < most_entries; entry.increment(none)) {
    if (!fs::is_directory(entry->symlink_status(none))) continue;
    ++seen;
    const bool run = is_run(entry->path());
    if (run) found.push_back(entry->path());
    if (run || is_hidden(entry->path()) || entry.depth() >= deepest_folder) entry.disable_recursion_pending();
  }
  return found;
}

Json Folder::read(const std::string& name) const
{
  const fs::path file = input(name);
  if (!fs::is_regular_file(file)) throw Refusal(404, fmt::format("there is no {}", name));
  const std::string text = io::read_text_file(file, most_bytes_of_body);
  refuse_other_than_utf8(text, name);
  return {{"text", text}, {"modified", io::sha256_of(text)}};
}

Json Folder::write(const std::string& name, const Json& body) const
{
  static std::mutex one_at_a_time;
  const std::lock_guard lock(one_at_a_time);
  const fs::path file = input(name);
  const std::string text = text_in(body, "text"), mark = text_in(body, "modified", "");
  const bool there = fs::exists(fs::symlink_status(file));
  if (there && !fs::is_regular_file(file)) throw Refusal(403, fmt::format("{} is not a file", name));
  if (there ? mark != io::sha256_of(io::read_text_file(file, most_bytes_of_body)) : !mark.empty())
    throw Refusal(409, name + (mark.empty() ? " already exists" : " was changed by another program"));
  if (there && is_protected(file)) throw Refusal(403, fmt::format("{} is write-protected", name));
  io::make_folder(file.parent_path());
  io::write_atomically(file, text);
  return {{"modified", io::sha256_of(text)}};
}

std::string text_in(const Json& body, const char* key)
{
  const auto found = body.find(key);
  if (found == body.end() || !found->is_string()) throw Refusal(400, fmt::format("the request has no text \"{}\"", key), {{"key", key}});
  return found->get<std::string>();
}

std::string text_in(const Json& body, const char* key, const std::string& otherwise)
{
  return body.contains(key) && !body[key].is_null() ? text_in(body, key) : otherwise;
}

std::vector<std::string> texts_in(const Json& body, const char* key)
{
  std::vector<std::string> texts;
  const auto found = body.find(key);
  if (found == body.end() || found->is_null()) return texts;
  const bool right = found->is_array() && found->size() <= 1000 &&
                     std::all_of(found->begin(), found->end(), [](const Json& item) { return item.is_string(); });
  if (!right) throw Refusal(400, fmt::format("\"{}\" is not a list of texts", key), {{"key", key}});
  for (const Json& item : *found) texts.push_back(item.get<std::string>());
  return texts;
}

}  // namespace berm::desk
