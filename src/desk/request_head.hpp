// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>
#include <string_view>

namespace berm::desk {

constexpr std::size_t longest_head = 16 << 10;

/// The lines of a request before its body.
struct RequestHead {
  std::string method, path;  ///< path: without escapes
  std::map<std::string, std::string> query;
  std::multimap<std::string, std::string> fields;  ///< by their names in small letters
  bool keeps_open = true;                          ///< the client may send another request

  /// The first one of that name; "" where there is none.
  std::string field(const std::string& name) const;
  bool has(const std::string& name) const { return fields.count(name) > 0; }
};

/// Reads the lines of HTTP/1.1 (RFC 9112), without the empty one that ends them. Throws Refusal 400 where they are no head of a request, or say twice what can be said once.
RequestHead head_of(std::string_view lines);

}  // namespace berm::desk
