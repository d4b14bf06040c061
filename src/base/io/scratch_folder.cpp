// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/commands/run_faults_test.cpp
#include "io/scratch_folder.hpp"

#include "io/atomic_file.hpp"
#include "os/error.hpp"

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <new>
#include <string>
#include <system_error>
#include <unistd.h>
#include <utility>

namespace berm::io {
namespace fs = std::filesystem;

namespace {

/// Where the system's temporary files go.
fs::path system_folder()
{
  std::error_code error;
  const fs::path folder = fs::temp_directory_path(error);
  if (!error) return folder;
  for (const char* variable : {"TMPDIR", "TMP", "TEMP", "TEMPDIR"})  // in the order of temp_directory_path
    if (const char* const named = std::getenv(variable))
      throw RunError(std::string(variable) + " names " + named + " for temporary files, which is not a folder: " + error.message());
  throw RunError("there is no folder /tmp for temporary files: " + error.message());
}

}  // namespace

ScratchFolder::ScratchFolder()
{
  const char* const outer = std::getenv(outer_variable);
  std::string name = ((outer != nullptr ? fs::path(outer) : system_folder()) / "berm-XXXXXX").string();
  if (mkdtemp(name.data()) == nullptr) throw RunError("no temporary folder " + name + " can be made: " + std::strerror(errno));
  path_ = name;
  if (outer != nullptr) return;
  try {
    start_guard();
  } catch (...) {
    remove();
    throw;
  }
}

/// The shell reads until the other end of the pipe is closed, which the system does whatever ends this program.
void ScratchFolder::start_guard()
{
  int pipe[2];
  if (::pipe2(pipe, O_CLOEXEC) != 0) throw_errno("no temporary folder can be made");
  held_ = pipe[1];
  const int nowhere = ::open("/dev/null", O_WRONLY | O_CLOEXEC);
  const auto leave = [&] {
    ::close(pipe[0]);
    if (nowhere >= 0) ::close(nowhere);
  };
  try {
    guard_.emplace(ChildStart{.words = {"/bin/sh", "-c", "trap '' HUP INT TERM; read -r nothing; rm -rf -- \"$0\"", path_.string()},
                              .out = nowhere,
                              .in = pipe[0],
                              .outlives = true});
  } catch (const std::system_error& error) {
    leave();
    throw RunError(std::string("no temporary folder can be made: /bin/sh does not start: ") + error.code().message());
  }
  leave();
}

ScratchFolder::~ScratchFolder()
{
  remove();
}

void ScratchFolder::remove()
{
  try {
    std::error_code ignored;  // a temporary folder left behind is no reason to fail
    fs::remove_all(path_, ignored);
  } catch (const std::bad_alloc&) {
    if (held_ >= 0) ::close(std::exchange(held_, -1));
    if (guard_) guard_->wait();  // it does it
  }
  guard_.reset();
  if (held_ >= 0) ::close(held_);
}

void ScratchFolder::move_files_to(const fs::path& folder) const
{
  try {
    for (const fs::directory_entry& entry : fs::directory_iterator(path_)) {
      copy_atomically(entry.path(), folder / entry.path().filename());
      fs::remove(entry.path());
    }
  } catch (const fs::filesystem_error& error) {
    throw RunError(std::string("files cannot be moved out of the temporary folder: ") + error.what());
  }
}

}  // namespace berm::io
