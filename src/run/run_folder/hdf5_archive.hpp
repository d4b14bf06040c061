// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/archive.hpp"

#include <filesystem>
#include <hdf5.h>

namespace berm::run_folder {

/// Handle of an HDF5 object, closed with this object.
class Hdf5Id {
public:
  using Close = herr_t (*)(hid_t);

  Hdf5Id(hid_t id, Close how) : id_(id), close_(how) {}
  ~Hdf5Id() { close(); }
  Hdf5Id(const Hdf5Id&) = delete;
  Hdf5Id& operator=(const Hdf5Id&) = delete;

  operator hid_t() const { return id_; }
  bool valid() const { return id_ >= 0; }
  /// False where closing failed: data may not have been written.
  bool close();

private:
  hid_t id_;
  Close close_;
};

/// Writes each value as a dataset of a new HDF5 file, a table as a group, after a user block of `header_bytes` zeros.
/// Throws RunError.
class Hdf5Writer : public Archive {
public:
  Hdf5Writer(const std::filesystem::path& path, std::size_t header_bytes);

  /// To be called last. Throws RunError where something could not be written.
  void close();
  bool reads() const override { return false; }
  [[noreturn]] void refuse(const std::string& why) const override;

protected:
  void list(const std::string& path, std::vector<Real>& numbers) override;
  void list(const std::string& path, std::vector<Index>& numbers) override;
  void list(const std::string& path, std::vector<BigIndex>& numbers) override;
  void list(const std::string& path, std::string& text) override;

private:
  void write(const std::string& path, hid_t type_in_file, hid_t type, std::size_t count, const void* values);
  [[noreturn]] void fail() const;

  std::filesystem::path path_;
  Hdf5Id file_;
};

/// Reads what Hdf5Writer wrote. Throws RunError.
class Hdf5Reader : public Archive {
public:
  explicit Hdf5Reader(const std::filesystem::path& path);

  bool reads() const override { return true; }
  [[noreturn]] void refuse(const std::string& why) const override;

protected:
  void list(const std::string& path, std::vector<Real>& numbers) override;
  void list(const std::string& path, std::vector<Index>& numbers) override;
  void list(const std::string& path, std::vector<BigIndex>& numbers) override;
  void list(const std::string& path, std::string& text) override;

private:
  template <class List>
  void read(const std::string& path, H5T_class_t kind, hid_t type, List& values) const;

  std::filesystem::path path_;
  Hdf5Id file_;
};

}  // namespace berm::run_folder
