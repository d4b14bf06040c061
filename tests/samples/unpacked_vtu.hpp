// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <cstring>
#include <fmt/format.h>
#include <regex>
#include <stdexcept>
#include <string>
#include <zlib.h>

namespace berm {

/// A .vtu file whose arrays are compressed by vtkZLibDataCompressor, as VTK describes that, with the same arrays uncompressed: what berm wrote before. Throws where
/// the arrays do not lie end to end. None of the program's own code.
inline std::string unpacked_vtu(const std::string& file)
{
  const std::string mark = "<AppendedData encoding=\"raw\">\n_", ending = "\n</AppendedData>\n</VTKFile>\n",
                    compressor = " compressor=\"vtkZLibDataCompressor\"";
  const std::size_t data = file.find(mark) + mark.size();
  std::string header = file.substr(0, data), unpacked;
  const std::size_t at = header.find(compressor);
  if (at == std::string::npos) throw std::runtime_error("the file is not compressed");
  header.erase(at, compressor.size());
  const auto number = [&](std::size_t place) {
    std::uint64_t n = 0;
    std::memcpy(&n, file.data() + data + place, sizeof n);
    return n;
  };
  const std::regex tag("offset=\"(\\d+)\"");
  std::string rewritten;
  std::size_t end = 0, copied = 0;
  for (std::sregex_iterator k(header.begin(), header.end(), tag), none_left; k != none_left; ++k) {
    const std::size_t offset = std::stoul((*k)[1]), blocks = number(offset), size = number(offset + 8), last = number(offset + 16);
    if (offset != end) throw std::runtime_error("an array does not begin where the one before ends");
    std::string bytes;
    std::size_t from = offset + 24 + 8 * blocks;
    for (std::size_t b = 0; b < blocks; ++b) {
      const std::size_t packed = number(offset + 24 + 8 * b);
      std::string block(b + 1 == blocks && last > 0 ? last : size, '\0');
      uLongf count = block.size();
      if (uncompress(reinterpret_cast<Bytef*>(block.data()), &count, reinterpret_cast<const Bytef*>(file.data() + data + from), packed) !=
              Z_OK ||
          count != block.size())
        throw std::runtime_error("a block is damaged");
      bytes += block;
      from += packed;
    }
    end = from;
    const std::uint64_t length = bytes.size();
    rewritten += header.substr(copied, static_cast<std::size_t>(k->position()) - copied) + fmt::format("offset=\"{}\"", unpacked.size());
    copied = static_cast<std::size_t>(k->position() + k->length());
    unpacked += std::string(reinterpret_cast<const char*>(&length), sizeof length) + bytes;
  }
  if (file.substr(data + end) != ending) throw std::runtime_error("the last array does not end at the closing tag");
  return rewritten + header.substr(copied) + unpacked + ending;
}

}  // namespace berm
