// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <functional>

namespace berm::mesh {

/// While it lives, meshes that gmsh makes of berm's own geometries are kept in a folder, for this process and those that it starts: runs of one mesh start gmsh once. Where a process that
/// started this one keeps them, its folder stays the one.
class KeptMeshes {
public:
  explicit KeptMeshes(const std::filesystem::path& folder);
  ~KeptMeshes();
  KeptMeshes(const KeptMeshes&) = delete;
  KeptMeshes& operator=(const KeptMeshes&) = delete;

private:
  bool outermost_;
};

/// Gives `msh`, and the .log beside it, the bytes that were kept of this geometry, in this dimension, or calls make(), which makes them, and keeps them. Of several processes that want the same mesh at
/// once one makes it, and the others wait. What cannot be kept is made each time. Throws what make() throws.
void kept_or_made(const std::filesystem::path& geo, const std::filesystem::path& msh, int dim, const std::function<void()>& make);

}  // namespace berm::mesh
