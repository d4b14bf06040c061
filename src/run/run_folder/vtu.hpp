// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/field_info.hpp"
#include "core/types.hpp"

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace berm::run_folder {

/// Types of cells, as VTK numbers them.
enum class VtkCell : std::uint8_t {
  vertex = 1,
  line = 3,
  triangle = 5,
  polygon = 7,
  quad = 9,
  tetrahedron = 10,
  hexahedron = 12,
  quadratic_triangle = 22,
  quadratic_tetrahedron = 24
};

/// An unstructured grid, to be written to a .vtu file: VTK's XML format, version 1.0, with appended little-endian data, each array
/// compressed by zlib (zlib_blocks.hpp), and UInt64 headers. Fields are compressed when they are given: frames of many particles are large.
class Vtu {
public:
  /// The grid's points: x y z of each, m.
  explicit Vtu(std::vector<Real> points) : points_(std::move(points)) {}

  std::size_t point_count() const { return points_.size() / 3; }
  std::size_t cell_count() const { return types_.size(); }
  /// Makes room for `cells` more of about `points` points each.
  void reserve_cells(std::size_t cells, std::size_t points);
  void add_cell(VtkCell type, const std::vector<Index>& points);

  /// A field: `components` numbers of each point or cell, one after the other. T: float, double or std::int32_t. A field of
  /// points also has its label and unit in the file, as attributes Label and Unit of its array, which other programs ignore.
  template <class T>
  void point_field(const FieldInfo& info, const std::vector<T>& values, const std::vector<const char*>& component_names = {});
  template <class T>
  void cell_field(const std::string& name, int components, const std::vector<T>& values);
  /// The time of the grid, s, as VTK programs look for it (TimeValue).
  void set_time(Real time) { time_ = time; }

  /// The file, all of it compressed: nothing but the disk is left to wait for.
  class Packed {
  public:
    /// Writes it atomically. Throws RunError.
    void write(const std::filesystem::path& path) const;

  private:
    friend class Vtu;
    std::string header_;
    std::vector<std::string> arrays_;
  };
  /// What was given is gone after it.
  Packed pack();
  void write(const std::filesystem::path& path) { pack().write(path); }

private:
  struct Array {
    std::string attributes, packed;
  };
  std::vector<Real> points_;
  std::vector<std::int64_t> connectivity_, offsets_;
  std::vector<std::uint8_t> types_;
  std::vector<Array> point_fields_, cell_fields_;
  Real time_ = nan;
};

}  // namespace berm::run_folder
