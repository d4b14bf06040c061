// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "structures/base/driven_body.hpp"

#include <cmath>
#include <map>

namespace berm::base {

/// What an answer is measured in.
enum class AnswerUnit { ratio, length, area, time, angle, stress, force, moment, work };

/// The SI unit as UDUNITS-2 spells it: of forces and what follows from them, and of areas, per metre run where they are of two dimensions.
const char* unit_text(AnswerUnit unit, int force_dimension);

/// Reads and writes a number of a reading.
template <class Of>
struct Access {
  constexpr Access(bool (*is_there)(const Of&), Real (*value_of)(const Of&), void (*store_in)(Of&, Real))
      : there(is_there),
        value(value_of),
        store(store_in)
  {
  }
  template <class Function>
  constexpr Access(Function value_of) : value(value_of)
  {
  }

  bool (*there)(const Of&) = nullptr;  ///< whether the reading has it; its value may be NaN all the same; null: where its value is finite
  Real (*value)(const Of&) = nullptr;
  void (*store)(Of&, Real) = nullptr;  ///< of what is read back from summary.json
};

/// How a number stands in tables of the page.
struct Heading {
  const char* words = nullptr;  ///< HTML, above its column; null: it has none
  const char* unit = "";
  Real size = 1;             ///< of that unit in SI
  bool whole = false;        ///< it counts
  const char* missing = "";  ///< what stands where there is no number, instead of "–"; then the column stands without any
};

/// Of readings that do not ask which stages a run has.
struct AnyStage {};

/// A row of the answers of a reading: one number that a run may have, wherever it is told. {WORD} in name and meaning is what AnswerList::fill puts there.
template <class Of, class Stage = AnyStage, class Giver = Of>
struct Answer {
  const char* name;
  AnswerUnit unit;
  const char* meaning;
  Access<Of> number;
  run_folder::QuantityKind kind = run_folder::QuantityKind::answer;
  bool (*given)(const Giver&) = nullptr;  ///< whether the input prescribes it; null: it never does
  bool (*known)(const Stage&) = nullptr;  ///< whether a run of such a stage may have it; null: of any
  bool at_end = false;                    ///< it is of the end of its travel or state, at which the body may still move
  Heading heading{};

  constexpr Answer headed(const Heading& its) const
  {
    Answer row = *this;
    row.heading = its;
    return row;
  }
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

/// The words that {WORD} in names and meanings stands for.
using Fill = std::map<std::string, std::string>;

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
  /// The names that follow end with a multiple of D: NAME_0.35D; without one they do not.
  void at(std::optional<Real> over_D) { ending_ = over_D ? ending_at(*over_D) : ""; }
  void fill(Fill words) { fill_ = std::move(words); }
  /// What stands behind the meanings that follow.
  void behind(const std::string& words) { behind_ = words; }

  template <class Of, class Rows>
  void add(const Rows& rows, const Of& reading)
  {
    add(rows, reading, reading);
  }
  template <class Of, class Rows, class Giver>
  void add(const Rows& rows, const Of& reading, const Giver& giver)
  {
    for (const auto& row : rows)
      if (const Real value = row.number.value(reading); row.number.there != nullptr ? row.number.there(reading) : std::isfinite(value))
        add(row.name, row.unit, value, row.meaning,
            row.given != nullptr && row.given(giver) ? run_folder::QuantityKind::prescribed : row.kind, row.at_end);
  }
  void add(const std::string& name, AnswerUnit unit, Real value, const std::string& meaning,
           run_folder::QuantityKind kind = run_folder::QuantityKind::answer, bool at_end = false);
  /// Names alone, of all rows that a run of such a stage may have.
  template <class Rows, class Stage = AnyStage>
  void add_names(const Rows& rows, const Stage& stage = {})
  {
    for (const auto& row : rows)
      if (row.known == nullptr || row.known(stage)) add(row.name, row.unit, nan, row.meaning, row.kind);
  }

  const std::vector<run_folder::Quantity>& list() const { return list_; }
  std::vector<std::string> names() const;

  /// "_0.35D".
  static std::string ending_at(Real over_D);

private:
  int force_dimension_;
  Real force_ = 0, length_ = 0;
  const std::map<std::string, std::string>* moving_ = nullptr;
  std::string of_, prefix_, ending_, behind_;
  Fill fill_;
  std::vector<run_folder::Quantity> list_;
};

/// Takes the answers of a reading back from their names and values; `prefix` as of AnswerList.
template <class Of, class Rows>
void take_answers(const Rows& rows, const std::map<std::string, Real>& values, const std::string& prefix, Of& reading)
{
  for (const auto& row : rows)
    if (const auto found = values.find(prefix + row.name); found != values.end()) row.number.store(reading, found->second);
}

/// Quantities as a table of the log: model, dimensionless, and prototype (force per metre and length times the gravity level) where the model has one; "" without any.
std::string log_table(const std::vector<run_folder::Quantity>& quantities, const BodyScale& scale);

}  // namespace berm::base
