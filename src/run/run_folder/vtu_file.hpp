// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/field_info.hpp"
#include "core/types.hpp"

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace berm::run_folder {

/// Reads single arrays of a .vtu file that Vtu wrote, or an earlier version of it that did not compress. Sizes in its header are checked against the size of the file before
/// memory is allocated.
/// All functions throw RunError, with the file's name, where the file is missing, cut off or not one of Vtu's.
class VtuFile {
public:
  /// Reads the header and checks that the file is complete.
  explicit VtuFile(const std::filesystem::path& path);
  ~VtuFile();
  VtuFile(const VtuFile&) = delete;
  VtuFile& operator=(const VtuFile&) = delete;

  std::size_t point_count() const { return points_; }
  std::size_t cell_count() const { return cells_; }

  /// The single-precision fields of points, in order; a missing label is the name.
  const std::vector<FieldInfo>& point_fields() const { return point_fields_; }

  /// All numbers of an array; T must be what the file holds.
  template <class T>
  std::vector<T> numbers(const std::string& name) const;
  /// The same, where there must be `count` of them.
  template <class T>
  std::vector<T> numbers(const std::string& name, std::size_t count) const;

  /// Throws RunError with the file's name and what is wrong with it.
  [[noreturn]] void refuse(const std::string& words) const;

private:
  struct Array {
    std::string type;
    std::uint64_t offset;
  };
  void read_header();
  template <class T>
  std::vector<T> unpacked(const std::string& name, std::uint64_t offset) const;
  void read(void* to, std::uint64_t count, std::uint64_t from) const;

  std::filesystem::path path_;
  int file_ = -1;
  std::uint64_t size_ = 0, data_ = 0, data_end_ = 0;  ///< bytes: the file's, where the appended data begins and ends
  bool compressed_ = false;
  std::size_t points_ = 0, cells_ = 0;
  std::map<std::string, Array> arrays_;
  std::vector<FieldInfo> point_fields_;
};

}  // namespace berm::run_folder
