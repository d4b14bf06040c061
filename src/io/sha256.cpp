// SPDX-License-Identifier: BSD-3-Clause
#include "io/sha256.hpp"

#include "core/error.hpp"

#include <array>
#include <fmt/format.h>
#include <fstream>
#include <link.h>
#include <memory>
#include <openssl/evp.h>

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

std::vector<fs::path> program_files(const std::string& name)
{
  struct Search {
    const std::string& begin;
    std::vector<fs::path> found;
  } search{name, {}};
  std::error_code ignored;
  search.found.push_back(fs::read_symlink("/proc/self/exe", ignored));
  dl_iterate_phdr(
      [](dl_phdr_info* info, std::size_t, void* data) {
        auto& to = *static_cast<Search*>(data);
        if (const fs::path path = info->dlpi_name; path.filename().string().starts_with(to.begin)) to.found.push_back(path);
        return 0;
      },
      &search);
  std::erase(search.found, fs::path());
  return search.found;
}

}  // namespace berm::io
