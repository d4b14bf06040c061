// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/input/places_test.cpp
#include "input/places.hpp"

#include "input/override.hpp"

#include <charconv>
#include <fmt/format.h>

namespace berm::input {

/// The key of the document that a key of the case comes from.
std::string Places::written(const std::string& key) const
{
  constexpr std::string_view stage = "stage[";
  if (!key.starts_with(stage)) return key;
  std::size_t number = 0;
  const auto [end, error] = std::from_chars(key.data() + stage.size(), key.data() + key.size(), number);
  if (error != std::errc() || number >= stages_.size() || *end != ']') return key;
  const std::string of_stage = fmt::format("{}{}]", stage, stages_[number]);
  std::string rest = key.substr(static_cast<std::size_t>(end - key.data()) + 1);
  // What ends a drag of a sweep is written as the sweep's amplitude.
  if (rest.starts_with(".until") && follow(document_->root, of_stage + ".amplitude").whole) rest = ".amplitude";
  return of_stage + rest;
}

Located Places::located(const std::string& key, const std::string& message) const
{
  if (!document_) return {.key = key, .message = message};
  const Found found = follow(document_->root, written(key));
  return input::located(*document_, *found.node, found.path, message);
}

Located Places::located(const KeyError& error) const
{
  const std::string key_and_message = error.what();
  const std::size_t end = key_and_message.find(": ");
  if (end == std::string::npos) return {.message = key_and_message};
  return located(key_and_message.substr(0, end), key_and_message.substr(end + 2));
}

bool Places::has(const std::string& key) const
{
  return document_ && follow(document_->root, written(key)).whole;
}

bool Places::is_given(const std::string& key) const
{
  return has(key) && (!document_->resolved || !follow(document_->root, written(key)).node->override_key.empty());
}

}  // namespace berm::input
