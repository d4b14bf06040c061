// SPDX-License-Identifier: BSD-3-Clause
// What the desk asks its server: docs/how_to/desk.md.
import type { Finding } from "../editor/editor";

const stored_as = "berm-desk-token";

/** What went wrong, in a sentence for the reader. */
export class Refusal extends Error {
  constructor(readonly status: number, message: string) {
    super(message);
  }
}

/** The token comes behind # in the address, and leaves it at once: what is copied from there later opens nothing. */
export function take_token(): string | null {
  const found = /^#([0-9a-f]{32,})$/.exec(location.hash);
  try {
    if (found) sessionStorage.setItem(stored_as, found[1]);
    if (found) history.replaceState(null, "", `${location.pathname}#/`);
    return sessionStorage.getItem(stored_as);
  } catch {
    return found?.[1] ?? null;
  }
}

let token = "";
export function use_token(word: string): void {
  token = word;
}

async function ask(method: string, path: string, query: Record<string, string | number>, body?: unknown): Promise<Response> {
  const words = new URLSearchParams(Object.entries(query).map(([key, value]) => [key, String(value)])).toString();
  let answer: Response;
  try {
    answer = await fetch(`api/${path}${words ? `?${words}` : ""}`, {
      method,
      headers: { Authorization: `Bearer ${token}`, ...(body === undefined ? {} : { "Content-Type": "application/json" }) },
      body: body === undefined ? undefined : JSON.stringify(body),
    });
  } catch {
    throw new Refusal(0, "berm desk does not answer: it was closed, or this machine sleeps. Start it again in a terminal; runs continue without it.");
  }
  if (answer.ok) return answer;
  const why = await answer.json().catch(() => ({}));
  throw new Refusal(answer.status, typeof why.error === "string" ? why.error : `${answer.status} ${answer.statusText}`);
}

async function json<T>(answer: Promise<Response>): Promise<T | null> {
  const got = await answer;
  return got.status === 204 ? null : ((await got.json()) as T);
}

export type Status = "queued" | "running" | "stopped" | "failed" | "finished";
export interface About { version: string; folder: string; cores: number }
export interface Kind { kind: string; title: string; group: string; question: string; sizes: string[]; soils: string[]; sounding: boolean; example: string }
/** What an input is, by its first tables. */
export type InputKind = "case" | "study" | "element" | "fit" | "cyclic" | "sea" | "route";
export interface Soil { soil: string; material: string; title: string; source: string; trust: string }
export interface FileOf { path: string; title?: string; modified?: string | number }
export interface RunState { path: string; case: string; status: Status; progress: number | null; time_left_s: number | null; began_here: boolean; can_resume: boolean; title?: string; date?: string; answer?: { name: string; value: number; unit: string }; bytes?: number; notes?: string }
export interface FolderOf { path: string; cases: FileOf[]; studies: FileOf[]; tests: FileOf[]; runs: string[]; folders: string[] }
export interface Column { name: string; label: string; unit: string | null; meaning: string }
export interface Rows { of: string; columns: Column[]; rows: (number | string | null)[][]; from_row: number; more: boolean }
export interface RunNow extends RunState, Rows { log_tail: string; why?: string; summary?: Summary }
export interface Quantity { value: number; unit: string; meaning: string; kind: string; of: string }
export interface Summary { text?: Record<string, string>; quantities?: Record<string, Quantity>; checks?: Record<string, unknown>; warnings?: string[]; invalid?: unknown; uncertainty?: { quantities: Record<string, { converged: number; half_width: number }> } }
/** Of curves.json. */
export interface Axis { symbol: string; unit: string; meaning: string }
export interface Chart { chart: string; x: Axis; y: Axis; curves: { name: string; x: (number | null)[]; y: (number | null)[]; smoothed?: (number | null)[] }[] }
export interface Soil2D { frame: number; time_s: number; points: number; x: number[]; y: number[]; z?: number[]; size: number[]; field?: { name: string; label: string; unit: string; values: number[] }; fields: string[]; rigids: [number, number][][] }
export interface Checked { findings: Finding[]; estimate: { particles: number; time_s: number | null; memory_bytes: number; disk_bytes: number; lines: string[] } | null }
export interface Exported { files: string[]; warnings: string[] }
export interface Shown { address: string; without_scripts: boolean }
export interface Job { job: string; command: string; status: Status; log_tail: string; made: string[] }

