// SPDX-License-Identifier: BSD-3-Clause
#include "start/kinds.hpp"

#include "input/message_text.hpp"
#include "os/error.hpp"
#include "start/templates.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <sstream>

namespace berm::start {
namespace {

/// What stands between two words, or "".
std::string between(const std::string& text, const std::string& before, const std::string& after)
{
  const std::size_t found = text.find(before);
  if (found == std::string::npos) return "";
  const std::size_t begin = found + before.size();
  return text.substr(begin, text.find(after, begin) - begin);
}

Kind read_kind(const CaseTemplate& one)
{
  const std::string header = between(one.text, "\n# ", "\n");
  const std::size_t colon = header.find(": ");
  return {one.kind,
          header.substr(0, colon),
          header.substr(colon + 2),
          between(one.text, "\ntitle = \"", "\""),
          between(one.text, " examples/", "\n"),
          one.text};
}

std::vector<Kind> read_kinds()
{
  std::vector<Kind> all;
  for (const CaseTemplate& one : case_templates()) all.push_back(read_kind(one));
  std::stable_sort(all.begin(), all.end(), [](const Kind& a, const Kind& b) { return a.group < b.group; });
  return all;
}

/// A line with the value of a size; one without values for sizes stays.
std::string line_at(const std::string& line, const std::string& size)
{
  const std::size_t comment = line.find("# [quick ");
  if (comment == std::string::npos) return line;
  const std::size_t end = line.find(']', comment);
  const std::string values = line.substr(comment, end - comment);
  const std::size_t equals = line.find(" = ");
  const std::string normal = line.substr(equals + 3, line.find_last_not_of(' ', comment - 1) - equals - 2);
  const std::string value = size == "quick"  ? between(values, "[quick ", ", fine ")
                            : size == "fine" ? values.substr(values.find(", fine ") + 7)
                                             : normal;
  return fmt::format("{:<39} # {}:{}", line.substr(0, equals + 3) + value, size, line.substr(end + 1));
}

}  // namespace

const std::vector<Kind>& kinds()
{
  static const std::vector<Kind> all = read_kinds();
  return all;
}

const Kind& kind_called(const std::string& name)
{
  std::vector<std::string> names;
  for (const Kind& one : kinds()) {
    if (one.name == name) return one;
    names.push_back(one.name);
  }
  throw InputError(fmt::format("there is no kind {}{}", input::in_quotes(name), input::suggestion(name, names)));
}

std::string at_size(const Kind& kind, const std::string& size)
{
  if (std::find(sizes.begin(), sizes.end(), size) == sizes.end())
    throw InputError(fmt::format("--size: there is no size {}{}", input::in_quotes(size), input::suggestion(size, sizes)));
  std::istringstream lines(kind.text);
  std::string written;
  for (std::string line; std::getline(lines, line);) written += line_at(line, size) + "\n";
  return written;
}

}  // namespace berm::start
