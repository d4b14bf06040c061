// SPDX-License-Identifier: BSD-3-Clause
// Results of a command that makes no page of its own, as a study: its tables and pictures.
import { digits } from "../film_numbers";
import { make } from "../film_elements";
import { api } from "./api";
import { element } from "../element";

const most_rows = 500;

/** Fields of a CSV file, quoted or not, by row. */
export function rows_of(csv: string): string[][] {
  const rows: string[][] = [[]];
  for (const [, quoted, plain, end] of csv.trimEnd().matchAll(/(?:"((?:[^"]|"")*)"|([^,\r\n]*))(,|\r?\n|$)/g)) {
    rows[rows.length - 1].push(quoted === undefined ? plain : quoted.replaceAll('""', '"'));
    if (end === "") break;
    if (end !== ",") rows.push([]);
  }
  return rows;
}

function table_of([head, ...rows]: string[][]): HTMLElement {
  const cell = (text: string) => {
    const number = text !== "" && Number.isFinite(Number(text));
    return make("td", number ? "number" : "", number && !/^\d+$/.test(text) ? digits(Number(text)) : text);
  };
  return make("div", "scrolls", make("table", "list", make("thead", "", make("tr", "", ...head.map((word) => make("th", "", word)))), make("tbody", "", ...rows.slice(0, most_rows).map((row) => make("tr", "", ...row.map(cell))))));
}

/** A picture that a command made. */
export async function picture_of(path: string, name: string): Promise<HTMLElement> {
  const address = URL.createObjectURL(await api.file(path)), image = element("img", { src: address, alt: name });
  image.addEventListener("load", () => URL.revokeObjectURL(address));
  return make("figure", "picture", image, make("figcaption", "quiet", name));
}

/** Tables and pictures among the files that a command made. */
export async function results_of(made: string[]): Promise<HTMLElement[]> {
  const table = async (file: string, heading: string) => {
    const path = made.find((each) => each.endsWith(`/${file}`));
    return path ? [make("section", "", make("h3", "", heading), table_of(rows_of(await (await api.file(path)).text())))] : [];
  };
  const pictures = made.filter((each) => each.endsWith(".png")).map((each) => picture_of(each, each.split("/").pop()!.replace(/\.png$/, "").replace(/^tornado\./, "Tornado: ")));
  return [
    ...(await table("estimates.csv", "Low, best and high estimate")),
    ...(await table("distribution.csv", "Distribution: mean, scatter, lognormal fit, probability of a limit")),
    ...(await table("sensitivity.csv", "Sensitivity: one parameter low or high, all others at their best")),
    make("div", "pictures", ...(await Promise.all(pictures))),
    ...(await table("results.csv", "All runs")),
    ...(await table("envelope.csv", "Probes")),
  ];
}
