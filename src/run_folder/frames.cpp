// SPDX-License-Identifier: BSD-3-Clause
#include "run_folder/frames.hpp"

#include "core/error.hpp"
#include "io/atomic_file.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::run_folder {
namespace {

constexpr const char* collection = "frames.pvd";

template <int dim, class T>
void append(std::vector<T>& list, const Vec<dim>& v)
{
  for (int d = 0; d < 3; ++d) list.push_back(d < dim ? static_cast<T>(v[d]) : T{0});
}

std::string file_name(const char* kind, Index number)
{
  return fmt::format("{}_{:04}.vtu", kind, number);
}

}  // namespace

template <int dim>
FrameWriter<dim>::FrameWriter(const std::filesystem::path& folder, const mesh::Mesh<dim>& mesh) : folder_(folder)
{
  io::make_folder(folder);
  write_mesh(mesh);
}

template <int dim>
void FrameWriter<dim>::write(Frame<dim> frame)
{
  const bool written = !times_.empty() && times_.back() == frame.time;
  if (written && last_.time == frame.time) return;
  last_ = std::move(frame);
  if (written) return;  // by the run that this one goes on with
  with_rigids_ = !last_.rigid_bodies.empty();
  const Index number = static_cast<Index>(times_.size());
  write_soil(file_name(soil_kind(), number));
  if (with_rigids_) write_rigids(file_name("rigid", number));
  times_.push_back(last_.time);
  write_collection();
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
  if (!k.reads()) return io::sync_file(folder_);
  for (const std::string& name : files())
    if (!std::filesystem::exists(folder_ / name)) k.refuse(fmt::format("{} is gone", (folder_ / name).string()));
}

template <int dim>
void FrameWriter<dim>::remove_others() const
{
  write_collection();
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
  io::Vtu vtu(std::move(points));
  vtu.reserve_cells(mesh.nodes.size(), dim + 1);
  for (const auto& nodes : mesh.nodes)
    vtu.add_cell(dim == 2 ? io::VtkCell::triangle : io::VtkCell::tetrahedron, std::vector<Index>(nodes.begin(), nodes.end()));
  const std::vector<std::int32_t> region(mesh.region.begin(), mesh.region.end());
  vtu.cell_field("region", 1, region);
  vtu.write(folder_ / "mesh.vtu");
}

template <int dim>
void FrameWriter<dim>::write_soil(const std::string& name) const
{
  std::vector<Real> points;
  std::vector<float> velocity, displacement, stress, mean_stress, strain, volumetric, increment, accumulated, volume;
  std::vector<std::int32_t> body, id;
  // Lists that grow by doubling would take half as much again, of the memory of a large run.
  const std::size_t count = last_.particles.size();
  points.reserve(3 * count);
  for (auto* list : {&velocity, &displacement}) list->reserve(3 * count);
  stress.reserve(6 * count);
  for (auto* list : {&mean_stress, &strain, &volumetric, &increment, &accumulated, &volume}) list->reserve(count);
  for (auto* list : {&body, &id}) list->reserve(count);
  for (const FrameParticle<dim>& f : last_.particles) {
    const bodies::Particle<dim>& p = f.particle;
    append<dim>(points, p.x);
    append<dim>(velocity, p.v);
    append<dim>(displacement, f.displacement);
    for (int k = 0; k < 6; ++k) stress.push_back(k < tensor_size<dim> ? static_cast<float>(p.stress[k]) : 0);
    mean_stress.push_back(static_cast<float>(trace(p.stress) / 3));
    strain.push_back(static_cast<float>(f.strain.deviatoric));
    volumetric.push_back(static_cast<float>(f.strain.volumetric));
    increment.push_back(static_cast<float>(f.strain_increment));
    accumulated.push_back(static_cast<float>(p.deviatoric_strain));
    volume.push_back(static_cast<float>(p.volume));
    body.push_back(f.body);
    id.push_back(p.id);
  }
  io::Vtu vtu(std::move(points));
  vtu.reserve_cells(last_.triangles.empty() ? count : last_.triangles.size(), last_.triangles.empty() ? 1 : 6);
  for (const auto& nodes : last_.triangles) vtu.add_cell(io::VtkCell::quadratic_triangle, std::vector<Index>(nodes.begin(), nodes.end()));
  if (last_.triangles.empty())
    for (Index k = 0; k < static_cast<Index>(last_.particles.size()); ++k) vtu.add_cell(io::VtkCell::vertex, {k});
  vtu.set_time(last_.time);
  vtu.point_field("velocity", 3, velocity);
  vtu.point_field("displacement", 3, displacement);
  vtu.point_field("stress", 6, stress, {"XX", "YY", "ZZ", "XY", "YZ", "XZ"});
  vtu.point_field("mean_stress", 1, mean_stress);
  vtu.point_field("deviatoric_strain", 1, strain);
  vtu.point_field("volumetric_strain", 1, volumetric);
  vtu.point_field("incremental_deviatoric_strain", 1, increment);
  vtu.point_field("accumulated_deviatoric_strain", 1, accumulated);
  vtu.point_field("volume", 1, volume);
  vtu.point_field("body", 1, body);
  vtu.point_field("id", 1, id);
  vtu.write(folder_ / name);
}

template <int dim>
void FrameWriter<dim>::write_rigids(const std::string& name) const
{
  std::vector<Real> points;
  for (const FrameRigid<dim>& f : last_.rigid_bodies)
    for (const Vec<dim>& x : f.surface.points) append<dim>(points, x);
  io::Vtu vtu(std::move(points));
  std::vector<std::int32_t> rigid;
  std::vector<float> velocity;
  Index first = 0;
  for (std::size_t r = 0; r < last_.rigid_bodies.size(); ++r) {
    for (const auto& cell : last_.rigid_bodies[r].surface.cells) {
      std::vector<Index> corners = cell.points;
      for (Index& corner : corners) corner += first;
      vtu.add_cell(cell.type, corners);
      rigid.push_back(static_cast<std::int32_t>(r));
      append<dim>(velocity, last_.rigid_bodies[r].velocity);
    }
    first += static_cast<Index>(last_.rigid_bodies[r].surface.points.size());
  }
  vtu.set_time(last_.time);
  vtu.cell_field("rigid", 1, rigid);
  vtu.cell_field("velocity", 3, velocity);
  vtu.write(folder_ / name);
}

template <int dim>
void FrameWriter<dim>::write_collection() const
{
  std::string xml = "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"1.0\" byte_order=\"LittleEndian\">\n<Collection>\n";
  for (std::size_t k = 0; k < times_.size(); ++k) {
    const auto line = [&](int part, const char* kind) {
      xml += fmt::format("<DataSet timestep=\"{}\" part=\"{}\" name=\"{}\" file=\"{}\"/>\n", times_[k], part, kind,
                         file_name(kind, static_cast<Index>(k)));
    };
    line(0, soil_kind());
    if (with_rigids_) line(1, "rigid");
  }
  io::write_atomically(folder_ / collection, xml + "</Collection>\n</VTKFile>\n");
}

template class FrameWriter<2>;
template class FrameWriter<3>;

}  // namespace berm::run_folder
