// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/structures/penetration/penetration_run_test.cpp
#include "structures/penetration/found_walls.hpp"

#include "core/error.hpp"
#include "mesh/seabed.hpp"
#include "run_folder/frame_reader.hpp"

#include <algorithm>

namespace berm::penetration {
namespace {

constexpr Real near_middle = 0.1;  // of D

Walls in_first_frame(const record::RunRecord& run, const base::BodyProfile& body)
{
  if (run.folder.empty() || run.settings.geometry == problem::Geometry::axisymmetric) return {};
  try {
    const std::vector<run_folder::FrameFiles> frames = run_folder::frame_files(run.folder / "frames");
    if (frames.empty()) return {};
    const std::vector<float> x = run_folder::read_soil(frames.front().soil).x;
    if (x.empty()) return {};
    const auto [least, most] = std::minmax_element(x.begin(), x.end());
    const Real middle = (body.left + body.right) / 2, reach = near_middle * body.width;
    Walls walls;
    if (std::abs(*least - middle) < reach) walls.left = middle;
    if (std::abs(*most - middle) < reach) walls.right = middle;
    return walls;
  } catch (const RunError&) {
    return {};  // the page says so where it shows the frames
  }
}

}  // namespace

Walls walls_of(const record::RunRecord& run, const base::BodyProfile& body)
{
  const mesh::MeshSettings& mesh = run.settings.mesh;
  if (const auto* bed = std::get_if<mesh::SeabedMesh>(&mesh)) {
    const mesh::SeabedLayout layout = layout_of(*bed);
    return {layout.left, layout.right, bed->depth > 0 ? -bed->depth : -infinity};
  }
  if (const auto* box = std::get_if<mesh::BoxMesh>(&mesh)) {
    const Vec<2> lower = bodies::to_vec<2>(box->lower), size = bodies::to_vec<2>(box->size);
    return {lower[0], lower[0] + size[0], lower[1]};
  }
  return in_first_frame(run, body);
}

}  // namespace berm::penetration
