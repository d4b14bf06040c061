// SPDX-License-Identifier: BSD-3-Clause
#include "samples/error_of.hpp"
#include "samples/temporary_folder.hpp"
#include "soil_fit/measured.hpp"
#include "soil_fit/usual_fit.hpp"

#include <gtest/gtest.h>

namespace berm::soil_fit::this_file {
namespace {

constexpr const char* sand =
    "[material.soil]\nlaw = \"norsand\"\ndensity = 1000\ncritical_friction_angle = \"31 deg\"\ncritical_void_ratio = 0.9\n"
    "critical_line_slope = 0.03\nvolumetric_coupling = 0.3\ndilatancy = 3\nhardening_modulus = 100\nvoid_ratio = 0.72\nrigidity = 300\n"
    "poisson_ratio = 0.2\nmax_pressure = \"2 MPa\"\n[[free]]\nkey = \"dilatancy\"\nfrom = 1.5\nto = 6\n";
constexpr const char* drained_triaxial = "[[measured]]\nname = \"lab\"\nfile = \"tests.csv\"\nkind = \"triaxial\"\ndrained = true\n";

class MeasuredTests : public testing::Test {
protected:
  std::vector<MeasuredTest> tests(const std::string& csv, const std::string& more = "", const std::string& kind = drained_triaxial)
  {
    folder_.write("tests.csv", csv);
    return read_measured(read_fit_text("case.toml", sand + kind + more, folder_.path()));
  }
  /// Without the folder.
  std::string fault(const std::string& csv, const std::string& more = "", const std::string& kind = drained_triaxial)
  {
    std::string error = test::error_of<InputError>([&] { tests(csv, more, kind); });
    const std::string path = folder_.path().string() + "/";
    for (std::size_t at = error.find(path); at != std::string::npos; at = error.find(path)) error.erase(at, path.size());
    return error;
  }

