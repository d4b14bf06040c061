// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "samples/temporary_folder.hpp"

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fcntl.h>
#include <string>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>
#include <vector>

namespace berm {

/// What a program left behind when it ended.
struct Ended {
  int status = -1;  ///< exit status; -1: a signal ended it
  std::string out, err;
};

/// The variable with which a program draws its pictures; without it they are blank (blank_gnuplot.c).
inline std::string with_pictures()
{
  return std::string("PATH=") + std::getenv("PATH");
}

/// The built program, started in a folder with its own environment variables beside ours; stdout and stderr go to files elsewhere.
class Program {
public:
  Program(const std::filesystem::path& folder, const std::vector<std::string>& arguments, const std::vector<std::string>& environment = {})
  {
    std::vector<std::string> words = {BERM_PROGRAM};
    words.insert(words.end(), arguments.begin(), arguments.end());
    std::vector<char*> argv;
    for (std::string& word : words) argv.push_back(word.data());
    argv.push_back(nullptr);
    const std::string out = (streams_ / "out").string(), err = (streams_ / "err").string();
    const std::string blank = (std::filesystem::path(BERM_PROGRAM).parent_path() / "tests/blank").string() + ":" + std::getenv("PATH");
    id_ = ::fork();
    if (id_ != 0) return;
    ::setenv("PATH", blank.c_str(), 1);
    for (const std::string& variable : environment) {
      const auto sign = variable.find('=');
      ::setenv(variable.substr(0, sign).c_str(), variable.substr(sign + 1).c_str(), 1);
    }
    const int to_out = ::open(out.c_str(), O_WRONLY | O_CREAT, 0666), to_err = ::open(err.c_str(), O_WRONLY | O_CREAT, 0666);
    if (::chdir(folder.c_str()) != 0 || ::dup2(to_out, STDOUT_FILENO) < 0 || ::dup2(to_err, STDERR_FILENO) < 0) ::_exit(99);
    ::execv(BERM_PROGRAM, argv.data());
    ::_exit(98);
  }
  ~Program()
  {
    if (id_ > 0) {
      ::kill(id_, SIGKILL);
      ::waitpid(id_, nullptr, 0);
    }
  }
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;

  pid_t id() const { return id_; }
  /// What it has printed so far.
  std::string out() const { return streams_.read("out"); }
  void signal(int number) const { ::kill(id_, number); }
  Ended wait()
  {
    int status = 0;
    ::waitpid(id_, &status, 0);
    id_ = 0;
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, streams_.read("out"), streams_.read("err")};
  }

private:
  TemporaryFolder streams_;
  pid_t id_ = 0;
};

inline Ended run_program(const std::filesystem::path& folder, const std::vector<std::string>& arguments,
                         const std::vector<std::string>& environment = {})
{
  return Program(folder, arguments, environment).wait();
}

/// Waits until the test is true, at most 20 s.
template <class Test>
bool wait_until(const Test& test)
{
  for (int n = 0; n < 2000 && !test(); ++n) std::this_thread::sleep_for(std::chrono::milliseconds(10));
  return test();
}

inline std::string text_of_file(const std::filesystem::path& path)
{
  std::stringstream content;
  content << std::ifstream(path, std::ios::binary).rdbuf();
  return content.str();
}

/// Names of what lies in a folder, sorted, "/" behind folders.
inline std::vector<std::string> names_in(const std::filesystem::path& folder)
{
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    names.push_back(entry.path().filename().string() + (entry.is_directory() ? "/" : ""));
  std::sort(names.begin(), names.end());
  return names;
}

}  // namespace berm
