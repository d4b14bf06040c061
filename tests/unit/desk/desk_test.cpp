// SPDX-License-Identifier: BSD-3-Clause
// A desk from outside: cases, runs and their results over real sockets.
#include "samples/desk_client.hpp"
#include "samples/small_cases.hpp"

#include <gtest/gtest.h>
#include <numbers>

namespace berm::desk::this_file {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

class DeskTest : public testing::Test {
protected:
  DeskTest()
  {
    fs::create_directories(folder_ / "bay");
    std::ofstream(folder_ / "bay/case.toml") << test::small_case;
    desk_.emplace(folder_.path(), std::vector<std::string>{"--threads", "1"});
  }
  /// Waits for the state of a run.
  bool becomes(const std::string& run, const std::string& state) const
  {
    return wait_until([&] { return status_of(run) == state; });
  }
  std::string status_of(const std::string& run) const { return desk_->get("/api/run?path=" + run).json().value("status", ""); }
  void write_long_case() const { std::ofstream(folder_ / "bay/long.toml") << long_case(); }
  /// A minute of computing: the drag is a thousand times slower.
  static std::string long_case()
  {
    const std::string velocity = "velocity = \"1 m/s\"";
    std::string text = test::small_case;
    return text.replace(text.rfind(velocity), velocity.size(), "velocity = \"1 mm/s\"");
  }

