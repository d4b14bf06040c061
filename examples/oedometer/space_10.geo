// SPDX-License-Identifier: BSD-3-Clause
n = 10;
depth = 0.1;
Include "plates.geo";
