// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "run_folder/run_folder.hpp"
#include "samples/history_columns.hpp"
#include "samples/run_to_write.hpp"

#include <gtest/gtest.h>

namespace berm {

/// Width and height of a PNG from its first chunk; 0, 0 where the file is not a whole one.
inline std::pair<int, int> png_size(const std::filesystem::path& path)
{
  const std::string bytes = content_of(path);
  if (bytes.size() < 33 || bytes.substr(0, 8) != "\x89PNG\r\n\x1a\n" || bytes.find("IEND") == std::string::npos) return {0, 0};
  const auto number = [&](std::size_t at) {
    int n = 0;
    for (std::size_t k = 0; k < 4; ++k) n = 256 * n + static_cast<unsigned char>(bytes[at + k]);
    return n;
  };
  return {number(16), number(20)};
}

/// A run folder that pictures are drawn in.
class DrawnRun : public testing::Test {
protected:
  TemporaryFolder base;
  run_folder::RunFolder folder{base.path() / "run"};

  static bool gnuplot_is_there() { return std::system("gnuplot --version > /dev/null 2>&1") == 0; }
  run_folder::History pipe_history(Real drag)
  {
    SamplePipe pipe;
    pipe.drag = drag;
    pipe.ripple = 20;
    pipe.write(folder.file("history.csv"));
    return run_folder::read_history(folder.file("history.csv"));
  }
  /// A history with these columns and no rows.
  run_folder::History empty_history()
  {
    put_schema(folder.file("history.csv"), {"time_s", "u_m", "w_m", "H_N_m", "V_N_m"});
    put(folder.file("history.csv"), "time_s,stage,u_m,w_m,H_N_m,V_N_m\n");
    return run_folder::read_history(folder.file("history.csv"));
  }
};

}  // namespace berm
