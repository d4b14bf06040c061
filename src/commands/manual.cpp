// SPDX-License-Identifier: BSD-3-Clause
#include "commands/command.hpp"
#include "os/text_of_list.hpp"

#include <cctype>
#include <fmt/format.h>

namespace berm::commands {
namespace {

using Words = std::vector<std::string>;

/// Those that --help lists.
std::vector<const CLI::App*> commands_of(const CLI::App& program)
{
  std::vector<const CLI::App*> all;
  for (const CLI::App* command : program.get_subcommands([](const CLI::App*) { return true; }))
    if (!command->get_group().empty()) all.push_back(command);
  return all;
}

/// -o and --output.
Words names_of(const CLI::Option& option)
{
  Words names;
  for (const std::string& name : option.get_snames()) names.push_back("-" + name);
  for (const std::string& name : option.get_lnames()) names.push_back("--" + name);
  return names;
}

bool is_positional(const CLI::Option& option)
{
  return names_of(option).empty();
}

bool takes_value(const CLI::Option& option)
{
  return option.get_items_expected_max() > 0;
}

/// The words of a list of choices, TEXT:{table,json}; none where anything is taken.
Words choices_of(const CLI::Option& option)
{
  const std::string type = option.get_type_name();
  const auto begin = type.find('{'), end = type.find('}');
  if (begin == std::string::npos || end == std::string::npos) return {};
  return CLI::detail::split(type.substr(begin + 1, end - begin - 1), ',');
}

/// A text as man takes it: no line begins with a point or a quote, and \ and - are themselves.
std::string roff(const std::string& text)
{
  std::string made;
  for (const char c : text) made += c == '\\' ? "\\e" : c == '-' ? "\\-" : std::string(1, c);
  return made.empty() || (made[0] != '.' && made[0] != '\'') ? made : "\\&" + made;
}

std::string roff_of(const CLI::Option& option)
{
  std::string names = is_positional(option) ? "\\fI" + roff(option.get_name(true)) + "\\fR"
                                            : fmt::format("\\fB{}\\fR", text_of_list(
                                                                            [&] {
                                                                              Words each;
                                                                              for (const std::string& name : names_of(option))
                                                                                each.push_back(roff(name));
                                                                              return each;
                                                                            }(),
                                                                            "\\fR, \\fB"));
  if (!is_positional(option) && takes_value(option)) {
    const Words choices = choices_of(option);
    names += " \\fI" + (choices.empty() ? "VALUE" : roff(text_of_list(choices, "|"))) + "\\fR";
  }
  return fmt::format(".TP\n{}\n{}\n", names, roff(option.get_description()));
}

std::string upper(std::string name)
{
  for (char& c : name) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return name;
}

std::string page(const std::string& name, const std::string& description, const std::string& synopsis, const std::string& body)
{
  return fmt::format(
      ".\\\" SPDX-License-Identifier: BSD-3-Clause\n.TH {} 1 \"\" \"berm {}\" \"berm\"\n.SH NAME\n{} \\- {}\n.SH SYNOPSIS\n{}\n{}"
      ".SH EXIT STATUS\n.TP\n.B 0\ndone\n.TP\n.B 1\nthe run failed\n.TP\n.B 2\nthe input is wrong\n.TP\n.B 75\nstopped with a checkpoint, "
      "from which "
      "\\fBberm run \\-\\-resume\\fR continues it\n",
      upper(name), BERM_VERSION, roff(name), roff(description), synopsis, body);
}

std::string page_of(const CLI::App& command)
{
  const std::string name = "berm-" + command.get_name();
  std::string synopsis = fmt::format(".B berm {}\n[\\fIoption\\fR]...", command.get_name()), arguments, options;
  for (const CLI::Option* option : command.get_options()) {
    if (is_positional(*option)) {
      const std::string shown = "\\fI" + roff(option->get_name(true)) + "\\fR" + (option->get_items_expected_max() > 1 ? "..." : "");
      synopsis += option->get_required() ? " " + shown : " [" + shown + "]";
      arguments += roff_of(*option);
    } else {
      options += roff_of(*option);
    }
  }
  if (!arguments.empty()) arguments = ".SH ARGUMENTS\n" + arguments;
  return page(name, command.get_description(), synopsis, arguments + ".SH OPTIONS\n" + options) + ".SH SEE ALSO\n.BR berm (1)\n";
}

std::string page_of_program(const CLI::App& program)
{
  std::string commands, see;
  for (const CLI::App* command : commands_of(program)) {
    commands += fmt::format(".TP\n\\fBberm {}\\fR\n{}\n", command->get_name(), roff(command->get_description()));
    see += fmt::format("{}.BR berm\\-{} (1)", see.empty() ? "" : ",\n", command->get_name());
  }
  const std::string examples = ".SH EXAMPLES\n.nf\nberm new pipe\\-in\\-clay my_case.toml\nberm check my_case.toml\nberm run my_case.toml "
                               "\\-o out/my_case\nberm report "
                               "out/my_case\n.fi\n";
  const std::string environment = ".SH ENVIRONMENT\n.TP\n.B OMP_PROC_BIND\nfalse: threads are not bound to processors\n.SH FILES\n.TP\n.I "
                                  "/usr/share/doc/berm/examples\nexamples, with the package berm\\-doc\n";
  return page("berm", "pipe-soil interaction at large deformation by the material point method",
              ".B berm\n\\fIcommand\\fR [\\fIargument\\fR]...",
              fmt::format(".SH DESCRIPTION\n{}\n.SH COMMANDS\n{}", roff(program.get_description()), commands) + examples + environment) +
         ".SH SEE ALSO\n" + see + "\n";
}

/// Options by name, of a command.
Words flags_of(const CLI::App& command)
{
  Words flags;
  for (const CLI::Option* option : command.get_options())
    for (const std::string& name : names_of(*option)) flags.push_back(name);
  return flags;
}

/// For a shell in single quotes.
std::string quoted(const std::string& text)
{
  std::string made = "'";
  for (const char c : text) made += c == '\'' ? "'\\''" : std::string(1, c);
  return made + "'";
}

}  // namespace

std::map<std::string, std::string> manual_pages(const CLI::App& program)
{
  std::map<std::string, std::string> pages = {{"berm.1", page_of_program(program)}};
  for (const CLI::App* command : commands_of(program)) pages["berm-" + command->get_name() + ".1"] = page_of(*command);
  return pages;
}

std::string bash_completion(const CLI::App& program)
{
  Words names;
  std::string cases;
  for (const CLI::App* command : commands_of(program)) {
    names.push_back(command->get_name());
    std::string values, plain;
    for (const CLI::Option* option : command->get_options()) {
      const Words choices = choices_of(*option);
      if (choices.empty()) continue;
      if (is_positional(*option))
        plain = fmt::format("{} ", text_of_list(choices, " "));
      else
        values += fmt::format("        {}) COMPREPLY=($(compgen -W '{}' -- \"$word\")); return ;;\n", text_of_list(names_of(*option), "|"),
                              text_of_list(choices, " "));
    }
    cases += fmt::format("    {})\n{}      if [[ $word == -* ]]; then COMPREPLY=($(compgen -W '{}' -- \"$word\")); return; fi\n      "
                         "COMPREPLY=($(compgen -W '{}' "
                         "-- \"$word\")) ;;\n",
                         command->get_name(), values.empty() ? "" : "      case $before in\n" + values + "      esac\n",
                         text_of_list(flags_of(*command), " "), plain);
  }
  return fmt::format(
      "# SPDX-License-Identifier: BSD-3-Clause\n_berm()\n{{\n  local word=${{COMP_WORDS[COMP_CWORD]}} "
      "before=${{COMP_WORDS[COMP_CWORD-1]}}\n  "
      "COMPREPLY=()\n  if [[ $COMP_CWORD -eq 1 ]]; then COMPREPLY=($(compgen -W '{} --help --version' -- \"$word\")); return; fi\n  case "
      "${{COMP_WORDS[1]}} in\n{}  esac\n}}\ncomplete -o bashdefault -o default -F _berm berm\n",
      text_of_list(names, " "), cases);
}

std::string zsh_completion(const CLI::App& program)
{
  std::string names, cases;
  for (const CLI::App* command : commands_of(program)) {
    names += fmt::format("  {}\n", quoted(command->get_name() + ":" + command->get_description()));
    std::string flags;
    for (const CLI::Option* option : command->get_options())
      for (const std::string& name : names_of(*option)) {
        const Words choices = choices_of(*option);
        const std::string value = !takes_value(*option) ? ""
                                  : choices.empty()     ? ":value:_files"
                                                        : fmt::format(":value:({})", text_of_list(choices, " "));
        flags += fmt::format(" {}", quoted(fmt::format("*{}{}", name, value)));
      }
    cases += fmt::format("    {}) _arguments{} '*:file:_files' ;;\n", command->get_name(), flags);
  }
  return fmt::format("#compdef berm\n# SPDX-License-Identifier: BSD-3-Clause\nlocal -a commands\ncommands=(\n{})\nif (( CURRENT == 2 )); "
                     "then\n  _describe command "
                     "commands\nelse\n  local command=${{words[2]}}\n  shift words; (( CURRENT-- ))\n  case $command in\n{}  esac\nfi\n",
                     names, cases);
}

std::string fish_completion(const CLI::App& program)
{
  std::string text = "# SPDX-License-Identifier: BSD-3-Clause\n";
  for (const CLI::App* command : commands_of(program)) {
    text +=
        fmt::format("complete -c berm -n __fish_use_subcommand -f -a {} -d {}\n", command->get_name(), quoted(command->get_description()));
    for (const CLI::Option* option : command->get_options()) {
      std::string line = fmt::format("complete -c berm -n '__fish_seen_subcommand_from {}'", command->get_name());
      const Words choices = choices_of(*option);
      if (is_positional(*option) && choices.empty()) continue;
      for (const std::string& name : option->get_snames()) line += " -s " + name;
      for (const std::string& name : option->get_lnames()) line += " -l " + name;
      if (!choices.empty())
        line += fmt::format("{} -a {}", is_positional(*option) ? "" : " -x", quoted(text_of_list(choices, " ")));
      else if (takes_value(*option))
        line += " -r";
      text += line + " -d " + quoted(option->get_description()) + "\n";
    }
  }
  return text;
}

}  // namespace berm::commands
