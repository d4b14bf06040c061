// SPDX-License-Identifier: BSD-3-Clause
#include "os/error.hpp"
#include "samples/error_of.hpp"
#include "samples/temporary_folder.hpp"
#include "sea/sea_settings.hpp"

#include <gtest/gtest.h>

namespace berm::sea::this_file {
namespace {

constexpr const char* wind = "[sea]\nspectrum = \"jonswap\"\nsignificant_height = \"4.5 m\"\npeak_period = \"10 s\"\ndepth = \"30 m\"\n";
constexpr const char* rest =
    "[pipe]\ndiameter = \"0.25 m\"\nsubmerged_weight = \"400 N/m\"\ndrag = 0.9\ninertia = 3.29\nlift = 0.9\n[bed]\nfriction = 0.6\n";

class SeaSettings : public testing::Test {
protected:
  SeaCase read(const std::string& toml, const std::vector<std::string>& set = {})
  {
    return read_sea_case(folder_.write("sea.toml", toml), set);
  }
  /// Without the folder.
  std::string fault(const std::string& toml, const std::vector<std::string>& set = {})
  {
    std::string error = test::error_of<InputError>([&] { read(toml, set); });
    const std::string path = folder_.path().string() + "/";
    for (std::size_t at = error.find(path); at != std::string::npos; at = error.find(path)) error.erase(at, path.size());
    return error;
  }
  TemporaryFolder folder_;
};

TEST_F(SeaSettings, have_a_peakedness_by_steepness_where_none_is_given)
{
  const SeaCase c = read(std::string(wind) + rest);
  EXPECT_NEAR(c.peakedness, std::exp(5.75 - 1.15 * 10 / std::sqrt(4.5)), 1e-12);
  EXPECT_NEAR(formulas::height_of(*c.spectrum), 4.5, 1e-9);
  EXPECT_EQ(read(std::string(wind) + rest, {"sea.peakedness=2"}).peakedness, 2);
  EXPECT_EQ(read(std::string(wind) + rest, {"sea.spectrum=\"pierson_moskowitz\""}).peakedness, 1);
}

TEST_F(SeaSettings, take_a_spectrum_in_hertz)
{
  folder_.write("spectrum.csv", "frequency_Hz,density\n0.05,0\n0.1,20\n0.2,0\n");
  const SeaCase c = read("[sea]\nspectrum = \"table\"\ntable = \"spectrum.csv\"\ndepth = \"30 m\"\n" + std::string(rest));
  EXPECT_NEAR(formulas::height_of(*c.spectrum), 4 * std::sqrt(0.15 * 20 / 2), 1e-4);
  EXPECT_NEAR(c.spectrum->peak(), 2 * pi * 0.1, 1e-12);
}

TEST_F(SeaSettings, say_what_is_wrong_with_a_sea)
{
  const std::string all = std::string(wind) + rest;
  EXPECT_NE(fault(all, {"sea.depth=\"5 m\""}).find("such waves break"), std::string::npos) << fault(all, {"sea.depth=\"5 m\""});
  EXPECT_NE(fault(all, {"sea.peak_period=\"3 s\""}).find("too steep"), std::string::npos) << fault(all, {"sea.peak_period=\"3 s\""});
  EXPECT_NE(fault(all, {"sea.depth=\"2 km\""}).find("the waves do not reach the seabed"), std::string::npos);
  EXPECT_NE(fault(all, {"pipe.diameter=250"}).find("at most 10 m"), std::string::npos) << fault(all, {"pipe.diameter=250"});
  EXPECT_NE(fault(all, {"record.step=\"3 s\""}).find("does not resolve the waves"), std::string::npos);
  EXPECT_NE(fault(all, {"bed.trench_depth=\"1 m\""}).find("from 5 to 45 deg"), std::string::npos);
  EXPECT_NE(fault(all, {"pipe.embedment=\"1 m\""}).find("more than the diameter"), std::string::npos);
  EXPECT_NE(fault(all, {"pipe.weight=1"}).find("submerged_weight"), std::string::npos) << fault(all, {"pipe.weight=1"});
}

TEST_F(SeaSettings, say_what_is_wrong_with_a_spectrum)
{
  const std::string all = "[sea]\nspectrum = \"table\"\ntable = \"spectrum.csv\"\ndepth = \"30 m\"\n" + std::string(rest);
  const auto fault_of = [&](const std::string& rows) {
    folder_.write("spectrum.csv", "frequency_Hz,density\n" + rows);
    return fault(all);
  };
  EXPECT_NE(fault_of("0,1\n0.1,2\n").find("spectrum.csv:2"), std::string::npos) << fault_of("0,1\n0.1,2\n");
  EXPECT_NE(fault_of("0.1,1\n0.1,2\n").find("frequencies must ascend"), std::string::npos);
  EXPECT_NE(fault_of("0.1,1\n0.2,-2\n").find("is negative"), std::string::npos);
  EXPECT_NE(fault_of("0.1,0\n0.2,0\n").find("every density is 0"), std::string::npos);
}

}  // namespace
}  // namespace berm::sea::this_file
