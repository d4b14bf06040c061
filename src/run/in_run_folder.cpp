// SPDX-License-Identifier: BSD-3-Clause
#include "run/in_run_folder.hpp"

#include "core/error.hpp"
#include "input/write_case.hpp"
#include "output/whole_file.hpp"

#include <exception>
#include <spdlog/spdlog.h>

namespace berm {

bool in_run_folder(const RunRequest& request, const ScratchFolder& scratch, const std::string& size,
                   const std::function<bool(const RunFolder&, RunLog&)>& run)
{
  const RunFolder folder(request.folder);
  write_whole(folder.file("resolved.toml"), resolved_toml(request.settings));
  copy_whole(request.case_file, folder.file("case.toml"));
  scratch.move_files_to(folder.path());
  RunLog log(folder.file("run.log"));
  spdlog::info("{} -> {}: {}, {} threads", request.case_file.string(), folder.path().string(), size, request.threads);
  try {
    const bool finished = run(folder, log);
    log.check();
    return finished;
  } catch (const RunError& error) {
    log.info_to_file(error.what());
    throw;
  }
}

void run_and_leave(const std::function<void()>& run, const std::function<void()>& leave_results)
{
  std::exception_ptr failure;
  try {
    run();
  } catch (const RunError&) {
    failure = std::current_exception();
  }
  try {
    leave_results();
  } catch (const RunError& error) {
    if (!failure) throw;
    spdlog::warn("{}", error.what());
  }
  if (failure) std::rethrow_exception(failure);
}

}  // namespace berm
