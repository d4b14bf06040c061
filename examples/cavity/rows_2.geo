// SPDX-License-Identifier: BSD-3-Clause
n = 2;
Include "wedge.geo";
