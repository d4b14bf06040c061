// SPDX-License-Identifier: BSD-3-Clause
n = 20;
Include "slope.geo";
