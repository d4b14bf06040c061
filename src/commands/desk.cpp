// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/desk/desk_test.cpp
#include "desk/desk.hpp"

#include "commands/case_options.hpp"
#include "commands/command.hpp"
#include "commands/option_values.hpp"
#include "io/atomic_file.hpp"
#include "io/scratch_folder.hpp"
#include "os/child_process.hpp"
#include "os/interrupt.hpp"

#include <algorithm>
#include <arpa/inet.h>
#include <cstdio>
#include <fmt/format.h>
#include <system_error>
#include <thread>

namespace berm::commands {
namespace {

/// Opens the address by a file that only its user reads: what a program is called with, all users of the machine see.
void open_in_browser(const std::string& address, const std::filesystem::path& folder)
{
  const std::filesystem::path file = folder / "desk.html";
  io::write_atomically(file, fmt::format("<!doctype html><meta http-equiv=\"refresh\" content=\"0;url={}\">\n", address));
  std::filesystem::permissions(file, std::filesystem::perms::owner_read);
  try {
    ChildProcess({.words = {"xdg-open", file.string()}, .messages = (folder / "messages").string(), .outlives = true}).wait();
  } catch (const std::system_error&) {  // there is none: the address was printed
  }
}

bool is_host_name(const std::string& word)
{
  constexpr const char* allowed = "abcdefghijklmnopqrstuvwxyz0123456789.-";
  return word.find_first_of("abcdefghijklmnopqrstuvwxyz") == 0 && word.find_first_not_of(allowed) == std::string::npos;
}

bool is_address(const std::string& word)
{
  in_addr address{};
  return inet_aton(word.c_str(), &address) != 0 && std::count(word.begin(), word.end(), '.') == 3;
}

bool is_prefix(const std::string& word)
{
  constexpr const char* allowed = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-";
  return word.size() > 1 && word.size() < 100 && word[0] == '/' && word.find_first_not_of(allowed, 1) == std::string::npos;
}

}  // namespace

Command add_desk(CLI::App& program)
{
  struct Options : desk::DeskSettings {
    bool no_browser = false;
  };
  const auto options = std::make_shared<Options>();
  CLI::App* app = program.add_subcommand("desk", "work on the cases and runs of a folder in a browser of this machine");
  app->add_option("FOLDER", options->folder, "the folder; nothing outside of it is shown or written (default: here)");
  app->add_option("--port", options->listen.port, "port (default: one that is free)")->check(whole_number_within(1, 65535));
  app->add_option("--listen", options->listen.address,
                  "address of this machine to listen on (default: 127.0.0.1); 0.0.0.0 in a container whose port is forwarded")
      ->check(CLI::Validator(
          [](std::string& word) { return is_address(word) ? std::string() : "an address is four numbers, such as 0.0.0.0"; }, "ADDRESS"));
  app->add_option("--threads", options->threads, "threads of all runs together; further runs wait (default: all processors)")
      ->check(whole_number_within(1, 1024));
  app->add_option("--name", options->proxy.name,
                  "host name of a proxy in front of it, without port, which requests may also use (default: none)")
      ->check(CLI::Validator(
          [](std::string& word) { return is_host_name(word) ? std::string() : "a host name has letters, digits, . and -"; }, "HOST"));
  app->add_option("--prefix", options->proxy.prefix, "path prefix of a proxy, such as /berm (default: none)")
      ->check(CLI::Validator(
          [](std::string& word) { return is_prefix(word) ? std::string() : "a prefix is like /berm: letters, digits, _ and -"; }, "/WORD"));
  app->add_flag("--no-browser", options->no_browser, "print the address and open no browser");
  return {app, [options] {
            messages_to_stderr();
            catch_interrupts();
            survive_failed_writes();
            options->place = default_folder;
            desk::Desk desk(*options);
            fmt::print("{}\n", desk.address());
            std::fflush(stdout);
            const io::ScratchFolder scratch;
            std::jthread browser([&] {
              if (!options->no_browser) open_in_browser(desk.address(), scratch.path());
            });
            std::jthread ends([&] {
              while (!interrupted()) std::this_thread::sleep_for(std::chrono::milliseconds(200));
              desk.stop();
            });
            desk.serve();
            return 0;
          }};
}

}  // namespace berm::commands
