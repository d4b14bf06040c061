// SPDX-License-Identifier: BSD-3-Clause
// What `berm report`, `berm study` and `berm verify` read of a run folder. The first byte of an input says which file the rest is: h history.csv,
// s summary.json, l run.log, p frames.pvd. A damaged file is told of, or refused with RunError or InputError.
#include "target.hpp"

#include "jobs/jobs.hpp"
#include "report/expectations/expectations_section.hpp"
#include "report/page/page.hpp"
#include "report/quality/quality_section.hpp"
#include "report/results/results_section.hpp"
#include "run_folder/frame_reader.hpp"
#include "run_folder/history.hpp"
#include "structures/structures.hpp"

#include <sstream>

using namespace berm;

namespace {

namespace fs = std::filesystem;

constexpr const char* settings = R"(gravity = [0, -490]
mesh = {kind = "box", size = [1, 1], cells = [2, 2]}
material.sand = {law = "mohr_coulomb", density = 900, young_modulus = 7e6, poisson_ratio = 0.25, friction_angle = 0.6}
body.sand = {material = "sand", regions = ["box"]}
rigid.pipe = {shape = "circle", center = [0.5, 0.9], diameter = 0.02}
contact.skin = {body = "sand", rigid = "pipe", friction_angle = 0.4}
stage = [{name = "push", kind = "push", velocity = 1, until.embedment = 0.02},
         {name = "drag", kind = "drag", velocity = 1, vertical = "fixed", until.displacement = 0.02}]
)";

/// A run folder with a resolved.toml and at most one file more.
class Folder {
public:
  Folder()
  {
    fs::create_directories(path() / "frames");
    folder_.hold("resolved.toml", settings);
  }
  void hold(const std::string& name, const std::string& text)
  {
    if (!name_.empty() && name_ != name) fs::remove(path() / name_);
    name_ = name;
    folder_.hold(name, text);
  }
  const fs::path& path() const { return folder_.path(); }

private:
  MemoryFolder folder_;
  std::string name_;
};

/// The numbers that `berm study` and `berm verify` take.
void take_numbers(const fs::path& folder)
{
  expectations::Observable observable;
  observable.quantity = "energy_error";
  may_be_refused([&] { evaluate(observable, folder); });
  observable.quantity.clear();
  observable.column = "w_m";
  for (const expectations::Measure measure :
       {expectations::Measure::slope, expectations::Measure::acceleration, expectations::Measure::period}) {
    observable.measure = measure;
    may_be_refused([&] { evaluate(observable, folder); });
  }
}

constexpr const char* expected = R"(requirement = "it holds"
derived = "there"
[run.any]
[[expect]]
run = "any"
quantity = "V_at_w_0.1D"
least = 1
source = "s"
why = "w"
[published]
source = "nobody"
[[published.claim]]
statement = "V, H, w and heave"
where = "1"
runs = ["any"]
expect = [{label = "V", quantity = "V_at_w_0.1D", exact = 1000, tolerance = 0.1, partly = 0.4},
          {label = "H", quantity = "H_at_part", at = 0.5, over_number = {quantity = "H_at_part", at = 1}, least = 1},
          {label = "w", quantity = "sinking_after_u", at = 0.3, most = 0.1, partly = "always"},
          {label = "heave", quantity = "berm_at_end"}]
why = "so"
)";

/// A schema that fits a header without quotes.
std::vector<run_folder::Column> columns_in_header(const std::string& text)
{
  std::vector<run_folder::Column> columns;
  std::istringstream header(text.substr(0, text.find('\n')));
  for (std::string name; std::getline(header, name, ',');)
    if (name != "stage") columns.push_back({name, name.substr(0, name.find('_')), "1", "of a test", "run"});
  return columns;
}

void write_sections(const fs::path& folder)
{
  static const report::ExpectationSheets sheets = {expectations::read_expectations_text("expected.toml", expected)};
  may_be_refused([&] {
    std::vector<record::RunRecord> runs = {structures::read_run(folder)};
    runs[0].origin = run_folder::Origin{{}, {}, "case.toml", {}};
    runs[0].end = record::RunEnd::finished;
    report::run_data(runs[0]);
    const std::vector<report::Judgement> judgements = report::judgements_of(runs);
    report::results_section(runs, judgements);
    report::quality_section(runs, judgements);
    report::expectations_section(runs, sheets);
    report::claims_section(runs, sheets);
  });
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  static Folder folder;
  const auto [kind, text] = kind_and_text(data, size, 'h');
  const char* file = kind == 's' ? "summary.json" : kind == 'l' ? "run.log" : kind == 'p' ? "frames/frames.pvd" : "history.csv";
  folder.hold(file, text);
  if (kind == 'h') run_folder::write_schema(folder.path() / "history.csv", columns_in_header(text));
  if (kind == 'p') {
    may_be_refused([&] { run_folder::frame_files(folder.path() / "frames"); });
    return 0;
  }
  write_sections(folder.path());
  if (kind != 'l') take_numbers(folder.path());
  if (kind == 's') {
    jobs::wall_time_of(folder.path());
    jobs::has_result({folder.path() / "resolved.toml", {}, folder.path(), false});
  }
  return 0;
}
