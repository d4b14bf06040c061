// SPDX-License-Identifier: BSD-3-Clause
#include "run/in_run_folder.hpp"

#include "core/error.hpp"
#include "input/write_case.hpp"
#include "output/whole_file.hpp"

#include <spdlog/spdlog.h>

namespace berm {

bool in_run_folder(const RunRequest& request, const ScratchFolder& scratch, const std::string& size,
                   const std::function<bool(const RunFolder&, RunLog&)>& run)
{
  const RunFolder folder(request.folder);
  write_whole(folder.file("resolved.toml"), resolved_toml(request.settings));
  write_whole(folder.file("case.toml"), read_whole(request.case_file));
  scratch.move_files_to(folder.path());
  RunLog log(folder.file("run.log"));
  spdlog::info("{} -> {}: {}, {} threads", request.case_file.string(), folder.path().string(), size, request.threads);
  try {
    return run(folder, log);
  } catch (const RunError& error) {
    log.info_to_file(error.what());
    throw;
  }
}

}  // namespace berm
