// SPDX-License-Identifier: BSD-3-Clause
// A file of the surface of a rigid body: of an input whose first byte is o the rest is an OBJ file, of others an STL file, as text or binary. Refused in one line, or a
// body with a volume and moments of inertia.
#include "target.hpp"

#include "bodies/rigid/triangle_faults.hpp"
#include "bodies/rigid/triangle_file.hpp"

using namespace berm;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  static const MemoryFolder folder;
  const auto [kind, text] = kind_and_text(data, size, 'o');
  const std::filesystem::path file = folder.hold(kind == 'o' ? "surface.obj" : "surface.stl", text);
  may_be_refused([&] {
    const bodies::Triangles triangles = bodies::read_triangles(file);
    const std::string fault = fault_of(triangles);
    if (!fault.empty()) return promise_one_line(fault);
    const bodies::Contents contents = contents_of(triangles);
    promise(std::isfinite(contents.volume) && contents.volume != 0, "a surface contains a volume", fmt::format("{}", contents.volume));
    promise(contents.center.allFinite(), "it has a centre", "");
    promise(contents.inertia.allFinite() && contents.inertia.minCoeff() > 0, "its moments of inertia are positive",
            fmt::format("{} {} {}", contents.inertia[0], contents.inertia[1], contents.inertia[2]));
  });
  return 0;
}
