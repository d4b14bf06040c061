// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/mesh/mesh_cache_test.cpp
#include "os/mesh_cache.hpp"

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

namespace berm {
namespace {

namespace fs = std::filesystem;

constexpr const char* variable = "BERM_MESH_CACHE";

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
      stop_if_asked("another run is making the mesh");
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
void cache(const fs::path& geo, const fs::path& msh, const fs::path& cached)
{
  const auto copy = [](const fs::path& from, const fs::path& to) {
    fs::copy_file(from, to.string() + ".part", fs::copy_options::overwrite_existing);
    fs::rename(to.string() + ".part", to);
  };
  copy(msh, cached.string() + ".msh");
  copy(log_beside(msh), cached.string() + ".log");
  copy(geo, cached.string() + ".geo");
}

}  // namespace

MeshCache::MeshCache(const fs::path& folder)
    : outermost_(::setenv(variable, fs::absolute(folder).c_str(), 0) == 0 && std::getenv(variable) == fs::absolute(folder))
{
}

MeshCache::~MeshCache()
{
  if (outermost_) ::unsetenv(variable);
}

void cached_or_generated(const fs::path& geo, const fs::path& msh, int dim, const std::function<void()>& generate)
{
  const char* const folder = std::getenv(variable);
  if (folder == nullptr) return generate();
  const std::string geometry = bytes_of(geo);
  const fs::path cached = fs::path(folder) / fmt::format("{:016x}-{}", std::hash<std::string>()(geometry), dim);
  const Turn turn(cached.string() + ".lock");
  try {
    if (bytes_of(cached.string() + ".geo") == geometry) {
      fs::copy_file(cached.string() + ".log", log_beside(msh), fs::copy_options::overwrite_existing);
      fs::copy_file(cached.string() + ".msh", msh, fs::copy_options::overwrite_existing);
      return;
    }
  } catch (const fs::filesystem_error&) {  // it is made again
  }
  generate();
  try {
    cache(geo, msh, cached);
  } catch (const fs::filesystem_error&) {
    std::error_code ignored;
    fs::remove(cached.string() + ".geo", ignored);
  }
}

}  // namespace berm
