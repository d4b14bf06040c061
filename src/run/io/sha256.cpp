// SPDX-License-Identifier: BSD-3-Clause
#include "io/sha256.hpp"

#include "core/error.hpp"

#include <array>
#include <fmt/format.h>
#include <fstream>
#include <link.h>
#include <memory>
#include <openssl/evp.h>
#include <string_view>

namespace berm::io {

namespace fs = std::filesystem;

std::string sha256_of_file(const fs::path& file)
{
  std::ifstream stream(file, std::ios::binary);
  const std::unique_ptr<EVP_MD_CTX, decltype(&EVP_MD_CTX_free)> digest(EVP_MD_CTX_new(), &EVP_MD_CTX_free);
  bool good = stream.good() && digest != nullptr && EVP_DigestInit_ex(digest.get(), EVP_sha256(), nullptr) == 1;
  std::vector<char> part(1 << 18);
  while (good && stream) {
    stream.read(part.data(), static_cast<std::streamsize>(part.size()));
    good = !stream.bad() && EVP_DigestUpdate(digest.get(), part.data(), static_cast<std::size_t>(stream.gcount())) == 1;
  }
  std::array<unsigned char, EVP_MAX_MD_SIZE> bytes{};
  unsigned count = 0;
  if (!good || EVP_DigestFinal_ex(digest.get(), bytes.data(), &count) != 1)
    throw RunError(fmt::format("{}: cannot be read for its SHA-256", file.string()));
  std::string hex;
  for (unsigned k = 0; k < count; ++k) hex += fmt::format("{:02x}", bytes[k]);
  return hex;
}

std::vector<ProgramFile> program_files(const std::string& name)
{
  constexpr std::string_view deleted = " (deleted)";  // what Linux appends to the name of a file that is removed or replaced
  struct Search {
    const std::string& begin;
    std::vector<ProgramFile> found;
  } search{name, {}};
  std::error_code ignored;
  std::string program = fs::read_symlink("/proc/self/exe", ignored).filename().string();
  if (program.ends_with(deleted)) program.resize(program.size() - deleted.size());
  search.found.push_back({program, "/proc/self/exe"});
  dl_iterate_phdr(
      [](dl_phdr_info* info, std::size_t, void* data) {
        auto& to = *static_cast<Search*>(data);
        const fs::path path = info->dlpi_name;
        if (const std::string file = path.filename().string(); !file.empty() && file.starts_with(to.begin))
          to.found.push_back({file, path});
        return 0;
      },
      &search);
  std::ifstream maps("/proc/self/maps");
  for (std::string line; std::getline(maps, line);)
    for (std::size_t k = 1; k < search.found.size(); ++k)
      if (line.ends_with(fmt::format("/{}{}", search.found[k].name, deleted))) search.found[k].path.clear();
  return search.found;
}

}  // namespace berm::io
