// SPDX-License-Identifier: BSD-3-Clause
#include "os/text_file.hpp"

#include <algorithm>

namespace berm {
namespace {

/// Bytes of the character of UTF-8 that begins at `at`; 0 where none does.
std::size_t character_at(std::string_view text, std::size_t at)
{
  const auto byte = [&](std::size_t k) { return static_cast<unsigned char>(text[k]); };
  const std::size_t size = byte(at) < 0x80 ? 1 : byte(at) < 0xC2 ? 0 : byte(at) < 0xE0 ? 2 : byte(at) < 0xF0 ? 3 : byte(at) < 0xF5 ? 4 : 0;
  if (size == 0 || at + size > text.size()) return 0;
  for (std::size_t k = at + 1; k < at + size; ++k)
    if ((byte(k) & 0xC0) != 0x80) return 0;
  return size;
}

bool is_utf8(std::string_view text)
{
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t size = character_at(text, at);
    if (size == 0) return false;
    at += size;
  }
  return true;
}

/// Latin-1 as UTF-8. Bytes 0x80 to 0x9F, which Windows has for dashes and quotation marks, become question marks.
std::string from_latin_1(std::string_view text)
{
  std::string written;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < 0x80) {
      written += c;
    } else if (byte < 0xA0) {
      written += '?';
    } else {
      written += static_cast<char>(0xC0 | (byte >> 6));
      written += static_cast<char>(0x80 | (byte & 0x3F));
    }
  }
  return written;
}

}  // namespace

std::size_t begin_of_text(std::string_view bytes)
{
  constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
  return bytes.starts_with(byte_order_mark) ? byte_order_mark.size() : 0;
}

FileBytes read_text(const std::filesystem::path& path, std::uintmax_t most)
{
  FileBytes found = read_file(path, most);
  std::string& text = found.bytes;
  if (text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF"))
    found.fault = "is text in UTF-16: save it as text in UTF-8";
  else if (text.find('\0') != std::string::npos)
    found.fault = "holds a NUL byte: this is not a text file; save it as text in UTF-8";
  if (!found.fault.empty()) return {"", found.fault};
  text.erase(0, begin_of_text(text));
  if (!is_utf8(text)) text = from_latin_1(text);
  if (text.find('\n') == std::string::npos) std::replace(text.begin(), text.end(), '\r', '\n');
  return found;
}

}  // namespace berm
