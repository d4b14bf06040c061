// SPDX-License-Identifier: BSD-3-Clause
#include "samples/program.hpp"
#include "samples/temporary_folder.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace berm::commands::this_file {
namespace {

/// Of a sand of 33 deg that does not change its volume: q = 2.39 sigma_3.
constexpr const char* tests = "test,axial_strain (%),q (kPa),p (kPa),volumetric_strain "
                              "(%)\nA,0,0,100,0\nA,0.2,60,120,0.12\nA,1,236,178.7,0.3\nA,3,240,180,0.28\nA,5,238,179.3,0.31\n"
                              "B,0,0,200,0\nB,0.2,80,226.7,0.13\nB,1,410,336.7,0.55\nB,3,479,359.7,0.6\nB,5,478,359.3,0.63\n";

class FitCommand : public testing::Test {
protected:
  FitCommand() { folder_.write("tests.csv", tests); }
  Ended fit(std::vector<std::string> words)
  {
    words.insert(words.begin(), "fit");
    return run_program(folder_.path(), words);
  }
  TemporaryFolder folder_;
};

TEST_F(FitCommand, of_a_law_and_its_tests_leaves_an_input_that_gives_the_same)
{
  const Ended ended = fit({"mohr_coulomb", "tests.csv"});
  EXPECT_EQ(ended.status, 0) << ended.err;
  EXPECT_NE(ended.out.find("friction_angle"), std::string::npos);
  EXPECT_NE(ended.err.find("the page is out/tests/fit.html"), std::string::npos) << ended.err;
  EXPECT_EQ(fit({"out/tests/case.toml", "-o", "again"}).status, 0);
  const auto quantities = [&](const std::string& of) {
    return nlohmann::json::parse(text_of_file(folder_ / (of + "/summary.json")))["quantities"];
  };
  const double phi = quantities("out/tests")["friction_angle"]["value"];
  EXPECT_NEAR(phi * 180 / pi, 33, 0.5);
  EXPECT_EQ(quantities("again")["friction_angle"]["value"], phi);
}

TEST_F(FitCommand, replaces_results_with_force_alone)
{
  EXPECT_EQ(fit({"mohr_coulomb", "tests.csv", "-o", "here"}).status, 0);
  const Ended again = fit({"mohr_coulomb", "tests.csv", "-o", "here"});
  EXPECT_EQ(again.status, 2);
  EXPECT_NE(again.err.find("here holds the results of a fit: replace them with --force"), std::string::npos) << again.err;
  EXPECT_EQ(fit({"mohr_coulomb", "tests.csv", "-o", "here", "--force"}).status, 0);
  folder_.write("notes", "");
  EXPECT_NE(fit({"mohr_coulomb", "tests.csv", "-o", ".", "--force"}).err.find("holds files that are not of berm fit"), std::string::npos);
}

TEST_F(FitCommand, with_senseless_words_says_what_is_wanted)
{
  const auto fault = [&](const std::vector<std::string>& words) { return fit(words).err; };
  EXPECT_EQ(fault({"norsand"}), "berm: what is norsand to be fitted to? berm fit norsand TESTS.csv\n");
  EXPECT_EQ(fault({"clay", "tests.csv"}), "berm: clay is a law of undrained clay: berm fit clay TESTS.csv --undrained\n");
  folder_.write("library.toml", "[material.soil]\nlaw = \"user\"\nlibrary = \"law.so\"\nsymbol = \"law\"\ndensity = 1000\nyoung_modulus = "
                                "2e7\npoisson_ratio = 0.3\n[[free]]\nkey = "
                                "\"young_modulus\"\nfrom = 1e6\nto = 1e8\n[[measured]]\nname = \"lab\"\nfile = \"tests.csv\"\ntest = "
                                "\"test\"\nkind = \"triaxial\"\ndrained = true\n");
  EXPECT_EQ(fault({"library.toml"}),
            "berm: material.soil.law: a law from a library has a list of properties, which has no keys to fit: fit one of berm's laws\n");
  EXPECT_NE(fault({"norsant", "tests.csv"}).find("did you mean \"norsand\"?"), std::string::npos);
  EXPECT_EQ(fault({"mohr_coulomb", "nothing.csv"}).rfind("berm: nothing.csv: ", 0), 0u) << fault({"mohr_coulomb", "nothing.csv"});
}

}  // namespace
}  // namespace berm::commands::this_file
