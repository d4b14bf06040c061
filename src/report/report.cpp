// SPDX-License-Identifier: BSD-3-Clause
#include "report/report.hpp"

#include "core/error.hpp"
#include "output/whole_file.hpp"
#include "report/figures.hpp"
#include "report/page.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm {
namespace {

namespace fs = std::filesystem;

constexpr const char* page_name = "report.html";
constexpr const char* figures_name = "report_figures";

fs::path whole(const fs::path& path)
{
  const fs::path normal = fs::absolute(path).lexically_normal();
  return normal.has_filename() ? normal : normal.parent_path();
}

/// The run folders that a folder holds, by name.
std::vector<fs::path> run_folders_in(const fs::path& folder)
{
  std::vector<fs::path> found;
  for (const auto& entry : fs::directory_iterator(folder))
    if (entry.is_directory() && is_run_folder(entry.path())) found.push_back(entry.path());
  std::sort(found.begin(), found.end());
  return found;
}

/// The run folders that are meant. What an earlier report wrote may be named among them (`berm report out/study/*`) and is passed over.
std::vector<fs::path> run_folders(const std::vector<std::string>& names)
{
  std::vector<fs::path> folders;
  for (const std::string& name : names) {
    const fs::path path = whole(name);
    if (!fs::exists(path)) throw InputError(fmt::format("{}: there is no such folder", name));
    if (path.filename() == page_name && !fs::is_directory(path)) continue;
    if (path.filename() == figures_name) continue;
    if (!fs::is_directory(path)) throw InputError(fmt::format("{}: is a file; a run folder is needed, as berm run makes it", name));
    if (is_run_folder(path)) {
      folders.push_back(path);
      continue;
    }
    const std::vector<fs::path> within = run_folders_in(path);
    if (within.empty()) throw InputError(fmt::format("{}: is no run folder and holds none (there is no resolved.toml)", name));
    folders.insert(folders.end(), within.begin(), within.end());
  }
  std::vector<fs::path> unique;
  for (const fs::path& folder : folders)
    if (std::find(unique.begin(), unique.end(), folder) == unique.end()) unique.push_back(folder);
  if (unique.empty()) throw InputError("no run folder is named");
  return unique;
}

Real particles_of(const RunRecord& run)
{
  const Real count = run.timing("particles");
  return std::isnan(count) ? 0 : count;
}

/// The order of the page: the material point method first, then by number of particles.
bool finer(const RunRecord& a, const RunRecord& b)
{
  if (a.settings.method != b.settings.method) return a.settings.method == Method::mpm;
  return particles_of(a) > particles_of(b);
}

/// The folder of a single run, or the deepest folder that holds all.
fs::path common_folder(const std::vector<fs::path>& folders)
{
  fs::path common = folders.size() == 1 ? folders[0] : folders[0].parent_path();
  for (const fs::path& folder : folders)
    while (std::mismatch(common.begin(), common.end(), folder.begin(), folder.end()).first != common.end()) common = common.parent_path();
  return common;
}

}  // namespace

std::vector<fs::path> write_report(const ReportRequest& request)
{
  const std::vector<fs::path> folders = run_folders(request.folders);
  const fs::path page = request.output.empty() ? common_folder(folders) / page_name : fs::path(request.output);
  std::vector<RunRecord> runs;
  for (const fs::path& folder : folders) runs.push_back(read_run(folder));
  std::stable_sort(runs.begin(), runs.end(), finer);

  write_whole(page, report_page(runs));
  std::vector<fs::path> written = {page};
  if (request.figures) {
    const fs::path figures = page.parent_path() / figures_name;
    for (const std::string& name : draw_report_figures(runs, figures)) written.push_back(figures / name);
  }
  return written;
}

}  // namespace berm
