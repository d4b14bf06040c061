// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/sanity/sanity_test.cpp
#include "sanity/questions.hpp"
#include "sanity/sanity.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::sanity {

void is_the_mesh_what_its_file_says(const Scene& s, Findings& found)
{
  for (const std::string& remark : s.mesh_remarks) found.warn("mesh.file", remark);
}

void is_the_mesh_in_metres(const Scene& s, Findings& found)
{
  constexpr Real per_mm = 1000, fewest = 1, most = 1000;  // widths of the body that a mesh spans
  const auto* file = std::get_if<mesh::GmshFile>(&s.c.mesh);
  if (file == nullptr || file->made_from) return;
  Real width = 0, extent = 0;
  for (const RigidScene& rigid : s.rigids) width = std::max(width, rigid.width);
  for (const Span& span : s.mesh)
    if (span.to > span.from) extent = std::max(extent, span.length());
  if (!(width > 0) || extent < most * width) return;
  const Real as_mm = extent / per_mm / width;
  if (as_mm < fewest || as_mm > most) return;
  found.refuse("mesh.file",
               fmt::format("spans {}, {:.2g} times the rigid body, {}: is the mesh in millimetres? mesh.scale = {:g} reads it so",
                           words_of(extent, "m"), extent / width, words_of(width, "m"), file->scale / per_mm));
}

}  // namespace berm::sanity
