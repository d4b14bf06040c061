// SPDX-License-Identifier: BSD-3-Clause
#include "commands/option_values.hpp"

#include "input/message_text.hpp"
#include "input/text_table.hpp"
#include "os/text_of_list.hpp"

#include <algorithm>
#include <charconv>
#include <fmt/format.h>
#include <regex>
#include <set>
#include <utility>

namespace berm::commands {
namespace {

std::string refusal(const std::string& text, const std::string& allowed)
{
  const std::string fault = input::fault_of_commas(text);
  return fmt::format("{} {}; allowed: {}", input::in_quotes(text), fault.empty() ? "is not allowed" : fault, allowed);
}

/// TEXT, {table,json} of TEXT:{table,json}, and <a number from 5 to 30> of FLOAT:a number from 5 to 30.
std::string value_words(const std::string& type)
{
  const auto colon = type.find(':');
  const std::string allowed = colon == std::string::npos ? type : type.substr(colon + 1);
  return allowed.find(' ') == std::string::npos ? allowed : "<" + allowed + ">";
}

std::string names_of(const std::set<CLI::Option*>& options)
{
  std::vector<std::string> names;
  for (const CLI::Option* option : options) names.push_back(option->get_name());
  std::sort(names.begin(), names.end());
  return text_of_list(names, ", ");
}

}  // namespace

CLI::Validator number_within(const Range& range)
{
  const std::string allowed = "a number " + input::range_text(range, "");
  return {[range, allowed](const std::string& text) {
            const std::optional<Real> number = input::number_in(text);
            return number && input::within(*number, range) ? "" : refusal(text, allowed);
          },
          allowed};
}

CLI::Validator whole_number_within(int least, int most)
{
  const std::string allowed = fmt::format("a whole number from {} to {}", least, most);
  return {[least, most, allowed](const std::string& text) {
            int number = 0;
            const auto [rest, error] = std::from_chars(text.data(), text.data() + text.size(), number);
            const bool whole = error == std::errc() && rest == text.data() + text.size();
            return whole && number >= least && number <= most ? "" : refusal(text, allowed);
          },
          allowed};
}

CLI::Validator one_of(const std::vector<std::string>& words)
{
  return {[words](const std::string& text) {
            return std::find(words.begin(), words.end(), text) != words.end()
                       ? ""
                       : fmt::format("{} is not allowed{}", input::in_quotes(text), input::suggestion(text, words));
          },
          fmt::format("{{{}}}", text_of_list(words, ","))};
}

std::string Help::make_option_opts(const CLI::Option* option) const
{
  const std::string value = value_words(option->get_type_name());
  std::string words = value.empty() ? "" : " " + value;
  if (option->get_expected_max() == CLI::detail::expected_max_vector_size) words += " ...";
  if (!option->get_needs().empty()) words += " (with " + names_of(option->get_needs()) + ")";
  if (!option->get_excludes().empty()) words += " (not with " + names_of(option->get_excludes()) + ")";
  return words;
}

std::string in_words(const CLI::ParseError& error)
{
  static const std::pair<std::regex, const char*> sentences[] = {
      {std::regex("(\\S+): \\d+ required (?:TEXT|INT|FLOAT) missing"), "$1: needs a value"},
      {std::regex("(\\S+): \\d+ required (?:TEXT:|INT:|FLOAT:)?(.*) missing"), "$1: needs a value; allowed: $2"},
      {std::regex("(\\S+): At Most 1 required but received \\d+"), "$1: is given more than once"},
      {std::regex("(\\S+) was given a disallowed flag override"), "$1: takes no value"},
      {std::regex("Could not convert: (\\S+) = (.*)"), "$1: \"$2\" is not allowed"},
      {std::regex("(\\S+) excludes (\\S+)"), "$1: cannot be combined with $2"},
      {std::regex("(\\S+) requires (\\S+)"), "$1: needs $2"},
      {std::regex("(\\S+) is required"), "$1 is missing"},
      {std::regex("The following arguments? (?:was|were) not expected: (.*)"), "unexpected argument: $1"}};
  const std::string said = error.what();
  for (const auto& [pattern, words] : sentences)
    if (std::regex_match(said, pattern)) return std::regex_replace(said, pattern, words);
  return said;
}

}  // namespace berm::commands
