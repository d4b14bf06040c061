// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "desk/process.hpp"

#include <filesystem>
#include <list>
#include <map>
#include <memory>
#include <mutex>
#include <optional>

namespace berm::desk {

/// A run, or a command that starts some: it goes on where the desk ends.
struct Work {
  std::string kind;                ///< run, study, envelope ...
  std::string name;                ///< of the folder that it fills, as clients call it
  std::string case_file;           ///< that it was made from, as clients call it
  std::vector<std::string> words;  ///< of its command
  std::filesystem::path folder;    ///< that it fills
  int threads = 1;

  /// FOLDER.messages, which holds what it prints.
  std::filesystem::path messages() const { return folder.string() + ".messages"; }
};

enum class WorkState { queued, running, stopped, failed, finished };
const char* word_of(WorkState state);

/// The file of what a piece of work prints, which it alone has as long as it waits or is at work, whichever desk was asked for it.
class MessagesFile {
public:
  /// Throws Refusal 409 where another has it, or it is no regular file.
  explicit MessagesFile(const Work& work);
  ~MessagesFile();
  MessagesFile(const MessagesFile&) = delete;
  MessagesFile& operator=(const MessagesFile&) = delete;

  /// For a process, without what was in it.
  int given();
  /// Its process has ended.
  void end(bool kept);

private:
  std::filesystem::path path_;
  int file_;
  bool given_ = false;
};

/// Work that this desk was asked for, in its order: it begins when as many threads are free as it takes. Work that has not begun ends with the desk.
class Queue : public std::enable_shared_from_this<Queue> {
public:
  struct Entry {
    Work work;
    WorkState state = WorkState::queued;
    std::shared_ptr<Process> process{};
    bool asked_to_stop = false;
    std::string why{};  ///< it failed before its process began
    std::string
        left{};  ///< identity_with_log of the folder as it left it: where that is another word, somebody else was at work there since
  };

  Queue(std::filesystem::path folder, int threads) : folder_(std::move(folder)), free_(threads), threads_(threads) {}

  int threads() const { return threads_; }
  /// Throws Refusal 409 where that folder is being filled, by this desk or another.
  void add(Work work);
  /// Ctrl-C to its process, or it leaves the queue. False where it is not at work here.
  bool stop(const std::string& name);
  /// Work that is not in its folder any more, and has ended.
  void forget(const std::string& name);
  std::optional<Entry> find(const std::string& name) const;
  std::vector<Entry> entries() const;

private:
  void start_what_fits();
  void ended(const std::string& name, int status);

  std::filesystem::path folder_;
  mutable std::mutex mutex_;
  std::list<Entry> entries_;
  std::map<std::string, MessagesFile> messages_;  ///< by the name of what waits or is at work
  int free_, threads_;
};

}  // namespace berm::desk
