import { BufferAttribute, BufferGeometry, ShapeUtils, Vector2 } from 'three'
import type { Outline } from './outlines'
import type { Mark } from './twist'

/**
 * How many corners round things have, for pictures that a processor draws: coarse is half of them,
 * rough a third, where they are small. Lines are dear there: what is turned has them only where it
 * is widest.
 */
export type Detail = 'fine' | 'coarse' | 'rough'
const EACH: Readonly<Record<Detail, number>> = { fine: 1, coarse: 2, rough: 3 }

/** A prism along z, with holes through it. */
export interface Prism {
  readonly outline: Outline
  readonly from: number
  readonly to: number
  readonly tint: number
  readonly holes: readonly Outline[]
  /** The part of a crank that twists. */
  readonly mark: Mark | null
}

/**
 * A surface turned about the y-axis: `profile` are [radius, height, tint] seen with the axis at
 * the left, counter-clockwise, over the angles from the x-axis towards the viewer. An open
 * profile gives an open shell.
 */
export interface Turned {
  readonly profile: readonly (readonly [number, number, number])[]
  readonly from: number
  readonly to: number
  readonly steps: number
}

/** Cosine of the angle between faces below which an edge is sharp and gets a line. */
const SMOOTH = Math.cos(0.62)

/** Faces and the lines that are drawn along their edges. */
export interface Shape {
  readonly faces: BufferGeometry
  readonly lines: BufferGeometry
}

/** Points, triangles and lines of a body, as they are put together. */
export class Mould {
  readonly #detail: Detail
  readonly #positions: number[] = []
  readonly #normals: number[] = []
  readonly #tints: number[] = []
  readonly #index: number[] = []
  readonly #lines: number[] = []
  /** Of each point of the faces and of the lines: the throw it turns with, the piece it is of. */
  readonly #marks: number[] = []
  readonly #lineMarks: number[] = []
  #mark: Mark | null = null

  constructor(detail: Detail) {
    this.#detail = detail
  }

