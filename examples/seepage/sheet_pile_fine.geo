// SPDX-License-Identifier: BSD-3-Clause
// Cells of half the size.
size = 0.015;
Include "sheet_pile.geo";
