// SPDX-License-Identifier: BSD-3-Clause

/** Makes each button[data-copy] copy the table whose id it names, as text with tabs. */
export function serve_copy_buttons(): void {
  for (const button of document.querySelectorAll<HTMLButtonElement>("button.copy[data-copy]")) {
    const words = button.textContent!;
    button.setAttribute("aria-live", "polite");
    let copies = 0;
    button.addEventListener("click", async () => {
      const table = document.getElementById(button.dataset.copy!);
      if (!(table instanceof HTMLTableElement)) return;
      const mine = ++copies;
      button.textContent = (await copied(table_text(table))) ? "copied" : "not allowed to copy";
      setTimeout(() => mine === copies && (button.textContent = words), 2000);
    });
  }
}

/** Rows as lines, cells with tabs between them; a tab or line break within a cell is a blank. Numbers of an invalid answer keep the mark that the style sheet sets. */
export function table_text(table: HTMLTableElement): string {
  return [...table.rows].map((row) => [...row.cells].map(cell_text).join("\t") + "\n").join("");
}

function cell_text(cell: HTMLTableCellElement): string {
  const text = cell.textContent!.trim().replace(/\s+/g, " ");
  return cell.matches(".invalid td.number") ? `${text} (!)` : text;
}

async function copied(text: string): Promise<boolean> {
  try {
    await navigator.clipboard.writeText(text);
    return true;
  } catch {
    return copied_by_selection(text);
  }
}

// Where the clipboard is not allowed (some browsers, for pages of files): select the text and let the browser copy what is selected.
function copied_by_selection(text: string): boolean {
  const focused = document.activeElement;
  const area = document.createElement("textarea");
  area.value = text;
  area.className = "copy_area";
  document.body.append(area);
  area.select();
  const done = document.execCommand("copy");
  area.remove();
  if (focused instanceof HTMLElement) focused.focus();
  return done;
}