  prism({ outline: whole, from, to, tint, holes: through, mark }: Prism): void {
    this.#mark = mark
    const rings = [whole, ...through].map((ring) => thinned(ring, EACH[this.#detail]))
    const [low, high] = from < to ? [from, to] : [to, from]
    for (const ring of rings) this.#wall(ring, low, high, tint, ring === rings[0] ? 1 : -1)
    const [outline, ...holes] = rings.map(({ corners }) => corners) as [Outline]
    const corners = [outline, ...holes].flat()
    const triangles =
      holes.length === 0 && convex(outline) ? fan(outline.length) : cut(outline, holes)
    for (const [z, front] of [
      [low, false],
      [high, true],
    ] as const) {
      const first = this.#positions.length / 3
      for (const [x, y] of corners) {
        this.#point(x, y, z, 0, 0, front ? 1 : -1, tint)
        this.#note(this.#marks, front)
      }
      for (const [a, b, c] of triangles) {
        this.#index.push(first + a, first + (front ? b : c), first + (front ? c : b))
      }
    }
  }

  /** The side of a prism, `out` -1 for a hole; both rings run counter-clockwise. */
  #wall(
    { corners: ring, sharp }: Ring,
    low: number,
    high: number,
    tint: number,
    out: 1 | -1,
  ): void {
    const count = ring.length
    const corner = (index: number) => around(ring, index)
    const normals = normalsOf(ring)
    const normal = (index: number): Corner => {
      const [x, y] = around(normals, index)
      return [out * x, out * y]
    }
    const smooth = (index: number) => !around(sharp, index)
    // at each corner, where the wall before it ends and the wall after it begins
    const edges = ring.map((_, index) => {
      const [before, after] = [normal(index - 1), normal(index)]
      const edge = (across: Corner) => this.#edge(corner(index), low, high, across, tint)
      if (!smooth(index)) return [edge(before), edge(after)] as const
      const shared = edge(unit(before[0] + after[0], before[1] + after[1]))
      return [shared, shared] as const
    })
    for (let index = 0; index < count; index++) {
      const [[, from], [to]] = [around(edges, index), around(edges, index + 1)]
      const quad = out > 0 ? [0, 2, 3, 0, 3, 1] : [0, 3, 2, 0, 1, 3]
      const points = [from, from + 1, to, to + 1]
      this.#index.push(...quad.map((point) => points[point] as number))
      const [a, b] = [corner(index), corner(index + 1)]
      this.#lines.push(a[0], a[1], low, b[0], b[1], low, a[0], a[1], high, b[0], b[1], high)
      if (!smooth(index)) this.#lines.push(a[0], a[1], low, a[0], a[1], high)
      for (const front of [false, false, true, true, ...(smooth(index) ? [] : [false, true])])
        this.#note(this.#lineMarks, front)
    }
  }

  /** The two ends of an edge of a wall; gives the place of the first among the points. */
  #edge([x, y]: Corner, low: number, high: number, [nx, ny]: Corner, tint: number): number {
    const first = this.#positions.length / 3
    this.#point(x, y, low, nx, ny, 0, tint)
    this.#note(this.#marks, false)
    this.#point(x, y, high, nx, ny, 0, tint)
    this.#note(this.#marks, true)
    return first
  }

  /** Notes where a point at the rear or front end of a marked prism belongs. */
  #note(marks: number[], front: boolean): void {
    if (this.#mark) marks.push(front ? this.#mark.high : this.#mark.low, this.#mark.piece)
  }

  turned({ profile, from, to, steps: finely }: Turned): void {
    const steps = Math.ceil(finely / EACH[this.#detail])
    const whole = to - from > 6.28
    const ringed = new Set<string>()
    const lined = this.#detail === 'fine' ? () => true : outermost(profile)
    for (let part = 0; part + 1 < profile.length; part++) {
      const [a, b] = [profile[part], profile[part + 1]] as [readonly number[], readonly number[]]
      const [r0, y0, r1, y1] = [a[0], a[1], b[0], b[1]] as [number, number, number, number]
      if (r0 === r1 && y0 === y1) continue // only the tint changes
      const [nr, ny] = unit(y1 - y0, r0 - r1)
      const first = this.#positions.length / 3
      for (let step = 0; step <= steps; step++) {
        const angle = from + ((to - from) * step) / steps
        const [cos, sin] = [Math.cos(angle), Math.sin(angle)]
        this.#point(r0 * cos, y0, r0 * sin, nr * cos, ny, nr * sin, b[2] as number)
        this.#point(r1 * cos, y1, r1 * sin, nr * cos, ny, nr * sin, b[2] as number)
        if (step === steps) break
        const at = first + 2 * step
        if (r1 > 0) this.#index.push(at, at + 1, at + 3)
        if (r0 > 0) this.#index.push(at, at + 3, at + 2)
      }
      for (const [r, y, place] of [
        [r0, y0, part],
        [r1, y1, part + 1],
      ] as const) {
        if (r > 0 && lined(place) && !ringed.has(`${r} ${y}`)) this.#ring(r, y, from, to, steps)
        ringed.add(`${r} ${y}`)
      }
      if (!whole) {
        for (const angle of [from, to]) {
          const [cos, sin] = [Math.cos(angle), Math.sin(angle)]
          this.#lines.push(r0 * cos, y0, r0 * sin, r1 * cos, y1, r1 * sin)
        }
      }
    }
    if (!whole) {
      this.#end(profile, from, false)
      this.#end(profile, to, true)
    }
  }

  /** The line that a corner of a profile draws. */
  #ring(radius: number, y: number, from: number, to: number, steps: number): void {
    for (let step = 0; step < steps; step++)
      for (const end of [step, step + 1]) {
        const angle = from + ((to - from) * end) / steps
        this.#lines.push(radius * Math.cos(angle), y, radius * Math.sin(angle))
      }
  }

  /** The flat end of a shape that is not turned all the way round; its profile must be convex. */
  #end(
    profile: readonly (readonly [number, number, number])[],
    angle: number,
    last: boolean,
  ): void {
    const first = this.#positions.length / 3
    const [cos, sin] = [Math.cos(angle), Math.sin(angle)]
    const side = last ? 1 : -1
    for (const [radius, height, tint] of profile) {
      this.#point(radius * cos, height, radius * sin, -side * sin, 0, side * cos, tint)
    }
    for (let corner = 1; corner + 1 < profile.length; corner++) {
      this.#index.push(first, first + corner + (last ? 0 : 1), first + corner + (last ? 1 : 0))
    }
  }

  #point(x: number, y: number, z: number, nx: number, ny: number, nz: number, tint: number): void {
    this.#positions.push(x, y, z)
    this.#normals.push(nx, ny, nz)
    this.#tints.push(tint)
  }

