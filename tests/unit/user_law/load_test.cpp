// SPDX-License-Identifier: BSD-3-Clause
#include "user_law/load.hpp"

#include "io/sha256.hpp"
#include "material/user_law.hpp"
#include "os/error.hpp"

#include <gtest/gtest.h>

namespace berm::user_law::this_file {
namespace {

using OwnLaw = material::UserLaw<material::Interface::own>;

settings::Case case_with(const std::string& symbol)
{
  OwnLaw law;
  law.density = 2000;
  law.young_modulus = 1e7;
  law.poisson_ratio = 0.25;
  law.library = BERM_TRIAL_LAWS;
  law.symbol = symbol;
  law.properties = {1e7, 0.25};
  law.state_variables = 1;
  settings::Case c;
  c.material = {{"clay", law}};
  return c;
}

OwnLaw& law_of(settings::Case& c)
{
  return c.material[0].second.get<OwnLaw>();
}

std::string refusal_of(settings::Case c)
{
  try {
    load(c);
  } catch (const KeyError& error) {
    return error.what();
  }
  return "";
}

TEST(Load, makes_a_law_that_can_be_called_and_notes_its_library)
{
  settings::Case c = case_with("");
  EXPECT_THROW(prepare(law_of(c)), std::logic_error);
  load(c);
  EXPECT_EQ(law_of(c).library_sha256, io::sha256_of_file(BERM_TRIAL_LAWS));
  EXPECT_EQ(library_hashes(c).size(), 1u);
  EXPECT_EQ(library_hashes(c)[0].second, law_of(c).library_sha256);
  SymTensor<2> stress;
  Real calls = 0;
  update(prepare(law_of(c)), stress, material::Increment<2, Real>{{{0, -1e-3, 0, 0}}, 1}, &calls);
  EXPECT_NEAR(stress[1], -1.2e4, 1e-8);
  EXPECT_EQ(calls, 1);
  EXPECT_NO_THROW(throw_failures(c));
}

TEST(Load, refuses_another_library_than_the_run_began_with)
{
  settings::Case c = case_with("");
  law_of(c).library_sha256 = std::string(64, '0');
  EXPECT_EQ(refusal_of(c).find("material.clay.library: "), 0u);
  EXPECT_NE(refusal_of(c).find("does not have the SHA-256 0000"), std::string::npos);
}

TEST(Load, names_the_key_of_what_it_refuses)
{
  EXPECT_EQ(refusal_of(case_with("no_such")).find("material.clay.symbol: "), 0u);
  EXPECT_EQ(refusal_of(case_with("fails")).find("material.clay.library: a trial without strain fails: the law \"user\" of [material.clay]"),
            0u);
  settings::Case c = case_with("");
  law_of(c).library = "/no/such/law.so";
  EXPECT_EQ(refusal_of(c), "material.clay.library: there is no /no/such/law.so; build it first");
}

TEST(Load, tells_of_a_law_that_fails_later_until_that_is_forgotten)
{
  settings::Case c = case_with("not_a_number");
  load(c);
  SymTensor<2> stress;
  Real calls = 0;
  update(prepare(law_of(c)), stress, material::Increment<2, Real>{{}, 1, 0.5}, &calls);
  EXPECT_THROW(throw_failures(c), RunError);
  forget_failures(c);
  EXPECT_NO_THROW(throw_failures(c));
}

}  // namespace
}  // namespace berm::user_law::this_file