  TemporaryFolder folder_;
};

TEST_F(MeasuredTests, have_units_by_their_headings)
{
  for (const char* csv :
       {"axial_strain_percent,q_kPa,p_kPa\n0,0,100\n1,150,150\n", "axial_strain (%);q (kPa);p (kPa)\n0;0;100\n1,0;150,0;150,0\n",
        "# of a laboratory\naxial_strain [1],q [MPa],p [Pa]\n0,0,100000\n0.01,0.15,150000\n"}) {
    const std::vector<MeasuredTest> found = tests(csv);
    ASSERT_EQ(found.size(), 1u) << csv;
    EXPECT_EQ(found[0].name, "lab");
    EXPECT_DOUBLE_EQ(found[0].driven[1], -std::log(0.99)) << "strains of a laboratory are over the length at the start";
    EXPECT_DOUBLE_EQ(found[0].curves[0].values[1], 150e3);
    EXPECT_DOUBLE_EQ(found[0].held[1], 100e3) << "p less q/3";
    EXPECT_DOUBLE_EQ(element::start_of(found[0].settings.kind).horizontal(), 100e3);
  }
}

TEST_F(MeasuredTests, are_named_by_a_column_and_have_keys_of_their_own)
{
  const std::vector<MeasuredTest> found =
      tests("id,e1,dev,sig3,e\nA,0.1,1,50,0.7\nA,1.1,60,52,0.698\nB,0,0,200,0.8\nB,2,300,200,0.81\nC,0,0,100,0.9\nC,1,90,100,0.9\n",
            "test = \"id\"\ntests = [\"A\", \"B\"]\nheld_out = [\"B\"]\nspecimen = {void_ratio = \"e\"}\ncolumns = {axial_strain = \"e1 "
            "(%)\", q = "
            "\"dev (kPa)\", lateral_stress = \"sig3 (kPa)\", void_ratio = \"e\"}\n");
  ASSERT_EQ(found.size(), 2u);
  EXPECT_FALSE(found[0].held_out);
  EXPECT_TRUE(found[1].held_out);
  EXPECT_DOUBLE_EQ(found[0].specimen.at("void_ratio"), 0.7);
  EXPECT_DOUBLE_EQ(found[0].driven[0], 0) << "from the first row";
  EXPECT_NEAR(found[0].driven[1], -std::log(1 - 0.011) + std::log(1 - 0.001), 1e-15);
  EXPECT_DOUBLE_EQ(found[0].held[1], 52e3);
  EXPECT_DOUBLE_EQ(element::start_of(found[0].settings.kind).vertical(), 51e3);
  ASSERT_EQ(found[1].curves.size(), 2u);
  EXPECT_NEAR(found[1].curves[1].values[1], std::log(1.8 / 1.81), 1e-15) << "it dilates";
}

TEST_F(MeasuredTests, of_oedometers_go_by_their_stress)
{
  const std::vector<MeasuredTest> found = tests("vertical_stress (kPa),void_ratio\n10,0.80\n100,0.77\n400,0.74\n100,0.745\n", "k0 = 0.5\n",
                                                "[[measured]]\nname = \"lab\"\nfile = \"tests.csv\"\nkind = \"oedometer\"\n");
  EXPECT_TRUE(found[0].by_stress());
  EXPECT_DOUBLE_EQ(found[0].driven[2], 400e3);
  EXPECT_NEAR(found[0].curves[0].values[2], std::log(1.8 / 1.74), 1e-15);
}

TEST_F(MeasuredTests, that_are_wrong_get_one_message)
{
  const char* rest = "0,0,100\n10,150,150\n";
  EXPECT_EQ(fault(std::string("axial_strain,q_kPa,p_kPa\n") + rest),
            "tests.csv: the column \"axial_strain\" has no unit: measured.lab.columns = {axial_strain = \"axial_strain (%)\"}");
  EXPECT_EQ(fault(std::string("axial_strain_1,q_kPa,p_kPa\n") + rest),
            "tests.csv:3: axial_strain in the column \"axial_strain_1\" is 10, which no specimen strains by: is its unit %?");
  EXPECT_EQ(fault("axial_strain_percent,q_kPa,p_kPa\n0,0,100\n-10,150,150\n"),
            "tests.csv:3: axial_strain in the column \"axial_strain_percent\" reaches -0.1: compression is positive; with direction = "
            "\"extension\" extension is positive");
  EXPECT_EQ(fault("axial_strain_percent,q_kPa,p_kPa\n0,0,-100\n10,150,-150\n"),
            "tests.csv:2: p in the column \"p_kPa\" is -1e+05 Pa: stresses are effective, and compression is positive");
  EXPECT_EQ(fault("axial_strain_percent,q_Pa,p_kPa\n0,0,100\n10,50,150\n"),
            "tests.csv:3: q in the column \"q_Pa\" is 50 Pa at most, which is not a stress of a test of soil: is its unit right?");
  EXPECT_EQ(
      fault("axial_strain_percent,dev_kPa,p_kPa\n0,0,100\n10,150,150\n"),
      "tests.csv: no column is q (vertical less lateral stress), or stress_ratio (vertical divided by lateral effective stress): name it, "
      "measured.lab.columns = {q = \"HEADING (UNIT)\"}; its headings are axial_strain_percent, dev_kPa, p_kPa");
  EXPECT_EQ(fault("axial_strain_percent,q_kPa\n0,0\n10,150\n"),
            "tests.csv:2: the stress at the start is not known: give confining_stress, or vertical_stress and k0, of measured.lab");
  EXPECT_EQ(fault("axial_strain_percent,q_kPa,p_kPa\n0,0,100\n10,many,150\n"),
            "tests.csv:3: \"many\" in the column \"q_kPa\" is not a number");
  EXPECT_EQ(fault("axial_strain_percent,q_kPa,p_kPa,volumetric_strain_percent,void_ratio\n0,0,100,0,0.7\n10,150,150,2,0.75\n"),
            "tests.csv:3: volumetric_strain in the column \"volumetric_strain_percent\" and void_ratio in the column \"void_ratio\" have "
            "opposite "
            "signs: compression is positive, and makes the void ratio smaller");
  EXPECT_EQ(fault("axial_strain_percent,q_kPa,p_kPa\n0,0,100\n10,150,150\n", "tests = [\"A\"]\n"),
            "tests.csv: measured.lab: there is no test \"A\" (allowed: lab)");
}

TEST_F(MeasuredTests, in_extension_are_positive_where_they_lengthen)
{
  const std::vector<MeasuredTest> found = tests("axial_strain (%),q (kPa),p (kPa)\n0,20,100\n10,-60,80\n", "direction = \"extension\"\n");
  EXPECT_DOUBLE_EQ(found[0].driven[1], std::log(1.1));
  EXPECT_NEAR(as_measured(found[0], found[0].driven[1]), 0.1, 1e-15);
  EXPECT_NE(fault("axial_strain (%),q (kPa),p (kPa)\n0,20,100\n10,60,80\n", "direction = \"extension\"\n")
                .find("in extension q, vertical less lateral stress, decreases"),
            std::string::npos);
}

TEST_F(MeasuredTests, that_go_to_and_fro_are_on_both_sides)
{
  const std::vector<MeasuredTest> found =
      tests("axial_strain (%),q (kPa),p (kPa)\n0,0,100\n1,40,90\n-1.5,-50,80\n", "",
            "[[measured]]\nname = \"lab\"\nfile = \"tests.csv\"\nkind = \"triaxial\"\ndrained = false\n");
  EXPECT_DOUBLE_EQ(found[0].driven[2], -std::log(1.015));
  EXPECT_DOUBLE_EQ(found[0].curves[0].values[2], -50e3);
}

TEST_F(MeasuredTests, by_a_mean_stress_are_isotropic)
{
  const std::vector<MeasuredTest> found = tests("p (kPa),volumetric_strain (%)\n0,0\n50,0\n100,0.5\n200,1.1\n", "",
                                                "[[measured]]\nname = \"lab\"\nfile = \"tests.csv\"\nkind = \"isotropic\"\n");
  EXPECT_EQ(found[0].rows(), 3u) << "without the row that is not loaded";
  EXPECT_DOUBLE_EQ(found[0].driven[0], 50e3);
  EXPECT_NEAR(found[0].curves[0].values[2], -std::log(1 - 0.011), 1e-15);
}

TEST_F(MeasuredTests, of_several_specimens_need_the_column_that_names_them)
{
  EXPECT_EQ(
      fault("specimen,axial_strain (%),q (kPa),p (kPa)\nA,0,0,100\nA,1,150,150\nB,0,0,200\nB,1,300,300\n"),
      "tests.csv:4: the strain begins again here, where the column specimen changes: several tests are named by it, measured.lab.test = "
      "\"specimen\"");
  EXPECT_NE(
      fault("axial_strain (%),q (kPa),p (kPa),e0\n0,0,100,0.7\n1,150,150,0.7\n", "specimen = {void_ration = \"e0\"}\n").find("void_ration"),
      std::string::npos);
}

TEST_F(MeasuredTests, need_a_key_that_the_soil_has)
{
  const auto fault_of = [&](const std::string& free) {
    return test::error_of<InputError>([&] { read_fit_text("case.toml", sand + ("[[free]]\n" + free) + drained_triaxial, folder_.path()); });
  };
  EXPECT_EQ(fault_of("key = \"dilatance\"\nfrom = 1\nto = 2\n").substr(0, 120),
            "case.toml: free.dilatance: [material.soil] has no such key, whose value is where the search begins; did you mean \"dilata");
  EXPECT_EQ(fault_of("key = \"rigidity\"\nfrom = 400\nto = 900\n"),
            "case.toml: free.rigidity: the material has 300, which is not within its bounds, 400 to 900");
  EXPECT_EQ(fault_of("key = \"critical_friction_angle\"\nfrom = \"20 kPa\"\nto = \"45 kPa\"\n"),
            "case.toml: free.critical_friction_angle: its bounds need the dimension of the material's \"31 deg\"");
}

/// Increments of an oedometer, and a stage each of a drained and an undrained triaxial test at failure.
constexpr const char* ags = R"("GROUP","CONS"
"HEADING","LOCA_ID","SAMP_TOP","SPEC_DPTH","CONS_INCN","CONS_INCF","CONS_INCE"
"UNIT","","m","m","","kPa",""
"TYPE","ID","2DP","2DP","X","0DP","3DP"
"DATA","BH1","3.00","3.10","1","25","0.951"
"DATA","BH1","3.00","3.10","2","50","0.912"
"DATA","BH1","3.00","3.10","3","100","0.860"

"GROUP","TREG"
"HEADING","LOCA_ID","SAMP_TOP","SPEC_DPTH","TREG_TYPE"
"UNIT","","m","m",""
"TYPE","ID","2DP","2DP","PA"
"DATA","BH1","3.00","3.20","CD"
"DATA","BH1","5.00","5.10","CU"

"GROUP","TRET"
"HEADING","LOCA_ID","SAMP_TOP","SPEC_DPTH","TRET_TESN","TRET_CONP","TRET_PWPI","TRET_STRN","TRET_DEVF","TRET_PWPF","TRET_STV"
"UNIT","","m","m","","kPa","kPa","%","kPa","kPa","%"
"TYPE","ID","2DP","2DP","X","0DP","0DP","1DP","0DP","0DP","2DP"
"DATA","BH1","3.00","3.20","1","100","300","8.0","236","300","-1.2"
"DATA","BH1","5.00","5.10","1","150","300","10.0","120","390",""
)";

TEST_F(MeasuredTests, of_AGS_are_increments_and_failures)
{
  folder_.write("lab.ags", ags);
  const auto tests_of = [&](const std::string& kind) {
    return read_measured(read_fit_text("case.toml", sand + ("[[measured]]\nname = \"lab\"\nfile = \"lab.ags\"\n" + kind), folder_.path()));
  };
  const std::vector<MeasuredTest> oedometer = tests_of("kind = \"oedometer\"\nk0 = 0.6\n");
  ASSERT_EQ(oedometer.size(), 1u);
  EXPECT_EQ(oedometer[0].name, "BH1/3.10");
  EXPECT_DOUBLE_EQ(oedometer[0].driven[2], 100e3);
  EXPECT_NEAR(oedometer[0].curves[0].values[2], std::log(1.951 / 1.86), 1e-12);
  const std::vector<MeasuredTest> drained = tests_of("kind = \"triaxial\"\ndrained = true\n"),
                                  undrained = tests_of("kind = \"triaxial\"\ndrained = false\n");
  ASSERT_EQ(drained.size(), 1u);
  ASSERT_EQ(undrained.size(), 1u);
  EXPECT_EQ(drained[0].name, "BH1/3.20/1");
  EXPECT_DOUBLE_EQ(drained[0].held[1], 100e3);
  EXPECT_DOUBLE_EQ(drained[0].curves[0].values[1], 236e3);
  EXPECT_NEAR(drained[0].curves[1].values[1], -std::log(1.012), 1e-12);
  EXPECT_DOUBLE_EQ(undrained[0].curves[1].values[1], 150e3 + 40e3 - 90e3) << "p' by the pore pressure";
  EXPECT_NE(
      test::error_of<InputError>([&] { tests_of("kind = \"simple_shear\"\ndrained = false\n"); }).find("oedometer and triaxial tests"),
      std::string::npos);
}

TEST_F(MeasuredTests, of_a_law_alone_get_usual_numbers_and_bounds)
{
  folder_.write("tests.csv", "test,axial_strain_percent,q_kPa,p_kPa,void_ratio\nA,0,0,100,0.7\nA,1,150,150,0.69\n");
  for (const std::string& law : usual_laws()) {
    UsualFit request{law, {folder_ / "tests.csv"}};
    request.undrained = law == "clay" || law == "ngi_adp";
    const FitCase c = read_fit_text("case.toml", usual_fit(request), folder_.path());
    EXPECT_GE(c.free.size(), 2u) << law;
    EXPECT_EQ(read_measured(c)[0].name, "A") << law;
  }
  EXPECT_EQ(test::error_of<InputError>([&] {
              usual_fit({"nosand", {folder_ / "tests.csv"}});
            }).substr(0, 116),
            "\"nosand\" is neither an input of berm fit (FILE.toml) nor a law that it knows usual numbers of; did you mean \"norsand");
}

}  // namespace
}  // namespace berm::soil_fit::this_file
