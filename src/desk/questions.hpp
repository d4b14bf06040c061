// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "desk/process.hpp"
#include "io/scratch_folder.hpp"

#include <atomic>
#include <condition_variable>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <set>

namespace berm::desk {

/// A command that answers within seconds: its words, what it reads, and the file that it makes, where that is its answer.
struct Question {
  std::vector<std::string> words;
  std::optional<std::string> text{};           ///< its standard input
  std::string about{};                         ///< a later question about the same ends this one; "": none does
  std::map<std::string, std::string> given{};  ///< files by their names, which stand among the words: their paths are put there
  std::string made{};                          ///< "model.svg": its path is put behind the words
};

struct CommandOutput {
  int status = 0;
  std::string text;  ///< the file that it made, or what it printed
  std::string messages;
};

/// Asks this program, as many questions at once as there are processors.
class Questions {
public:
  explicit Questions(std::filesystem::path folder);
  /// Throws Refusal 409 where a later question took its place, 504 where it took too long.
  CommandOutput ask(const Question& question);
  /// Ends those that are being answered; later ones are refused.
  void end();

private:
  std::filesystem::path folder_;
  io::ScratchFolder scratch_;
  std::mutex mutex_;
  std::condition_variable ended_;
  std::map<std::string, std::shared_ptr<Process>> about_;
  std::set<std::shared_ptr<Process>> asked_;
  int free_, number_ = 0;
  bool ending_ = false;
};

}  // namespace berm::desk
