// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/commands/report_test.cpp
#include "report/page/report.hpp"

#include "io/atomic_file.hpp"
#include "io/log.hpp"
#include "io/scratch_folder.hpp"
#include "os/error.hpp"
#include "report/page/page.hpp"
#include "report/results/results_section.hpp"
#include "structures/base/invalid_answer.hpp"
#include "structures/structures.hpp"

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <fmt/format.h>
#include <map>
#include <set>
#include <stdexcept>

namespace berm::report {
namespace {

namespace fs = std::filesystem;

constexpr const char *page_name = "report.html", *pdf_name = "report.pdf";
constexpr const char* figures_name = "report_figures";

fs::path whole(const fs::path& path)
{
  const fs::path normal = fs::absolute(path).lexically_normal();
  return normal.has_filename() ? normal : normal.parent_path();
}

/// The run folders that a folder holds, by name; those of a study or an envelope lie in its folder runs/.
std::vector<fs::path> run_folders_in(const fs::path& folder)
{
  std::vector<fs::path> found;
  for (const fs::path& place : {folder, folder / "runs"}) {
    std::error_code error;
    for (fs::directory_iterator entry(place, error), end; !error && entry != end; entry.increment(error))
      if (record::is_run_folder(entry->path())) found.push_back(entry->path());
    if (!found.empty()) break;
  }
  std::sort(found.begin(), found.end());
  return found;
}

/// The run folders that are meant. What an earlier report wrote may be named among them (`berm report out/study/*`) and is passed over.
std::vector<fs::path> run_folders(const std::vector<std::string>& names)
{
  std::vector<fs::path> folders;
  for (const std::string& name : names) {
    const fs::path path = whole(name);
    std::error_code error;
    const fs::file_status found = fs::status(path, error);
    if (!fs::exists(found))
      throw InputError(fmt::format("{}: {}", name, error && error.value() != ENOENT ? error.message() : "there is no such folder"));
    if ((path.filename() == page_name || path.filename() == pdf_name) && !fs::is_directory(found)) continue;
    if (path.filename() == figures_name) continue;
    if (!fs::is_directory(found)) throw InputError(fmt::format("{}: is a file; a run folder is needed, as berm run makes it", name));
    if (record::is_run_folder(path)) {
      folders.push_back(path);
      continue;
    }
    const std::vector<fs::path> within = run_folders_in(path);
    if (within.empty())
      throw InputError(fmt::format("{}: is not a run folder and contains none (there is no resolved.toml that can be read)", name));
    folders.insert(folders.end(), within.begin(), within.end());
  }
  std::vector<fs::path> unique;
  std::set<fs::path> known;
  for (const fs::path& folder : folders)
    if (known.insert(fs::weakly_canonical(folder)).second) unique.push_back(folder);
  if (unique.empty()) throw InputError("no run folder is named");
  return unique;
}

Real particles_of(const record::RunRecord& run)
{
  const Real count = run.timing("particles");
  return std::isnan(count) ? 0 : count;
}

/// The order of the page: the material point method first, then by number of particles. Of a case by both methods the more reliable one leads.
bool finer(const record::RunRecord& a, const record::RunRecord& b)
{
  if (a.settings.method != b.settings.method) return a.settings.method == settings::Method::mpm;
  return particles_of(a) > particles_of(b);
}

/// The folder of a single run that was named, or the deepest folder that holds all.
fs::path folder_of_page(const std::vector<std::string>& names, const std::vector<fs::path>& folders)
{
  fs::path common = folders.front();
  if (folders.size() > 1) common = common.parent_path();
  if (folders.size() == 1 && names.size() == 1) common = whole(names.front());
  for (const fs::path& folder : folders)
    while (std::mismatch(common.begin(), common.end(), folder.begin(), folder.end()).first != common.end()) common = common.parent_path();
  return common;
}

/// Runs of one name get that of the folder above before it.
void tell_apart(std::vector<record::RunRecord>& runs)
{
  std::map<std::string, int> count;
  for (const record::RunRecord& run : runs) ++count[run.name];
  for (record::RunRecord& run : runs)
    if (count[run.name] > 1) run.name = fmt::format("{}/{}", run.folder.parent_path().filename().string(), run.name);
}

/// A run whose answer is invalid has a mark behind its name, and so beside each of its numbers, curves and pictures.
void mark_invalid(std::vector<record::RunRecord>& runs)
{
  for (record::RunRecord& run : runs)
    if (run.summary) run.name += base::invalid_mark(run.summary->invalid);
}

/// Reads what can be read; of several runs one that cannot is left out, with a word in `left_out`. Throws InputError where none is left.
std::vector<record::RunRecord> read_runs(const std::vector<fs::path>& folders, std::vector<std::string>& left_out)
{
  std::vector<record::RunRecord> runs;
  for (const fs::path& folder : folders) try {
      runs.push_back(structures::read_run(folder));
      for (const std::string& file : runs.back().changed) io::warn("{}: {}", runs.back().name, record::words_of_change(file));
    } catch (const std::runtime_error& error) {
      if (folders.size() == 1) throw;
      left_out.push_back(fmt::format("{} is left out: {}", folder.filename().string(), error.what()));
      io::warn("{}", left_out.back());
    }
  if (runs.empty()) throw InputError("none of the run folders can be read");
  std::stable_sort(runs.begin(), runs.end(), finer);
  lead_with_reliable_method(runs);
  tell_apart(runs);
  mark_invalid(runs);
  return runs;
}

/// What is expected by the file that was asked for, else by those in the run folders: each once. A run whose own cannot be read says so.
ExpectationSheets expected_of(const ReportRequest& request, std::vector<record::RunRecord>& runs)
{
  if (!request.expected.empty()) return {expectations::read_expectations(request.expected)};
  ExpectationSheets sheets;
  std::set<std::string> known;
  for (record::RunRecord& run : runs) try {
      const fs::path file = run.folder / expectations::expected_file;
      std::error_code error;
      if (!fs::exists(file, error)) continue;
      const std::string text = io::read_text_file(file);
      if (known.insert(text).second) sheets.push_back(expectations::read_expectations_text(file.string(), text));
    } catch (const std::runtime_error& error) {
      run.faults.push_back(fmt::format("its expected values are left out: {}", error.what()));
    }
  return sheets;
}

/// Where the page goes. A name for a PDF is refused: --pdf would print the page over itself.
fs::path page_file(const ReportRequest& request, const std::vector<fs::path>& folders)
{
  if (request.output.empty()) return folder_of_page(request.folders, folders) / page_name;
  fs::path page(request.output);
  std::string ending = page.extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
  if (ending == ".pdf")
    throw InputError(fmt::format("-o {}: the page is HTML; name it {}, and --pdf writes {} beside it", request.output,
                                 fs::path(page).replace_extension("html").string(), fs::path(page).replace_extension("pdf").string()));
  return page;
}

}  // namespace

std::vector<fs::path> write_report(const ReportRequest& request)
{
  const std::vector<fs::path> folders = run_folders(request.folders);
  const fs::path page = page_file(request, folders);
  const fs::path browser = request.pdf ? printing_browser() : fs::path();  // or an error before there is work
  const fs::path pandoc = request.docx ? word_writer() : fs::path();
  std::vector<std::string> left_out;
  std::vector<record::RunRecord> runs = read_runs(folders, left_out);
  const ExpectationSheets expected = expected_of(request, runs);

  io::write_atomically(page, report_page(runs, expected, left_out));
  std::vector<fs::path> written = {page};
  if (request.pdf) print_pdf(browser, page, written.emplace_back(fs::path(page).replace_extension("pdf")));
  if (request.docx) {
    const io::ScratchFolder scratch;
    std::vector<std::string> pictures = draw_report_figures(runs, published_points(runs, expected), scratch.path() / figures_name);
    std::erase_if(pictures, [](const std::string& name) { return !name.ends_with(".png"); });
    for (std::string& name : pictures) name = (fs::path(figures_name) / name).string();
    io::write_atomically(scratch.path() / page_name, word_page(runs, expected, left_out, pictures));
    write_docx(pandoc, scratch.path() / page_name, written.emplace_back(fs::path(page).replace_extension("docx")));
  }
  if (request.figures) {
    const fs::path figures = io::make_inner_folder(page.parent_path(), figures_name);
    for (const std::string& name : draw_report_figures(runs, published_points(runs, expected), figures)) written.push_back(figures / name);
  }
  return written;
}

}  // namespace berm::report
