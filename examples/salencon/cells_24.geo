// SPDX-License-Identifier: BSD-3-Clause
n = 24;
Include "quarter.geo";
