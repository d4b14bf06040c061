// SPDX-License-Identifier: BSD-3-Clause
// The lines of a request to a desk, by whoever reaches its port: refused in one line, or read into words that end no line.
#include "target.hpp"

#include "desk/refusal.hpp"
#include "desk/request_head.hpp"
#include "os/control_characters.hpp"

using namespace berm;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  try {
    const desk::RequestHead head = desk::head_of(text_of(data, std::min(size, desk::longest_head)));
    promise(head.path.starts_with('/'), "a path begins at the root", head.path);
    promise(!has_control_character(head.method), "a method is a word", head.method);
    for (const auto& [name, value] : head.fields) {
      promise(!name.empty() && !has_control_character(name), "a field has a name", name);
      promise(value.find_first_of("\r\n") == std::string::npos, "a value is one line", value);
    }
  } catch (const desk::Refusal& refusal) {
    promise_one_line(refusal.what());
    promise(refusal.status == 400, "what is no head is refused as that", refusal.what());
  }
  return 0;
}
