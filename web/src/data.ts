// SPDX-License-Identifier: BSD-3-Clause
// What `berm report` writes into the page for the script: JSON in the element #berm-data, and blocks of numbers in elements of their own.

/** Lengths in m, forces in N/m, times in s, as in history.csv; a number that is not finite is null. */
export interface PageData {
  version: string;
  runs: RunData[];
  /** What is published of the tests that there are runs of. */
  published: PublishedPoint[];
}

export interface RunData {
  /** Name of the run folder, and the case's title. Text of the user's: never markup. */
  name: string;
  title: string;
  method: "mpm" | "fem";
  /** null where no push or drag drives a rigid body. */
  diameter: number | null;
  /** What forces are made dimensionless with; null without a driven body, in space, and where the soil has neither weight nor a strength without friction. */
  measure: Measure | null;
  /** Lengths and forces per metre are so many times larger in the prototype; null where gravity is the earth's, or none: there is no prototype. */
  prototype: number | null;
  /** Whether it is of a test of which something is published. */
  of_test: boolean;
  /** What is said of the columns of history.csv: label without unit, some words, SI unit ("" for a pure number). */
  quantities: Record<string, { label: string; words: string; unit: string }>;
  /** Columns of history.csv by name, each as long as `stage`. */
  columns: Record<string, (number | null)[]>;
  stage: string[];
  /** Rows of history.csv (counted from 0) that the columns hold; null: all of them. */
  row: number[] | null;
  push: PathData;
  drag: PathData;
  lift: PathData;
  /** Charts that answer the question of the structure. */
  charts?: OwnChart[];
  /** How sure the curves of charts are, where the run was asked. */
  bands: BandData[];
  film: FilmData | null;
  /** Only of the run of a pipeline; null: nothing is there yet, or it is damaged. */
  line?: LineData | null;
}

export interface Measure {
  /** N/m; a stress is over this by D, an energy per metre this times D. */
  size: number;
  /** The letters of what stresses, forces and energies per metre are divided by. */
  stress: string;
  force: string;
  energy: string;
}

/** Rows (of `columns`) that pushes or drags consist of. Each drag begins with the row before its first. */
export interface PathData {
  rows: number[];
  /** u where the first drag began. */
  u_begin: number;
  /** Of a drag of a body that turns: the displacement of a named point since the drag began, m, by row of the path, and what to call it. */
  u?: { words: string; values: (number | null)[] };
  /** Forces freed from noise over +-0.01 D of the travel of each push or drag, a twentieth of it at most, by row of the path; null where it goes back and forth. */
  V_mean: (number | null)[];
  H_mean: (number | null)[];
}

/** Curves of one run over one another, as in curves.json, by row (of `columns`). */
export interface OwnChart {
  chart: string;
  title: string;
  x: AxisData;
  y: AxisData;
  /** `smoothed`: y freed from noise. */
  curves: { name: string; rows: number[]; x: (number | null)[]; y: (number | null)[]; smoothed?: (number | null)[] }[];
}

/** What an axis shows, in SI units. */
export interface AxisData {
  symbol: string;
  unit: string;
  meaning: string;
}

/** The band of a curve, over w of the push or over u from where the first drag began, in the units of the columns; null where it is not known. */
export interface BandData {
  chart: "V_w" | "H_u" | "w_u";
  x: (number | null)[];
  low: (number | null)[];
  high: (number | null)[];
}

/** A number or a level that is published, in model units. */
export interface PublishedPoint {
  chart: "V_w" | "H_u" | "w_u";
  /** null: a level, over the whole axis. */
  x: number | null;
  y: number;
  label: string;
}

/** The soil of a run, frame by frame. A block is the id of an element <script type="text/plain"> that holds base64 of zlib-compressed bytes, little-endian. */
export interface FilmData {
  kind: "particles" | "triangles";
  count: number;
  frames: FrameData[];
  /** x = lower + step * code. */
  lower: [number, number];
  step: number;
  /** Region of interest, m: around the path of the driven body; all of the soil without one. */
  view: { lower: [number, number]; upper: [number, number] };
  /** m, original surface; null: not known. */
  surface: number | null;
  /** m, corners of the original surface from left to right, where that is not level. */
  ground?: [number, number][];
  /** What of the run the film leaves out, for a caption: "every 2nd frame"; null: nothing. */
  note: string | null;
  /** Unit of H and V. */
  forces: "N/m" | "N";
  /** Whether x is the radius around an axis, of which the film holds one half. */
  around_axis: boolean;
  /** The whole of a run in space, of which the film is a slice; null: it has no room on the page. */
  space?: SpaceData | null;
  /** Codes (16 bits) of all positions. Bytes in planes: [x low][x high][y low][y high], each by frame, then point. Frame 0 holds codes, each later
   * one the change since the frame before, modulo 2^16 and folded: 0, -1, 1, -2, ... are 0, 1, 2, 3, ... */
  position: string;
  /** Side of the square that a particle stands for at the start, as codes (uint16), by point; only for particles. */
  size: string | null;
  /** Corners of triangles (uint32, three each), only for triangles; `elements` of them in a row make one element. */
  triangles: string | null;
  elements: number;
  fields: FieldData[];
  rigids: RigidData[];
  /** The flow of the water, of runs that have it. */
  flow?: FlowData;
}

