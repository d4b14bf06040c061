// SPDX-License-Identifier: BSD-3-Clause
#include "verify_falls.hpp"

#include <algorithm>

namespace berm::verification::this_file {
namespace {

class Verify : public VerifyFalls {};

TEST_F(Verify, ends_with_0_where_all_is_met)
{
  example("fall", two_runs + claim("earth", "\"-10 m/s^2\"") + claim("light", "-5"));
  const Ended ended = verify({});
  EXPECT_EQ(ended.status, 0) << ended.out << ended.err;
  EXPECT_NE(ended.out.find("fall/earth  stone_vy_m_s acceleration  -10 m/s^2  -10 m/s^2"), std::string::npos) << ended.out;
  EXPECT_EQ(made(), (Words{"earth/", "light/"}));
}
TEST_F(Verify, ends_with_1_where_one_is_missed)
{
  example("fall", two_runs + claim("earth", "-10.01") + claim("light", "-5"));
  const Ended ended = verify({"fall"});
  EXPECT_EQ(ended.status, 1);
  EXPECT_NE(ended.out.find("MISSED"), std::string::npos);
}
TEST_F(Verify, runs_what_is_named_and_no_more)
{
  example("fall", two_runs + claim("earth", "-10") + claim("light", "-5"));
  EXPECT_EQ(verify({"fall/light"}).status, 0);
  EXPECT_EQ(made(), Words{"light/"});
  EXPECT_EQ(verify({"--fast", "examples/fall"}).status, 0);
  EXPECT_EQ(made(), (Words{"earth/", "light/"}));
}
TEST_F(Verify, takes_the_folder_in_which_it_is_started)
{
  example("fall", two_runs + claim("earth", "-10") + claim("light", "-5"));
  const Ended ended = run_program(folder_ / "examples/fall", {"verify", "."});
  EXPECT_EQ(ended.status, 0) << ended.out << ended.err;
  EXPECT_NE(ended.out.find("fall/light"), std::string::npos) << ended.out;
}
TEST_F(Verify, runs_element_tests)
{
  example("soil",
          "[run.sheared]\nelement = true\ncase = \"tests.toml\"\n[[expect]]\nrun = \"sheared\"\nquantity = \"ds.s_u\"\nexact = \"8 kPa\"\n"
          "tolerance = 1e-6\nsource = \"s_u\"\nwhy = \"rounding\"\nrequirement = \"r\"\nderived = \"d\"\n");
  folder_.write(
      "examples/soil/tests.toml",
      "[material.clay]\nlaw = \"mohr_coulomb\"\ndensity = 600\nyoung_modulus = 3e6\npoisson_ratio = 0.49\nfriction_angle = 0\ncohesion = "
      "8e3\n[[test]]\nname = \"ds\"\nkind = \"simple_shear\"\nmaterial = \"clay\"\ndrained = false\nconfining_stress = 5e4\nstrain_path "
      "= [0.05]\n");
  const Ended ended = verify({"soil"});
  EXPECT_EQ(ended.status, 0) << ended.out << ended.err;
  EXPECT_NE(ended.out.find("soil/sheared  ds.s_u    8 kPa"), std::string::npos) << ended.out;
  const std::string page = text_of_file(folder_ / "out/verification/soil.html");
  for (const char* part : {"berm element ", "simple_shear_stress_strain.png", "element.html"})
    EXPECT_NE(page.find(part), std::string::npos) << part;
}
TEST_F(Verify, lists_its_problems_and_runs_nothing)
{
  example("fall", two_runs + claim("earth", "-10") + claim("earth", "-10") + claim("light", "-5"));
  const Ended ended = verify({"--list"});
  EXPECT_EQ(ended.status, 0);
  EXPECT_NE(ended.out.find("fall/earth  fast  2        on earth"), std::string::npos) << ended.out;
  EXPECT_NE(ended.out.find("fall/light        1"), std::string::npos) << ended.out;
  EXPECT_EQ(verify({"--list", "--fast"}).out.find("light"), std::string::npos);
  EXPECT_EQ(names_in(folder_.path()), Words{"examples/"});
}
TEST_F(Verify, tells_what_is_promised_and_how_the_last_run_went)
{
  example("fall", two_runs + claim("earth", "-10") + claim("light", "-4"));
  const std::string before = verify({"--requirements"}).out;
  EXPECT_NE(before.find("fall: r\n  derived: d\n  not run: fall/earth"), std::string::npos) << before;
  EXPECT_EQ(names_in(folder_.path()), Words{"examples/"});
  EXPECT_EQ(verify({"fall"}).status, 1);
  const std::string after = verify({"--requirements"}).out;
  EXPECT_NE(after.find("  met: fall/earth"), std::string::npos) << after;
  EXPECT_NE(after.find("  MISSED: fall/light"), std::string::npos) << after;
  const std::string page = text_of_file(folder_ / "out/verification/requirements.html");
  EXPECT_NE(page.find("fall.html#earth"), std::string::npos) << page;
  EXPECT_NE(page.find("MISSED"), std::string::npos) << page;
}
TEST_F(Verify, misses_what_a_page_quotes_no_longer_and_puts_it_right_where_it_is_asked_to)
{
  const std::string quoted =
      "[[expect]]\nrun = \"light\"\ncolumn = \"stone_vy_m_s\"\nmeasure = \"acceleration\"\nquoted = \"It falls with {-4.90 m/s^2}\"\n";
  example("fall", two_runs + claim("earth", "-10") + quoted);
  const Ended without = verify({"--list"});
  EXPECT_EQ(without.status, 2);
  EXPECT_NE(without.err.find("README.md has no \"It falls with -4.90 m/s^2\""), std::string::npos) << without.err;
  folder_.write("examples/fall/README.md", "# A stone\n\nIt falls with -4.90 m/s^2.\n");
  const Ended stale = verify({"fall"});
  EXPECT_EQ(stale.status, 1) << stale.out;
  EXPECT_NE(stale.out.find("MISSED"), std::string::npos) << stale.out;
  const Ended mended = verify({"fall", "--quote"});
  EXPECT_NE(mended.err.find("is now -5.00"), std::string::npos) << mended.err;
  EXPECT_NE(text_of_file(folder_ / "examples/fall/README.md").find("It falls with -5.00 m/s^2."), std::string::npos);
  EXPECT_EQ(verify({"fall"}).status, 0);
  folder_.write("examples/fall/README.md", "It falls with -5.00 m/s^2. It falls with -5.00 m/s^2.\n");
  EXPECT_NE(verify({"fall"}).err.find("has more than one"), std::string::npos);
}
TEST_F(Verify, knows_the_nearest_name)
{
  example("fall", two_runs + claim("earth", "-10") + claim("light", "-5"));
  for (const auto& [name, says] : std::vector<std::pair<std::string, std::string>>{
           {"fal", "did you mean \"fall\"?"}, {"fall/lihgt", "did you mean \"fall/light\"?"}, {"fals/light", "did you mean \"fall\"?"}}) {
    const Ended ended = verify({name});
    EXPECT_EQ(ended.status, 2) << name;
    EXPECT_NE(ended.err.find(says), std::string::npos) << ended.err;
    EXPECT_EQ(ended.err.find('\n'), ended.err.size() - 1) << ended.err;
  }
  const Ended none = verify({"--examples", "exampels"});
  EXPECT_EQ(none.status, 2);
  EXPECT_NE(none.err.find("exampels: No such file"), std::string::npos) << none.err;
}
TEST_F(Verify, refuses_wrong_input_before_anything_runs)
{
  for (const auto& [more, says] : std::vector<std::pair<std::string, std::string>>{
           {"[run.b]\ncase = \"cave.toml\"\n", "expected.toml: run.b: examples/fall/cave.toml: there is no such file"},
           {"[run.b]\nset = [\"gravty=1\"]\n", "expected.toml: run.b: --set gravty: "},
           {"[run.b]\nfats = true\n", "expected.toml:2: run.b.fats: unknown key; did you mean \"fast\"?"}}) {
    example("fall", more + two_runs + claim("earth", "-10") + claim("light", "-5") + claim("b", "-10"));
    const Ended ended = verify({});
    EXPECT_EQ(ended.status, 2) << more;
    EXPECT_NE(ended.err.find(says), std::string::npos) << ended.err;
    EXPECT_FALSE(std::filesystem::exists(folder_ / "out")) << more;
  }
}
TEST_F(Verify, has_a_row_for_a_run_that_fails_and_goes_on)
{
  // The stone of the second run begins below the mesh.
  example("fall", std::string("[run.deep]\nset = ['body.stone.block.center=[0.5, -3]']\n") + two_runs + claim("deep", "-10") +
                      claim("earth", "-10") + claim("light", "-5") + claim("light", "-5") +
                      "[[expect]]\nrun = \"earth\"\ncolumn = \"stne_ux_m\"\nleast = 0\nsource = \"s\"\nwhy = \"w\"\nrequirement = "
                      "\"r\"\nderived = \"d\"\n");
  const Ended ended = verify({});
  EXPECT_EQ(ended.status, 1);
  std::istringstream lines(ended.out);
  std::string line;
  int failed = 0, met = 0;
  while (std::getline(lines, line)) {
    const bool fails = line.find("FAILED") != std::string::npos;
    failed += fails;
    met += line.find(" met ") != std::string::npos;
    if (!fails) continue;
    const std::string says = line.starts_with("fall/deep") ? "body.stone" : "did you mean \"stone_ux_m\"";
    EXPECT_NE(line.find(says), std::string::npos) << line;
  }
  EXPECT_EQ(failed, 2) << ended.out;
  EXPECT_EQ(met, 3) << ended.out;
}
TEST_F(Verify, writes_a_book_that_needs_no_network)
{
  example("fall", two_runs + claim("earth", "-10") + claim("light", "-5.1") +
                      "[[expect]]\nruns = [\"earth\", \"light\"]\ncolumn = \"stone_vy_m_s\"\nmeasure = \"acceleration\"\nlimit = 0\nexact "
                      "= 1\ntolerance = 1e-6\n"
                      "source = \"-10 and -5\"\nwhy = \"round-off\"\nrequirement = \"r\"\nderived = \"d\"\n");
  EXPECT_EQ(verify({}, {with_pictures()}).status, 1);
  const std::string book = "out/verification/";
  EXPECT_EQ(names_in(folder_ / "out/verification"),
            (Words{"fall.html", "fall/", "figures/", "index.html", "requirements.html", "trust.html"}));
  const std::string index = text_of_file(folder_ / (book + "index.html")), page = text_of_file(folder_ / (book + "fall.html"));
  for (const char* part :
       {"fall.html#earth", "-10 m/s^2", ">met<", ">MISSED<", "2 numbers met, 1 missed", "order of stone_vy_m_s acceleration"})
    EXPECT_NE(index.find(part), std::string::npos) << part;
  for (const char* part : {"<h1>A stone that falls</h1>", "<math", "earth: on earth", "round-off", "fall/light/history.csv",
                           "id=\"convergence\"", "berm run examples/fall/case.toml --set 'gravity=[0, -5]'"})
    EXPECT_NE(page.find(part), std::string::npos) << part;
  const std::string svg = "xmlns='http://www.w3.org/2000/svg'";  // a name that nobody fetches
  for (const std::string& text : {index, page}) {
    EXPECT_NE(text.find("\"Content-Security-Policy\" content=\"default-src 'none'; script-src 'none';"), std::string::npos);
    for (std::size_t at = 0; (at = text.find("http", at)) != std::string::npos; ++at) {
      if (text.substr(at, 10) == "http-equiv") continue;
      EXPECT_EQ(text.substr(at - std::min<std::size_t>(at, 7), svg.size()), svg);
    }
    for (std::size_t at = 0; (at = text.find(" src=\"", at)) != std::string::npos; ++at) {
      const std::string address = text.substr(at + 6, text.find('"', at + 6) - at - 6);
      EXPECT_TRUE(std::filesystem::exists(folder_ / (book + address))) << address;
    }
  }
  // A column of each run and the order.
  for (const char* name : {"fall_earth_1", "fall_light_2", "fall_convergence_3"})
    EXPECT_TRUE(std::filesystem::exists(folder_ / (book + "figures/plots/" + name + ".gp"))) << name;
}
TEST_F(Verify, that_is_interrupted_ends_its_runs_and_tells_what_is_done)
{
  const std::string endless = "[run.endless]\nset = ['stage.fall.until.time=1e6', 'gravity=[0, 0]', 'output.history_time=1']\n";
  example("fall", endless + two_runs + ends("endless") + claim("earth", "-10") + claim("light", "-5"));
  Program program(folder_.path(), {"verify", "--threads", "2"});
  ASSERT_TRUE(wait_until(
      [&] { return is_there("fall/light/summary.json") && !is_there("fall/light.messages") && is_there("fall/endless/history.csv"); }));
  std::this_thread::sleep_for(std::chrono::milliseconds(100));  // until it is known that the others have ended
  program.signal(SIGINT);
  const Ended ended = program.wait();
  EXPECT_EQ(ended.status, 75);
  EXPECT_NE(ended.err.find("interrupted: 2 of 3 problems are done"), std::string::npos) << ended.err;
  EXPECT_NE(ended.out.find("not run"), std::string::npos) << ended.out;
  EXPECT_NE(result("fall/endless/summary.json").find("\"finished\": false"), std::string::npos);
}

}  // namespace
}  // namespace berm::verification::this_file
