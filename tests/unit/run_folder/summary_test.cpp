// SPDX-License-Identifier: BSD-3-Clause
#include "run_folder/summary_file.hpp"

#include "samples/run_to_write.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <regex>

namespace berm::run_folder::this_file {
namespace {

Summary sample_summary()
{
  Summary summary;
  summary.quantities = {{"V_at_w_0.1D", 764.25, "N/m"}, {"H_max", std::numeric_limits<Real>::quiet_NaN(), "N/m"}};
  summary.force_measure = {"gammaD2", 172, "N/m", "γ′ D²"};
  summary.timing = {.wall_s = 12.5,
                    .processors_s = 24,
                    .parts = {.steps = 11, .rows = 0.5, .frames = 0.25, .checkpoints = 0.125, .beside = 3},
                    .threads = 2,
                    .cells = 800,
                    .steps = 5'000'000'000,
                    .counts = MpmCounts{9000},
                    .loops = {{"move", 1.5, 7}},
                    .memory = {4e8, 5e8, 3e8}};
  summary.checks = {{"reached_the_end", true}, {"energy_balance", 0.01}};
  summary.text = {{"title", "a \"pipe\""}, {"berm", "0.1.0"}};
  summary.invalid = {"energy does not balance"};
  return summary;
}

TEST(Summary, has_the_form_that_readers_rely_on)
{
  const TemporaryFolder folder;
  sample_summary().write(folder.path() / "summary.json");
  const auto json = nlohmann::json::parse(content_of(folder.path() / "summary.json"));
  EXPECT_EQ(json["quantities"]["V_at_w_0.1D"]["value"].get<double>(), 764.25);
  EXPECT_EQ(json["quantities"]["V_at_w_0.1D"]["unit"], "N/m");
  EXPECT_EQ(json["force_measure"]["name"], "gammaD2");
  EXPECT_EQ(json["force_measure"]["value"].get<double>(), 172);
  EXPECT_EQ(json["force_measure"]["unit"], "N/m");
  EXPECT_EQ(json["timing"]["particle_steps_per_s"].get<double>(), 3.6e12);
  EXPECT_EQ(json["timing"]["particles"].get<int>(), 9000);
  EXPECT_EQ(json["timing"]["wall_s"].get<double>(), 12.5);
  EXPECT_EQ(json["timing"]["threads"].get<int>(), 2);
  EXPECT_EQ(json["timing"]["steps"].get<std::int64_t>(), 5'000'000'000);
  EXPECT_DOUBLE_EQ(json["timing"]["seconds_per_step"].get<double>(), 2.5e-9);
  EXPECT_EQ(json["timing"]["loops"][0]["label"], "move");
  EXPECT_EQ(json["timing"]["ranks"].get<int>(), 3);
  for (const auto& [name, seconds] : {std::pair{"steps_s", 11.},
                                      {"rows_s", 0.5},
                                      {"frames_s", 0.25},
                                      {"checkpoints_s", 0.125},
                                      {"beside_s", 3.},
                                      {"processors_s", 24.}}) {
    EXPECT_EQ(json["timing"][name].get<double>(), seconds) << name;
    EXPECT_STREQ(unit_of_timing(name), "s");
  }
  EXPECT_EQ(json["timing"]["memory_bytes"].get<double>(), 5e8);
  EXPECT_EQ(json["checks"]["reached_the_end"], true);
  EXPECT_EQ(json["checks"]["energy_balance"].get<double>(), 0.01);
  EXPECT_EQ(json["text"]["title"], "a \"pipe\"");
  EXPECT_EQ(json["invalid"], nlohmann::json::parse(R"(["energy does not balance"])"));
}

bool is_check_or_timing(const std::string& name)
{
  const std::vector<std::string> names = check_and_timing_names();
  return std::find(names.begin(), names.end(), name) != names.end();
}

// Some checks stand only in the summary of a run that has what they are of: the sources tell all.
TEST(CheckNames, are_those_that_the_methods_write)
{
  const std::filesystem::path simulation = std::filesystem::path(BERM_SOURCE_DIR) / "src/run/simulation";
  const std::regex check(R"re((?:\{|emplace_back\()"([a-z_]+)",)re");
  int count = 0;
  for (const char* file : {"mpm_method.cpp", "fem_method.cpp", "cell_watch.cpp"}) {
    const std::string text = content_of(simulation / file);
    for (std::sregex_iterator found(text.begin(), text.end(), check), end; found != end; ++found, ++count)
      EXPECT_TRUE(is_check_or_timing((*found)[1])) << (*found)[1];
  }
  EXPECT_EQ(count, 28) << "two of them are checks of both methods";
  EXPECT_TRUE(is_check_or_timing("finished"));
}

TEST(TimingNames, are_those_of_the_summary)
{
  Summary of_elements = sample_summary();
  of_elements.timing.counts = FemCounts{.nodes = 700, .iterations = 60};
  for (const Summary& summary : {sample_summary(), of_elements}) {
    const auto json = nlohmann::json::parse(summary.json());
    for (const auto& [name, value] : json["timing"].items()) EXPECT_TRUE(name == "loops" || is_check_or_timing(name)) << name;
  }
  EXPECT_FALSE(is_check_or_timing("loops")) << "is not a number";
}

TEST(Summary, of_finite_elements_counts_nodes_and_iterations_and_no_particles)
{
  Summary summary = sample_summary();
  summary.timing.counts = FemCounts{.nodes = 700, .iterations = 60};
  summary.timing.memory = {nan};
  const auto timing = nlohmann::json::parse(summary.json())["timing"];
  EXPECT_EQ(timing["nodes"].get<int>(), 700);
  EXPECT_EQ(timing["iterations"].get<int>(), 60);
  EXPECT_EQ(timing["cells"].get<int>(), 800);
  EXPECT_EQ(timing["wall_s"].get<double>(), 12.5);
  EXPECT_EQ(timing["loops"].size(), 1u);
  for (const char* name : {"particle_steps_per_s", "particles", "memory_bytes"}) EXPECT_FALSE(timing.contains(name)) << name;
}

TEST(Summary, a_number_that_is_not_there_is_null_and_the_file_stays_json)
{
  Summary summary = sample_summary();
  summary.text.emplace_back("broken", "\xff");
  const auto json = nlohmann::json::parse(summary.json());
  EXPECT_TRUE(json["quantities"]["H_max"]["value"].is_null());
}

TEST(Summary, empty_has_all_its_parts)
{
  const auto json = nlohmann::json::parse(Summary{}.json());
  for (const char* part : {"quantities", "timing", "checks"}) EXPECT_TRUE(json[part].is_object()) << part;
}

TEST(Summary, is_read_as_it_was_written)
{
  const TemporaryFolder folder;
  EXPECT_FALSE(read_summary(folder.path()).has_value());
  Summary written = sample_summary();
  written.write(folder.path() / "summary.json");
  RunSummary read = read_summary(folder.path()).value();
  ASSERT_EQ(read.quantities.size(), 2u);
  EXPECT_EQ(read.quantities[0].name, "V_at_w_0.1D");
  EXPECT_EQ(read.quantities[0].value, 764.25);
  EXPECT_EQ(read.quantities[0].unit, "N/m");
  EXPECT_TRUE(std::isnan(read.quantities[1].value));
  EXPECT_EQ(read.timing["wall_s"], 12.5);
  EXPECT_EQ(read.timing["steps"], 5e9);
  EXPECT_EQ(read.checks["reached_the_end"], 1);
  EXPECT_EQ(read.checks["energy_balance"], 0.01);
  EXPECT_EQ(read.text["title"], "a \"pipe\"");
  EXPECT_FALSE(read.finished());
  for (const bool finished : {false, true}) {
    written.checks = {{"finished", finished}};
    written.write(folder.path() / "summary.json");
    EXPECT_EQ(read_summary(folder.path())->finished(), finished);
  }
}

/// What reading says behind the file's name; "" where it is taken.
std::string refusal_of(const std::string& text)
{
  const TemporaryFolder folder;
  const std::filesystem::path file = folder.path() / "summary.json";
  std::ofstream(file, std::ios::binary) << text;
  try {
    read_summary(folder.path());
  } catch (const RunError& error) {
    const std::string said = error.what();
    EXPECT_EQ(said.find(file.string()), 0u) << said;
    return said.substr(std::min(said.size(), file.string().size()));
  }
  return "";
}

TEST(Summary, that_is_damaged_is_refused_with_the_reason)
{
  EXPECT_EQ(refusal_of(""), " is damaged: byte 1 is not JSON");
  EXPECT_EQ(refusal_of("[]"), " is damaged: it is not a table");
  EXPECT_EQ(refusal_of("{}"), " is damaged: it has no \"quantities\"");
  const std::string rest = R"(, "timing": {}, "checks": {}, "text": {}})";
  EXPECT_EQ(refusal_of(R"({"quantities": {})" + rest), "");
  EXPECT_EQ(refusal_of(R"({"quantities": 5)" + rest), " is damaged: \"quantities\" is not a table");
  EXPECT_EQ(refusal_of(R"({"quantities": {"V": 5})" + rest), " is damaged: a value in \"quantities\" is not a table");
  EXPECT_EQ(refusal_of(R"({"quantities": {"V": {"unit": "N"}})" + rest), " is damaged: it has no \"value\"");
  EXPECT_EQ(refusal_of(R"({"quantities": {"V": {"value": "5", "unit": "N"}})" + rest),
            " is damaged: a value in \"quantities\" is not a number");
  EXPECT_EQ(refusal_of(R"({"quantities": {"V": {"value": 5, "unit": 1}})" + rest), " is damaged: a value in \"quantities\" is not a text");
  EXPECT_EQ(refusal_of(R"({"quantities": {"V": {"value": 1e999, "unit": "N"}})" + rest), " is damaged: a number in it is too large");
  EXPECT_EQ(refusal_of(R"({"quantities": {}, "timing": {"wall_s": []}, "checks": {}, "text": {}})"),
            " is damaged: a value in \"timing\" is not a number");
  EXPECT_EQ(refusal_of(R"({"quantities": {}, "timing": {}, "checks": {"finished": "true"}, "text": {}})"),
            " is damaged: a value in \"checks\" is not a number");
  EXPECT_EQ(refusal_of(R"({"quantities": {}, "timing": {}, "checks": {}, "text": {"title": null}})"),
            " is damaged: a value in \"text\" is not a text");
  // Its texts go into decks of other programs.
  for (const char* text : {R"("date": "2026\n/SYS,touch x")", R"("\u001b[2J": "")", R"("case": "a\u0085b")"})
    EXPECT_EQ(refusal_of(fmt::format(R"({{"quantities": {{}}, "timing": {{}}, "checks": {{}}, "text": {{{}}}}})", text)),
              " is damaged: a text in it holds a control character");
  EXPECT_EQ(refusal_of(std::string(5'000'000, '[')), " is damaged: byte 5000001 is not JSON");
  EXPECT_EQ(refusal_of(std::string(4'000'000, '[') + std::string(4'000'000, ']')), " is damaged: it is not a table");
  EXPECT_EQ(refusal_of(std::string(10'000'001, ' ')), ": is longer than 10000000 bytes, the maximum");
}

TEST(Summary, that_is_cut_is_never_taken)
{
  const std::string whole = sample_summary().json();
  for (std::size_t length = 0; length + 2 < whole.size(); ++length) EXPECT_NE(refusal_of(whole.substr(0, length)), "") << length;
  EXPECT_EQ(refusal_of(whole), "");
}

TEST(Summary, that_is_no_file_cannot_be_read)
{
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder.path() / "summary.json");
  EXPECT_THROW(read_summary(folder.path()), RunError);
}

TEST(Summary, quantities_keep_their_order)
{
  const std::string text = sample_summary().json();
  EXPECT_LT(text.find("V_at_w_0.1D"), text.find("H_max"));
}

}  // namespace
}  // namespace berm::run_folder::this_file
