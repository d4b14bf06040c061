// SPDX-License-Identifier: BSD-3-Clause
#include "user_law/library.hpp"

#include "core/error.hpp"
#include "core/read_file.hpp"
#include "user_law/crash_guard.hpp"

#include <algorithm>
#include <cfenv>
#include <cstring>
#include <dlfcn.h>
#include <elf.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <optional>
#include <unistd.h>

namespace berm::user_law {
namespace {

namespace fs = std::filesystem;

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

void* open_library(const fs::path& file)
{
  std::error_code error;
  if (!fs::exists(file, error)) {
    const fs::path folder = file.parent_path();
    const bool made = fs::exists(folder / "Makefile", error) || fs::exists(folder / "makefile", error);
    throw InputError(
        fmt::format("there is no {}; build it first{}", file.string(), made ? fmt::format(": make -C {}", folder.string()) : ""));
  }
  std::string fault;
  const int readable = open_to_read(file, fault);
  if (readable < 0) throw InputError(fmt::format("{}: {}", file.string(), fault));
  ::close(readable);
  // Code made with -ffast-math would have small numbers set to zero from its loading on, in all of the program.
  std::fenv_t rounding;
  std::fegetenv(&rounding);
  const std::string name = "loading " + file.string();
  std::optional<InsideCall> inside(name);
  void* const library = ::dlopen(fs::absolute(file).c_str(), RTLD_NOW | RTLD_LOCAL);
  const char* const reason = library == nullptr ? ::dlerror() : nullptr;
  inside.reset();
  std::fesetenv(&rounding);
  if (library == nullptr) throw InputError(fmt::format("the library does not load: {}", reason));
  return library;
}

Symbol find_function(void* library, const fs::path& file, const std::vector<std::string>& names)
{
  for (const std::string& name : names)
    if (void* const address = ::dlsym(library, name.c_str())) return {address, name};
  std::vector<std::string> known = functions_in(file);
  constexpr std::size_t most = 12;
  if (known.size() > most) known.resize(most);
  throw InputError(fmt::format("{} has no function {}; it has {}", file.string(), fmt::join(names, " or "),
                               known.empty() ? "none" : fmt::format("{}", fmt::join(known, ", "))));
}

std::vector<std::string> functions_in(const fs::path& file)
{
  constexpr std::uintmax_t max_bytes = 1'000'000'000;
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
