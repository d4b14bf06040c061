// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "samples/temporary_folder.hpp"

#include <array>
#include <fmt/format.h>
#include <sstream>

namespace berm {

using Color = std::array<int, 3>;

/// Whether pictures can be made and looked at here.
inline bool draws_png()
{
  return std::system("rsvg-convert --version > /dev/null 2>&1 && gnuplot --version > /dev/null 2>&1") == 0;
}

/// Red, green and blue of a pixel of a PNG, counted from the upper left corner, as gnuplot reads it.
inline Color color_at(const std::filesystem::path& picture, int column, int row)
{
  const TemporaryFolder folder;
  const std::filesystem::path table = folder.path() / "table";
  const std::string command =
      fmt::format("gnuplot -e \"set table '{}'; plot '{}' binary filetype=png every ::{}:{}:{}:{} with rgbimage\" > /dev/null 2>&1",
                  table.string(), picture.string(), column, row, column + 1, row + 1);
  if (std::system(command.c_str()) != 0) throw std::runtime_error("gnuplot cannot read " + picture.string());
  std::istringstream lines(content_of(table));
  for (std::string line; std::getline(lines, line);) {
    Color color;
    int x, y;
    if (std::istringstream(line) >> x >> y >> color[0] >> color[1] >> color[2]) return color;
  }
  throw std::runtime_error("no pixel in " + table.string());
}

}  // namespace berm
