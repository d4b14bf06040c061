// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/commands/new_test.cpp
#include "commands/command.hpp"
#include "commands/templates.hpp"
#include "core/error.hpp"
#include "input/message_text.hpp"
#include "io/atomic_file.hpp"

#include <algorithm>
#include <filesystem>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace berm::commands {
namespace {

namespace fs = std::filesystem;

/// The title that a case gives itself, without its quotes.
std::string title_of(const std::string& text)
{
  const std::string key = "\ntitle = \"";
  const std::size_t begin = text.find(key);
  if (begin == std::string::npos) return "";
  const std::size_t first = begin + key.size();
  return text.substr(first, text.find('"', first) - first);
}

int list_templates()
{
  for (const CaseTemplate& one : case_templates()) fmt::print("  {:<16} {}\n", one.kind, title_of(one.text));
  fmt::print("berm new KIND [FILE] writes one of them.\n");
  return 0;
}

std::vector<std::string> kinds()
{
  std::vector<std::string> all;
  for (const CaseTemplate& one : case_templates()) all.push_back(one.kind);
  return all;
}

int write_template(const std::string& kind, const std::string& file)
{
  const std::vector<CaseTemplate>& all = case_templates();
  const auto found = std::find_if(all.begin(), all.end(), [&](const CaseTemplate& one) { return one.kind == kind; });
  if (found == all.end()) throw InputError(fmt::format("there is no kind {}{}", input::in_quotes(kind), input::suggestion(kind, kinds())));
  const fs::path path = file.empty() ? fs::path(kind + ".toml") : fs::path(file);
  if (fs::exists(fs::symlink_status(path))) throw InputError(fmt::format("{} is there already: name another file", path.string()));
  io::write_atomically(path, found->text);
  fmt::print("{0} is written. Change what is marked with <-, then\n  berm check {0}\n  berm run {0} -o out/{1}\n  berm report out/{1}\n",
             path.string(), path.stem().string());
  return 0;
}

}  // namespace

Command add_new(CLI::App& program)
{
  struct Options {
    std::string kind, file;
  };
  const auto options = std::make_shared<Options>();
  CLI::App* app = program.add_subcommand("new", "write a commented case to begin with; without a KIND, list the kinds");
  app->add_option("KIND", options->kind, "what to begin with")->type_name(fmt::format("{{{}}}", fmt::join(kinds(), ",")));
  app->add_option("FILE", options->file, "file to write (default: KIND.toml here)");
  return {app, [options] { return options->kind.empty() ? list_templates() : write_template(options->kind, options->file); }};
}

}  // namespace berm::commands
