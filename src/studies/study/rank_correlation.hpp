// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/describe.hpp"

#include <vector>

namespace berm::study {

/// Two parameters of a sample that rise or fall together.
struct SampleCorrelation {
  std::vector<std::string> parameters;  ///< names of two
  Real rank = 0;                        ///< Spearman's, from -1 to 1
};
void describe(Describe& d, SampleCorrelation& correlation);

/// Refuses at [sample] what is no pair of these names, and rank correlations that no sample of so many rows can have together.
void check(Describe& d, const std::vector<SampleCorrelation>& correlations, const std::vector<std::string>& names, int rows);

/// The same shares of each parameter in another order, in which the parameters have these rank correlations, to the accuracy of a sample. [Iman and Conover, A distribution-free approach to inducing
/// rank correlation among input variables, Communications in Statistics B11 (1982)]
///
/// Scores Phi^-1(place/(n+1)) stand for the shares. With their correlation T = Q Q^T and that of the scores that is asked for, C = P P^T, C = 2 sin(pi rank/6), the rows of scores S become
/// S Q^-T P^T, and each parameter takes the order of its column. The first keeps its order.
std::vector<std::vector<Real>> with_rank_correlations(std::vector<std::vector<Real>> shares,
                                                      const std::vector<SampleCorrelation>& correlations,
                                                      const std::vector<std::string>& names);

/// The places of values in order, from 0; equal ones have the mean of theirs.
std::vector<Real> places_of(const std::vector<Real>& values);

/// Spearman's rank correlation, from -1 to 1: the correlation of the places that the pairs have in order of x and in order of y; equal ones share their places.
/// NaN with fewer than three pairs or where x or y does not vary.
Real rank_correlation(const std::vector<Real>& x, const std::vector<Real>& y);

}  // namespace berm::study
