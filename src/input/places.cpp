// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/input/places_test.cpp
#include "input/places.hpp"

#include "input/follow.hpp"

namespace berm::input {

std::string Places::located(const std::string& key, const std::string& message) const
{
  if (!document_) return key + ": " + message;
  const Found found = follow(document_->root, key);
  return input::located(*document_, *found.node, found.path, message);
}

std::string Places::located(const std::string& key_and_message) const
{
  const std::size_t end = key_and_message.find(": ");
  if (end == std::string::npos) return key_and_message;
  return located(key_and_message.substr(0, end), key_and_message.substr(end + 2));
}

bool Places::has(const std::string& key) const
{
  return document_ && follow(document_->root, key).whole;
}

}  // namespace berm::input