/** Darcy's flux by frame on a grid of squares. Signed bytes x, y of each square, row by row from below, frame by frame: flux = largest of the frame * byte / 127. */
export interface FlowData {
  /** m, the lower left corner of the grid, and the side of a square. */
  lower: [number, number];
  side: number;
  columns: number;
  rows: number;
  /** m/s, by frame. */
  largest: number[];
  block: string;
  /** Of both halves around an axis: the same at -x, too. */
  mirrored?: boolean;
}

/** The whole of a run in space: positions have planes [z low][z high], too, and rigid bodies are surfaces. */
export interface SpaceData extends FilmData {
  lower_z: number;
  /** One of so many particles is in the film; sizes are of all that it stands for. */
  one_of: number;
  surfaces: SurfaceData[];
}

/** The surface of a rigid body: `triangles` (uint32, three corners each) and the codes of its corners by frame, in planes as those of the soil. */
export interface SurfaceData {
  name: string;
  points: number;
  triangles: string;
  lower: [number, number, number];
  step: number;
  position: string;
}

/** The line of a pipeline from x = 0 on, frame by frame. */
export interface LineData {
  /** What is left of x = 0: the mirror image, the same rotated by 180 degrees, or nothing. */
  half: "symmetric" | "antisymmetric" | "none";
  /** m; 0: not known. */
  diameter: number;
  /** N/m, submerged, as the line was laid. */
  weight: number;
  /** m, up to which x the line moves sideways; all slices lie within. */
  region: number;
  /** m, x of the slices. That at x = 0 has the columns u_m, ... of the history, the others slice_1_u_m, ... */
  slices: number[];
  /** What of the run is left out, for a caption; null: nothing. */
  note: string | null;
  frames: { time: number; stage: string }[];
  /** The last frames of the stages that load the line. */
  ends: { name: string; frame: number }[];
  /** m, of the nodes. */
  x: number[];
  /** m, from the straight axis. */
  y: LineQuantity;
  /** N, effective compression. */
  P: LineQuantity;
  /** N m, lateral bending moment. */
  M: LineQuantity;
  strain_max: LineQuantity;
  strain_min: LineQuantity;
  /** null: not known. */
  bed: BedData | null;
}

/** How far the soil of the slices has risen since before the pipe was laid, m, in `frames` frames from `first` on: by slice and column, whose middles are at y, m. */
export interface BedData extends LineQuantity {
  first: number;
  frames: number;
  y: number[];
}

/** A quantity by frame and node: value = low + step * code (16 bits); its block has planes [low][high] as those of a film's places. */
export interface LineQuantity {
  low: number;
  step: number;
  block: string;
}

export interface FrameData {
  time: number;
  stage: string;
  /** m; null without a driven body. */
  u: number | null;
  w: number | null;
  /** In the unit of the film's forces; null without a driven body. */
  H: number | null;
  V: number | null;
}

/** A field of the soil that the frames of the run hold. One byte for each frame and point: value = low + (high - low) * byte / 255, clipped. Frame 0 holds bytes, each later one the change modulo 256. */
export interface FieldData {
  name: string;
  label: string;
  unit: string;
  low: number;
  high: number;
  block: string;
}

/** A rigid body's outline: float32 x, y of `points` corners by frame, m from the corner `lower` of the film; not a number in frames where it is not there. Two corners are a line. */
export interface RigidData {
  name: string;
  points: number;
  block: string;
  /** Of the other half around an axis: at -x. */
  mirrored?: boolean;
}

/** The row of history.csv that a row of the run's columns is. */
export function history_row(run: RunData, row: number): number {
  return run.row === null ? row : run.row[row];
}

export function page_data(): PageData {
  return JSON.parse(document.getElementById("berm-data")!.textContent!) as PageData;
}
