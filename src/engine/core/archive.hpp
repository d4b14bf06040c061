// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/types.hpp"
#include "os/error.hpp"

#include <algorithm>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

namespace berm {

/// Serializes what a restart needs. A struct names its members once, in a function
///
///   void archive(Archive& k, Totals<dim>& totals) { k("internal_work", totals.internal); ... }
///
/// that both writes and reads a checkpoint; what is read has the bits that were written.
class Archive {
public:
  virtual ~Archive() = default;

  /// True where values are read.
  virtual bool reads() const = 0;
  /// Refuses what was read, for this reason. Throws RunError.
  [[noreturn]] virtual void refuse(const std::string& why) const = 0;

  /// One value: number, bool, Vec, optional number, list of numbers, or text. Names are unique within their table. Reading
  /// refuses a missing value or one of another type.
  template <class T>
  void operator()(const std::string& name, T& variable)
  {
    if constexpr (std::is_same_v<T, std::vector<Real>> || std::is_same_v<T, std::vector<Index>> ||
                  std::is_same_v<T, std::vector<BigIndex>> || std::is_same_v<T, std::string>) {
      visit(name, variable);
    } else if constexpr (std::is_same_v<T, std::optional<Real>>) {
      std::vector<Real> numbers;
      if (variable) numbers.push_back(*variable);
      visit(name, numbers);
      if (numbers.size() > 1) refuse(path_ + name + " is not one number");
      variable = numbers.empty() ? std::nullopt : std::optional<Real>(numbers[0]);
    } else if constexpr (std::is_same_v<T, bool>) {
      std::vector<Index> numbers = {variable ? 1 : 0};
      fixed(name, numbers);
      variable = numbers[0] != 0;
    } else if constexpr (std::is_arithmetic_v<T>) {
      std::vector<T> numbers = {variable};
      fixed(name, numbers);
      variable = numbers[0];
    } else {
      std::vector<Real> numbers(variable.begin(), variable.end());
      fixed(name, numbers);
      std::copy(numbers.begin(), numbers.end(), variable.begin());
    }
  }

  /// A list of numbers of known length.
  template <class T>
  void fixed(const std::string& name, std::vector<T>& numbers)
  {
    const std::size_t count = numbers.size();
    visit(name, numbers);
    if (numbers.size() != count)
      refuse(path_ + name + " has " + std::to_string(numbers.size()) + " numbers instead of " + std::to_string(count));
  }

  /// Opens a table; what `visit` names goes into it.
  template <class Visit>
  void table(const std::string& name, const Visit& visit)
  {
    const std::size_t outside = path_.size();
    (path_ += name) += '/';
    visit();
    path_.resize(outside);
  }

protected:
  virtual void list(const std::string& path, std::vector<Real>& numbers) = 0;
  virtual void list(const std::string& path, std::vector<Index>& numbers) = 0;
  virtual void list(const std::string& path, std::vector<BigIndex>& numbers) = 0;
  virtual void list(const std::string& path, std::string& text) = 0;

private:
  template <class Values>
  void visit(const std::string& name, Values& values)
  {
    const std::size_t outside = path_.size();
    list(path_ += name, values);
    path_.resize(outside);
  }

  std::string path_;  ///< of the open table, "" or with a trailing "/"
};

}  // namespace berm
