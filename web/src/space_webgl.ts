// SPDX-License-Identifier: BSD-3-Clause
// The soil in space by WebGL: each particle a shaded ball, rigid bodies as surfaces. The graphics card has single precision, so its places count from the
// lower corner of the soil's codes.
import {
  AmbientLight, BufferAttribute, BufferGeometry, DataTexture, DirectionalLight, DoubleSide, DynamicDrawUsage, GLSL3, LinearFilter, LineBasicMaterial, LineSegments,
  Mesh, MeshLambertMaterial, OrthographicCamera, Plane, Points, RawShaderMaterial, Scene, Vector2, Vector3, WebGLRenderer,
} from "three";
import { PLAIN } from "./film_painter";
import { axes_of } from "./space_camera";
import { BALL, BODY, CLEAR, corners_at, edges_of, type SpaceLook, type SpaceModel, type SpacePainter } from "./space_painter";
import type { Vector } from "./space_parts";

const VERTEX = `precision highp float;
in vec3 position; in vec3 position_next; in float value; in float value_next; in float side; in float shown;
uniform mat4 projectionMatrix; uniform mat4 viewMatrix;
uniform float part; uniform float unit; uniform float pixels; uniform vec2 bytes; uniform vec3 kept_lower; uniform vec3 kept_upper;
out float shade;
void main() {
  vec3 place = mix(position, position_next, part) * 65535.0 * unit;
  bool out_of_it = shown < 0.5 || any(lessThan(place, kept_lower)) || any(greaterThan(place, kept_upper));
  gl_Position = out_of_it ? vec4(2.0, 2.0, 2.0, 1.0) : projectionMatrix * viewMatrix * vec4(place, 1.0);
  gl_PointSize = max(side * 65535.0 * unit * pixels, 1.5);
  shade = (mix(value, value_next, part) * 255.0 - bytes.x) / (bytes.y - bytes.x);
}`;

const FRAGMENT = `precision highp float;
in float shade;
uniform sampler2D colours; uniform vec3 plain; uniform bool has_values;
out vec4 colour;
void main() {
  vec2 q = 2.0 * gl_PointCoord - 1.0;
  float off = dot(q, q);
  if (off > 1.0) discard;
  vec3 own = has_values ? texture(colours, vec2((clamp(shade, 0.0, 1.0) * 255.0 + 0.5) / 256.0, 0.5)).rgb : plain;
  float light = dot(vec3(q.x, -q.y, sqrt(1.0 - off)), vec3(-0.35, 0.55, 0.76));
  colour = vec4(own * (0.78 + 0.22 * clamp(light, 0.0, 1.0)), 1.0);
}`;

/** Farther than any place of a model, m. */
const FAR = 1e6;

export class SpaceWebgl implements SpacePainter {
  readonly kind = "webgl";
  readonly canvas = document.createElement("canvas");
  private renderer: WebGLRenderer;
  private scene = new Scene();
  private eye = new OrthographicCamera();
  private lamp = new DirectionalLight(0xffffff, 2);
  private points = new Points();
  private colours = new DataTexture(new Uint8Array(4 * 256), 256, 1);
  private balls: RawShaderMaterial;
  private skin = new MeshLambertMaterial({ color: BODY, flatShading: true, side: DoubleSide, polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1 });
  private thread = new LineBasicMaterial();
  private bodies: Mesh[] = [];
  private model: SpaceModel | null = null;
  private nothing = new Uint8Array(0);
  private all = new Uint8Array(0);
  private width = 1;
  private height = 1;

  /** Throws where the browser has no WebGL 2; `lost` is called when the context goes. */
  constructor(lost: () => void) {
    const context = this.canvas.getContext("webgl2", { alpha: true, antialias: true, depth: true });
    if (context === null) throw new Error("no WebGL 2");
    this.renderer = new WebGLRenderer({ canvas: this.canvas, context });
    this.renderer.setClearColor(0, 0);
    this.canvas.addEventListener("webglcontextlost", lost);
    this.colours.minFilter = this.colours.magFilter = LinearFilter;
    this.balls = new RawShaderMaterial({
      vertexShader: VERTEX, fragmentShader: FRAGMENT, glslVersion: GLSL3,
      uniforms: {
        part: { value: 0 }, unit: { value: 1 }, pixels: { value: 1 }, bytes: { value: new Vector2() },
        kept_lower: { value: new Vector3() }, kept_upper: { value: new Vector3() },
        colours: { value: this.colours }, has_values: { value: false }, plain: { value: PLAIN.map((c) => c / 255) },
      },
    });
  }

  resize(width: number, height: number): void {
    this.width = width;
    this.height = height;
    this.renderer.setSize(width, height, false);
  }

