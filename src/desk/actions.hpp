// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "desk/folder.hpp"
#include "desk/questions.hpp"
#include "desk/queue.hpp"

#include <map>
#include <mutex>

namespace berm::desk {

/// What a desk does with cases and runs by the commands of berm, beside single runs.
class Actions {
public:
  /// `more`: options of a command that reads a case.
  Actions(const Folder& folder, std::shared_ptr<Queue> queue, Questions& questions, std::vector<std::string> more)
      : folder_(folder),
        queue_(std::move(queue)),
        questions_(questions),
        more_(std::move(more))
  {
  }

  /// JSON that a command prints: kinds of new cases, named soils.
  Json printed(const std::vector<std::string>& words);
  /// Of a case, element tests or a study.
  Json schema(const std::string& of);
  Json new_case(const Json& body);
  /// An SVG of a kind of new case.
  std::string picture(const std::string& kind);
  /// What `berm check` finds in a text as if it lay at a path; its drawing as SVG.
  Json check(const Json& body);
  std::string draw(const Json& body);
  Json report(const Json& body);
  Json export_springs(const Json& body);

  /// Whether there is such a kind of job: study, envelope, safety, element, uncertainty.
  static bool is_job(const std::string& kind);
  Json start(const std::string& kind, const Json& body);
  Json jobs() const;

private:
  CommandOutput written(const Json& body);
  std::string drawn(const std::string& text, const std::string& path);
  std::string answer_of(const Question& question);
  std::vector<std::string> runs_in(const Json& body) const;
  std::filesystem::path free_page() const;

  const Folder& folder_;
  std::shared_ptr<Queue> queue_;
  Questions& questions_;
  std::vector<std::string> more_;
  std::mutex mutex_;
  std::map<std::string, std::string> pictures_;  ///< by kind: they are the same as long as the program is
};

}  // namespace berm::desk