/** What is doubtful in the sounding of a case that was just made, by its path. */
export const doubts_of_new = new Map<string, string[]>();

export const api = {
  about: () => json<About>(ask("GET", "about", {})) as Promise<About>,
  schema: (of: InputKind) => json<Record<string, unknown>>(ask("GET", "schema", { of })) as Promise<Record<string, unknown>>,
  kinds: () => json<Kind[]>(ask("GET", "kinds", {})) as Promise<Kind[]>,
  soils: () => json<Soil[]>(ask("GET", "soils", {})) as Promise<Soil[]>,
  picture: async (kind: string) => (await ask("GET", `kinds/${kind}/picture`, {})).text(),
  create: (body: { kind: string; size?: string; soil?: string; cpt?: { name: string; text: string }; location?: string; path: string }) => json<{ path: string; doubts: string[] }>(ask("POST", "new", {}, body)) as Promise<{ path: string; doubts: string[] }>,
  folder: (path: string) => json<FolderOf>(ask("GET", "folder", { path })) as Promise<FolderOf>,
  read: (path: string) => json<{ text: string; modified: string | number }>(ask("GET", "case", { path })) as Promise<{ text: string; modified: string | number }>,
  save: (path: string, text: string, modified: string | number | null) => json<{ modified: string | number }>(ask("PUT", "case", { path }, { text, modified })) as Promise<{ modified: string | number }>,
  check: (path: string, text: string) => json<Checked>(ask("POST", "check", {}, { path, text })) as Promise<Checked>,
  draw: async (path: string, text: string) => (await ask("POST", "draw", {}, { path, text })).text(),
  runs: () => json<RunState[]>(ask("GET", "runs", {})) as Promise<RunState[]>,
  start: (body: { case?: string; out?: string; set?: string[]; threads?: number; resume?: string }) => json<{ path: string }>(ask("POST", "runs", {}, body)) as Promise<{ path: string }>,
  stop: (path: string) => json(ask("POST", "runs/stop", {}, { path })),
  remove: (path: string) => json(ask("POST", "runs/remove", {}, { path })),
  rename: (path: string, name: string) => json<{ path: string }>(ask("POST", "runs/rename", {}, { path, name })) as Promise<{ path: string }>,
  note: (path: string, text: string) => json(ask("POST", "runs/notes", {}, { path, text })),
  run: (path: string, from_row: number) => json<RunNow>(ask("GET", "run", { path, from_row })) as Promise<RunNow>,
  soil: (path: string, after: number) => json<Soil2D>(ask("GET", "run/soil", { path, after })),
  report: (runs: string[], pdf: boolean) => json<{ path: string; pdf?: string }>(ask("POST", "report", {}, { runs, pdf })) as Promise<{ path: string; pdf?: string }>,
  springs: (body: Record<string, unknown>) => json<Exported>(ask("POST", "export", {}, body)) as Promise<Exported>,
  work: (what: string, path: string, more: Record<string, unknown> = {}) => json<{ job: string }>(ask("POST", what, {}, { path, ...more })) as Promise<{ job: string }>,
  jobs: () => json<Job[]>(ask("GET", "jobs", {})) as Promise<Job[]>,
  stop_job: (job: string) => json(ask("POST", "jobs/stop", {}, { job })),
  /** An address at which a frame may show a page that berm made. */
  show: async (path: string) => {
    const { address, without_scripts } = (await json<Shown>(ask("POST", "show", {}, { path }))) as Shown;
    return { address: address.replace(/^\//, ""), without_scripts }; // below what a proxy puts before it
  },
  file: async (path: string) => (await ask("GET", "file", { path })).blob(),
};
