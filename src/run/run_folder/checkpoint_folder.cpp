// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/simulation/checkpoints_test.cpp
#include "run_folder/checkpoint_folder.hpp"

#include "io/atomic_file.hpp"

#include <charconv>
#include <fmt/format.h>
#include <memory>

namespace berm::run_folder {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view begin_of_name = "step_", end_of_name = ".h5";

/// The step in the name of a checkpoint; empty for other names.
std::optional<BigIndex> step_of(const fs::path& path)
{
  const std::string name = path.filename().string();
  if (!name.starts_with(begin_of_name) || !name.ends_with(end_of_name)) return std::nullopt;
  const char *first = name.data() + begin_of_name.size(), *last = name.data() + name.size() - end_of_name.size();
  BigIndex step = 0;
  const auto [end, error] = std::from_chars(first, std::max(first, last), step);
  return error == std::errc() && end == last ? std::optional(step) : std::nullopt;
}

}  // namespace

std::vector<fs::path> CheckpointFolder::files() const
{
  std::vector<fs::path> found;
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(path_, error))
    if (step_of(entry.path())) found.push_back(entry.path());
  std::sort(found.begin(), found.end(), [](const fs::path& a, const fs::path& b) { return step_of(a) > step_of(b); });
  return found;
}

fs::path CheckpointFolder::read(const Contents& contents, const std::function<void(const fs::path&, const std::string&)>& refused)
{
  const std::vector<fs::path> all = files();
  for (const fs::path& file : all) {
    try {
      read_checkpoint(file, contents);
      return last_ = file;
    } catch (const RunError& error) {
      refused(file, error.what());
    }
  }
  if (!all.empty()) throw RunError(fmt::format("none of the checkpoints in {} can be used", path_.string()));
  return {};
}

std::function<void()> CheckpointFolder::begin(BigIndex step, const Contents& contents)
{
  io::make_inner_folder(path_.parent_path(), path_.filename());
  const fs::path file = path_ / fmt::format("{}{}{}", begin_of_name, step, end_of_name);
  begin_checkpoint(file, contents);
  // Its temporary file goes with what was to finish it: where a file before it cannot be written, nobody does.
  const std::shared_ptr<const fs::path> part(new fs::path(io::part_of(file)), [](const fs::path* path) {
    std::error_code ignored;
    fs::remove(*path, ignored);
    delete path;
  });
  return [this, file, part] {
    finish_checkpoint(file);
    std::error_code error;
    for (const fs::path& other : files())
      if (other != file && other != last_) fs::remove(other, error);
    last_ = file;
  };
}

void CheckpointFolder::remove() const
{
  std::error_code ignored;  // a leftover file does no harm
  fs::remove_all(path_, ignored);
}

}  // namespace berm::run_folder
