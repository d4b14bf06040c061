// SPDX-License-Identifier: BSD-3-Clause
#include "run_folder/frames.hpp"

#include "io/atomic_file.hpp"
#include "os/error.hpp"
#include "run_folder/vtu.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <memory>

namespace berm::run_folder {
namespace {

constexpr const char* collection = "frames.pvd";
constexpr Real compressed_part = 0.6;  // of the bytes before: 0.27 at rest to 0.57 at the end of the probe test

template <int dim, class T>
void append(std::vector<T>& list, const Vec<dim>& v)
{
  for (int d = 0; d < 3; ++d) list.push_back(d < dim ? static_cast<T>(v[d]) : T{0});
}

/// How many components a field has in a file, where vectors have three and symmetric tensors six.
template <int dim>
int components_in_file(int components)
{
  return components == dim ? 3 : components == tensor_size<dim> ? 6 : components;
}

/// A field as a file has it: in single precision, components that there are none of zero.
template <int dim>
std::vector<float> in_file(const FieldValues<Real>& field, std::size_t count)
{
  const int components = field.info.components, all = components_in_file<dim>(components);
  std::vector<float> list(count * static_cast<std::size_t>(all), 0);
  auto to = list.begin();
  for (std::size_t k = 0; k < count; ++k, to += all)
    for (int c = 0; c < components; ++c) to[c] = static_cast<float>(field.at(k, c));
  return list;
}

std::string file_name(const char* kind, Index number)
{
  return fmt::format("{}_{:04}.vtu", kind, number);
}

/// VTK's word for a kind of cell of a surface.
template <int dim>
VtkCell vtk_cell(typename bodies::SurfaceMesh<dim>::Kind kind)
{
  using Kind = typename bodies::SurfaceMesh<dim>::Kind;
  return kind == Kind::line      ? VtkCell::line
         : kind == Kind::polygon ? VtkCell::polygon
         : kind == Kind::quad    ? VtkCell::quad
                                 : VtkCell::hexahedron;
}

}  // namespace

template <int dim>
std::size_t bytes_of_point_in_file(int more_numbers)
{
  const std::size_t place = 3 * sizeof(Real), cell = 2 * sizeof(std::int64_t) + 1, body_and_id = 2 * sizeof(std::int32_t);
  int numbers = 1 + more_numbers;  // the volume
  for (const FieldInfo& info : common_fields<dim>()) numbers += components_in_file<dim>(info.components);
  const std::size_t bytes = place + cell + body_and_id + static_cast<std::size_t>(numbers) * sizeof(float);
  return static_cast<std::size_t>(std::ceil(compressed_part * static_cast<Real>(bytes)));
}

template <int dim>
FrameWriter<dim>::FrameWriter(const std::filesystem::path& folder, const mesh::Mesh<dim>& mesh, bool with_mesh) : folder_(folder)
{
  io::make_folder(folder);
  if (with_mesh) write_mesh(mesh);
}

template <int dim>
void FrameWriter<dim>::write(const Frame<dim>& frame)
{
  if (const std::function<void()> files = write_later(frame)) files();
}

template <int dim>
std::function<void()> FrameWriter<dim>::write_later(const Frame<dim>& frame, Compress when)
{
  if (!times_.empty() && times_.back() == frame.time) return {};  // perhaps by the run that is resumed
  if (times_.empty()) {
    with_rigids_ = !frame.rigid_bodies.empty();
    with_elements_ = !frame.triangles.empty() || !frame.tetrahedra.empty();
  }
  times_.push_back(frame.time);
  const Index number = static_cast<Index>(times_.size()) - 1;
  std::function<void()> files =
      when == Compress::now ? write_files(frame, number) : [this, &frame, number] { write_files(frame, number)(); };
  return [this, files = std::move(files), times = times_] {
    files();
    write_collection(times);
  };
}

/// Compresses them.
template <int dim>
std::function<void()> FrameWriter<dim>::write_files(const Frame<dim>& frame, Index number) const
{
  const auto files = std::make_shared<std::vector<std::pair<std::filesystem::path, Vtu::Packed>>>();
  files->emplace_back(folder_ / file_name(soil_kind(), number), soil(frame));
  if (with_rigids_) files->emplace_back(folder_ / file_name("rigid", number), rigids(frame));
  return [files] {
    for (const auto& [path, packed] : *files) packed.write(path);
  };
}

template <int dim>
std::vector<std::string> FrameWriter<dim>::files() const
{
  std::vector<std::string> names;
  for (Index k = 0; k < static_cast<Index>(times_.size()); ++k) {
    names.push_back(file_name(soil_kind(), k));
    if (with_rigids_) names.push_back(file_name("rigid", k));
  }
  return names;
}

template <int dim>
void FrameWriter<dim>::archive(Archive& k)
{
  k("times", times_);
  k("with_rigids", with_rigids_);
  k("with_triangles", with_elements_);
  if (!k.reads()) return;
  for (const std::string& name : files())
    if (!std::filesystem::exists(folder_ / name)) k.refuse(fmt::format("{} is gone", (folder_ / name).string()));
}

template <int dim>
void FrameWriter<dim>::remove_others() const
{
  write_collection(times_);
  const std::vector<std::string> kept = files();
  std::error_code error;
  std::vector<std::filesystem::path> others;
  for (const auto& entry : std::filesystem::directory_iterator(folder_, error)) {
    const std::string name = entry.path().filename().string();
    const bool ours = name.starts_with("particles_") || name.starts_with("soil_") || name.starts_with("rigid_") || name.ends_with(".part");
    if (ours && std::find(kept.begin(), kept.end(), name) == kept.end()) others.push_back(entry.path());
  }
  for (const std::filesystem::path& other : others)
    if (!std::filesystem::remove(other, error)) throw RunError(fmt::format("cannot remove {}: {}", other.string(), error.message()));
}

template <int dim>
void FrameWriter<dim>::write_mesh(const mesh::Mesh<dim>& mesh) const
{
  std::vector<Real> points;
  points.reserve(3 * mesh.position.size());
  for (const Vec<dim>& x : mesh.position) append<dim>(points, x);
  Vtu vtu(std::move(points));
  vtu.reserve_cells(mesh.nodes.size(), dim + 1);
  for (const auto& nodes : mesh.nodes)
    vtu.add_cell(dim == 2 ? VtkCell::triangle : VtkCell::tetrahedron, std::vector<Index>(nodes.begin(), nodes.end()));
  const std::vector<std::int32_t> region(mesh.region.begin(), mesh.region.end());
  vtu.cell_field("region", 1, region);
  vtu.write(folder_ / "mesh.vtu");
}

template <int dim>
Vtu::Packed FrameWriter<dim>::soil(const Frame<dim>& frame) const
{
  const std::size_t count = frame.points.size();
  std::vector<Real> points;
  points.reserve(3 * count);  // a list that grows by doubling would take half as much again, of the memory of a large run
  for (const Vec<dim>& x : frame.points) append<dim>(points, x);
  Vtu vtu(std::move(points));
  const std::size_t elements = frame.triangles.size() + frame.tetrahedra.size();
  vtu.reserve_cells(with_elements_ ? elements : count, !with_elements_ ? 1 : dim == 2 ? 6 : 10);
  for (const auto& nodes : frame.triangles) vtu.add_cell(VtkCell::quadratic_triangle, std::vector<Index>(nodes.begin(), nodes.end()));
  for (const auto& nodes : frame.tetrahedra) vtu.add_cell(VtkCell::quadratic_tetrahedron, std::vector<Index>(nodes.begin(), nodes.end()));
  if (!with_elements_)
    for (Index k = 0; k < static_cast<Index>(count); ++k) vtu.add_cell(VtkCell::vertex, {k});
  vtu.set_time(frame.time);
  for (const FieldValues<Real>& field : frame.fields) {
    FieldInfo info = field.info;
    info.components = components_in_file<dim>(info.components);
    vtu.point_field(info, in_file<dim>(field, count),
                    info.components == 6 ? std::vector<const char*>{"XX", "YY", "ZZ", "XY", "YZ", "XZ"} : std::vector<const char*>{});
  }
  const std::vector<float> volume(frame.volume.begin(), frame.volume.end());
  vtu.point_field(FieldInfo{"volume", "volume that the point stands for", dim == 2 ? "m2" : "m3"}, volume);
  vtu.point_field(FieldInfo{"body", "number of the body", ""}, frame.body);
  vtu.point_field(FieldInfo{"id", "number in its body", ""}, frame.id);
  return vtu.pack();
}

template <int dim>
Vtu::Packed FrameWriter<dim>::rigids(const Frame<dim>& frame) const
{
  std::vector<Real> points;
  for (const FrameRigid<dim>& f : frame.rigid_bodies)
    for (const Vec<dim>& x : f.surface.points) append<dim>(points, x);
  Vtu vtu(std::move(points));
  std::vector<std::int32_t> rigid;
  std::vector<float> velocity;
  Index first = 0;
  for (std::size_t r = 0; r < frame.rigid_bodies.size(); ++r) {
    for (const auto& cell : frame.rigid_bodies[r].surface.cells) {
      std::vector<Index> corners = cell.points;
      for (Index& corner : corners) corner += first;
      vtu.add_cell(vtk_cell<dim>(cell.kind), corners);
      rigid.push_back(static_cast<std::int32_t>(r));
      append<dim>(velocity, frame.rigid_bodies[r].velocity);
    }
    first += static_cast<Index>(frame.rigid_bodies[r].surface.points.size());
  }
  vtu.set_time(frame.time);
  vtu.cell_field("rigid", 1, rigid);
  vtu.cell_field("velocity", 3, velocity);
  return vtu.pack();
}

template <int dim>
void FrameWriter<dim>::write_collection(const std::vector<Real>& times) const
{
  std::string xml = "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"1.0\" byte_order=\"LittleEndian\">\n<Collection>\n";
  for (std::size_t k = 0; k < times.size(); ++k) {
    const auto line = [&](int part, const char* kind) {
      xml += fmt::format("<DataSet timestep=\"{}\" part=\"{}\" name=\"{}\" file=\"{}\"/>\n", times[k], part, kind,
                         file_name(kind, static_cast<Index>(k)));
    };
    line(0, soil_kind());
    if (with_rigids_) line(1, "rigid");
  }
  io::write_atomically(folder_ / collection, xml + "</Collection>\n</VTKFile>\n");
}

template std::size_t bytes_of_point_in_file<2>(int);
template std::size_t bytes_of_point_in_file<3>(int);
template class FrameWriter<2>;
template class FrameWriter<3>;

}  // namespace berm::run_folder