  shape(): Shape {
    const faces = new BufferGeometry()
    const floats = (values: number[], size: number) =>
      new BufferAttribute(new Float32Array(values), size)
    faces.setAttribute('position', floats(this.#positions, 3))
    faces.setAttribute('normal', floats(this.#normals, 3))
    faces.setAttribute('tint', floats(this.#tints, 1))
    faces.setIndex(this.#index)
    const lines = new BufferGeometry()
    lines.setAttribute('position', floats(this.#lines, 3))
    if (this.#mark) {
      faces.setAttribute('mark', floats(this.#marks, 2))
      lines.setAttribute('mark', floats(this.#lineMarks, 2))
    }
    return { faces, lines }
  }
}

/** The item at a place of a ring, which goes round. */
function around<T>(ring: readonly T[], index: number): T {
  return ring[(index + ring.length) % ring.length] as T
}

/** Tells of the corners of a profile whether its widest part begins or ends there. */
function outermost(profile: Turned['profile']): (place: number) => boolean {
  const widest = Math.max(...profile.map(([radius]) => radius))
  const wide = (place: number) => profile[place]?.[0] === widest
  return (place) => wide(place) && !(wide(place - 1) && wide(place + 1))
}

/** The outward normal of each side of an outline, which begins at the corner of that place. */
function normalsOf(ring: Outline): readonly Corner[] {
  return ring.map(([x, y], index) => {
    const [across, up] = around(ring, index + 1)
    const length = Math.hypot(across - x, up - y) || 1
    return [(up - y) / length, (x - across) / length]
  })
}

/** An outline, and at which of its corners it has an edge that is seen. */
interface Ring {
  readonly corners: Outline
  readonly sharp: readonly boolean[]
}

/** Corners that a thing that is round all over keeps. */
const ROUND = 10

/** The ring with its sharp corners, and of those between them one of so many. */
function thinned(ring: Outline, each: number): Ring {
  const normals = normalsOf(ring)
  const sharp = ring.map((_, index) => !even(around(normals, index - 1), around(normals, index)))
  if (each === 1) return { corners: ring, sharp }
  const edges = sharp.flatMap((edge, index) => (edge ? [index] : []))
  const kept = edges.flatMap((edge, place) => {
    const steps = (edges[place + 1] ?? (edges[0] as number) + ring.length) - edge
    return spaced(edge, steps, 1 + Math.ceil((steps - 1) / each))
  })
  const round = Math.min(ring.length, Math.max(ROUND, Math.ceil(ring.length / each)))
  const corners = edges.length > 0 ? kept : spaced(0, ring.length, round)
  return {
    corners: corners.map((index) => around(ring, index)),
    sharp: corners.map((index) => around(sharp, index)),
  }
}

/** So many places from one on, evenly over some steps. */
function spaced(from: number, steps: number, count: number): number[] {
  return Array.from({ length: count }, (_, place) => from + Math.round((place * steps) / count))
}

/** Whether two sides with these normals meet without an edge that is seen. */
function even(a: Corner, b: Corner): boolean {
  return a[0] * b[0] + a[1] * b[1] > SMOOTH
}

/** Whether an outline never bends inward, so that it can be cut from one of its corners. */
function convex(ring: Outline): boolean {
  return ring.every(([x, y], index) => {
    const [a, b] = [ring[(index + 1) % ring.length], ring[(index + 2) % ring.length]] as [
      Corner,
      Corner,
    ]
    return (a[0] - x) * (b[1] - a[1]) - (a[1] - y) * (b[0] - a[0]) >= 0
  })
}

type Corner = readonly [number, number]
type Triangle = readonly [number, number, number]

function fan(corners: number): Triangle[] {
  return Array.from({ length: corners - 2 }, (_, index) => [0, index + 1, index + 2] as const)
}

/** Triangles of any outline, with holes. */
function cut(outline: Outline, holes: readonly Outline[]): Triangle[] {
  const flat = (ring: Outline) => ring.map(([x, y]) => new Vector2(x, y))
  return ShapeUtils.triangulateShape(flat(outline), holes.map(flat)) as unknown as Triangle[]
}

function unit(x: number, y: number): [number, number] {
  const length = Math.hypot(x, y) || 1
  return [x / length, y / length]
}
