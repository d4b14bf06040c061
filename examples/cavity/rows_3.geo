// SPDX-License-Identifier: BSD-3-Clause
n = 3;
Include "wedge.geo";
