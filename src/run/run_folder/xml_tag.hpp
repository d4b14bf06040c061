// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace berm::run_folder {

/// A text as the value of an attribute: & < > and " as entities.
std::string xml_attribute(const std::string& text);

/// A tag of the XML that berm writes.
class XmlTag {
public:
  explicit XmlTag(std::string_view text) : text_(text) {}

  /// The value of an attribute; "" where there is none.
  std::string operator[](const std::string& attribute) const;
  /// The value as a whole number that is not negative; empty where it is not.
  std::optional<std::uint64_t> whole_number(const std::string& attribute) const;
  /// The value as a finite number; empty where it is not.
  std::optional<double> number(const std::string& attribute) const;

private:
  std::string_view text_;
};

/// The tags of that name in a text, in order; they refer to the text.
std::vector<XmlTag> xml_tags(std::string_view text, const std::string& name);

}  // namespace berm::run_folder
