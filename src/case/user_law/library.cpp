// SPDX-License-Identifier: BSD-3-Clause
#include "user_law/library.hpp"

#include "io/atomic_file.hpp"
#include "io/sha256.hpp"
#include "os/case_programs.hpp"
#include "os/error.hpp"
#include "os/read_file.hpp"
#include "os/text_of_list.hpp"
#include "user_law/crash_guard.hpp"

#include <algorithm>
#include <cerrno>
#include <cfenv>
#include <cstring>
#include <dlfcn.h>
#include <elf.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <map>
#include <memory>
#include <optional>
#include <sys/mman.h>
#include <unistd.h>

namespace berm::user_law {
namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t max_bytes = 1'000'000'000;

/// Bytes as a file that has no name and does not change any more.
class SealedFile {
public:
  SealedFile(const std::string& name, const std::string& bytes) : file_(::memfd_create("berm-law", MFD_CLOEXEC | MFD_ALLOW_SEALING))
  {
    if (file_ < 0 || !io::write_all(file_, bytes) ||
        ::fcntl(file_, F_ADD_SEALS, F_SEAL_SEAL | F_SEAL_SHRINK | F_SEAL_GROW | F_SEAL_WRITE) != 0) {
      const int reason = errno;
      if (file_ >= 0) ::close(file_);
      throw RunError(fmt::format("{} cannot be copied into memory: {}", name, std::strerror(reason)));
    }
  }
  ~SealedFile() { ::close(file_); }
  SealedFile(const SealedFile&) = delete;
  SealedFile& operator=(const SealedFile&) = delete;

  std::string path() const { return fmt::format("/proc/self/fd/{}", file_); }

private:
  int file_;
};

/// What the loader says, of the file that the user knows.
std::string reason_of_loader(const std::string& path, const fs::path& file)
{
  std::string reason = ::dlerror();
  if (const std::size_t at = reason.find(path); at != std::string::npos) reason.replace(at, path.size(), file.string());
  return reason;
}

/// The object of a type at a place in the bytes of a file; empty beyond their end.
template <class T>
std::optional<T> object_at(const std::string& bytes, std::uint64_t place)
{
  if (place > bytes.size() || bytes.size() - place < sizeof(T)) return {};
  T object;
  std::memcpy(&object, bytes.data() + place, sizeof(T));
  return object;
}

std::string text_at(const std::string& bytes, std::uint64_t place)
{
  if (place >= bytes.size()) return "";
  const auto begin = bytes.begin() + static_cast<std::ptrdiff_t>(place);
  return {begin, std::find(begin, bytes.end(), '\0')};
}

}  // namespace

Library open_library(const fs::path& file, const std::string& wanted_sha256)
{
  std::error_code error;
  if (!fs::exists(file, error)) {
    const fs::path folder = file.parent_path();
    const bool made = fs::exists(folder / "Makefile", error) || fs::exists(folder / "makefile", error);
    throw InputError(
        fmt::format("there is no {}; build it first{}", file.string(), made ? fmt::format(": make -C {}", folder.string()) : ""));
  }
  const FileBytes read = read_file(file, max_bytes);
  if (!read.fault.empty()) throw InputError(fmt::format("{}: {}", file.string(), read.fault));
  const std::string hash = io::sha256_of(read.bytes);
  if (!wanted_sha256.empty() && wanted_sha256 != hash)
    throw InputError(fmt::format("{} does not have the SHA-256 {}: it has {}", file.string(), wanted_sha256, hash));
  // A library is loaded once. Its file stays open: the loader knows it by that name, and would take another of the same name for it.
  struct Loaded {
    std::unique_ptr<const SealedFile> sealed;
    void* handle;
  };
  static std::map<std::string, Loaded> loaded;
  if (const auto earlier = loaded.find(hash); earlier != loaded.end()) return {earlier->second.handle, hash};
  ask_to_load(file.string());
  auto sealed = std::make_unique<const SealedFile>(file.filename().string(), read.bytes);
  // Code made with -ffast-math would have small numbers set to zero from its loading on, in all of the program.
  std::fenv_t rounding;
  std::fegetenv(&rounding);
  const std::string name = "loading " + file.string();
  std::optional<InsideCall> inside(name);
  void* const library = ::dlopen(sealed->path().c_str(), RTLD_NOW | RTLD_LOCAL);
  const std::string reason = library == nullptr ? reason_of_loader(sealed->path(), file) : "";
  inside.reset();
  std::fesetenv(&rounding);
  if (library == nullptr) throw InputError(fmt::format("the library does not load: {}", reason));
  loaded[hash] = {std::move(sealed), library};
  return {library, hash};
}

Symbol find_function(void* library, const fs::path& file, const std::vector<std::string>& names)
{
  for (const std::string& name : names)
    if (void* const address = ::dlsym(library, name.c_str())) return {address, name};
  std::vector<std::string> known = functions_in(file);
  constexpr std::size_t most = 12;
  if (known.size() > most) known.resize(most);
  throw InputError(fmt::format("{} has no function {}; it has {}", file.string(), text_of_list(names, " or "),
                               known.empty() ? "none" : text_of_list(known, ", ")));
}

std::vector<std::string> functions_in(const fs::path& file)
{
  const std::string bytes = read_file(file, max_bytes).bytes;
  std::vector<std::string> names;
  const auto header = object_at<Elf64_Ehdr>(bytes, 0);
  if (!header || std::memcmp(header->e_ident, ELFMAG, SELFMAG) != 0 || header->e_ident[EI_CLASS] != ELFCLASS64) return names;
  const auto section = [&](std::uint64_t k) { return object_at<Elf64_Shdr>(bytes, header->e_shoff + k * sizeof(Elf64_Shdr)); };
  for (std::uint64_t k = 0; k < header->e_shnum; ++k) {
    const auto symbols = section(k);
    if (!symbols || symbols->sh_type != SHT_DYNSYM) continue;
    const auto strings = section(symbols->sh_link);
    for (std::uint64_t at = 0; strings && at + sizeof(Elf64_Sym) <= symbols->sh_size; at += sizeof(Elf64_Sym)) {
      const auto symbol = object_at<Elf64_Sym>(bytes, symbols->sh_offset + at);
      if (!symbol) break;
      if (ELF64_ST_TYPE(symbol->st_info) != STT_FUNC || symbol->st_shndx == SHN_UNDEF) continue;
      names.push_back(text_at(bytes, strings->sh_offset + symbol->st_name));
    }
  }
  std::erase_if(names, [](const std::string& name) { return name == "_init" || name == "_fini"; });
  std::sort(names.begin(), names.end());
  return names;
}

}  // namespace berm::user_law
