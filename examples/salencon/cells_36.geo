// SPDX-License-Identifier: BSD-3-Clause
n = 36;
Include "quarter.geo";
