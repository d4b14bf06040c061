// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/sanity/sanity_test.cpp
#include "sanity/questions.hpp"
#include "sanity/sanity.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <limits>

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

/// Numbers are 2^-52 |x| apart. A step moves soil by about 1e-3 of a cell, of which a hundredth must count.
void are_coordinates_resolved(const Scene& s, Findings& found)
{
  constexpr Real resolved = 1e-5;
  Real cell = infinity, farthest = 0;
  for (Index r = 0; r < static_cast<Index>(s.rigids.size()); ++r)
    if (const Real here = s.cell_size(r, {}); here < cell) cell = here;
  for (const SupportScene& support : s.supports) cell = std::min(cell, support.cell);
  for (const Span& span : s.mesh)
    if (span.to >= span.from) farthest = std::max({farthest, std::abs(span.from), std::abs(span.to)});
  const Real apart = std::numeric_limits<Real>::epsilon() * farthest;
  if (!(apart > resolved * cell)) return;
  found.refuse(
      "mesh",
      fmt::format(
          "lies up to {:.3g} m from the origin, where numbers are {:.2g} m apart, {:.1g} of a cell of {}: soil that moves less in a "
          "step would not move at all; move the origin of all coordinates nearer, to less than {:.1g} m",
          farthest, apart, apart / cell, words_of(cell, "m"), resolved * cell / std::numeric_limits<Real>::epsilon()));
}

void are_depth_slices_thicker_than_cells(const Scene& s, Findings& found)
{
  for (Index r = 0; r < static_cast<Index>(s.rigids.size()); ++r) {
    const auto& [name, rigid] = s.c.rigid[r];
    if (rigid.depth_slices == 0 || s.up_sign < 0 || !s.ground.line.level()) continue;
    const Real height = s.c.surface - s.rigids[r].space[s.up].from, thickness = height / rigid.depth_slices, cell = s.cell_size(r, {});
    if (!(thickness < 0.95 * cell)) continue;
    found.warn(fmt::format("rigid.{}.depth_slices", name),
               fmt::format("slices are {} thick and cells {}: a slice is then loaded by its neighbours; take {:.0f} or fewer",
                           words_of(thickness, "m"), words_of(cell, "m"), std::max(Real(1), std::floor(height / cell))));
  }
}

void do_slices_slide_without_jolts(const Scene& s, Findings& found)
{
  if (!s.is_mpm() || s.c.mpm.quadrature == settings::Quadrature::cut_cells) return;
  for (Index r = 0; r < static_cast<Index>(s.rigids.size()); ++r) {
    const auto& [name, rigid] = s.c.rigid[r];
    const bool driven = std::any_of(s.ways.begin(), s.ways.end(), [&](const Way& way) { return way.rigid == r; });
    const bool rubs = std::any_of(s.c.contact.begin(), s.c.contact.end(), [&, &of = name](const auto& contact) {
      const contact::ContactSettings& at = contact.second;
      return at.rigid == of && (at.friction_angle > 0 || at.adhesion > 0 || at.adhesion_factor > 0);
    });
    if (rigid.depth_slices > 0 && !driven && rubs)
      found.warn(fmt::format("rigid.{}.depth_slices", name),
                 fmt::format("no stage drives \"{}\", so the soil moves along it: mpm.quadrature = \"cut_cells\" avoids vibration of slow "
                             "soil at a shaft, which loses up to a tenth of the shaft friction",
                             name));
  }
}

}  // namespace berm::sanity
