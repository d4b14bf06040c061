// SPDX-License-Identifier: BSD-3-Clause
// A file of a frame (.vtu) as `berm report` reads it, as one of the soil and as one of rigid bodies: refused, or all of its numbers fit each other.
#include "target.hpp"

#include "os/error.hpp"
#include "run_folder/frame_reader.hpp"

using namespace berm;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  static const MemoryFile file;
  const std::filesystem::path& path = file.hold(data, size);
  try {
    const run_folder::SavedSoil soil = run_folder::read_soil(path);
    const std::size_t count = soil.x.size();
    promise(soil.volume.size() == count && soil.id.size() == count, "fields have a number for each point", std::to_string(count));
    for (const auto& field : soil.fields)
      promise(field.values.size() == static_cast<std::size_t>(field.info.components) * count, "fields have their numbers for each point",
              field.info.name);
    for (const auto& triangle : soil.triangles)
      for (const Index node : triangle) promise(node >= 0 && static_cast<std::size_t>(node) < count, "nodes exist", std::to_string(node));
  } catch (const RunError& error) {
    promise_one_line(error.what());
  }
  try {
    const run_folder::SavedRigids rigid_bodies = run_folder::read_rigids(path);
    promise(rigid_bodies.types.size() == rigid_bodies.cells.size() && rigid_bodies.rigid.size() == rigid_bodies.cells.size(),
            "each cell has a type", "");
    for (const auto& cell : rigid_bodies.cells)
      for (const Index point : cell)
        promise(point >= 0 && static_cast<std::size_t>(point) < rigid_bodies.x.size(), "points exist", std::to_string(point));
  } catch (const RunError& error) {
    promise_one_line(error.what());
  }
  return 0;
}
