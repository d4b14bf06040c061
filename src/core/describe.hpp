// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/types.hpp"

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace berm {

/// The values a number may take. Ends that are `open` are left out themselves.
struct Range {
  Real min = -infinity, max = infinity;
  bool min_open = false, max_open = false;
};
constexpr Range any_number{};
constexpr Range positive{0, infinity, true, false};
constexpr Range not_negative{0, infinity};

/// What is said of a parameter where it is declared. The unit is the SI unit of the number in memory, as UDUNITS-2 spells it ("" = a bare number);
/// the user may write any unit of the same dimension.
struct Parameter {
  const char* meaning;
  const char* unit = "";
  Range range = any_number;
  bool required = false;
  const char* formerly = "";  ///< the key that earlier versions had: refused, with the new one
  /// Instead of `unit`, for a number whose unit is known only later: any may be written, and the SI unit of that goes here ("1" of a bare number in a
  /// text; a plain number leaves it as it is). Numbers that share it must be of one dimension.
  std::string* any_unit = nullptr;
};

/// Visits the parameters of a struct. A struct declares them in one free function
///
///   void describe(Describe& d, Strip& strip)
///   {
///     d.value("width", strip.width, {.meaning = "width of the strip", .unit = "m", .range = positive, .required = true});
///   }
///
/// and reading, range checks, `berm params`, docs/parameters.md and resolved.toml all come from that. A default is the value that the
/// member has before the visit. Visitors: a reader (fills), a writer (resolved.toml), a lister (`berm params`).
class Describe {
public:
  using Leaf = std::variant<Real*, std::optional<Real>*, int*, bool*, std::string*, std::vector<std::string>*, std::vector<Real>*,
                            std::map<std::string, Real>*, std::map<std::string, int>*>;

  virtual ~Describe() = default;

  /// One parameter. A std::vector<Real> is an array of numbers with one unit; a std::map is a table from a free name to a number.
  /// An empty optional, string, vector or map that is not required may be left out and stays empty.
  template <class T>
  void value(const char* key, T& variable, const Parameter& parameter)
  {
    leaf(key, Leaf(&variable), parameter);
  }

  /// One word of a closed list. names[k] is the word for the value k of the enum.
  template <class Enum>
  void choice(const char* key, Enum& variable, const std::vector<const char*>& names, const Parameter& parameter)
  {
    variable = static_cast<Enum>(choose(key, names, static_cast<int>(variable), parameter));
  }

  /// One word of a closed list decides which struct the other keys of this table fill. names[k] is the word for alternative k.
  template <class... Ts>
  void one_of(const char* key, std::variant<Ts...>& variable, const std::vector<const char*>& names, const Parameter& parameter)
  {
    if (lists_all()) {
      choose(key, names, static_cast<int>(variable.index()), parameter);
      int k = 0;
      ((begin_alternative(key, names[k++]), list_alternative<Ts>(), end_alternative()), ...);
      return;
    }
    const int chosen = choose(key, names, static_cast<int>(variable.index()), parameter);
    int k = 0;
    ((k++ == chosen && static_cast<int>(variable.index()) != chosen ? static_cast<void>(variable.template emplace<Ts>()) : void()), ...);
    std::visit([&](auto& alternative) { describe(*this, alternative); }, variable);
  }

  /// A table inside the table: its keys go to one struct.
  template <class T>
  void table(const char* key, T& variable, const Parameter& parameter)
  {
    enter(key, parameter);
    describe(*this, variable);
    leave();
  }

  /// A table that may be left out altogether; then the optional stays empty.
  template <class T>
  void optional_table(const char* key, std::optional<T>& variable, const Parameter& parameter)
  {
    if (lists_all() ? true : has_table(key, variable.has_value())) {
      if (!variable) variable.emplace();
      table(key, *variable, parameter);
    }
  }

  /// Tables addressed by a name of the user's: [material.sand], [material.clay], ... in the order of the file.
  template <class T>
  void named_tables(const char* key, std::vector<std::pair<std::string, T>>& variable, const Parameter& parameter)
  {
    std::vector<std::string> present;
    for (const auto& entry : variable) present.push_back(entry.first);
    for (const std::string& name : names_in(key, present, parameter)) {
      T* place = nullptr;
      for (auto& entry : variable)
        if (entry.first == name) place = &entry.second;
      if (place == nullptr) place = &variable.emplace_back(name, T{}).second;
      enter_named(key, name);
      describe(*this, *place);
      leave();
    }
  }

  /// An ordered array of tables: [[stage]].
  template <class T>
  void array(const char* key, std::vector<T>& variable, const Parameter& parameter)
  {
    const int count = count_in(key, static_cast<int>(variable.size()), parameter);
    variable.resize(count);
    for (int k = 0; k < count; ++k) {
      enter_item(key, k);
      describe(*this, variable[k]);
      leave();
    }
  }

  /// Says at the line of `path` (a dotted path from the root, "body.sand.material" or "stage[2].until") that its value cannot be, unless it can.
  /// Only the reader acts on it; it throws InputError. `allowed` lists the words that would do (for the nearest known one).
  virtual void check(bool fine, const std::string& path, const std::string& message, const std::vector<std::string>& allowed = {}) = 0;

protected:
  virtual void leaf(const char* key, Leaf variable, const Parameter& parameter) = 0;
  virtual int choose(const char* key, const std::vector<const char*>& names, int current, const Parameter& parameter) = 0;
  /// Steps into a table; an absent one is as good as an empty one. leave() follows.
  virtual void enter(const char* key, const Parameter& parameter) = 0;
  virtual void leave() = 0;
  virtual bool has_table(const char* key, bool present) = 0;
  virtual std::vector<std::string> names_in(const char* key, const std::vector<std::string>& present, const Parameter& parameter) = 0;
  virtual void enter_named(const char* key, const std::string& name) = 0;
  virtual int count_in(const char* key, int present, const Parameter& parameter) = 0;
  virtual void enter_item(const char* key, int item) = 0;
  virtual bool lists_all() const { return false; }
  virtual void begin_alternative(const char* /*key*/, const char* /*name*/) {}
  virtual void end_alternative() {}

private:
  template <class T>
  void list_alternative()
  {
    T alternative{};
    describe(*this, alternative);
  }
};

}  // namespace berm
