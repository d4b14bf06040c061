// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/structures/driven/quantities_test.cpp
#include "structures/base/answer.hpp"

#include "structures/base/display_units.hpp"
#include "text/quantity_words.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::base {
namespace {

/// A text with what fill puts into it.
std::string filled(std::string text, const Fill& fill)
{
  for (const auto& [word, put] : fill)
    for (std::size_t at; (at = text.find('{' + word + '}')) != std::string::npos;) text.replace(at, word.size() + 2, put);
  return text;
}

/// Four digits that count, without an exponent in the range of engineering numbers.
std::string four_digits(Real value)
{
  const Real size = std::abs(value);
  if (std::isnan(value)) return "not known";
  if (!std::isfinite(value) || (size > 0 && (size < 1e-5 || size >= 1e7))) return fmt::format("{:.3e}", value);
  const int before = size > 0 ? static_cast<int>(std::floor(std::log10(size))) + 1 : 1;
  return fmt::format("{:.{}f}", value, std::max(0, 4 - before));
}

/// The number and unit of a quantity at model scale; "" of a bare number.
std::string at_model_scale(const run_folder::Quantity& q)
{
  constexpr Real large = 1e5;  // N, N m, J: from there on with a k
  const std::string& unit = q.unit;
  if (unit == "1") return "";
  if (unit == "m") return four_digits(1000 * q.value) + " mm  ";
  if (unit == "rad") return four_digits(q.value / degree) + " deg ";
  if (unit == "Pa") return four_digits(q.value / 1000) + " kPa ";
  const bool of_force = unit.starts_with('N') || unit.starts_with('J');
  const std::string words =
      of_force && std::abs(q.value) >= large ? four_digits(q.value / 1000) + " k" + unit : four_digits(q.value) + ' ' + unit;
  return fmt::format("{:<{}}", words, words.size() + (unit.size() < 3 ? 3 - unit.size() : 0) + 1);
}

}  // namespace

const char* unit_text(AnswerUnit unit, int force_dimension)
{
  const bool plane = force_dimension == 2;
  switch (unit) {
  case AnswerUnit::ratio:
    return "1";
  case AnswerUnit::length:
    return "m";
  case AnswerUnit::area:
    return plane ? "m" : "m2";
  case AnswerUnit::stress:
    return "Pa";
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
  const std::string words = filled(moves ? meaning + "; " + still->second : meaning, fill_) + behind_,
                    whole = prefix_ + filled(name, fill_) + ending_;
  list_.push_back({whole, value, unit_text(unit, force_dimension_), words, kind, of_});
  const auto twin = [&](const char* suffix, Real measure) {
    list_.push_back({whole + suffix, value / measure, "1", words, run_folder::QuantityKind::ratio, of_});
  };
  if (unit == AnswerUnit::force && force_dimension_ == 2 && force_ > 0) twin("_over_gammaD2", force_);
  if (unit == AnswerUnit::length && length_ > 0) twin("_over_D", length_);
}

std::vector<std::string> AnswerList::names() const
{
  std::vector<std::string> names;
  for (const run_folder::Quantity& q : list_) names.push_back(q.name);
  return names;
}

std::string AnswerList::ending_at(Real over_D)
{
  return fmt::format("_{:g}D", over_D);
}

std::string log_table(const std::vector<run_folder::Quantity>& quantities, const BodyScale& scale)
{
  using run_folder::Quantity;
  const auto ratio_of = [&](const std::string& name) {
    return std::ranges::find_if(
        quantities, [&](const Quantity& q) { return q.kind == run_folder::QuantityKind::ratio && q.name.starts_with(name + "_over_"); });
  };
  // R_end of a lift is the mean of -V over its end; V in its last row beside it would be a second number for one thing.
  const auto is_told_by_lift = [&](const std::string& name) {
    if (!name.ends_with(".V_end")) return false;
    return std::ranges::find(quantities, name.substr(0, name.size() - 5) + "R_end", &Quantity::name) != quantities.end();
  };
  std::vector<const Quantity*> shown;
  std::size_t width = 24;
  for (const Quantity& q : quantities)
    if (q.kind != run_folder::QuantityKind::ratio && !is_told_by_lift(q.name))
      shown.push_back(&q), width = std::max(width, q.name.size() + 1);
  if (shown.empty()) return "";
  const bool prototype = has_prototype(scale);
  const ForceMeasure measure = force_measure(scale);
  std::string table = fmt::format("{:<{}}{:>18}{:>16}", "", width, "model", "dimensionless");
  if (prototype) table += fmt::format("{:>20}", fmt::format("prototype ({:.4g} g)", scale.gravity_level));
  table += '\n';
  for (const Quantity* q : shown) {
    const bool force = q->unit == "N/m" || q->unit == "N", length = q->unit == "m";
    const auto ratio = ratio_of(q->name);
    const std::string bare = q->unit == "1"              ? four_digits(q->value)
                             : force && measure.size > 0 ? four_digits(q->value / measure.size)
                             : ratio != quantities.end() ? four_digits(ratio->value)
                                                         : "";
    table += fmt::format("{:<{}}{:>18}{:>16}", q->name, width, at_model_scale(*q), bare);
    const Real scaled = q->value * scale.gravity_level;
    if (prototype && q->unit == "N/m") table += fmt::format("{:>20}", four_digits(scaled / 1000) + " kN/m");
    if (prototype && length) table += fmt::format("{:>20}", four_digits(scaled) + " m   ");
    table.erase(table.find_last_not_of(' ') + 1);
    table += '\n';
  }
  if (measure.kind == ForceMeasure::Kind::strength)
    table += fmt::format("dimensionless: forces over D s_u with s_u = {}, lengths over D\n", text::stress_words(scale.strength));
  else
    table += fmt::format("dimensionless: {}lengths over D\n", measure.size > 0 ? "forces over gamma' D^2, " : "");
  return table;
}

}  // namespace berm::base
