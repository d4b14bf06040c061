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

/// The admissible values of a number; a bound that is `open` is itself excluded.
struct Range {
  Real min = -infinity, max = infinity;
  bool min_open = false, max_open = false;
};
constexpr Range any_number{};
constexpr Range positive{0, infinity, true, false};
constexpr Range not_negative{0, infinity};

/// A word that stands for a number: "unlimited" for infinity.
struct NumberWord {
  const char* word;
  Real value;
};

/// Declaration of a parameter. The unit is the SI unit of the number in memory, as UDUNITS-2 spells it ("" = dimensionless);
/// the user may write any unit of the same dimension.
struct Parameter {
  const char* meaning;
  const char* unit = "";
  Range range = any_number;
  bool required = false;
  std::vector<NumberWord> words = {};  ///< of a number, that may stand for it
  /// Instead of `unit`, for a number whose dimension is known only when it is read: its SI unit goes here ("1" for a
  /// dimensionless number in a text; a plain number leaves it unchanged). Numbers that share it must have one dimension.
  std::string* any_unit = nullptr;
};

/// Visits the parameters of a struct. A struct declares them in one free function
///
///   void describe(Describe& d, Strip& strip)
///   {
///     d.value("width", strip.width, {.meaning = "width of the strip", .unit = "m", .range = positive, .required = true});
///   }
///
/// from which follow reading, range checks, `berm params`, docs/parameters.md and resolved.toml. A default is the value that
/// the member has before the visit. Visitors: a reader (fills), a writer (resolved.toml), a lister (`berm params`).
class Describe {
public:
  using Leaf = std::variant<Real*, std::optional<Real>*, int*, bool*, std::string*, std::vector<std::string>*, std::vector<Real>*,
                            std::map<std::string, Real>*, std::map<std::string, int>*, std::map<std::string, std::string>*>;

  virtual ~Describe() = default;

  /// One parameter. A std::vector<Real> is an array of numbers with one unit; a std::map is a table from a user's name to a
  /// number or a text. An empty optional, string, vector or map that is not required may be left out and stays empty.
  template <class T>
  void value(const char* key, T& variable, const Parameter& parameter)
  {
    leaf(key, Leaf(&variable), parameter);
  }

  /// One word of a closed list; names[k] is the word for enumerator k.
  template <class Enum>
  void choice(const char* key, Enum& variable, const std::vector<const char*>& names, const Parameter& parameter)
  {
    variable = static_cast<Enum>(choose(key, names, static_cast<int>(variable), parameter));
  }

  /// One word of a closed list selects the struct that the other keys of this table fill; names[k] is the word for
  /// alternative k.
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

  /// A nested table; its keys fill one struct.
  template <class T>
  void table(const char* key, T& variable, const Parameter& parameter)
  {
    enter(key, parameter);
    describe(*this, variable);
    leave();
  }

  /// A table that may be left out; the optional then stays empty.
  template <class T>
  void optional_table(const char* key, std::optional<T>& variable, const Parameter& parameter)
  {
    if (lists_all() ? true : has_table(key, variable.has_value())) {
      if (!variable) variable.emplace();
      table(key, *variable, parameter);
    }
  }

  /// A table that may be left out, and then stays empty().
  template <class T>
  requires(requires(T table) { table.empty(); }) void optional_table(const char* key, T& variable, const Parameter& parameter)
  {
    if (lists_all() || has_table(key, !variable.empty())) table(key, variable, parameter);
  }

  /// Tables under names that the user chooses: [material.sand], [material.clay], ... in the order of the file.
  template <class T>
  void named_tables(const char* key, std::vector<std::pair<std::string, T>>& variable, const Parameter& parameter)
  {
    std::vector<std::string> present;
    for (const auto& entry : variable) present.push_back(entry.first);
    for (const std::string& name : names_in(key, present, parameter)) {
      T* entry_of_name = nullptr;
      for (auto& entry : variable)
        if (entry.first == name) entry_of_name = &entry.second;
      if (entry_of_name == nullptr) entry_of_name = &variable.emplace_back(name, T{}).second;
      enter_named(key, name);
      describe(*this, *entry_of_name);
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

  /// Refuses the value at `path` (dotted from the root: "body.sand.material", "stage[2].until") unless it is valid. Only the
  /// reader acts on it: it throws InputError with the line. `allowed` lists the admissible words, for a suggestion.
  virtual void check(bool valid, const std::string& path, const std::string& message, const std::vector<std::string>& allowed = {}) = 0;

protected:
  virtual void leaf(const char* key, Leaf variable, const Parameter& parameter) = 0;
  virtual int choose(const char* key, const std::vector<const char*>& names, int current, const Parameter& parameter) = 0;
  /// Enters a table; an absent one counts as empty. leave() follows.
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
