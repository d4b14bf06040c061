// SPDX-License-Identifier: BSD-3-Clause
n = 5;
Include "plates.geo";
