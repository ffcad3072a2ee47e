import { DoubleSide, ShaderMaterial, Vector2, Vector3 } from 'three'
import { channels, type Palette } from './palette'
import type { Slice } from './section'
import { MOST, type Twisted } from './twist'

/**
 * Materials of a technical illustration: a light that stands at the eye's left shoulder, shading
 * from cool to warm (after A. Gooch), a darker rim, thin lines along the edges. Cheap enough for a
 * computer without a graphics card. In a section what stands before it is left out, and what stands
 * behind it is faint; shafts are cut, other parts stand where their middle stands.
 */
const ALONG = /* glsl */ `
uniform float whole;
varying float vAlong;
float along(mat4 instance, vec4 at) { return mix(at.z, instance[3].z, whole); }`

/**
 * A crank that twists: each point is turned with its throw (`mark.x`, from the front), clockwise
 * seen from the front, and has the colour of its piece (`mark.y`).
 */
const TWIST = /* glsl */ `
#ifdef TWISTING
attribute vec2 mark;
uniform float ahead[${MOST}];
uniform vec4 heat[${MOST + 1}];
varying vec4 vHeat;
vec3 twisted(vec3 at) {
  int place = int(mark.x);
  float angle = mix(ahead[place], ahead[min(place + 1, ${MOST - 1})], fract(mark.x));
  float c = cos(angle);
  float s = sin(angle);
  return vec3(c * at.x + s * at.y, c * at.y - s * at.x, at.z);
}
#else
vec3 twisted(vec3 at) { return at; }
#endif`

const CUT = /* glsl */ `
uniform vec2 section;
uniform vec3 paper;
varying float vAlong;
bool before() { return vAlong > section.y; }
float faint(float share) { return vAlong < section.x ? share : 0.0; }`

const VERTEX = /* glsl */ `${ALONG}${TWIST}
attribute float tint;
varying vec3 vNormal;
varying float vTint;
void main() {
  vec4 at = instanceMatrix * vec4(twisted(position), 1.0);
  vAlong = along(instanceMatrix, at);
  vNormal = mat3(modelViewMatrix) * (mat3(instanceMatrix) * twisted(normal));
  vTint = tint;
#ifdef TWISTING
  vHeat = heat[int(mark.y)];
#endif
  gl_Position = projectionMatrix * (modelViewMatrix * at);
}`

const SHADED = /* glsl */ `${CUT}
uniform vec3 base;
uniform vec3 second;
uniform float dark;
varying vec3 vNormal;
varying float vTint;
#ifdef TWISTING
varying vec4 vHeat;
#endif
void main() {
  if (before()) discard;
  vec3 n = normalize(gl_FrontFacing ? vNormal : -vNormal);
  vec3 key = normalize(vec3(-0.42, 0.62, 0.66));
  vec3 colour = mix(base, second, vTint);
#ifdef TWISTING
  colour = mix(colour, vHeat.rgb, vHeat.a);
#endif
  float lit = dot(n, key) * 0.5 + 0.5;
  vec3 cool = colour * mix(vec3(0.50, 0.54, 0.64), vec3(0.34, 0.37, 0.45), dark);
  vec3 warm = colour * vec3(1.06, 1.04, 1.0) + 0.05;
  vec3 shade = mix(cool, warm, smoothstep(0.05, 0.95, lit));
  float gloss = pow(max(dot(reflect(-key, n), vec3(0.0, 0.0, 1.0)), 0.0), 26.0);
  float rim = pow(1.0 - clamp(n.z, 0.0, 1.0), 3.0);
  shade = shade * (1.0 - 0.22 * rim) + 0.26 * gloss;
  gl_FragColor = vec4(mix(shade, paper, faint(0.8)), 1.0);
}`

