// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/input/read_case_wrong_inputs_test.cpp
#include "input/value_reader.hpp"

#include "input/message_text.hpp"
#include "input/units.hpp"
#include "os/control_characters.hpp"

#include <fmt/format.h>

namespace berm::input {
namespace {

constexpr std::size_t max_in_text = 4096;  // bytes

}  // namespace

Real ValueReader::number(const Node& node, const std::string& path) const
{
  Real value = 0;
  if (node.kind == Node::Kind::text) {
    for (const NumberWord& word : parameter_.words)
      if (node.text == word.word) return word.value;
    try {
      value = parameter_.any_unit != nullptr ? number_in_any_unit(node, path) : to_si(node.text, parameter_.unit);
    } catch (const UnitError& error) {
      std::string words;
      for (const NumberWord& word : parameter_.words)
        words += fmt::format("{} {}", words.empty() ? "; or one of the words" : ",", in_quotes(word.word));
      refuse(document_, node, path, error.what() + words);
    }
  } else if (node.kind == Node::Kind::whole) {
    value = static_cast<Real>(node.whole);
  } else if (node.kind == Node::Kind::number) {
    value = node.number;
  } else {
    refuse(document_, node, path, fmt::format("must be {}, not {}", wanted(parameter_.unit), kind_of(node)));
  }
  if (!std::isfinite(value)) refuse(document_, node, path, fmt::format("must be a finite number, not {}", value));
  check_range(node, path, value);
  return value;
}

Real ValueReader::number_in_any_unit(const Node& node, const std::string& path) const
{
  const SiQuantity quantity = to_si(node.text);
  if (!parameter_.any_unit->empty() && !same_dimension(*parameter_.any_unit, quantity.unit))
    refuse(document_, node, path,
           fmt::format("{} is in {}, another number of this parameter in {}", in_quotes(node.text), quantity.unit, *parameter_.any_unit));
  *parameter_.any_unit = quantity.unit;
  return quantity.value;
}

void ValueReader::check_range(const Node& node, const std::string& path, Real value) const
{
  if (within(value, parameter_.range)) return;
  const std::string unit = parameter_.unit;
  std::string hint;
  if (node.kind == Node::Kind::text)
    hint = fmt::format("; {} is {:.6g}{}{}", in_quotes(node.text), value, unit.empty() ? "" : " ", unit);
  else if (unit == "rad")
    hint = fmt::format("; a plain number is in radians: write \"{} deg\" if degrees are meant", value);
  else
    hint = fmt::format("; it is {}{}{}", value, unit.empty() ? "" : " ", unit);
  refuse(document_, node, path, fmt::format("must be {}{}", range_text(parameter_.range, unit), hint));
}

int ValueReader::whole_number(const Node& node, const std::string& path) const
{
  Real value = 0.5;
  if (node.kind == Node::Kind::whole) value = static_cast<Real>(node.whole);
  if (node.kind == Node::Kind::number) value = node.number;
  if (!std::isfinite(value) || value != std::floor(value))
    refuse(document_, node, path, fmt::format("must be a whole number, such as 4, not {}", kind_of(node)));
  check_range(node, path, value);
  using Limits = std::numeric_limits<int>;
  if (value < Limits::min() || value > Limits::max()) refuse(document_, node, path, fmt::format("{} is too large a number", value));
  return static_cast<int>(value);
}

std::string ValueReader::text(const Node& node, const std::string& path) const
{
  if (node.kind != Node::Kind::text) refuse(document_, node, path, fmt::format("must be a text in quotes, not {}", kind_of(node)));
  if (node.text.empty() && parameter_.required) refuse(document_, node, path, "must not be empty");
  if (node.text.size() > max_in_text) refuse(document_, node, path, fmt::format("is longer than {} bytes", max_in_text));
  if (has_control_character(node.text))
    refuse(document_, node, path, fmt::format("{} holds a control character, such as the end of a line", in_quotes(node.text)));
  return node.text;
}

void ValueReader::operator()(bool* value) const
{
  if (node_.kind != Node::Kind::boolean) refuse(document_, node_, path_, fmt::format("must be true or false, not {}", kind_of(node_)));
  *value = node_.truth;
}

void ValueReader::check_array(const char* what, const char* example, const std::string& entries) const
{
  if (node_.kind != Node::Kind::array)
    refuse(document_, node_, path_, fmt::format("must be a list of {}, such as {}, not {}{}", what, example, kind_of(node_), entries));
  if (node_.items.empty() && parameter_.required) refuse(document_, node_, path_, "must not be empty");
}

void ValueReader::operator()(std::vector<std::string>* values) const
{
  check_array("texts", "[\"left\", \"right\"]", "");
  values->clear();
  for (std::size_t k = 0; k < node_.items.size(); ++k) {
    const std::string path = fmt::format("{}[{}]", path_, k);
    values->push_back(text(node_.items[k], path));
    if (values->back().empty()) refuse(document_, node_.items[k], path, "must not be empty");
  }
}

void ValueReader::operator()(std::vector<Real>* values) const
{
  check_array("numbers", "[0, 1]", fmt::format("; each is {}", wanted(parameter_.unit)));
  values->clear();
  for (std::size_t k = 0; k < node_.items.size(); ++k) values->push_back(number(node_.items[k], fmt::format("{}[{}]", path_, k)));
}

void ValueReader::check_names(const char* to_what, const char* example) const
{
  if (node_.kind != Node::Kind::table)
    refuse(document_, node_, path_, fmt::format("must be a table from names to {}, such as {}, not {}", to_what, example, kind_of(node_)));
  for (const Node& item : node_.items)
    if (item.key.empty()) refuse(document_, item, path_, "a name must not be empty");
}

void ValueReader::operator()(std::map<std::string, Real>* values) const
{
  check_names("numbers", "{top = 0.5}");
  values->clear();
  for (const Node& item : node_.items) (*values)[item.key] = number(item, path_ + "." + item.key);
}

void ValueReader::operator()(std::map<std::string, int>* values) const
{
  check_names("numbers", "{top = 4}");
  values->clear();
  for (const Node& item : node_.items) (*values)[item.key] = whole_number(item, path_ + "." + item.key);
}

void ValueReader::operator()(std::map<std::string, std::string>* values) const
{
  check_names("texts", "{top = \"sand\"}");
  values->clear();
  for (const Node& item : node_.items) (*values)[item.key] = text(item, path_ + "." + item.key);
}

}  // namespace berm::input
