// SPDX-License-Identifier: BSD-3-Clause
#include "os/text_of_list.hpp"
#include "report/page/report.hpp"

#include "io/atomic_file.hpp"
#include "io/run_and_wait.hpp"
#include "io/scratch_folder.hpp"
#include "os/error.hpp"

#include <algorithm>
#include <cstdlib>
#include <fmt/format.h>
#include <sstream>
#include <unistd.h>
#include <vector>

namespace berm::report {
namespace {

namespace fs = std::filesystem;

constexpr const char* names[] = {"chromium", "chromium-browser", "google-chrome", "google-chrome-stable"};

bool is_program(const fs::path& file)
{
  std::error_code error;
  return fs::is_regular_file(file, error) && ::access(file.c_str(), X_OK) == 0;
}

fs::path in_path(const std::string& name)
{
  const char* path = std::getenv("PATH");
  std::istringstream folders(path == nullptr ? "/usr/bin:/bin" : path);
  for (std::string folder; std::getline(folders, folder, ':');)
    if (const fs::path file = fs::path(folder) / name; is_program(file)) return file;
  return {};
}

/// The address of a file; all but plain letters by their numbers.
std::string address_of(const fs::path& file)
{
  std::string address = "file://";
  for (const char c : fs::absolute(file).lexically_normal().string()) {
    const auto byte = static_cast<unsigned char>(c);
    const bool plain = byte < 0x80 && (std::isalnum(byte) != 0 || std::string_view("/._-~").find(c) != std::string_view::npos);
    address += plain ? std::string(1, c) : fmt::format("%{:02X}", byte);
  }
  return address;
}

}  // namespace

fs::path printing_browser()
{
  if (const char* named = std::getenv("BERM_BROWSER"); named != nullptr && *named != '\0') {
    if (is_program(named)) return named;
    throw RunError(fmt::format("--pdf: BERM_BROWSER names \"{}\", which is not a program", named));
  }
  for (const char* name : names)
    if (const fs::path found = in_path(name); !found.empty()) return found;
  throw RunError(
      fmt::format("--pdf: no browser that can print is installed (looked for {}). Install one, as by apt-get install chromium, or name one "
                  "in the environment variable BERM_BROWSER; or open the page in any browser and print it there",
                  text_of_list(names, ", ")));
}

fs::path word_writer()
{
  if (const fs::path found = in_path("pandoc"); !found.empty()) return found;
  throw RunError("--docx: pandoc is not installed; install it, as by apt-get install pandoc");
}

void write_docx(const fs::path& pandoc, const fs::path& page, const fs::path& docx)
{
  const io::ScratchFolder scratch;
  const fs::path made = scratch.path() / "page.docx", messages = scratch.path() / "messages.txt";
  const int status = io::run_and_wait({pandoc.string(), "--from=html", "--to=docx", "--resource-path=" + page.parent_path().string(),
                                       "--output=" + made.string(), page.string()},
                                      messages);
  if (status != 0)
    throw RunError(fmt::format("--docx: {} could not write {} (exit status {}): {}", pandoc.string(), docx.string(), status,
                               io::last_message(messages)));
  io::copy_atomically(made, docx);
}

void print_pdf(const fs::path& browser, const fs::path& page, const fs::path& pdf)
{
  const io::ScratchFolder scratch;  // a browser wants a profile of its own
  const fs::path made = scratch.path() / "page.pdf", messages = scratch.path() / "messages.txt";
  // Time is virtual: the browser waits until the page has drawn its films, and no longer.
  std::vector<std::string> words = {browser.string(),
                                    "--headless",
                                    "--disable-gpu",
                                    "--no-first-run",
                                    "--no-pdf-header-footer",
                                    "--force-device-scale-factor=2",
                                    "--virtual-time-budget=20000",
                                    "--user-data-dir=" + (scratch.path() / "profile").string(),
                                    "--print-to-pdf=" + made.string(),
                                    address_of(page)};
  if (::geteuid() == 0) words.insert(words.begin() + 1, "--no-sandbox");  // which it cannot have as root
  const int status = io::run_and_wait(words, messages);
  if (status != 0 || !io::read_text_file(made).starts_with("%PDF"))
    throw RunError(fmt::format("--pdf: {} could not print {} (exit status {}): {}", browser.string(), page.string(), status,
                               io::last_message(messages)));
  io::copy_atomically(made, pdf);
}

}  // namespace berm::report