const LINE_VERTEX = /* glsl */ `${ALONG}${TWIST}
attribute mat4 instanceMatrix;
void main() {
  vec4 at = instanceMatrix * vec4(twisted(position), 1.0);
  vAlong = along(instanceMatrix, at);
  gl_Position = projectionMatrix * (modelViewMatrix * at);
  gl_Position.z -= 0.0004 * gl_Position.w;
}`

const PLAIN = /* glsl */ `${CUT}
uniform vec3 base;
uniform float opacity;
void main() {
  if (before()) discard;
  gl_FragColor = vec4(base, opacity * (1.0 - faint(0.75)));
}`

const GLASS = /* glsl */ `${CUT}
uniform vec3 base;
uniform float opacity;
varying vec3 vNormal;
varying float vTint;
void main() {
  if (before()) discard;
  float edge = 1.0 - abs(normalize(vNormal).z);
  gl_FragColor = vec4(base, (1.0 - faint(0.75)) * opacity * (0.35 + 1.9 * pow(edge, 2.5)));
}`

const GLOW_VERTEX = /* glsl */ `${ALONG}
attribute vec4 hue;
varying vec4 vHue;
varying float vHigh;
varying vec3 vNormal;
void main() {
  vec4 at = instanceMatrix * vec4(position, 1.0);
  vHue = hue;
  vAlong = along(instanceMatrix, at);
  vHigh = position.y;
  vNormal = normalize(mat3(modelViewMatrix) * (mat3(instanceMatrix) * normal));
  gl_Position = projectionMatrix * (modelViewMatrix * at);
}`

const GLOW = /* glsl */ `${CUT}
varying vec4 vHue;
varying float vHigh;
varying vec3 vNormal;
void main() {
  if (before() || faint(1.0) > 0.0) discard;
  gl_FragColor = vec4(vHue.rgb, vHue.a * (0.55 + 0.45 * vHigh) * (0.5 + 0.5 * abs(vNormal.z)));
}`

const SHAFTS = ['crankshaft', 'balanceShaft', 'gear'] as const
const CYLINDERS = ['piston', 'rod', 'slave', 'mount'] as const
const PARTS = [...SHAFTS, ...CYLINDERS] as const
const ARROWS = ['force', 'part', 'couple', 'roll', 'reaction'] as const
export type Arrow = (typeof ARROWS)[number]
/** What is shaded, by the colours of the palette that it takes. */
type Shaded = Record<(typeof PARTS)[number] | Arrow, ShaderMaterial>

export interface Materials extends Readonly<Shaded> {
  /** Lines of shafts, and of what stands in a cylinder. */
  readonly lines: ShaderMaterial
  readonly partLines: ShaderMaterial
  readonly glass: ShaderMaterial
  readonly glassLines: ShaderMaterial
  readonly glow: ShaderMaterial
  /** Of a crank that twists. */
  readonly twisting: ShaderMaterial
  readonly twistingLines: ShaderMaterial
  /** Twists that crank, null for not at all; `sense` is that of the exhibit. */
  twist(twisted: Twisted | null, sense: number): void
  /** How it is twisted: radians clockwise by throw, colours by piece. */
  readonly twisted: { readonly ahead: Float32Array; readonly heat: Float32Array }
  /** Puts on the colours of a palette. */
  dress(palette: Palette, dark: boolean): void
  /** Shows a slice between two places along z, null for everything. */
  cut(slice: Pick<Slice, 'from' | 'to'> | null): void
  dispose(): void
}

/** Uniforms that materials share: where a section is, and what is faint turns into. */
interface Cut {
  readonly section: { value: Vector2 }
  readonly paper: { value: Vector3 }
}

const EVERYTHING = [Number.MIN_SAFE_INTEGER, Number.MAX_SAFE_INTEGER] as const

