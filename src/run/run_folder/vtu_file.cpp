// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/run_folder/frame_reader_test.cpp
#include "run_folder/vtu_file.hpp"

#include "io/atomic_file.hpp"
#include "os/error.hpp"
#include "os/read_file.hpp"
#include "run_folder/vtk_name.hpp"
#include "run_folder/xml_tag.hpp"
#include "run_folder/zlib_blocks.hpp"

#include <cerrno>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

namespace berm::run_folder {
namespace {

constexpr std::uint64_t max_header = 1 << 16;  // bytes; Vtu's headers have some 3000
constexpr std::string_view data_mark = "<AppendedData encoding=\"raw\">\n_", end_mark = "\n</AppendedData>\n</VTKFile>\n",
                           kind = "<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\"",
                           compressor = " compressor=\"vtkZLibDataCompressor\"";

}  // namespace

VtuFile::VtuFile(const std::filesystem::path& path) : path_(path)
{
  std::string fault;
  file_ = open_to_read(path, fault);
  if (file_ < 0) refuse(fault);
  try {
    read_header();
  } catch (...) {
    ::close(file_);
    throw;
  }
}

VtuFile::~VtuFile()
{
  ::close(file_);
}

void VtuFile::refuse(const std::string& words) const
{
  throw RunError(fmt::format("{}: {}", path_.string(), words));
}

void VtuFile::read(void* to, std::uint64_t count, std::uint64_t from) const
{
  for (char* next = static_cast<char*>(to); count > 0;) {
    const ssize_t got = ::pread(file_, next, count, static_cast<off_t>(from));
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) io::throw_errno(fmt::format("cannot read {}", path_.string()));
    if (got == 0) refuse("ends too early; it was cut off");
    next += got;
    from += static_cast<std::uint64_t>(got);
    count -= static_cast<std::uint64_t>(got);
  }
}

void VtuFile::read_header()
{
  struct stat about {};
  if (::fstat(file_, &about) != 0) io::throw_errno(fmt::format("cannot read {}", path_.string()));
  size_ = static_cast<std::uint64_t>(about.st_size);
  std::string header(std::min(size_, max_header), '\0'), end(std::min<std::uint64_t>(size_, end_mark.size()), '\0');
  read(header.data(), header.size(), 0);
  const std::size_t mark = header.find(data_mark);
  const std::size_t file = header.find(kind);
  if (mark == std::string::npos || file == std::string::npos) refuse("is not a .vtu file of a frame, or was cut off");
  compressed_ = header.compare(file + kind.size(), compressor.size(), compressor) == 0;
  if (header[file + kind.size() + (compressed_ ? compressor.size() : 0)] != '>') refuse("is not a .vtu file of a frame");
  read(end.data(), end.size(), size_ - end.size());
  if (end != end_mark) refuse("has no end; it was cut off");
  header.resize(mark);
  data_ = mark + data_mark.size();
  if (data_ + end_mark.size() > size_) refuse("is damaged: its header and its end overlap");
  data_end_ = size_ - end_mark.size();

  for (const XmlTag& tag : xml_tags(header, "Piece")) {
    const std::optional<std::uint64_t> points = tag.whole_number("NumberOfPoints"), cells = tag.whole_number("NumberOfCells");
    // A point takes 24 bytes and a cell 9.
    const std::uint64_t max_bytes = size_ * (compressed_ ? max_zlib_ratio : 1);
    if (!points || !cells || *points > max_bytes / 24 || *cells > max_bytes / 9)
      refuse("is damaged: it is too short for the points in its header");
    points_ = *points;
    cells_ = *cells;
  }
  for (const XmlTag& tag : xml_tags(header, "DataArray")) {
    const std::optional<std::uint64_t> offset = tag.whole_number("offset");
    if (!offset) refuse("is damaged: an array has no offset");
    arrays_[tag["Name"]] = {tag["type"], *offset};
  }
  const std::size_t first = std::min(header.find("<PointData>"), header.size()),
                    last = std::min(header.find("</PointData>"), header.size());
  if (last < first) refuse("is damaged: its fields end before they begin");
  for (const XmlTag& tag : xml_tags(std::string_view(header).substr(first, last - first), "DataArray")) {
    if (tag["type"] != vtk_name<float>) continue;
    constexpr std::uint64_t max_components = 9;
    const std::uint64_t components = tag.whole_number("NumberOfComponents").value_or(1);
    if (components < 1 || components > max_components)
      refuse(fmt::format("is damaged: the array {} has {} components", tag["Name"], components));
    const std::string name = tag["Name"], label = tag["Label"];
    point_fields_.push_back({name, label.empty() ? name : label, tag["Unit"], static_cast<int>(components), to_frame});
  }
}

