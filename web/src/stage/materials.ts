import { DoubleSide, ShaderMaterial, Vector3 } from 'three'
import { channels, type Palette } from './palette'

/**
 * Materials of a technical illustration: a light that stands at the eye's left shoulder, shading
 * from cool to warm (after A. Gooch), a darker rim, thin lines along the edges. Cheap enough for a
 * computer without a graphics card.
 */
const VERTEX = /* glsl */ `
attribute float tint;
varying vec3 vNormal;
varying float vTint;
void main() {
  mat4 place = viewMatrix * modelMatrix * instanceMatrix;
  vNormal = mat3(place) * normal;
  vTint = tint;
  gl_Position = projectionMatrix * place * vec4(position, 1.0);
}`

const SHADED = /* glsl */ `
uniform vec3 base;
uniform vec3 second;
uniform float dark;
varying vec3 vNormal;
varying float vTint;
void main() {
  vec3 n = normalize(gl_FrontFacing ? vNormal : -vNormal);
  vec3 key = normalize(vec3(-0.42, 0.62, 0.66));
  vec3 colour = mix(base, second, vTint);
  float lit = dot(n, key) * 0.5 + 0.5;
  vec3 cool = colour * mix(vec3(0.50, 0.54, 0.64), vec3(0.34, 0.37, 0.45), dark);
  vec3 warm = colour * vec3(1.06, 1.04, 1.0) + 0.05;
  vec3 shade = mix(cool, warm, smoothstep(0.05, 0.95, lit));
  float gloss = pow(max(dot(reflect(-key, n), vec3(0.0, 0.0, 1.0)), 0.0), 26.0);
  float rim = pow(1.0 - clamp(n.z, 0.0, 1.0), 3.0);
  shade = shade * (1.0 - 0.22 * rim) + 0.26 * gloss;
  gl_FragColor = vec4(shade, 1.0);
}`

const LINE_VERTEX = /* glsl */ `
attribute mat4 instanceMatrix;
void main() {
  gl_Position = projectionMatrix * viewMatrix * modelMatrix * instanceMatrix * vec4(position, 1.0);
  gl_Position.z -= 0.0004 * gl_Position.w;
}`

const PLAIN = /* glsl */ `
uniform vec3 base;
uniform float opacity;
void main() { gl_FragColor = vec4(base, opacity); }`

const GLASS = /* glsl */ `
uniform vec3 base;
uniform float opacity;
varying vec3 vNormal;
varying float vTint;
void main() {
  float edge = 1.0 - abs(normalize(vNormal).z);
  gl_FragColor = vec4(base, opacity * (0.35 + 1.9 * pow(edge, 2.5)));
}`

const GLOW_VERTEX = /* glsl */ `
attribute vec4 hue;
varying vec4 vHue;
varying float vHigh;
varying vec3 vNormal;
void main() {
  mat4 place = viewMatrix * modelMatrix * instanceMatrix;
  vHue = hue;
  vHigh = position.y;
  vNormal = normalize(mat3(place) * normal);
  gl_Position = projectionMatrix * place * vec4(position, 1.0);
}`

const GLOW = /* glsl */ `
varying vec4 vHue;
varying float vHigh;
varying vec3 vNormal;
void main() {
  gl_FragColor = vec4(vHue.rgb, vHue.a * (0.55 + 0.45 * vHigh) * (0.5 + 0.5 * abs(vNormal.z)));
}`

const PARTS = ['crankshaft', 'balanceShaft', 'gear', 'piston', 'rod', 'slave'] as const
const ARROWS = ['force', 'part', 'couple'] as const
export type Arrow = (typeof ARROWS)[number]
/** What is shaded, by the colours of the palette that it takes. */
type Shaded = Record<(typeof PARTS)[number] | Arrow, ShaderMaterial>

export interface Materials extends Readonly<Shaded> {
  readonly lines: ShaderMaterial
  readonly glass: ShaderMaterial
  readonly glassLines: ShaderMaterial
  readonly glow: ShaderMaterial
  /** Puts on the colours of a palette. */
  dress(palette: Palette, dark: boolean): void
  dispose(): void
}

export function materials(): Materials {
  const made = [
    ...PARTS.map((name) => [name, shaded()]),
    ...ARROWS.map((name) => [name, overAll()]),
  ]
  const opaque = Object.fromEntries(made) as Shaded
  const lines = plain(LINE_VERTEX, PLAIN)
  const glassLines = plain(LINE_VERTEX, PLAIN)
  const glass = plain(VERTEX, GLASS)
  glass.side = DoubleSide
  const glow = plain(GLOW_VERTEX, GLOW)
  return {
    ...opaque,
    lines,
    glass,
    glassLines,
    glow,
    dress: (palette, dark) => {
      for (const name of [...PARTS, ...ARROWS]) {
        const [base, second = base] = [palette[name]].flat() as [number, number?]
        colour(opaque[name], 'base', base)
        colour(opaque[name], 'second', second)
        set(opaque[name], 'dark', dark ? 1 : 0)
      }
      colour(lines, 'base', palette.edge)
      set(lines, 'opacity', palette.edgeOpacity)
      colour(glass, 'base', palette.glass)
      set(glass, 'opacity', dark ? 0.2 : 0.17)
      colour(glassLines, 'base', palette.glass)
      set(glassLines, 'opacity', dark ? 0.42 : 0.5)
    },
    dispose: () => {
      for (const material of [...Object.values(opaque), lines, glassLines, glass, glow])
        material.dispose()
    },
  }
}

function shaded(): ShaderMaterial {
  const uniforms = {
    base: { value: new Vector3() },
    second: { value: new Vector3() },
    dark: { value: 0 },
  }
  // Faces stand back a little, so that the lines on their edges are whole.
  const back = { polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 2 }
  return new ShaderMaterial({ vertexShader: VERTEX, fragmentShader: SHADED, uniforms, ...back })
}

/** For arrows: seen through everything else, as in a drawing. */
function overAll(): ShaderMaterial {
  return Object.assign(shaded(), { depthTest: false, depthWrite: false, transparent: true })
}

function plain(vertexShader: string, fragmentShader: string): ShaderMaterial {
  const uniforms = { base: { value: new Vector3() }, opacity: { value: 1 } }
  const over = { transparent: true, depthWrite: false }
  return new ShaderMaterial({ vertexShader, fragmentShader, uniforms, ...over })
}

function colour(material: ShaderMaterial, name: string, value: number): void {
  const uniform = material.uniforms[name]
  if (uniform) (uniform.value as Vector3).set(...channels(value))
}

function set(material: ShaderMaterial, name: string, value: number): void {
  const uniform = material.uniforms[name]
  if (uniform) uniform.value = value
}
