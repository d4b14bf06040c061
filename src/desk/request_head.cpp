// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/desk/desk_request_head_test.cpp
#include "desk/request_head.hpp"

#include "desk/refusal.hpp"
#include "os/control_characters.hpp"

#include <algorithm>
#include <charconv>
#include <fmt/format.h>

namespace berm::desk {
namespace {

constexpr std::string_view end_of_line = "\r\n";

[[noreturn]] void refuse(const std::string& why)
{
  throw Refusal(400, why);
}

/// What stands before the separator; `text` begins behind it then.
std::string_view taken_to(std::string_view& text, std::string_view separator)
{
  const std::size_t at = std::min(text.find(separator), text.size());
  const std::string_view part = text.substr(0, at);
  text.remove_prefix(std::min(at + separator.size(), text.size()));
  return part;
}

bool is_token(std::string_view word)
{
  constexpr std::string_view marks = "!#$%&'*+-.^_`|~";
  return !word.empty() && std::all_of(word.begin(), word.end(), [&](char c) {
    return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || marks.find(c) != std::string_view::npos;
  });
}

std::string in_small_letters(std::string_view word)
{
  std::string small(word);
  for (char& c : small)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return small;
}

/// Each %20 as the byte that it stands for, in a query + as a space.
std::string without_escapes(std::string_view text, bool of_query)
{
  std::string plain;
  for (std::size_t k = 0; k < text.size(); ++k) {
    if (text[k] != '%') {
      plain += of_query && text[k] == '+' ? ' ' : text[k];
      continue;
    }
    unsigned byte = 0;
    const char* const begin = text.data() + k + 1;
    if (k + 2 >= text.size() || std::from_chars(begin, begin + 2, byte, 16).ptr != begin + 2)
      refuse("the address has a % that is no escape");
    plain += static_cast<char>(byte);
    k += 2;
  }
  return plain;
}

void read_first_line(std::string_view line, RequestHead& head)
{
  head.method = taken_to(line, " ");
  std::string_view target = taken_to(line, " ");
  const bool right = is_token(head.method) && target.starts_with('/') && (line == "HTTP/1.1" || line == "HTTP/1.0") &&
                     std::all_of(target.begin(), target.end(), [](char c) { return c > ' ' && c < 127; });
  if (!right) refuse("this is no request that the server understands");
  head.keeps_open = line == "HTTP/1.1";
  head.path = without_escapes(taken_to(target, "?"), false);
  while (!target.empty()) {
    std::string_view value = taken_to(target, "&");
    const std::string name = without_escapes(taken_to(value, "="), true);
    if (!head.query.emplace(name, without_escapes(value, true)).second) refuse(fmt::format("the address says {} twice", one_line(name)));
  }
}

void read_field(std::string_view line, RequestHead& head)
{
  const std::size_t colon = line.find(':');
  if (colon == std::string_view::npos || !is_token(line.substr(0, colon))) refuse("a line of the request is no NAME: VALUE");
  std::string_view value = line.substr(colon + 1);
  while (!value.empty() && (value.front() == ' ' || value.front() == '\t')) value.remove_prefix(1);
  while (!value.empty() && (value.back() == ' ' || value.back() == '\t')) value.remove_suffix(1);
  const auto is_control = [](char c) { return (static_cast<unsigned char>(c) < ' ' && c != '\t') || c == 127; };
  if (std::any_of(value.begin(), value.end(), is_control)) refuse("a line of the request has control characters");
  head.fields.emplace(in_small_letters(line.substr(0, colon)), value);
}

}  // namespace

std::string RequestHead::field(const std::string& name) const
{
  const auto found = fields.lower_bound(name);
  return found == fields.end() || found->first != name ? "" : found->second;
}

RequestHead head_of(std::string_view lines)
{
  RequestHead head;
  read_first_line(taken_to(lines, end_of_line), head);
  while (!lines.empty()) read_field(taken_to(lines, end_of_line), head);
  for (const char* once : {"authorization", "content-length", "content-type", "origin"})
    if (head.fields.count(once) > 1) refuse(fmt::format("the request says {} twice", once));
  if (head.has("connection")) head.keeps_open = in_small_letters(head.field("connection")) == "keep-alive";
  return head;
}

}  // namespace berm::desk