  show(model: SpaceModel): void {
    this.clear();
    this.model = model;
    const { soil } = model;
    this.nothing = new Uint8Array(soil.count);
    this.all = new Uint8Array(soil.count).fill(1);
    const geometry = new BufferGeometry();
    const moving = (name: string, array: Uint16Array | Uint8Array, items: number, normalized = true) =>
      geometry.setAttribute(name, new BufferAttribute(array, items, normalized).setUsage(DynamicDrawUsage));
    moving("position", soil.places[0], 3);
    moving("position_next", soil.places[0], 3);
    moving("value", this.nothing, 1);
    moving("value_next", this.nothing, 1);
    moving("shown", this.all, 1, false);
    geometry.setAttribute("side", new BufferAttribute(soil.sizes, 1, true));
    this.points = new Points(geometry, this.balls);
    this.points.frustumCulled = false;
    this.bodies = model.surfaces.map((surface) => {
      const skin = new BufferGeometry();
      skin.setAttribute("position", new BufferAttribute(this.places(surface.corners[0]), 3).setUsage(DynamicDrawUsage));
      skin.setIndex(new BufferAttribute(surface.triangles, 1));
      const body = new Mesh(skin, this.skin);
      body.frustumCulled = false;
      return body;
    });
    const edges = new BufferGeometry();
    edges.setAttribute("position", new BufferAttribute(this.places(edges_of(soil.box)), 3));
    this.scene.add(this.points, new LineSegments(edges, this.thread), ...this.bodies, this.lamp, new AmbientLight(0xffffff, 1.3));
    (this.colours.image.data as Uint8Array).set(model.colours);
    this.colours.needsUpdate = true;
  }

  draw(look: SpaceLook): void {
    if (this.model === null) return;
    this.place_eye(look);
    this.move_soil(this.model, look);
    this.move_bodies(this.model, look);
    this.thread.color.set(look.line);
    this.renderer.render(this.scene, this.eye);
  }

  free(): void {
    this.clear();
    this.balls.dispose();
    this.skin.dispose();
    this.thread.dispose();
    this.colours.dispose();
    this.renderer.dispose();
  }

  private clear(): void {
    this.scene.traverse((object) => (object as Partial<Mesh>).geometry?.dispose());
    this.scene.clear();
  }

  private place_eye({ camera }: SpaceLook): void {
    const { up, back } = axes_of(camera);
    const { box } = this.model!.soil;
    const far = 4 * (Math.hypot(...box.upper.map((x, d) => x - box.lower[d])) + camera.height);
    const half = camera.height / 2, wide = (half * this.width) / this.height;
    Object.assign(this.eye, { left: -wide, right: wide, top: half, bottom: -half, near: 0, far: 2 * far });
    this.eye.up.set(...up);
    const target = this.from_lower(camera.target);
    this.eye.position.set(...target).addScaledVector(new Vector3(...back), far);
    this.eye.lookAt(...target);
    this.eye.updateProjectionMatrix();
    this.lamp.position.set(...back).addScaledVector(new Vector3(...up), 0.7);
  }

  private move_soil({ soil, values }: SpaceModel, look: SpaceLook): void {
    const next = Math.min(look.frame + 1, soil.places.length - 1);
    this.upload("position", soil.places[look.frame]);
    this.upload("position_next", soil.places[next]);
    this.upload("value", values === null ? this.nothing : values[look.frame]);
    this.upload("value_next", values === null ? this.nothing : values[next]);
    this.upload("shown", look.mask ?? this.all);
    const { uniforms } = this.balls;
    uniforms.part.value = look.part;
    uniforms.unit.value = soil.step;
    uniforms.pixels.value = (BALL * this.height) / look.camera.height;
    uniforms.bytes.value.set(look.from_byte, look.to_byte);
    uniforms.has_values.value = values !== null;
    uniforms.kept_lower.value.set(...this.from_lower(look.kept.lower)).clampScalar(-FAR, FAR);
    uniforms.kept_upper.value.set(...this.from_lower(look.kept.upper)).clampScalar(-FAR, FAR);
  }

  private move_bodies({ surfaces }: SpaceModel, look: SpaceLook): void {
    for (const [i, body] of this.bodies.entries()) {
      const places = body.geometry.getAttribute("position") as BufferAttribute;
      (places.array as Float32Array).set(this.places(corners_at(surfaces[i], look.frame, look.part)));
      places.needsUpdate = true;
      body.visible = look.bodies !== "hidden";
    }
    const clear = look.bodies === "clear";
    if (this.skin.transparent !== clear) this.skin.needsUpdate = true;
    Object.assign(this.skin, { transparent: clear, opacity: clear ? CLEAR : 1, depthWrite: !clear });
    const planes: Plane[] = [];
    for (const [d, axis] of [new Vector3(1, 0, 0), new Vector3(0, 1, 0), new Vector3(0, 0, 1)].entries()) {
      const [low, high] = [this.from_lower(look.kept.lower)[d], this.from_lower(look.kept.upper)[d]];
      if (low > -Infinity) planes.push(new Plane(axis.clone(), -low));
      if (high < Infinity) planes.push(new Plane(axis.clone().negate(), high));
    }
    this.renderer.localClippingEnabled = true;
    this.skin.clippingPlanes = look.cut_bodies ? planes : [];
  }

  /** A place from the lower corner of the soil's codes. */
  private from_lower(place: Vector): Vector {
    return place.map((x, d) => x - this.model!.soil.lower[d]) as Vector;
  }

  /** Places x, y, z one after the other, as the graphics card takes them. */
  private places(all: ArrayLike<number>): Float32Array {
    const { lower } = this.model!.soil;
    return Float32Array.from(all, (x, i) => x - lower[i % 3]);
  }

  /** Points the attribute at a frame's own array; nothing is uploaded when it is there already. */
  private upload(name: string, array: Uint16Array | Uint8Array): void {
    const attribute = this.points.geometry.getAttribute(name) as BufferAttribute;
    if (attribute.array === array) return;
    attribute.array = array;
    attribute.needsUpdate = true;
  }
}
