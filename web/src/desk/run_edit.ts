// SPDX-License-Identifier: BSD-3-Clause
// The name of a run and what its reader notes about it.
import { element } from "../element";
import { make } from "../film_elements";
import { api } from "./api";

/** Asks for both; the path that the run then has, null where nothing was changed. */
export function edit_run(path: string, notes: string, named: boolean): Promise<string | null> {
  const before = path.split("/").pop()!, dialog = make("dialog", "new_case"), form = element("form", { method: "dialog" }), wrong = make("p", "bad");
  const name = element("input", { type: "text", id: "run-name", value: before, required: "", maxlength: 200 }), text = element("textarea", { id: "run-notes", rows: 6, maxlength: 5000 });
  text.value = notes;
  name.disabled = !named; // a run at work keeps its folder
  const stop = element("button", { type: "button" }, "Cancel");
  form.append(
    make("h3", "", path), element("label", { for: "run-name" }, "Name of its folder"), name, element("label", { for: "run-notes" }, "Notes (notes.txt in that folder)"), text, wrong,
    make("div", "bar", element("button", { type: "submit", class: "primary" }, "Save"), stop));
  dialog.append(form);
  document.body.append(dialog);
  return new Promise((done) => {
    let now: string | null = null;
    stop.addEventListener("click", () => dialog.close());
    dialog.addEventListener("close", () => {
      dialog.remove();
      done(now);
    });
    form.addEventListener("submit", (event) => {
      event.preventDefault();
      const save = async () => {
        if (text.value !== notes) await api.note(path, text.value), (now = path);
        if (name.value.trim() !== before) now = (await api.rename(path, name.value.trim())).path;
        dialog.close();
      };
      save().catch((error: Error) => (wrong.textContent = error.message));
    });
    dialog.showModal();
    name.select();
  });
}
