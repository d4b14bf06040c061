// SPDX-License-Identifier: BSD-3-Clause
n = 120;
Include "box.geo";
