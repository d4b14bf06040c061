// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <functional>

namespace berm {

/// While it lives, meshes that gmsh generates from berm's own geometries are cached in a folder, for this process and those that it starts: runs of one mesh start gmsh once. A cache of the
/// process that started this one stays in force.
class MeshCache {
public:
  explicit MeshCache(const std::filesystem::path& folder);
  ~MeshCache();
  MeshCache(const MeshCache&) = delete;
  MeshCache& operator=(const MeshCache&) = delete;

private:
  bool outermost_;
};

/// Copies the cached mesh of this geometry and dimension to `msh`, and its log to the .log beside it; or calls generate(), which makes them, and caches them. Of several processes that want the
/// same mesh at once one generates it, and the others wait. A mesh that cannot be cached is generated each time. Throws what generate() throws.
void cached_or_generated(const std::filesystem::path& geo, const std::filesystem::path& msh, int dim,
                         const std::function<void()>& generate);

}  // namespace berm
