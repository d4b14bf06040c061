// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "desk/folder.hpp"
#include "desk/live.hpp"
#include "desk/queue.hpp"

#include <chrono>
#include <functional>
#include <map>
#include <set>

namespace berm::desk {

/// The runs in a folder, whoever began them: started, stopped, and how far they are.
class Runs {
public:
  /// `place`: where a run of a case goes where nobody says it; `more`: options that each run has.
  Runs(const Folder& folder, std::shared_ptr<Queue> queue, std::function<std::filesystem::path(const std::filesystem::path&)> place,
       std::vector<std::string> more)
      : folder_(folder),
        queue_(std::move(queue)),
        place_(std::move(place)),
        more_(std::move(more)),
        live_(folder)
  {
  }

  Json list();
  /// {case, out?, set?, threads?} or {resume, threads?}: {path}.
  Json start(const Json& body);
  void stop(const std::string& name);
  /// The folder of a run that nobody is at work on, and what it printed. Throws Refusal.
  void remove(const std::string& name);
  /// Gives such a folder another name in its place: {path}. Throws Refusal.
  Json rename(const std::string& name, const std::string& new_name);
  /// What its reader writes about it. Throws Refusal.
  void note(const std::string& name, const std::string& text);
  /// State, advance, rows of the history from a number on, end of the log, and the summary once there is one.
  Json one(const std::string& name, std::size_t from_row);

private:
  /// What a run is that nobody is at work on, and its case; looked up anew where its files changed.
  struct AtRest {
    std::string of, case_file;
    WorkState state;
    std::string why;                ///< it did not come to its end
    Json summary = Json::object();  ///< digest_of, and its bytes on the disk
  };
  std::filesystem::path at_hand(const std::string& name) const;
  void look_again();
  AtRest at_rest(const std::filesystem::path& run);
  Json state_of(const std::string& name, const std::optional<Queue::Entry>& entry);
  std::vector<std::filesystem::path> found();
  Work work_of(const Json& body, const std::set<std::filesystem::path>& taken);
  std::filesystem::path free_place(const std::filesystem::path& case_file, const std::set<std::filesystem::path>& taken) const;

  const Folder& folder_;
  std::shared_ptr<Queue> queue_;
  std::function<std::filesystem::path(const std::filesystem::path&)> place_;
  std::vector<std::string> more_;
  Live live_;
  std::mutex mutex_;
  std::map<std::string, AtRest> at_rest_;
  std::vector<std::filesystem::path> found_;
  std::chrono::steady_clock::time_point looked_{};
};

/// --set of each change that a client wishes, KEY=VALUE. Throws Refusal.
std::vector<std::string> changes_in(const Json& body);
int threads_in(const Json& body, int otherwise);

}  // namespace berm::desk
