// SPDX-License-Identifier: BSD-3-Clause
import { page_data } from "./data";
import { show_charts } from "./charts";
import { serve_copy_buttons } from "./copy";
import { show_films } from "./films";
import { show_first_look } from "./first_look";
import { show_line } from "./line_film";
import { open_details_in_print } from "./print";
import { sign_scrolling_tables } from "./tables";
import { show_space } from "./space_panel";
import { follow_theme } from "./theme";

const data = page_data();
follow_theme();
serve_copy_buttons();
open_details_in_print();
const curves = [...show_first_look(document.getElementById("first-look"), data), ...show_charts(document.getElementById("curves")!, document.getElementById("trust")!, data)];
show_space(document.getElementById("soil")!, data.runs);
const line = show_line(document.getElementById("line"), data, (moment) => films?.follow(moment));
const films = show_films(document.getElementById("soil")!, data, (moments) => {
  curves.forEach((each) => each.mark(moments));
  line?.follow(moments);
});
sign_scrolling_tables();
