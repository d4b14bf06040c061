// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/problem/build_test.cpp
#include "boundary/support.hpp"

#include "os/error.hpp"
#include "os/text_of_list.hpp"

#include <fmt/format.h>

namespace berm::boundary {

void describe(Describe& d, SupportSettings& support)
{
  d.value("boundary", support.boundary, {.meaning = "boundary of the mesh that is fixed", .required = true});
  d.value("fixed", support.fixed, {.meaning = "directions that are fixed: \"x\", \"y\", \"z\"", .required = true});
  d.value("drained", support.drained,
          {.meaning = "the water of consolidating soil flows across the boundary; else it does not in the directions that are fixed"});
  d.value("absorbs", support.absorbs,
          {.meaning = "the boundary holds in geostatic stages only; in others it keeps the force that it held then, and yields to waves as "
                      "if the same soil continued beyond it: dashpots with the impedance of the soil in the directions that are fixed"});
  d.value("head", support.head,
          {.meaning =
               "of a drained support: head of the water outside above that of the sea at rest, less than 0 below it. The excess pore "
               "pressure at the boundary is 9.81 kN/m^3 times it, whatever the gravity of the case; absent = none",
           .unit = "m"});
  d.value("ramp", support.ramp,
          {.meaning = "time over which the head rises where the support begins to act, and falls where it no longer acts; 0 = at once",
           .unit = "s",
           .range = not_negative});
  d.optional_table("motion", support.motion,
                   {.meaning =
                        "the boundary moves in some stages. Where the support holds this is the velocity of the soil at it; where it "
                        "absorbs it is the velocity of the incoming wave, which a free surface doubles. Along the directions in `fixed`"});
  d.value("stages", support.stages, {.meaning = "names of the stages in which it acts; in others it is released; absent or empty = all"});
}

template <int dim>
Index fixed_boundary(const mesh::Mesh<dim>& mesh, const std::string& name, const SupportSettings& support)
{
  const Index boundary = mesh.find_boundary(support.boundary);
  if (boundary == none)
    throw KeyError(fmt::format("support.{}.boundary: the mesh has no boundary \"{}\"; it has {}", name, support.boundary,
                               text_of_list(mesh.boundary_names, ", ")));
  return boundary;
}

std::uint8_t fixed_directions(const SupportSettings& support)
{
  int bits = 0;
  for (const std::string& direction : support.fixed) bits |= 1 << (direction[0] - 'x');
  return static_cast<std::uint8_t>(bits);
}

template Index fixed_boundary<2>(const mesh::Mesh<2>&, const std::string&, const SupportSettings&);
template Index fixed_boundary<3>(const mesh::Mesh<3>&, const std::string&, const SupportSettings&);

}  // namespace berm::boundary
