// SPDX-License-Identifier: BSD-3-Clause
n = 32;
Include "square.geo";
