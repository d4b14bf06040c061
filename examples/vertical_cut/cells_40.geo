// SPDX-License-Identifier: BSD-3-Clause
n = 40;
Include "cut.geo";
