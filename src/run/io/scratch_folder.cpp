// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/commands/run_faults_test.cpp
#include "io/scratch_folder.hpp"

#include "core/error.hpp"
#include "io/atomic_file.hpp"

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <string>

namespace berm::io {
namespace fs = std::filesystem;

ScratchFolder::ScratchFolder()
{
  std::string name = (fs::temp_directory_path() / "berm-XXXXXX").string();
  if (mkdtemp(name.data()) == nullptr) throw RunError("no temporary folder " + name + " can be made: " + std::strerror(errno));
  path_ = name;
}

ScratchFolder::~ScratchFolder()
{
  std::error_code ignored;  // a temporary folder left behind is no reason to fail
  fs::remove_all(path_, ignored);
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
