// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace berm::test {

/// A block that falls freely for 0.1 s: v_y = -g t. A hundredth of a second of computing.
constexpr const char* falling_stone = R"(gravity = [0, "-10 m/s^2"]
mesh = {kind = "box", size = [1, 1], cells = [4, 4]}
material.stone = {law = "linear_elastic", density = 1000, young_modulus = 1e6, poisson_ratio = 0}
body.stone = {material = "stone", block = {center = [0.5, 0.7], size = [0.2, 0.2], spacing = 0.1}}
output.history_time = "1 ms"
[[stage]]
name = "fall"
kind = "free"
until.time = "0.1 s"
)";

}  // namespace berm::test
