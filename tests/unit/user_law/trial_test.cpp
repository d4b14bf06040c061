// SPDX-License-Identifier: BSD-3-Clause
#include "user_law/trial.hpp"

#include "os/error.hpp"
#include "samples/trial_law.hpp"

#include <gtest/gtest.h>

namespace berm::user_law::this_file {
namespace {

using samples::trial_law;

const TrialStart start{3, 1e4, {0}};

TEST(Trial, takes_a_law_whose_points_know_nothing_of_each_other)
{
  for (const int dimension : {2, 3}) {
    const TrialStart here{dimension, 1e4, {0}};
    const LoadedLaw law = trial_law("berm_law");
    EXPECT_NO_THROW(refuse_failing(law, here));
    EXPECT_NO_THROW(refuse_memory(law, here));
    EXPECT_TRUE(safe_in_threads(law, here));
  }
}

TEST(Trial, refuses_a_law_that_fails_without_strain)
{
  EXPECT_THROW(refuse_failing(trial_law("fails"), start), InputError);
  EXPECT_THROW(refuse_failing(trial_law("never_content"), start), InputError);
}

TEST(Trial, refuses_a_law_that_keeps_variables_from_one_call_to_the_next)
{
  EXPECT_THROW(refuse_memory(trial_law("remembers"), start), InputError);
}

TEST(Trial, finds_a_law_that_works_in_static_memory_unsafe_in_threads_unless_they_take_turns)
{
  EXPECT_NO_THROW(refuse_memory(trial_law("works_in_static_memory"), start));
  EXPECT_FALSE(safe_in_threads(trial_law("works_in_static_memory"), start));
  EXPECT_TRUE(safe_in_threads(trial_law("works_in_static_memory", true), start));
}

template <int argument>
void umat_that_uses(double* stress, double*, double*, double*, double*, double*, double*, double*, double*, double*, const double* stran,
                    const double* dstran, const double*, const double*, const double* temp, const double*, const double*, const double*,
                    const char*, const int*, const int*, const int* ntens, const int*, const double*, const int*, const double* coords,
                    const double*, double*, const double* celent, const double*, const double* dfgrd1, const int*, const int* npt,
                    const int*, const int*, const int*, const int*, std::size_t)
{
  const double used[] = {0, stran[1], *temp, coords[0], *celent, dfgrd1[4], static_cast<double>(*npt)};
  for (int k = 0; k < *ntens; ++k) stress[k] += 1e7 * dstran[k] * (1 + used[argument]);
}

template <int argument>
std::string refusal()
{
  const LoadedLaw law(Umat{umat_that_uses<argument>}, {"clay", {}, 0}, "the law", true);
  try {
    refuse_unknown_arguments(law, {2, 1e4, {}});
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(Trial, refuses_a_umat_that_uses_what_berm_does_not_know)
{
  EXPECT_EQ(refusal<0>(), "");
  EXPECT_EQ(refusal<1>().find("the law uses STRAN, the total strain, which berm does not give it"), 0u) << refusal<1>();
  EXPECT_EQ(refusal<2>().find("the law uses TEMP"), 0u);
  EXPECT_EQ(refusal<3>().find("the law uses COORDS"), 0u);
  EXPECT_EQ(refusal<4>().find("the law uses CELENT"), 0u);
  EXPECT_EQ(refusal<5>().find("the law uses DFGRD0 or DFGRD1"), 0u);
  EXPECT_EQ(refusal<6>().find("the law uses NOEL or NPT"), 0u);
}

}  // namespace
}  // namespace berm::user_law::this_file
