// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "run_folder/summary.hpp"

#include <cmath>
#include <map>

namespace berm::base {

/// What an answer is measured in.
enum class AnswerUnit { ratio, length, time, angle, force, moment, work };

/// The SI unit as UDUNITS-2 spells it: of forces and what follows from them per metre run where they are of two dimensions.
const char* unit_text(AnswerUnit unit, int force_dimension);

/// Reads and writes a number of a reading.
template <class Of>
struct Access {
  bool (*there)(const Of&);  ///< whether the reading has it; its value may be NaN all the same
  Real (*value)(const Of&);
  void (*store)(Of&, Real) = nullptr;  ///< of what is read back from summary.json
};

/// Of readings that do not ask which stages a run has.
struct AnyStage {};

/// A row of the answers of a reading: one number that a run may have, wherever it is told.
template <class Of, class Stage = AnyStage>
struct Answer {
  const char* name;
  AnswerUnit unit;
  const char* meaning;
  Access<Of> number;
  run_folder::QuantityKind kind = run_folder::QuantityKind::answer;
  bool (*given)(const Of&) = nullptr;     ///< whether the input prescribes it; null: it never does
  bool (*known)(const Stage&) = nullptr;  ///< whether a run of such a stage may have it; null: of any
  bool at_end = false;                    ///< it is of the end of its travel or state, at which the body may still move
};

/// The number that these members lead to, one within the other; each may be optional.
template <auto First, auto... Rest>
struct Member {
  template <class Of>
  static const Real* find(const Of& of)
  {
    const auto& member = of.*First;
    if constexpr (requires { member.has_value(); }) {
      if (!member) return nullptr;
      return next(*member);
    } else {
      return next(member);
    }
  }
  template <class Of>
  static void store(Of& of, Real value)
  {
    auto& member = of.*First;
    if constexpr (requires { member.has_value(); }) {
      if (!member) member.emplace();
      store_next(*member, value);
    } else {
      store_next(member, value);
    }
  }

private:
  template <class Inner>
  static const Real* next(const Inner& inner)
  {
    if constexpr (sizeof...(Rest) > 0)
      return Member<Rest...>::find(inner);
    else
      return &inner;
  }
  template <class Inner>
  static void store_next(Inner& inner, Real value)
  {
    if constexpr (sizeof...(Rest) > 0)
      Member<Rest...>::store(inner, value);
    else
      inner = value;
  }
};

/// The access to that number.
template <class Of, auto... Path>
constexpr Access<Of> number = {[](const Of& of) { return Member<Path...>::find(of) != nullptr; },
                               [](const Of& of) {
                                 const Real* found = Member<Path...>::find(of);
                                 return found == nullptr ? nan : *found;
                               },
                               [](Of& of, Real value) { Member<Path...>::store(of, value); }};

/// Access to a number that is there where it is finite.
template <class Of, auto... Path>
constexpr Access<Of> finite_number = {[](const Of& of) { return std::isfinite(*Member<Path...>::find(of)); }, number<Of, Path...>.value};

/// The answers of readings as summary.json has them.
class AnswerList {
public:
  explicit AnswerList(int force_dimension) : force_dimension_(force_dimension) {}

  /// Forces also over this, lengths also over that: dimensionless twins NAME_over_gammaD2 and NAME_over_D. Without a force or length above 0 there are none.
  void twins(Real force, Real length) { force_ = force, length_ = length; }
  /// What is said behind the meaning of answers at the end of a travel or state at which the body still moves, by that.
  void moving(const std::map<std::string, std::string>& words) { moving_ = &words; }
  /// What follows is of this travel or state, and its names begin with this.
  void of(const std::string& travel, const std::string& prefix) { of_ = travel, prefix_ = prefix; }

  template <class Of, class Rows>
  void add(const Rows& rows, const Of& reading)
  {
    for (const auto& row : rows)
      if (row.number.there(reading))
        add(row.name, row.unit, row.number.value(reading), row.meaning,
            row.given != nullptr && row.given(reading) ? run_folder::QuantityKind::prescribed : row.kind, row.at_end);
  }
  void add(const std::string& name, AnswerUnit unit, Real value, const std::string& meaning,
           run_folder::QuantityKind kind = run_folder::QuantityKind::answer, bool at_end = false);
  /// Names alone, of all rows that a run of such a stage may have.
  template <class Rows, class Stage>
  void add_names(const Rows& rows, const Stage& stage)
  {
    for (const auto& row : rows)
      if (row.known == nullptr || row.known(stage)) add(row.name, row.unit, nan, row.meaning, row.kind);
  }

  const std::vector<run_folder::Quantity>& list() const { return list_; }

private:
  int force_dimension_;
  Real force_ = 0, length_ = 0;
  const std::map<std::string, std::string>* moving_ = nullptr;
  std::string of_, prefix_;
  std::vector<run_folder::Quantity> list_;
};

/// Takes the answers of a reading back from their names and values; `prefix` as of AnswerList.
template <class Of, class Rows>
void take_answers(const Rows& rows, const std::map<std::string, Real>& values, const std::string& prefix, Of& reading)
{
  for (const auto& row : rows)
    if (const auto found = values.find(prefix + row.name); found != values.end()) row.number.store(reading, found->second);
}

}  // namespace berm::base
