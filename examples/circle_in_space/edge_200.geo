// SPDX-License-Identifier: BSD-3-Clause
edge = 0.2;
Include "quarter.geo";
