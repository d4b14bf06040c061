// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/describe.hpp"
#include "core/types.hpp"
#include "study/rank_correlation.hpp"
#include "study/study_axis.hpp"

#include <cstdint>
#include <vector>

namespace berm::study {

enum class DistributionKind { uniform, triangular, normal, lognormal };
inline const std::vector<const char*> distribution_words = {"uniform", "triangular", "normal", "lognormal"};

constexpr Real low_share = 0.05, high_share = 0.95;  ///< of all values: those below the low estimate, and below the high one

/// A distribution by its estimates, in SI units. Uniform from low to high; triangular from low to high with its peak at best; of the others 5 % of all values lie below low, a half
/// below best, and 95 % below high.
struct Distribution {
  DistributionKind kind = DistributionKind::lognormal;
  Real low = 0, high = 0;
  std::optional<Real> best;      ///< absent: the middle of low and high, of a lognormal one the middle of their logarithms
  std::optional<Real> min, max;  ///< no value lies beyond
  std::string unit;              ///< as any_unit of a parameter
};
void describe(Describe& d, Distribution& distribution);

/// Says at `path` what does not fit together.
void check(Describe& d, const std::string& path, const Distribution& distribution);

/// The value below which the share p of all values lies, 0 < p < 1. Normal and lognormal (of the logarithm y): y = best + (high - best) z(p) / z(0.95) above best, with
/// best - low below it, z the quantile of the standard normal distribution; where min or max is given, p is the share of what is left between them.
Real quantile(const Distribution& distribution, Real p);

/// (1 + erf(z / sqrt 2)) / 2: the share of the standard normal distribution below z.
Real standard_normal_share(Real z);

/// z with (1 + erf(z / sqrt 2)) / 2 = p, to 1e-14; at most 9 in size.
Real standard_normal_quantile(Real p);

/// A number that is not known well, and the keys that it sets.
struct SampleParameter {
  std::string name;
  std::vector<std::string> keys;             ///< each gets the number itself
  std::map<std::string, std::string> times;  ///< each gets its quantity times the number, which is bare
  Distribution distribution;
};

/// A Latin hypercube of parameters, beside runs with all of them at their medians and with one of them at its 5 % and 95 % value.
struct StudySample {
  int size = 0, seed = 1;
  std::vector<SampleParameter> parameter;
  std::vector<std::string> seeds = {};  ///< keys that get another whole number in each row
  std::vector<SampleCorrelation> correlation = {};
};

void describe(Describe& d, SampleParameter& parameter);
void describe(Describe& d, StudySample& sample);
/// Says at [sample] what does not fit together.
void check(Describe& d, const StudySample& sample);

/// The axis of a sample: the value "best", then "NAME low" and "NAME high" of each parameter, then the rows of the sample, "1", "2", ... A sample of seeds alone has but the rows. Numbers have six
/// digits, so that they are the same wherever exp and log differ in their last bits.
StudyAxis sample_axis(const StudySample& sample);

/// The rows of the sample as a table that read_table reads.
std::string samples_csv(const StudyAxis& axis);

/// A Latin hypercube: shares between 0 and 1 by parameter, then row. Those of a parameter have one in each n-th part of the way, at a random place in it, and the
/// parts are in random order:
///
///   p_k = (order_k + u_k) / n
///
/// The numbers come from std::mt19937_64, whose bits the C++ standard prescribes, parameter by parameter: first the order (each item from the last on swapped with
/// one not behind it), then the u. So the rows are the same on every machine, and a parameter that is added at the end leaves those before it as they are.
/// (McKay, Beckman and Conover, 1979.)
std::vector<std::vector<Real>> latin_hypercube(std::size_t parameters, std::size_t rows, std::uint64_t seed);

}  // namespace berm::study