template <class T>
std::vector<T> VtuFile::numbers(const std::string& name) const
{
  const auto found = arrays_.find(name);
  if (found == arrays_.end()) refuse(fmt::format("has no array {}", name));
  const Array& array = found->second;
  if (array.type != vtk_name<T>) refuse(fmt::format("is damaged: the array {} is not of {}", name, vtk_name<T>));
  if (compressed_) return unpacked<T>(name, array.offset);
  std::uint64_t bytes = 0;
  const std::uint64_t room = data_end_ - data_;
  if (array.offset > room || room - array.offset < sizeof bytes) refuse(fmt::format("is damaged: the array {} lies outside of it", name));
  read(&bytes, sizeof bytes, data_ + array.offset);
  if (bytes > room - array.offset - sizeof bytes || bytes % sizeof(T) != 0)
    refuse(fmt::format("is damaged: the array {} has a wrong length", name));
  std::vector<T> list(bytes / sizeof(T));
  read(list.data(), bytes, data_ + array.offset + sizeof bytes);
  return list;
}

/// Of a compressed array.
template <class T>
std::vector<T> VtuFile::unpacked(const std::string& name, std::uint64_t offset) const
{
  const auto wrong = [&] { refuse(fmt::format("is damaged: the array {} has a wrong length", name)); };
  const std::uint64_t room = data_end_ - data_;
  if (offset > room || room - offset < ZlibHeader::first_bytes) refuse(fmt::format("is damaged: the array {} lies outside of it", name));
  char first[ZlibHeader::first_bytes];
  read(first, sizeof first, data_ + offset);
  const ZlibHeader header(first);
  const std::uint64_t size = header.size(room - offset), bytes = header.unpacked(room - offset);
  if (size == 0 || (bytes == 0 && header.blocks > 0) || bytes % sizeof(T) != 0) wrong();
  std::vector<std::uint64_t> packed(header.blocks);
  read(packed.data(), packed.size() * sizeof(std::uint64_t), data_ + offset + sizeof first);
  std::vector<T> list(bytes / sizeof(T));
  std::uint64_t from = offset + size;
  std::string block;
  for (std::uint64_t k = 0; k < header.blocks; from += packed[k++]) {
    if (packed[k] > room - from) wrong();
    block.resize(packed[k]);
    read(block.data(), block.size(), data_ + from);
    if (!unpack_zlib(block, reinterpret_cast<char*>(list.data()) + k * header.block_bytes, header.bytes_of(k))) wrong();
  }
  return list;
}

template <class T>
std::vector<T> VtuFile::numbers(const std::string& name, std::size_t count) const
{
  std::vector<T> list = numbers<T>(name);
  if (list.size() != count) refuse(fmt::format("is damaged: the array {} has {} numbers instead of {}", name, list.size(), count));
  return list;
}

template std::vector<double> VtuFile::numbers(const std::string&) const;
template std::vector<std::int64_t> VtuFile::numbers(const std::string&) const;
template std::vector<double> VtuFile::numbers(const std::string&, std::size_t) const;
template std::vector<float> VtuFile::numbers(const std::string&, std::size_t) const;
template std::vector<std::int32_t> VtuFile::numbers(const std::string&, std::size_t) const;
template std::vector<std::int64_t> VtuFile::numbers(const std::string&, std::size_t) const;
template std::vector<std::uint8_t> VtuFile::numbers(const std::string&, std::size_t) const;

}  // namespace berm::run_folder
