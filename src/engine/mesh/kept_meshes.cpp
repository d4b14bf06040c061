// SPDX-License-Identifier: BSD-3-Clause
#include "mesh/kept_meshes.hpp"

#include "os/interrupt.hpp"
#include "os/read_file.hpp"

#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <thread>
#include <unistd.h>

namespace berm::mesh {
namespace {

namespace fs = std::filesystem;

constexpr const char* variable = "BERM_KEPT_MESHES";

std::string bytes_of(const fs::path& file)
{
  constexpr std::uintmax_t most = 100'000'000;
  return read_file(file, most).bytes;
}

/// Held by one process at a time; given back by whatever ends it.
class Turn {
public:
  explicit Turn(const fs::path& file) : file_(::open(file.c_str(), O_RDWR | O_CREAT | O_NOFOLLOW | O_CLOEXEC, 0600))
  {
    while (file_ >= 0 && ::flock(file_, LOCK_EX | LOCK_NB) != 0 && (errno == EWOULDBLOCK || errno == EINTR)) {
      stop_if_asked("another run makes the mesh");
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
  }
  ~Turn()
  {
    if (file_ >= 0) ::close(file_);
  }
  Turn(const Turn&) = delete;
  Turn& operator=(const Turn&) = delete;

private:
  int file_;
};

fs::path log_beside(const fs::path& msh)
{
  return fs::path(msh).replace_extension(".log");
}

/// All or nothing: the geometry, by which the others are found, comes last.
void keep(const fs::path& geo, const fs::path& msh, const fs::path& kept)
{
  const auto copy = [](const fs::path& from, const fs::path& to) {
    fs::copy_file(from, to.string() + ".part", fs::copy_options::overwrite_existing);
    fs::rename(to.string() + ".part", to);
  };
  copy(msh, kept.string() + ".msh");
  copy(log_beside(msh), kept.string() + ".log");
  copy(geo, kept.string() + ".geo");
}

}  // namespace

KeptMeshes::KeptMeshes(const fs::path& folder)
    : outermost_(::setenv(variable, fs::absolute(folder).c_str(), 0) == 0 && std::getenv(variable) == fs::absolute(folder))
{
}

KeptMeshes::~KeptMeshes()
{
  if (outermost_) ::unsetenv(variable);
}

void kept_or_made(const fs::path& geo, const fs::path& msh, int dim, const std::function<void()>& make)
{
  const char* const folder = std::getenv(variable);
  if (folder == nullptr) return make();
  const std::string geometry = bytes_of(geo);
  const fs::path kept = fs::path(folder) / fmt::format("{:016x}-{}", std::hash<std::string>()(geometry), dim);
  const Turn turn(kept.string() + ".lock");
  try {
    if (bytes_of(kept.string() + ".geo") == geometry) {
      fs::copy_file(kept.string() + ".log", log_beside(msh), fs::copy_options::overwrite_existing);
      fs::copy_file(kept.string() + ".msh", msh, fs::copy_options::overwrite_existing);
      return;
    }
  } catch (const fs::filesystem_error&) {  // it is made again
  }
  make();
  try {
    keep(geo, msh, kept);
  } catch (const fs::filesystem_error&) {
    std::error_code ignored;
    fs::remove(kept.string() + ".geo", ignored);
  }
}

}  // namespace berm::mesh
