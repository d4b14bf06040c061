// SPDX-License-Identifier: BSD-3-Clause
edge = 0.05;
Include "quarter.geo";
