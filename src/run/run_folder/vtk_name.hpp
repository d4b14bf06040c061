// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <bit>
#include <cstdint>

namespace berm::run_folder {

static_assert(std::endian::native == std::endian::little, "the .vtu files say that their data is little-endian");

/// Name of a number type in VTK's XML.
template <class T>
constexpr const char* vtk_name = nullptr;
template <>
inline constexpr const char* vtk_name<double> = "Float64";
template <>
inline constexpr const char* vtk_name<float> = "Float32";
template <>
inline constexpr const char* vtk_name<std::int32_t> = "Int32";
template <>
inline constexpr const char* vtk_name<std::int64_t> = "Int64";
template <>
inline constexpr const char* vtk_name<std::uint8_t> = "UInt8";

}  // namespace berm::run_folder
