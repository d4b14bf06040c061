// SPDX-License-Identifier: BSD-3-Clause
#include "io/sha256.hpp"

#include "io/atomic_file.hpp"
#include "os/error.hpp"
#include "os/read_file.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <elf.h>
#include <fmt/format.h>
#include <link.h>
#include <memory>
#include <openssl/evp.h>
#include <sstream>
#include <string_view>
#include <unistd.h>

namespace berm::io {

namespace fs = std::filesystem;

namespace {

using Bytes = std::array<unsigned char, EVP_MAX_MD_SIZE>;

std::string hexadecimal(const Bytes& bytes, unsigned count)
{
  std::string hex;
  for (unsigned k = 0; k < count; ++k) hex += fmt::format("{:02x}", bytes[k]);
  return hex;
}

}  // namespace

std::string sha256_of(std::string_view text)
{
  Bytes bytes{};
  unsigned count = 0;
  if (EVP_Digest(text.data(), text.size(), bytes.data(), &count, EVP_sha256(), nullptr) != 1) throw RunError("there is no SHA-256");
  return hexadecimal(bytes, count);
}

std::string sha256_of_file(const fs::path& file)
{
  std::string fault;
  const int opened = open_to_read(file, fault);
  if (opened < 0) throw RunError(fmt::format("{}: {}", file.string(), fault));
  const std::unique_ptr<EVP_MD_CTX, decltype(&EVP_MD_CTX_free)> digest(EVP_MD_CTX_new(), &EVP_MD_CTX_free);
  bool good = digest != nullptr && EVP_DigestInit_ex(digest.get(), EVP_sha256(), nullptr) == 1;
  std::vector<char> part(1 << 18);
  for (ssize_t count = 1; good && count > 0;) {
    count = ::read(opened, part.data(), part.size());
    if (count < 0 && errno == EINTR)
      count = 1;
    else
      good = count >= 0 && EVP_DigestUpdate(digest.get(), part.data(), static_cast<std::size_t>(count)) == 1;
  }
  ::close(opened);
  Bytes bytes{};
  unsigned count = 0;
  if (!good || EVP_DigestFinal_ex(digest.get(), bytes.data(), &count) != 1)
    throw RunError(fmt::format("{}: cannot be read for its SHA-256", file.string()));
  return hexadecimal(bytes, count);
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
  std::istringstream maps(read_text_file("/proc/self/maps"));
  for (std::string line; std::getline(maps, line);)
    for (std::size_t k = 1; k < search.found.size(); ++k)
      if (line.ends_with(fmt::format("/{}{}", search.found[k].name, deleted))) search.found[k].path.clear();
  return search.found;
}

namespace {

/// A structure of a file or of memory, by its place; all zero where it ends beyond the bytes.
template <class Part>
Part part_at(std::string_view bytes, std::size_t place)
{
  Part part{};
  if (place <= bytes.size() && sizeof part <= bytes.size() - place) std::memcpy(&part, bytes.data() + place, sizeof part);
  return part;
}

std::string_view cut(std::string_view bytes, std::size_t begin, std::size_t count)
{
  return begin <= bytes.size() ? bytes.substr(begin, count) : std::string_view();
}

/// The build id in the notes of a segment. Name and content of a note fill whole words.
std::string id_in_notes(std::string_view notes)
{
  const auto whole_words = [](std::size_t size) { return (size + 3) / 4 * 4; };
  while (notes.size() >= sizeof(Elf64_Nhdr)) {
    const auto note = part_at<Elf64_Nhdr>(notes, 0);
    const std::size_t content = sizeof note + whole_words(note.n_namesz), next = content + whole_words(note.n_descsz);
    if (note.n_type == NT_GNU_BUILD_ID && cut(notes, sizeof note, note.n_namesz) == std::string_view("GNU\0", 4)) {
      std::string id;
      for (const char byte : cut(notes, content, note.n_descsz)) id += fmt::format("{:02x}", static_cast<unsigned char>(byte));
      return id;
    }
    notes = cut(notes, next, notes.size());
  }
  return "";
}

}  // namespace

std::string build_id_at(const void* address)
{
  struct Search {
    std::uintptr_t address;
    std::string id;
  } search{reinterpret_cast<std::uintptr_t>(address), ""};
  dl_iterate_phdr(
      [](dl_phdr_info* info, std::size_t, void* data) {
        auto& to = *static_cast<Search*>(data);
        const auto holds_address = [&](const ElfW(Phdr) & segment) {
          const std::uintptr_t begin = info->dlpi_addr + segment.p_vaddr;
          return segment.p_type == PT_LOAD && to.address >= begin && to.address - begin < segment.p_memsz;
        };
        if (std::none_of(info->dlpi_phdr, info->dlpi_phdr + info->dlpi_phnum, holds_address)) return 0;
        for (int k = 0; k < info->dlpi_phnum && to.id.empty(); ++k)
          if (const ElfW(Phdr)& segment = info->dlpi_phdr[k]; segment.p_type == PT_NOTE)
            to.id = id_in_notes({reinterpret_cast<const char*>(info->dlpi_addr + segment.p_vaddr), segment.p_memsz});
        return 1;
      },
      &search);
  return search.id;
}

std::string build_id_in(const std::filesystem::path& file)
{
  constexpr std::uintmax_t max_bytes = 5'000'000'000;
  const std::string bytes = read_text_file(file, max_bytes);
  const auto header = part_at<Elf64_Ehdr>(bytes, 0);
  if (std::memcmp(header.e_ident, ELFMAG, SELFMAG) != 0 || header.e_ident[EI_CLASS] != ELFCLASS64) return "";
  for (std::size_t k = 0; k < header.e_phnum; ++k) {
    const auto segment = part_at<Elf64_Phdr>(bytes, header.e_phoff + k * header.e_phentsize);
    if (segment.p_type != PT_NOTE) continue;
    if (const std::string id = id_in_notes(cut(bytes, segment.p_offset, segment.p_filesz)); !id.empty()) return id;
  }
  return "";
}

}  // namespace berm::io
