// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/structures/driven/quantities_test.cpp
#include "structures/base/answer.hpp"

namespace berm::base {

const char* unit_text(AnswerUnit unit, int force_dimension)
{
  const bool plane = force_dimension == 2;
  switch (unit) {
  case AnswerUnit::ratio:
    return "1";
  case AnswerUnit::length:
    return "m";
  case AnswerUnit::time:
    return "s";
  case AnswerUnit::angle:
    return "rad";
  case AnswerUnit::force:
    return plane ? "N/m" : "N";
  case AnswerUnit::moment:
    return plane ? "N m/m" : "N m";
  case AnswerUnit::work:
    return plane ? "J/m" : "J";
  }
  return "1";
}

void AnswerList::add(const std::string& name, AnswerUnit unit, Real value, const std::string& meaning, run_folder::QuantityKind kind,
                     bool at_end)
{
  const auto still = at_end && moving_ != nullptr ? moving_->find(of_) : std::map<std::string, std::string>::const_iterator{};
  const bool moves = at_end && moving_ != nullptr && still != moving_->end();
  const std::string words = moves ? meaning + "; " + still->second : meaning;
  list_.push_back({prefix_ + name, value, unit_text(unit, force_dimension_), words, kind, of_});
  const auto twin = [&](const char* suffix, Real measure) {
    list_.push_back({prefix_ + name + suffix, value / measure, "1", words, run_folder::QuantityKind::ratio, of_});
  };
  if (unit == AnswerUnit::force && force_dimension_ == 2 && force_ > 0) twin("_over_gammaD2", force_);
  if (unit == AnswerUnit::length && length_ > 0) twin("_over_D", length_);
}

}  // namespace berm::base
