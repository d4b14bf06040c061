// SPDX-License-Identifier: BSD-3-Clause
n = 10;
Include "slope.geo";
