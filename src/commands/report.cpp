// SPDX-License-Identifier: BSD-3-Clause
#include "commands/report.hpp"

#include "commands/case_options.hpp"
#include "commands/command.hpp"
#include "os/error.hpp"

#include <fmt/format.h>

namespace berm::commands {

void print_report(const report::ReportRequest& request)
{
  for (const std::filesystem::path& file : write_report(request)) fmt::print("{}\n", std::filesystem::proximate(file).string());
}

Command add_report(CLI::App& program)
{
  const auto request = std::make_shared<report::ReportRequest>();
  CLI::App* app = program.add_subcommand("report", "write one page, report.html, with the results of runs");
  app->add_option("DIR", request->folders, "run folders, or folders that hold run folders")->required();
  app->add_option("-o,--output", request->output, "the page's file (default: report.html in the folder that holds the runs)");
  app->add_option("--expected", request->expected, "expected values of the runs (default: expected.toml in each run folder)");
  const auto former = std::make_shared<std::string>();
  app->add_option("--claims", *former)->group("");
  app->add_flag("--pdf", request->pdf, "also print the page to report.pdf beside it, by an installed Chromium or Google Chrome");
  app->add_flag("--docx", request->docx, "also write the page as a Word document, report.docx beside it, by pandoc");
  app->add_flag("--figures", request->figures, "also draw the curves and mechanisms as SVG and PNG, in report_figures beside the page");
  return {app, [request, former] {
            if (!former->empty()) throw InputError("--claims is --expected now, and names an expected.toml: docs/how_to/report.md");
            messages_to_stderr();
            print_report(*request);
            return 0;
          }};
}

}  // namespace berm::commands
