// SPDX-License-Identifier: BSD-3-Clause
#include "os/control_characters.hpp"

namespace berm {
namespace {

/// The bytes of the control character that begins there; 0 where none does. Beyond ASCII they are C2 80 to C2 9F.
std::size_t length_of_control(const std::string& text, std::size_t at)
{
  const auto byte = [&](std::size_t k) { return k < text.size() ? static_cast<unsigned char>(text[k]) : 0u; };
  if (byte(at) < 0x20 || byte(at) == 0x7F) return 1;
  return byte(at) == 0xC2 && byte(at + 1) >= 0x80 && byte(at + 1) < 0xA0 ? 2 : 0;
}

}  // namespace

bool has_control_character(const std::string& text)
{
  for (std::size_t k = 0; k < text.size(); ++k)
    if (length_of_control(text, k) > 0) return true;
  return false;
}

std::string one_line(std::string text)
{
  for (std::size_t k = 0; k < text.size(); ++k)
    for (std::size_t length = length_of_control(text, k); length > 0; --length) text[k + length - 1] = ' ';
  return text;
}

}  // namespace berm
