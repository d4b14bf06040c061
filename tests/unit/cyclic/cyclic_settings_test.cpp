// SPDX-License-Identifier: BSD-3-Clause
#include "cyclic/cyclic_settings.hpp"
#include "os/error.hpp"
#include "samples/error_of.hpp"
#include "samples/temporary_folder.hpp"

#include <gtest/gtest.h>

namespace berm::cyclic::this_file {
namespace {

constexpr const char* table =
    "shear_strain (%),average_stress_ratio,cycles,cyclic_stress_ratio\n3,0,1,0.8\n3,0,100,0.4\n15,0,1,1.2\n15,0,100,0.6\n";
constexpr const char* contours = "[contours]\ntable = \"contours.csv\"\n";
constexpr const char* storm = "[storm]\ncycles = [20, 50, 1]\nload = [0.5, 0.2, 0.7]\n";

class CyclicSettings : public testing::Test {
protected:
  CyclicCase read(const std::string& toml, const std::string& csv = table, const std::vector<std::string>& set = {})
  {
    folder_.write("contours.csv", csv);
    return read_cyclic_case(folder_.write("storm.toml", toml), set);
  }
  /// Without the folder.
  std::string fault(const std::string& toml, const std::string& csv = table, const std::vector<std::string>& set = {})
  {
    std::string error = test::error_of<InputError>([&] { read(toml, csv, set); });
    const std::string path = folder_.path().string() + "/";
    for (std::size_t at = error.find(path); at != std::string::npos; at = error.find(path)) error.erase(at, path.size());
    return error;
  }
  /// Of a table whose third line of numbers is this.
  std::string fault_of_row(const std::string& row)
  {
    return fault(std::string(contours) + storm,
                 "shear_strain (%),average_stress_ratio,cycles,cyclic_stress_ratio\n3,0,1,0.8\n3,0,100,0.4\n" + row +
                     "\n15,0,1,1.2\n15,0,100,0.6\n");
  }

