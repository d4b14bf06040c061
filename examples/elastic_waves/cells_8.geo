// SPDX-License-Identifier: BSD-3-Clause
n = 8;
Include "square.geo";
