// SPDX-License-Identifier: BSD-3-Clause
n = 80;
Include "box.geo";