  TemporaryFolder folder_;
};

TEST_F(CyclicSettings, sort_the_parcels_and_divide_their_loads_by_the_capacity)
{
  const auto loads = [](const CyclicCase& c) {
    std::vector<Real> all;
    for (const Parcel& parcel : c.parcels()) all.push_back(parcel.stress), all.push_back(parcel.cycles);
    return all;
  };
  EXPECT_EQ(loads(read(std::string(contours) + storm)), (std::vector<Real>{0.2, 50, 0.5, 20, 0.7, 1}));
  EXPECT_EQ(loads(read(std::string(contours) + storm + "order = \"given\"\n")), (std::vector<Real>{0.5, 20, 0.2, 50, 0.7, 1}));
  EXPECT_EQ(loads(read(std::string(contours) + "[storm]\ncycles = [3]\nload = [\"1.2 kN/m\"]\nstatic_capacity = \"2400 N/m\"\n")),
            (std::vector<Real>{0.5, 3}));
}

TEST_F(CyclicSettings, read_contours_with_their_unit_and_find_that_of_failure)
{
  const CyclicCase c = read(std::string(contours) + storm);
  EXPECT_EQ(c.failure, 1u);
  EXPECT_NEAR(c.diagram.strains()[0], 0.03, 1e-15);
  EXPECT_NEAR(c.diagram.stress(1, 10), 0.9, 1e-12);
  EXPECT_EQ(read(std::string(contours) + "failure = 0.03\n" + storm).failure, 0u);
  const std::string pore = "pore_pressure_ratio;average_stress_ratio;cycles;cyclic_stress_ratio\n0,6;0;1;1,2\n0,6;0;100;0,6\n";
  EXPECT_EQ(read(std::string(contours) + "of = \"pore_pressure_ratio\"\n" + storm, pore).diagram.strains(), std::vector<Real>{0.6});
}

TEST_F(CyclicSettings, refuse_a_wrong_table_with_its_line)
{
  EXPECT_EQ(fault_of_row("15,0,1,x"), "contours.csv:4: \"x\" in column \"cyclic_stress_ratio\" is not a finite number");
  EXPECT_EQ(fault_of_row("3,0,100,0.3"), "contours.csv:4: the cycles of a contour must ascend");
  EXPECT_EQ(fault_of_row("3,0,200,0.5"), "contours.csv:4: the stress of a contour must not increase with the number of cycles");
  EXPECT_EQ(fault_of_row("15,0,1,1.2\n3,0,200,0.3"), "contours.csv:5: the rows of a contour at an average stress must be consecutive");
  EXPECT_EQ(fault_of_row("3,0,0.5,0.9"), "contours.csv:4: cycles = 0.5 is less than 1");
  EXPECT_EQ(fault_of_row("3,7,1,0.9"), "contours.csv:4: average_stress_ratio = 7 is not from 0 to 2");
  EXPECT_EQ(fault_of_row("3,0.2,1,90"), "contours.csv:4: cyclic_stress_ratio = 90 is not from 0 to 5");
  EXPECT_EQ(fault_of_row("300,0,1,0.9"),
            "contours.csv:4: shear_strain = 3 is not more than 0 and at most 1; in per cent write the heading shear_strain (%)");
  const std::string whole = std::string(contours) + storm;
  EXPECT_EQ(fault(whole, "shear_strain,average_stress_ratio,cycles\n0.15,0,1\n0.15,0,10\n"),
            "contours.csv:2: a row of a contour needs average_stress_ratio, cycles and cyclic_stress_ratio");
  EXPECT_EQ(fault(whole, "shear_strain,average_stress_ratio,N,cyclic_stress_ratio\n0.15,0,1,1\n0.15,0,10,1\n"),
            "contours.csv:1: \"N\" is not a column of contours (allowed: average_stress_ratio, cycles, cyclic_stress_ratio); other units "
            "are written "
            "likewise, as in cm_s");
  EXPECT_EQ(fault(whole, "gamma,cycles\n1,1\n1,2\n"),
            "contours.csv:1: the first column is the quantity of the contours, \"shear_strain\", and not \"gamma\"");
  EXPECT_EQ(fault("[contours]\ntable = \"nothing.csv\"\n" + std::string(storm)).rfind("storm.toml:2: contours.table: nothing.csv: ", 0),
            0u);
}

TEST_F(CyclicSettings, refuse_what_does_not_fit_together_with_file_line_and_key)
{
  const std::string whole = std::string(contours) + storm;
  EXPECT_EQ(fault(whole, table, {"storm.average_load=0.4"}),
            "storm.toml:2: contours.table: the average stress is 0.4 s_u, and the contour of 0.03 is known from 0 to 0 s_u");
  EXPECT_EQ(fault(whole + "failure = 1\n").rfind("storm.toml:6: storm.failure: ", 0), 0u) << fault(whole + "failure = 1\n");
  EXPECT_EQ(fault(std::string(contours) + "failure = 0.1\n" + storm),
            "storm.toml:3: contours.failure: there is no contour of 0.1; those of the table are 0.03, 0.15");
  EXPECT_EQ(fault(std::string(contours) + "[storm]\ncycles = [20]\nload = [0.5, 0.2]\n"),
            "storm.toml:5: storm.load: has 2 loads, and storm.cycles 1 numbers: one of each for a parcel");
  EXPECT_EQ(fault(std::string(contours) + "[storm]\ncycles = [20, 0]\nload = [0.5, 0.2]\n")
                .rfind("storm.toml:4: storm.cycles[1]: must be from 1 to ", 0),
            0u);
  EXPECT_EQ(fault(std::string(contours) + "[storm]\ncycles = [20]\nload = [\"1 kN/m\"]\n"),
            "storm.toml:3: storm.static_capacity: is needed where loads have a unit");
  EXPECT_EQ(fault(std::string(contours) + "[storm]\ncycles = [20]\nload = [\"1 kN/m\"]\nstatic_capacity = 2\n"),
            "storm.toml:6: storm.static_capacity: of these loads some have a unit and some have none: give all with it, or all as ratios");
  EXPECT_NE(
      fault("[material.sand]\nlaw = \"mohr_coulomb\"\ndensity = 1000\nyoung_modulus = 1e6\npoisson_ratio = 0.3\nfriction_angle = \"30 "
            "deg\"\n" +
            whole)
          .find("material.sand.law: has no undrained strength to multiply: take \"clay\", \"ngi_adp\", or \"mohr_coulomb\" without "
                "friction_angle"),
      std::string::npos);
}

}  // namespace
}  // namespace berm::cyclic::this_file
