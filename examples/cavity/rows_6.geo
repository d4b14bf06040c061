// SPDX-License-Identifier: BSD-3-Clause
n = 6;
Include "wedge.geo";
