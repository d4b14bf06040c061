// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "samples/program.hpp"

#include <fstream>
#include <functional>

namespace berm {

/// Whether a process is there and has not ended: one that nobody has taken note of is listed still.
inline bool is_alive(pid_t process)
{
  const std::string stat = text_of_file("/proc/" + std::to_string(process) + "/stat");
  const std::size_t state = stat.rfind(") ");
  return state != std::string::npos && stat[state + 2] != 'Z';
}

/// The process whose number is in a file, once it is whole; 0 where it does not come.
inline pid_t process_in(const std::filesystem::path& file)
{
  std::string text;
  wait_until([&] { return (text = text_of_file(file)).ends_with('\n'); });
  return text.empty() ? 0 : std::stoi(text);
}

/// Does something in a process of its own, which does not return from it to the tests.
inline pid_t fork_to(const std::function<void()>& act)
{
  const pid_t process = ::fork();
  if (process != 0) return process;
  act();
  ::_exit(0);
}

/// A program of this name in a folder that notes its process in PROGRAM.process there and does not end.
inline void write_endless_program(const TemporaryFolder& folder, const std::string& name)
{
  const std::filesystem::path file =
      folder.write(name, "#!/bin/sh\necho $$ > '" + (folder / (name + ".process")).string() + "'\nexec sleep 1000\n");
  std::filesystem::permissions(file, std::filesystem::perms::owner_all);
}

}  // namespace berm
