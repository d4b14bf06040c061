// SPDX-License-Identifier: BSD-3-Clause
n = 16;
Include "square.geo";
