// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdio>
#include <fmt/format.h>

namespace berm::io {

/// Prints to the standard error. What nobody takes any more, as when the terminal is gone, is no reason to stop what is being computed.
template <class... Values>
void tell(fmt::format_string<Values...> form, Values&&... values)
{
  std::fputs(fmt::format(form, std::forward<Values>(values)...).c_str(), stderr);
}

}  // namespace berm::io
