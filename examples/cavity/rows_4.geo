// SPDX-License-Identifier: BSD-3-Clause
n = 4;
Include "wedge.geo";
