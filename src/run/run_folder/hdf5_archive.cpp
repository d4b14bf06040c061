// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/run_folder/checkpoint_file_test.cpp
#include "run_folder/hdf5_archive.hpp"

#include "io/atomic_file.hpp"

#include <cerrno>
#include <fmt/format.h>

namespace berm::run_folder {
namespace {

/// The library's own messages are suppressed: those of berm name the file and what to do. It does not clean up when the
/// program ends: after a failed write, on a full disk, it cannot release the file and crashes there.
void begin_library()
{
  [[maybe_unused]] static const herr_t once = H5dont_atexit();
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
}

/// Access without the library's locks, which not all shared file systems support.
hid_t access()
{
  begin_library();
  const hid_t how = H5Pcreate(H5P_FILE_ACCESS);
  H5Pset_file_locking(how, false, true);
  return how;
}

hid_t create(const std::filesystem::path& path, std::size_t header_bytes)
{
  const Hdf5Id to_reach(access(), H5Pclose), to_make(H5Pcreate(H5P_FILE_CREATE), H5Pclose);
  H5Pset_userblock(to_make, header_bytes);
  return H5Fcreate(path.c_str(), H5F_ACC_TRUNC, to_make, to_reach);
}

hid_t open(const std::filesystem::path& path)
{
  const Hdf5Id to_reach(access(), H5Pclose);
  return H5Fopen(path.c_str(), H5F_ACC_RDONLY, to_reach);
}

}  // namespace

bool Hdf5Id::close()
{
  const hid_t id = id_;
  id_ = H5I_INVALID_HID;
  return id < 0 || close_(id) >= 0;
}

Hdf5Writer::Hdf5Writer(const std::filesystem::path& path, std::size_t header_bytes)
    : path_(path),
      file_((errno = 0, create(path, header_bytes)), H5Fclose)
{
  if (!file_.valid()) fail();
}

void Hdf5Writer::fail() const
{
  if (errno != 0) io::throw_errno(fmt::format("cannot write {}", path_.string()));
  throw RunError(fmt::format("cannot write {}", path_.string()));
}

void Hdf5Writer::refuse(const std::string& why) const
{
  throw RunError(fmt::format("cannot write {}: {}", path_.string(), why));
}

void Hdf5Writer::close()
{
  errno = 0;
  if (H5Fflush(file_, H5F_SCOPE_LOCAL) < 0 || !file_.close()) fail();
}

void Hdf5Writer::write(const std::string& path, hid_t type_in_file, hid_t type, std::size_t count, const void* values)
{
  errno = 0;
  const hsize_t size = count;
  const Hdf5Id space(H5Screate_simple(1, &size, nullptr), H5Sclose), links(H5Pcreate(H5P_LINK_CREATE), H5Pclose);
  H5Pset_create_intermediate_group(links, 1);
  Hdf5Id set(H5Dcreate2(file_, path.c_str(), type_in_file, space, links, H5P_DEFAULT, H5P_DEFAULT), H5Dclose);
  if (!set.valid() || (count > 0 && H5Dwrite(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values) < 0) || !set.close()) fail();
}

void Hdf5Writer::list(const std::string& path, std::vector<Real>& numbers)
{
  write(path, H5T_IEEE_F64LE, H5T_NATIVE_DOUBLE, numbers.size(), numbers.data());
}
void Hdf5Writer::list(const std::string& path, std::vector<Index>& numbers)
{
  write(path, H5T_STD_I32LE, H5T_NATIVE_INT32, numbers.size(), numbers.data());
}
void Hdf5Writer::list(const std::string& path, std::vector<BigIndex>& numbers)
{
  write(path, H5T_STD_I64LE, H5T_NATIVE_INT64, numbers.size(), numbers.data());
}
void Hdf5Writer::list(const std::string& path, std::string& text)
{
  write(path, H5T_STD_U8LE, H5T_NATIVE_UCHAR, text.size(), text.data());
}

Hdf5Reader::Hdf5Reader(const std::filesystem::path& path) : path_(path), file_(open(path), H5Fclose)
{
  if (!file_.valid()) refuse("it is not an HDF5 file");
}

void Hdf5Reader::refuse(const std::string& why) const
{
  throw RunError(why);
}

template <class List>
void Hdf5Reader::read(const std::string& path, H5T_class_t kind, hid_t type, List& values) const
{
  const Hdf5Id set(H5Dopen2(file_, path.c_str(), H5P_DEFAULT), H5Dclose);
  if (!set.valid()) refuse(fmt::format("it has no {}", path));
  const Hdf5Id space(H5Dget_space(set), H5Sclose), in_file(H5Dget_type(set), H5Tclose);
  const hssize_t count = H5Sget_simple_extent_npoints(space);
  using Value = typename List::value_type;
  std::error_code error;
  const bool fits = count >= 0 && static_cast<std::uintmax_t>(count) <= std::filesystem::file_size(path_, error) / sizeof(Value);
  if (!fits || H5Tget_class(in_file) != kind || H5Tget_size(in_file) != sizeof(Value)) refuse(fmt::format("{} has the wrong type", path));
  values.assign(static_cast<std::size_t>(count), Value{});
  if (count > 0 && H5Dread(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()) < 0) refuse(fmt::format("{} cannot be read", path));
}

void Hdf5Reader::list(const std::string& path, std::vector<Real>& numbers)
{
  read(path, H5T_FLOAT, H5T_NATIVE_DOUBLE, numbers);
}
void Hdf5Reader::list(const std::string& path, std::vector<Index>& numbers)
{
  read(path, H5T_INTEGER, H5T_NATIVE_INT32, numbers);
}
void Hdf5Reader::list(const std::string& path, std::vector<BigIndex>& numbers)
{
  read(path, H5T_INTEGER, H5T_NATIVE_INT64, numbers);
}
void Hdf5Reader::list(const std::string& path, std::string& text)
{
  read(path, H5T_INTEGER, H5T_NATIVE_UCHAR, text);
  if (std::any_of(text.begin(), text.end(), [](unsigned char c) { return (c < 0x20 && c != '\n') || c == 0x7F; }))
    refuse(fmt::format("{} is not text", path));
}

}  // namespace berm::run_folder