export function materials(): Materials {
  const cut = { section: { value: new Vector2(...EVERYTHING) }, paper: { value: new Vector3() } }
  const nothing = { section: { value: new Vector2(...EVERYTHING) }, paper: cut.paper }
  const made = [
    ...SHAFTS.map((name) => [name, shaded(cut, 0)]),
    ...CYLINDERS.map((name) => [name, shaded(cut, 1)]),
    ...ARROWS.map((name) => [name, overAll(nothing)]),
  ]
  const opaque = Object.fromEntries(made) as Shaded
  const lines = plain(LINE_VERTEX, PLAIN, cut, 0)
  const partLines = plain(LINE_VERTEX, PLAIN, cut, 1)
  const glassLines = plain(LINE_VERTEX, PLAIN, cut, 1)
  const glass = plain(VERTEX, GLASS, cut, 1)
  glass.side = DoubleSide
  const glow = plain(GLOW_VERTEX, GLOW, cut, 1)
  const twisted = { ahead: new Float32Array(MOST), heat: new Float32Array(4 * (MOST + 1)) }
  const twisting = twistable(shaded(cut, 0), twisted)
  const twistingLines = twistable(plain(LINE_VERTEX, PLAIN, cut, 0), twisted)
  return {
    ...opaque,
    lines,
    partLines,
    glass,
    glassLines,
    glow,
    twisting,
    twistingLines,
    twisted,
    twist: (now, sense) => {
      for (let place = 0; place < MOST; place++)
        twisted.ahead[place] = now ? sense * (now.ahead[place] as number) : 0
      if (now) twisted.heat.set(now.heat)
      else twisted.heat.fill(0)
    },
    cut: (slice) => {
      cut.section.value.set(slice?.from ?? EVERYTHING[0], slice?.to ?? EVERYTHING[1])
    },
    dress: (palette, dark) => {
      const bodies = [...PARTS, ...ARROWS].map((name) => [opaque[name], palette[name]] as const)
      for (const [body, own] of [...bodies, [twisting, palette.crankshaft] as const]) {
        const [base, second = base] = [own].flat() as [number, number?]
        colour(body, 'base', base)
        colour(body, 'second', second)
        set(body, 'dark', dark ? 1 : 0)
      }
      for (const ink of [lines, partLines, twistingLines]) {
        colour(ink, 'base', palette.edge)
        set(ink, 'opacity', palette.edgeOpacity)
      }
      cut.paper.value.set(...channels(Number.parseInt(palette.paper.slice(1), 16)))
      colour(glass, 'base', palette.glass)
      set(glass, 'opacity', dark ? 0.2 : 0.17)
      colour(glassLines, 'base', palette.glass)
      set(glassLines, 'opacity', dark ? 0.42 : 0.5)
    },
    dispose: () => {
      const inks = [lines, partLines, glassLines, twistingLines]
      for (const material of [...Object.values(opaque), ...inks, twisting, glass, glow])
        material.dispose()
    },
  }
}

function shaded(cut: Cut, whole: number): ShaderMaterial {
  const uniforms = {
    ...cut,
    whole: { value: whole },
    base: { value: new Vector3() },
    second: { value: new Vector3() },
    dark: { value: 0 },
  }
  // Faces stand back a little, so that the lines on their edges are whole.
  const back = { polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 2 }
  return new ShaderMaterial({ vertexShader: VERTEX, fragmentShader: SHADED, uniforms, ...back })
}

/** The same for a crank that twists. */
function twistable(
  material: ShaderMaterial,
  { ahead, heat }: Materials['twisted'],
): ShaderMaterial {
  material.defines = { TWISTING: '' }
  Object.assign(material.uniforms, { ahead: { value: ahead }, heat: { value: heat } })
  return material
}

/** For arrows: seen through everything else, as in a drawing. */
function overAll(cut: Cut): ShaderMaterial {
  return Object.assign(shaded(cut, 1), { depthTest: false, depthWrite: false, transparent: true })
}

function plain(
  vertexShader: string,
  fragmentShader: string,
  cut: Cut,
  whole: number,
): ShaderMaterial {
  const uniforms = {
    ...cut,
    whole: { value: whole },
    base: { value: new Vector3() },
    opacity: { value: 1 },
  }
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
