// SPDX-License-Identifier: BSD-3-Clause
n = 12;
Include "quarter.geo";
