// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "record/run_record.hpp"
#include "text/html.hpp"

#include <functional>

namespace berm::base {

/// The sections of docs/how_to/what_will_catch_you.md that limits are of.
enum class Effect {
  dilation,
  cells,
  contact_width,
  walls,
  drive_speed,
  energy,
  balance,
  shaking,
  noise,
  contact,
  volume_bounds,
  short_travel,
  count
};

/// The heading of that section.
const char* heading_of(Effect effect);

/// What a measure that is not good makes of the resistance, where that is known.
enum class Sense { unknown, too_large, too_small };

/// Up to which value something is good, beyond which it is bad, of which effect it is, and why just there. With `large` it is the other way round: good from `good`
/// on, bad below `bad`.
struct Limit {
  Real good, bad;
  Effect effect;
  const char* reason;
  bool large = false;
  Sense sense = Sense::unknown;
};

/// The limit of a measure whose sense is known.
constexpr Limit too_large(Limit limit)
{
  limit.sense = Sense::too_large;
  return limit;
}
constexpr Limit too_small(Limit limit)
{
  limit.sense = Sense::too_small;
  return limit;
}

/// How a value stands; unknown where it is NaN.
text::Standing judge(const Limit& limit, Real value);

/// What is said of a value that is not good, as a sentence without its full stop: a text in which {} stands for the value in the words of its measure, or made.
struct Warning {
  using Made = std::function<std::string(const record::RunRecord&, Real)>;

  Warning() = default;
  Warning(const char* words) : text(words) {}
  Warning(std::string words) : text(std::move(words)) {}
  template <std::convertible_to<Made> Function>
  Warning(Function function) : made(std::move(function))
  {
  }

  std::string text{};
  Made made{};
};

/// One thing that shows whether a run can be trusted.
struct TrustMeasure {
  std::string what;
  const Limit* limit;  ///< null: it is stated, not judged
  std::function<bool(const record::RunRecord&)> applies;
  std::function<Real(const record::RunRecord&)> value;
  std::function<std::string(const record::RunRecord&, Real)> words;  ///< of a value that is known
  Warning warning;                                                   ///< where it is not good
  std::string (*limit_words)(Real);                                  ///< a limit in the unit of the value
  bool of_cells = false;  ///< whether it judges if cells are fine enough where no body of a width is driven

  std::string warning_of(const record::RunRecord& run, Real of) const;
};
using TrustMeasures = std::vector<TrustMeasure>;

/// Measures one after the other.
TrustMeasures joined(std::initializer_list<TrustMeasures> parts);

/// A measure that applies to every run.
bool always(const record::RunRecord& run);

/// A value as a part of one in per cent, or bare with two digits that count; a bare limit.
std::string in_percent(const record::RunRecord& run, Real value);
std::string as_number(const record::RunRecord& run, Real value);
std::string bare_limit(Real value);

}  // namespace berm::base
