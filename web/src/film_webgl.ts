// SPDX-License-Identifier: BSD-3-Clause
// The soil by WebGL: two frames lie in the graphics memory, and the shader goes between them.
import {
  BufferAttribute, BufferGeometry, Camera, DataTexture, DoubleSide, DynamicDrawUsage, GLSL3, LinearFilter, Mesh, NoBlending, type Object3D, Points,
  RawShaderMaterial, Scene, Vector2, WebGLRenderer,
} from "three";
import { CLOSE_GAPS, type Look, type Painter, PLAIN, SMALLEST_SQUARE } from "./film_painter";
import type { Soil } from "./film_soil";

const VERTEX = `precision highp float;
in vec2 position; in vec2 position_next; in float value; in float value_next; in float side;
uniform float part; uniform vec2 centre; uniform vec2 scale; uniform float pixels; uniform float smallest; uniform vec2 bytes;
out float shade;
void main() {
  gl_Position = vec4((mix(position, position_next, part) * 65535.0 - centre) * scale, 0.0, 1.0);
  gl_PointSize = max(side * 65535.0 * pixels, smallest);
  shade = (mix(value, value_next, part) * 255.0 - bytes.x) / (bytes.y - bytes.x);
}`;

const FRAGMENT = `precision highp float;
in float shade;
uniform sampler2D colours; uniform vec3 plain; uniform bool has_values;
out vec4 colour;
void main() {
  colour = has_values ? texture(colours, vec2((clamp(shade, 0.0, 1.0) * 255.0 + 0.5) / 256.0, 0.5)) : vec4(plain, 1.0);
}`;

export class WebglPainter implements Painter {
  readonly kind = "webgl";
  readonly canvas = document.createElement("canvas");
  private renderer: WebGLRenderer;
  private scene = new Scene();
  private camera = new Camera();
  private geometry = new BufferGeometry();
  private colours = new DataTexture(new Uint8Array(4 * 256), 256, 1);
  private material: RawShaderMaterial;
  private soil: Soil | null = null;
  private values: Uint8Array[] | null = null;
  private nothing = new Uint8Array(0);
  private width = 1;
  private height = 1;

  /** Throws where the browser has no WebGL 2, or none by a graphics card and `by_software` is false; `lost` is called when the context goes. */
  constructor(by_software: boolean, lost: () => void) {
    const context = this.canvas.getContext("webgl2", { alpha: true, antialias: false, depth: false, stencil: false });
    if (context === null) throw new Error("no WebGL 2");
    if (!by_software && is_software(context)) {
      context.getExtension("WEBGL_lose_context")?.loseContext();
      throw new Error("WebGL 2 by software only");
    }
    this.renderer = new WebGLRenderer({ canvas: this.canvas, context });
    this.renderer.setClearColor(0, 0);
    this.renderer.sortObjects = false;
    this.canvas.addEventListener("webglcontextlost", lost);
    this.colours.minFilter = this.colours.magFilter = LinearFilter;
    this.material = new RawShaderMaterial({
      vertexShader: VERTEX, fragmentShader: FRAGMENT, glslVersion: GLSL3, blending: NoBlending, depthTest: false, depthWrite: false, side: DoubleSide,
      uniforms: {
        part: { value: 0 }, centre: { value: new Vector2() }, scale: { value: new Vector2() }, pixels: { value: 1 }, smallest: { value: SMALLEST_SQUARE },
        bytes: { value: new Vector2() }, colours: { value: this.colours }, has_values: { value: false }, plain: { value: PLAIN.map((c) => c / 255) },
      },
    });
  }

  resize(width: number, height: number): void {
    this.width = width;
    this.height = height;
    this.renderer.setSize(width, height, false);
  }

  show_soil(soil: Soil): void {
    this.soil = soil;
    this.values = null;
    this.nothing = new Uint8Array(soil.count);
    this.geometry.dispose();
    this.geometry = new BufferGeometry();
    const moving = (name: string, array: Uint16Array | Uint8Array, items: number) =>
      this.geometry.setAttribute(name, new BufferAttribute(array, items, true).setUsage(DynamicDrawUsage));
    moving("position", soil.places[0], 2);
    moving("position_next", soil.places[0], 2);
    moving("value", this.nothing, 1);
    moving("value_next", this.nothing, 1);
    this.geometry.setAttribute("side", new BufferAttribute(soil.sizes ?? new Uint16Array(soil.count), 1, true));
    if (soil.triangles !== null) this.geometry.setIndex(new BufferAttribute(soil.triangles, 1));
    const object: Object3D = soil.triangles !== null ? new Mesh(this.geometry, this.material) : new Points(this.geometry, this.material);
    object.frustumCulled = false;
    this.scene.clear();
    this.scene.add(object);
  }

  show_values(frames: Uint8Array[] | null, colours: Uint8Array): void {
    this.values = frames;
    (this.colours.image.data as Uint8Array).set(colours);
    this.colours.needsUpdate = true;
  }

  draw(look: Look): void {
    const { soil, values } = this;
    if (soil === null) return;
    const next = Math.min(look.frame + 1, soil.places.length - 1);
    this.upload("position", soil.places[look.frame]);
    this.upload("position_next", soil.places[next]);
    this.upload("value", values === null ? this.nothing : values[look.frame]);
    this.upload("value_next", values === null ? this.nothing : values[next]);

    // The viewport is larger than the canvas by the largest square, since a point outside of the viewport is not drawn at all.
    const code = (soil.step * this.width) / look.window.width;
    const border = Math.ceil(soil.largest_size * code * CLOSE_GAPS) + 2;
    this.renderer.setViewport(-border, -border, this.width + 2 * border, this.height + 2 * border);
    const uniforms = this.material.uniforms;
    uniforms.part.value = look.part;
    uniforms.centre.value.set((look.window.x - soil.lower[0]) / soil.step, (look.window.y - soil.lower[1]) / soil.step);
    uniforms.scale.value.set((2 * code) / (this.width + 2 * border), (2 * code) / (this.height + 2 * border));
    uniforms.pixels.value = code * CLOSE_GAPS;
    uniforms.bytes.value.set(look.from_byte, look.to_byte);
    uniforms.has_values.value = values !== null;
    this.renderer.render(this.scene, this.camera);
  }

  free(): void {
    this.geometry.dispose();
    this.material.dispose();
    this.colours.dispose();
    this.renderer.dispose();
  }

  /** Points the attribute at a frame's own array: nothing is copied here, and nothing uploaded when the frame is there already. */
  private upload(name: string, array: Uint16Array | Uint8Array): void {
    const attribute = this.geometry.getAttribute(name) as BufferAttribute;
    if (attribute.array === array) return;
    attribute.array = array;
    attribute.needsUpdate = true;
  }
}

/** Whether the processor does what a graphics card should; browsers do not agree on failIfMajorPerformanceCaveat, so by name. */
function is_software(context: WebGL2RenderingContext): boolean {
  let name = String(context.getParameter(context.RENDERER));
  const info = name === "WebKit WebGL" ? context.getExtension("WEBGL_debug_renderer_info") : null;
  if (info !== null) name = String(context.getParameter(info.UNMASKED_RENDERER_WEBGL));
  return /swiftshader|llvmpipe|softpipe|software|basic render/i.test(name);
}
