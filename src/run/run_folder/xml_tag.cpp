// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/run_folder/frame_reader_test.cpp
#include "run_folder/xml_tag.hpp"

#include <charconv>
#include <cmath>
#include <iterator>
#include <utility>

namespace berm::run_folder {
namespace {

/// A text that is a number as a whole.
template <class T>
std::optional<T> number_in(const std::string& text)
{
  T value{};
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  if (text.empty() || error != std::errc{} || stop != end) return {};
  return value;
}

constexpr std::pair<const char*, const char*> entities[] = {{"&", "&amp;"}, {"<", "&lt;"}, {">", "&gt;"}, {"\"", "&quot;"}};

void replace_all(std::string& text, const std::string& what, const std::string& instead)
{
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + instead.size()))
    text.replace(at, what.size(), instead);
}

}  // namespace

std::string xml_attribute(const std::string& text)
{
  std::string value = text;
  for (const auto& [letter, entity] : entities) replace_all(value, letter, entity);
  return value;
}

std::string XmlTag::operator[](const std::string& attribute) const
{
  const std::string begin = " " + attribute + "=\"";
  const std::size_t at = text_.find(begin);
  if (at == std::string_view::npos) return "";
  const std::size_t from = at + begin.size(), to = text_.find('"', from);
  if (to == std::string_view::npos) return "";
  std::string value(text_.substr(from, to - from));
  for (auto entity = std::rbegin(entities); entity != std::rend(entities); ++entity) replace_all(value, entity->second, entity->first);
  return value;
}

std::optional<std::uint64_t> XmlTag::whole_number(const std::string& attribute) const
{
  return number_in<std::uint64_t>((*this)[attribute]);
}

std::optional<double> XmlTag::number(const std::string& attribute) const
{
  const std::optional<double> value = number_in<double>((*this)[attribute]);
  return value && std::isfinite(*value) ? value : std::nullopt;
}

std::vector<XmlTag> xml_tags(std::string_view text, const std::string& name)
{
  std::vector<XmlTag> tags;
  const std::string begin = "<" + name + " ";
  for (std::size_t at = text.find(begin); at != std::string_view::npos; at = text.find(begin, at + 1)) {
    const std::size_t to = text.find('>', at);
    if (to == std::string_view::npos) break;
    tags.emplace_back(text.substr(at, to - at));
  }
  return tags;
}

}  // namespace berm::run_folder
