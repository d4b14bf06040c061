// SPDX-License-Identifier: BSD-3-Clause
#include "verification/trust_page.hpp"

#include "verify_falls.hpp"

namespace berm::verification::this_file {
namespace {

TrustQuestion question(Real error, text::Standing standing)
{
  return {"fall/earth", "fall", "earth", "a", "1", error, {standing, {}, {"a < b."}}};
}

TEST(trust_page, right_ones_may_not_be_called_bad_and_wrong_ones_not_good)
{
  for (const auto& [error, standing, misjudged] :
       {std::tuple(0.04, text::Standing::good, false), std::tuple(0.04, text::Standing::fair, false),
        std::tuple(-0.04, text::Standing::bad, true), std::tuple(0.07, text::Standing::bad, false),
        std::tuple(0.07, text::Standing::good, false), std::tuple(-0.12, text::Standing::good, true),
        std::tuple(0.12, text::Standing::fair, false), std::tuple(0.12, text::Standing::bad, false)})
    EXPECT_EQ(question(error, standing).is_misjudged(), misjudged) << error;
}

TEST(trust_page, misjudged_runs_come_first)
{
  TrustQuestion worse = question(0.3, text::Standing::bad), misjudged = question(-0.2, text::Standing::good);
  worse.problem = "worse", misjudged.problem = "misjudged";
  const std::string page = trust_page({worse, misjudged});
  EXPECT_LT(page.find("misjudged<"), page.find("worse<")) << page;
  EXPECT_NE(page.find("of 2 wrong ones 1 are rated good"), std::string::npos) << page;
  EXPECT_NE(page.find("a &lt; b."), std::string::npos) << page;
}

class TrustOfFalls : public VerifyFalls {};

TEST_F(TrustOfFalls, asks_of_numbers_that_are_known)
{
  example("fall", two_runs + claim("earth", "-10") + claim("light", "-6") + ends("light"));
  const Ended ended = verify({});
  EXPECT_NE(ended.out.find("2 runs whose answer is known: of 1 right ones 0 are rated bad, of 1 wrong ones 1 are rated good"),
            std::string::npos)
      << ended.out;
  EXPECT_NE(result("index.html").find("trust.html"), std::string::npos);
  EXPECT_NE(result("trust.html").find("fall.html#light"), std::string::npos);
  example("fall", two_runs + ends("earth") + ends("light"));
  EXPECT_NE(verify({}).out.find("0 runs whose answer is known"), std::string::npos);
}

}  // namespace
}  // namespace berm::verification::this_file
