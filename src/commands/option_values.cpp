// SPDX-License-Identifier: BSD-3-Clause
#include "commands/option_values.hpp"

#include "input/message_text.hpp"
#include "input/text_table.hpp"
#include "os/text_of_list.hpp"

#include <algorithm>
#include <charconv>
#include <fmt/format.h>

namespace berm::commands {
namespace {

std::string refusal(const std::string& text, const std::string& allowed)
{
  const std::string fault = input::fault_of_commas(text);
  return fmt::format("{} {}; allowed: {}", input::in_quotes(text), fault.empty() ? "is not allowed" : fault, allowed);
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

}  // namespace berm::commands
