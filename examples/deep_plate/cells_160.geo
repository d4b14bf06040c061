// SPDX-License-Identifier: BSD-3-Clause
n = 160;
Include "box.geo";
