// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "settings/pipeline_settings.hpp"

#include <filesystem>

namespace berm::input {

/// Reads the files of the route and of the far soil's resistance, paths from `folder`, into their numbers: x_m,y_m and u_m,H_N_m (table_file.hpp). Throws KeyError where there is no
/// such file, and InputError with file and line where it is wrong.
void read_pipeline_tables(settings::PipelineSettings& pipeline, const std::filesystem::path& folder);

}  // namespace berm::input
