// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/run_folder/frames_test.cpp
#include "run_folder/vtu.hpp"

#include "io/atomic_file.hpp"
#include "run_folder/vtk_name.hpp"
#include "run_folder/xml_tag.hpp"
#include "run_folder/zlib_blocks.hpp"

#include <fmt/format.h>

namespace berm::run_folder {
namespace {

template <class T>
std::string attributes(const std::string& name, int components)
{
  return fmt::format("type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\"", vtk_name<T>, name, components);
}

template <class T>
std::string_view bytes_of(const std::vector<T>& values)
{
  return std::string_view(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T));
}

}  // namespace

void Vtu::reserve_cells(std::size_t cells, std::size_t points)
{
  connectivity_.reserve(connectivity_.size() + cells * points);
  offsets_.reserve(offsets_.size() + cells);
  types_.reserve(types_.size() + cells);
}

void Vtu::add_cell(VtkCell type, const std::vector<Index>& points)
{
  connectivity_.insert(connectivity_.end(), points.begin(), points.end());
  offsets_.push_back(static_cast<std::int64_t>(connectivity_.size()));
  types_.push_back(static_cast<std::uint8_t>(type));
}

template <class T>
void Vtu::point_field(const FieldInfo& info, const std::vector<T>& values, const std::vector<const char*>& component_names)
{
  std::string words = attributes<T>(info.name, info.components);
  int k = 0;
  for (const char* component : component_names) words += fmt::format(" ComponentName{}=\"{}\"", k++, component);
  for (const auto& [name, text] : {std::pair("Label", info.label), std::pair("Unit", info.unit)})
    if (!text.empty()) words += fmt::format(" {}=\"{}\"", name, xml_attribute(text));
  point_fields_.push_back({words, zlib_blocks(bytes_of(values))});
}

template <class T>
void Vtu::cell_field(const std::string& name, int components, const std::vector<T>& values)
{
  cell_fields_.push_back({attributes<T>(name, components), zlib_blocks(bytes_of(values))});
}

Vtu::Packed Vtu::pack()
{
  Packed file;
  std::string& xml = file.header_;
  std::uint64_t offset = 0;
  const auto add_packed = [&](const std::string& words, std::string packed) {
    xml += fmt::format("<DataArray {} format=\"appended\" offset=\"{}\"/>\n", words, offset);
    offset += packed.size();
    file.arrays_.push_back(std::move(packed));
  };
  const auto add = [&](const std::string& words, std::string_view bytes) { add_packed(words, zlib_blocks(bytes)); };
  const std::vector<Real> time = {time_};
  xml += "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" "
         "header_type=\"UInt64\" compressor=\"vtkZLibDataCompressor\">\n<UnstructuredGrid>\n";
  if (!std::isnan(time_)) {
    xml += "<FieldData>\n";
    add("type=\"Float64\" Name=\"TimeValue\" NumberOfTuples=\"1\"", bytes_of(time));
    xml += "</FieldData>\n";
  }
  xml += fmt::format("<Piece NumberOfPoints=\"{}\" NumberOfCells=\"{}\">\n<Points>\n", point_count(), cell_count());
  add(attributes<Real>("Points", 3), bytes_of(points_));
  xml += "</Points>\n<Cells>\n";
  add("type=\"Int64\" Name=\"connectivity\"", bytes_of(connectivity_));
  add("type=\"Int64\" Name=\"offsets\"", bytes_of(offsets_));
  add("type=\"UInt8\" Name=\"types\"", bytes_of(types_));
  xml += "</Cells>\n<PointData>\n";
  for (Array& field : point_fields_) add_packed(field.attributes, std::move(field.packed));
  xml += "</PointData>\n<CellData>\n";
  for (Array& field : cell_fields_) add_packed(field.attributes, std::move(field.packed));
  xml += "</CellData>\n</Piece>\n</UnstructuredGrid>\n<AppendedData encoding=\"raw\">\n_";
  *this = Vtu(std::vector<Real>());
  return file;
}

void Vtu::Packed::write(const std::filesystem::path& path) const
{
  std::vector<std::string_view> parts = {header_};
  parts.insert(parts.end(), arrays_.begin(), arrays_.end());
  parts.emplace_back("\n</AppendedData>\n</VTKFile>\n");
  io::write_atomically(path, parts);
}

template void Vtu::point_field(const FieldInfo&, const std::vector<double>&, const std::vector<const char*>&);
template void Vtu::point_field(const FieldInfo&, const std::vector<float>&, const std::vector<const char*>&);
template void Vtu::point_field(const FieldInfo&, const std::vector<std::int32_t>&, const std::vector<const char*>&);
template void Vtu::cell_field(const std::string&, int, const std::vector<double>&);
template void Vtu::cell_field(const std::string&, int, const std::vector<float>&);
template void Vtu::cell_field(const std::string&, int, const std::vector<std::int32_t>&);

}  // namespace berm::run_folder
