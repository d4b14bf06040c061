// SPDX-License-Identifier: BSD-3-Clause
import { element } from "../element";

/** Lets the browser keep a text as a file. */
export function download(name: string, type: string, text: string): void {
  const address = URL.createObjectURL(new Blob([text], { type }));
  const link = element("a", { href: address, download: name });
  document.body.append(link);
  link.click();
  link.remove();
  // The browser reads the address after this task.
  setTimeout(() => URL.revokeObjectURL(address), 60000);
}

/** A name of a file from the chart and the folder of a run. */
export function file_name(chart: string, run: string, ending: string): string {
  const plain = (text: string) => text.normalize("NFKD").replace(/[^A-Za-z0-9]+/g, "_").replace(/^_+|_+$/g, "");
  return [plain(chart), plain(run)].filter((part) => part !== "").join("_") + "." + ending;
}
