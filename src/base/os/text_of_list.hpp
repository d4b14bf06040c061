// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fmt/format.h>
#include <string>
#include <string_view>

namespace berm {

/// The elements of a list, each as the form of fmt says, with a text between them. As fmt::join, but it compiles none of fmt's formatters where it is used.
template <class List>
std::string text_of_list(const List& list, std::string_view between, std::string_view form = "{}")
{
  std::string text;
  bool first = true;
  for (const auto& element : list) {
    if (!first) text += between;
    text += fmt::vformat(form, fmt::make_format_args(element));
    first = false;
  }
  return text;
}

}  // namespace berm
