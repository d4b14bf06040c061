// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/commands/manual_test.cpp
#include "commands/command.hpp"
#include "commands/option_values.hpp"
#include "io/atomic_file.hpp"
#include "os/error.hpp"

#include <filesystem>
#include <fmt/format.h>

namespace berm::commands {

Command add_completion(CLI::App& program)
{
  const auto shell = std::make_shared<std::string>();
  CLI::App* app = program.add_subcommand("completion", "print the script that completes berm's commands in a shell");
  app->add_option("SHELL", *shell, "the shell: source <(berm completion bash)")->required()->check(one_of({"bash", "zsh", "fish"}));
  return {app, [shell, &program] {
            fmt::print("{}", *shell == "bash"  ? bash_completion(program)
                             : *shell == "zsh" ? zsh_completion(program)
                                               : fish_completion(program));
            return 0;
          }};
}

Command add_man(CLI::App& program)
{
  const auto folder = std::make_shared<std::string>();
  CLI::App* app = program.add_subcommand("man", "write the manual pages of all commands into a folder");
  app->add_option("FOLDER", *folder, "folder for berm.1, berm-run.1 ...")->required();
  return {app, [folder, &program] {
            std::error_code error;
            std::filesystem::create_directories(*folder, error);
            if (error) throw RunError(fmt::format("cannot make the folder {}: {}", *folder, error.message()));
            for (const auto& [name, page] : manual_pages(program)) io::write_atomically(std::filesystem::path(*folder) / name, page);
            return 0;
          }};
}

}  // namespace berm::commands
