// SPDX-License-Identifier: BSD-3-Clause
import { page_data } from "./data";
import { show_charts } from "./charts";
import { show_films } from "./films";

const data = page_data();
show_charts(document.getElementById("curves")!, data);
show_films(document.getElementById("soil")!, data);