  TemporaryFolder folder_;
  std::optional<DeskClient> desk_;
};

TEST_F(DeskTest, lists_reads_and_writes_cases)
{
  const Json contents = desk_->get("/api/folder?path=bay").json();
  ASSERT_EQ(contents.at("cases").size(), 1u) << contents;
  EXPECT_EQ(contents.at("cases")[0].at("path"), "bay/case.toml");
  const Json read = desk_->get("/api/case?path=bay/case.toml").json();
  EXPECT_EQ(read.at("text"), test::small_case);
  const Json written =
      desk_->put("/api/case?path=bay/case.toml", {{"text", "title = \"bay\"\n"}, {"modified", read.at("modified")}}).json();
  EXPECT_EQ(text_of_file(folder_ / "bay/case.toml"), "title = \"bay\"\n");
  EXPECT_EQ(desk_->get("/api/folder?path=bay").json().at("cases")[0].at("title"), "bay");
  // Somebody else writes: the next one is refused, and nothing is lost.
  std::ofstream(folder_ / "bay/case.toml") << "theirs";
  EXPECT_EQ(desk_->put("/api/case?path=bay/case.toml", {{"text", "ours"}, {"modified", written.at("modified")}}).status, 409);
  EXPECT_EQ(text_of_file(folder_ / "bay/case.toml"), "theirs");
  EXPECT_EQ(desk_->put("/api/case?path=new/case.toml", {{"text", "new"}}).status, 200);
  EXPECT_EQ(text_of_file(folder_ / "new/case.toml"), "new");
}

TEST_F(DeskTest, runs_a_case_and_gives_its_rows)
{
  const std::string run = desk_->post("/api/runs", {{"case", "bay/case.toml"}}).json().value("path", "");
  EXPECT_EQ(run, "out/bay/case");
  ASSERT_TRUE(becomes(run, "finished")) << desk_->get("/api/run?path=" + run).body;
  const Json whole = desk_->get("/api/run?path=" + run).json();
  ASSERT_GT(whole.at("rows").size(), 10u);
  EXPECT_EQ(whole.at("columns")[0].at("name"), "time_s");
  EXPECT_EQ(whole.at("columns").size(), whole.at("rows")[0].size());
  EXPECT_EQ(whole.at("progress"), 1);
  EXPECT_TRUE(whole.at("summary").at("checks").at("finished"));
  const Json rest = desk_->get(fmt::format("/api/run?path={}&from_row={}", run, whole.at("rows").size() - 3)).json();
  EXPECT_EQ(rest.at("rows"), Json(whole.at("rows").end() - 3, whole.at("rows").end()));
  // Its folder is not used again.
  EXPECT_EQ(desk_->post("/api/runs", {{"case", "bay/case.toml"}}).json().at("path"), "out/bay/case_2");
  ASSERT_TRUE(becomes("out/bay/case_2", "finished"));
  const Json soil = desk_->get("/api/run/soil?path=" + run).json();
  ASSERT_GT(soil.at("x").size(), 10u);
  EXPECT_EQ(soil.at("x").size(), soil.at("y").size());
  EXPECT_FALSE(soil.at("rigids").empty());
  EXPECT_EQ(desk_->get(fmt::format("/api/run/soil?path={}&after={}", run, soil.at("frame").get<int>())).status, 204);
  EXPECT_EQ(desk_->get("/api/file?path=" + run + "/history.csv").body, text_of_file(folder_ / run / "history.csv"));
}

TEST_F(DeskTest, fits_a_soil_to_the_tests_beside_its_input)
{
  fs::copy_file(fs::path(BERM_SOURCE_DIR) / "tests/docs/tests.csv", folder_ / "bay/tests.csv");
  std::ofstream(folder_ / "bay/fit.toml") << "[material.sand]\nlaw = \"mohr_coulomb\"\ndensity = 1000\nyoung_modulus = 2e7\npoisson_ratio "
                                             "= 0.3\nfriction_angle = \"30 deg\"\n[[free]]\nkey = "
                                             "\"friction_angle\"\nfrom = \"20 deg\"\nto = \"45 deg\"\n[[free]]\nkey = "
                                             "\"young_modulus\"\nfrom = \"1 MPa\"\nto = \"100 MPa\"\n[[measured]]\nname = \"lab\"\nfile = "
                                             "\"tests.csv\"\ntest = \"test\"\nkind = \"triaxial\"\ndrained = true\n";
  EXPECT_EQ(desk_->get("/api/folder?path=bay").json().at("tests").size(), 1u);
  const std::string job = desk_->post("/api/fit", {{"path", "bay/fit.toml"}}).json().value("job", "");
  EXPECT_EQ(job, "out/fit/bay/fit");
  ASSERT_TRUE(wait_until([&] { return fs::exists(folder_ / job / "summary.json"); })) << desk_->get("/api/jobs").body;
  EXPECT_NEAR(Json::parse(text_of_file(folder_ / job / "summary.json"))["quantities"]["friction_angle"]["value"].get<double>() * 180 /
                  std::numbers::pi,
              33, 0.5);
}

TEST_F(DeskTest, follows_a_storm_on_the_contours_beside_its_input)
{
  std::ofstream(folder_ / "bay/contours.csv")
      << "shear_strain,average_stress_ratio,cycles,cyclic_stress_ratio\n0.15,0,1,1\n0.15,0,100,0.6\n";
  std::ofstream(folder_ / "bay/storm.toml") << "[contours]\ntable = \"contours.csv\"\n[storm]\ncycles = [10]\nload = [0.4]\n";
  EXPECT_EQ(desk_->get("/api/folder?path=bay").json().at("tests").size(), 1u);
  const std::string job = desk_->post("/api/cyclic", {{"path", "bay/storm.toml"}}).json().value("job", "");
  ASSERT_TRUE(wait_until([&] { return fs::exists(folder_ / job / "summary.json"); })) << desk_->get("/api/jobs").body;
  EXPECT_NEAR(Json::parse(text_of_file(folder_ / job / "summary.json"))["quantities"]["strength_factor"]["value"].get<double>(), 0.8, 1e-6);
}

TEST_F(DeskTest, queues_stops_and_resumes_runs_which_outlive_it)
{
  write_long_case();
  const std::string first = desk_->post("/api/runs", {{"case", "bay/long.toml"}}).json().value("path", ""),
                    second = desk_->post("/api/runs", {{"case", "bay/case.toml"}}).json().value("path", "");
  EXPECT_EQ(status_of(second), "queued");
  ASSERT_TRUE(wait_until([&] { return fs::exists(folder_ / first / "history.csv"); }));
  EXPECT_EQ(status_of(first), "running");
  EXPECT_EQ(desk_->post("/api/runs/stop", {{"path", first}}).status, 200);
  ASSERT_TRUE(becomes(first, "stopped")) << desk_->get("/api/run?path=" + first).body;
  ASSERT_TRUE(becomes(second, "finished"));
  EXPECT_EQ(desk_->post("/api/runs", {{"resume", first}}).status, 200);
  ASSERT_TRUE(becomes(first, "running"));
  ASSERT_TRUE(wait_until([&] { return fs::exists(folder_ / first / "lock"); }));
  desk_->program().signal(SIGINT);
  EXPECT_EQ(desk_->program().wait().status, 0);
  EXPECT_TRUE(fs::exists(folder_ / first / "lock"));
  // Another desk finds it, though it began elsewhere, and stops it.
  const DeskClient other(folder_.path());
  const auto status = [&] { return other.get("/api/run?path=" + first).json().value("status", ""); };
  EXPECT_EQ(status(), "running");
  EXPECT_FALSE(other.get("/api/run?path=" + first).json().at("began_here"));
  EXPECT_EQ(other.post("/api/runs/stop", {{"path", first}}).status, 200);
  EXPECT_TRUE(wait_until([&] { return status() == "stopped"; }));
  EXPECT_EQ(other.get("/api/runs").json().size(), 2u);
}

TEST_F(DeskTest, says_why_a_run_died_and_whether_it_can_go_on)
{
  write_long_case();
  const std::string stopped = desk_->post("/api/runs", {{"case", "bay/long.toml"}}).json().value("path", "");
  ASSERT_TRUE(wait_until([&] { return fs::exists(folder_ / stopped / "history.csv"); }));
  desk_->post("/api/runs/stop", {{"path", stopped}});
  ASSERT_TRUE(becomes(stopped, "stopped"));
  Json run = desk_->get("/api/run?path=" + stopped).json();
  EXPECT_TRUE(run.at("can_resume"));
  EXPECT_NE(run.value("why", "").find("stopped at t = "), std::string::npos) << run.value("why", "");
  // The same folder, as an error would have left it.
  std::ofstream(folder_ / stopped / "run.log", std::ios::app) << "2026-11-28 12:00:00 the pipe leaves the mesh\n";
  run = desk_->get("/api/run?path=" + stopped).json();
  EXPECT_EQ(run.value("why", ""), "the pipe leaves the mesh");
  EXPECT_FALSE(run.at("can_resume"));
  EXPECT_EQ(run.at("status"), "failed");
  // Killed: nothing was written of why.
  fs::remove(folder_ / stopped / "summary.json");
  run = desk_->get("/api/run?path=" + stopped).json();
  EXPECT_NE(run.value("why", "").find("killed"), std::string::npos);
  EXPECT_TRUE(run.at("can_resume"));
}

TEST_F(DeskTest, a_new_case_takes_the_strength_of_a_sounding)
{
  // q_t of clay with s_u = 3 kPa + 1.5 kPa/m z and N_kt = 14, in the water of 16 kN/m3 of soil.
  std::string table = "depth_m,q_t_MPa\n";
  for (double z = 0.1; z < 4; z += 0.1) table += fmt::format("{:.2f},{:.5f}\n", z, (16 * z + 14 * (3 + 1.5 * z)) / 1000);
  const auto create = [&](const std::string& path, const Json& cpt, const std::string& location = "") {
    return desk_->post("/api/new", {{"kind", "pipe-in-clay"}, {"path", path}, {"cpt", cpt}, {"location", location}});
  };
  const Response written = create("bay/cpt.toml", {{"name", "C:/north/KP 12.csv"}, {"text", table}});
  ASSERT_EQ(written.status, 200) << written.body;
  const std::string text = desk_->get("/api/case?path=bay/cpt.toml").json().value("text", "");
  EXPECT_NE(text.find("KP_12.csv"), std::string::npos) << text;
  EXPECT_NE(text.find("profile"), std::string::npos);
  EXPECT_EQ(text.find("/KP_12.csv"), std::string::npos) << "where the file lay for a moment is nothing to the reader";
  EXPECT_TRUE(written.json().at("doubts").is_array());

  const Response wrong = create("bay/none.toml", {{"name", "x.csv"}, {"text", "depth_m,q_t_MPa\n1,two\n"}});
  EXPECT_EQ(wrong.status, 422);
  EXPECT_TRUE(wrong.json().value("error", "").starts_with("x.csv")) << wrong.body;
  EXPECT_EQ(create("bay/none.toml", {{"name", "x.csv"}, {"text", table}}, "--help").status, 422) << "a location of a table";
  EXPECT_EQ(create("bay/none.toml", {{"name", "--help"}, {"text", table}}).status, 400);
  EXPECT_EQ(create("bay/none.toml", {{"name", ".."}, {"text", table}}).status, 400);
  EXPECT_EQ(create("bay/none.toml", "x.csv").status, 400);
  EXPECT_FALSE(fs::exists(folder_ / "bay/none.toml"));
}

TEST_F(DeskTest, says_why_a_run_failed)
{
  std::ofstream(folder_ / "bay/wrong.toml") << test::small_case << "\n[nonsense]\n";
  const std::string run = desk_->post("/api/runs", {{"case", "bay/wrong.toml"}}).json().value("path", "");
  ASSERT_TRUE(becomes(run, "failed"));
  const Json failed = desk_->get("/api/run?path=" + run).json();
  EXPECT_NE(failed.at("log_tail").get<std::string>().find("nonsense"), std::string::npos);
  EXPECT_NE(failed.value("why", "").find("nonsense"), std::string::npos) << failed.value("why", "");
  EXPECT_FALSE(failed.at("can_resume"));
}

}  // namespace
}  // namespace berm::desk::this_file
