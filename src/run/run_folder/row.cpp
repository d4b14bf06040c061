// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/run_folder/history_test.cpp
#include "run_folder/row.hpp"

#include "os/error.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::run_folder {
namespace {

constexpr const char* directions[3] = {"x", "y", "z"};

}  // namespace

void Row::begin(Real time, const std::string& stage)
{
  if (!fixed_) columns_.clear();
  values_.clear();
  stage_ = stage;
  of_main("run");
  (*this)("time", time, seconds, "time");
}

void Row::set_of(std::string_view what, bool in_name)
{
  of_.assign(what);
  of_in_name_ = in_name;
}

void Row::operator()(std::string_view symbol, Real value, const ColumnUnit& unit, std::string_view meaning)
{
  add(symbol, "", value, unit, meaning);
}

void Row::component(std::string_view symbol, int d, Real value, const ColumnUnit& unit, std::string_view meaning)
{
  add(symbol, directions[d], value, unit, meaning);
}

void Row::add(std::string_view symbol, std::string_view component, Real value, const ColumnUnit& unit, std::string_view meaning)
{
  if (parts_ != 1 && unit.whole != nullptr) return add(symbol, component, parts_ * value, *unit.whole, meaning);
  name_.clear();
  if (of_in_name_) name_.append(of_).append("_");
  name_.append(symbol).append(component);
  const std::size_t label = name_.size();
  if (*unit.ending != '\0') name_.append("_").append(unit.ending);
  if (fixed_) {
    if (values_.size() == columns_.size() || columns_[values_.size()].name != name_) refuse();
  } else {
    Column& column = columns_.emplace_back(Column{name_, name_.substr(0, label), unit.name, std::string(meaning), of_});
    std::replace(column.label.begin(), column.label.end(), '_', ' ');
    if (!component.empty()) column.meaning.append(", ").append(component);
  }
  values_.push_back(value);
}

void Row::end()
{
  if (values_.size() != columns_.size()) refuse();
  fixed_ = true;
}

void Row::refuse() const
{
  const std::size_t at = values_.size();
  throw RunError(fmt::format("a row of the history has {} as its number {}, where the first row had {}",
                             at == columns_.size() || columns_[at].name != name_ ? name_ : "nothing", at + 1,
                             at < columns_.size() ? columns_[at].name : "nothing"));
}

}  // namespace berm::run_folder
