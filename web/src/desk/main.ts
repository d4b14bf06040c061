// SPDX-License-Identifier: BSD-3-Clause
// The page of berm desk.
document.body.textContent = "berm desk";
