import { BufferAttribute, BufferGeometry, ShapeUtils, Vector2 } from 'three'
import type { Outline } from './outlines'
import type { Mark } from './twist'

/** Cosine of the angle between faces below which an edge is sharp and gets a line. */
const SMOOTH = Math.cos(0.62)

/** Faces and the lines that are drawn along their edges. */
export interface Shape {
  readonly faces: BufferGeometry
  readonly lines: BufferGeometry
}

/** The profile of a round bar of radius and height 1, to be turned. */
export const BAR = [
  [0, 0, 0],
  [1, 0, 0],
  [1, 1, 0],
  [0, 1, 0],
] as const

/**
 * A body that is put together from prisms along z and turned shapes about y; each has a `tint` from
 * 0 (the part's own colour) to 1 (its second colour).
 */
export class Solid {
  readonly #positions: number[] = []
  readonly #normals: number[] = []
  readonly #tints: number[] = []
  readonly #index: number[] = []
  readonly #lines: number[] = []
  /** Of each point of the faces and of the lines: the throw it turns with, the piece it is of. */
  readonly #marks: number[] = []
  readonly #lineMarks: number[] = []
  #mark: Mark | null = null

  /** Marks the prism that follows as a part of a crank that twists. */
  marked(mark: Mark | null): this {
    this.#mark = mark
    return this
  }

  /** A prism with this outline between two places along z, with holes through it. */
  prism(
    outline: Outline,
    from: number,
    to: number,
    tint = 0,
    holes: readonly Outline[] = [],
  ): this {
    const [low, high] = from < to ? [from, to] : [to, from]
    for (const ring of [outline, ...holes])
      this.#wall(ring, low, high, tint, ring === outline ? 1 : -1)
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
    return this
  }

  /** The side of a prism, `out` -1 for a hole; both rings run counter-clockwise. */
  #wall(ring: Outline, low: number, high: number, tint: number, out: 1 | -1): void {
    const count = ring.length
    const corner = (index: number) => ring[(index + count) % count] as readonly [number, number]
    const normals = ring.map((_, index) => {
      const [a, b] = [corner(index), corner(index + 1)]
      const length = Math.hypot(b[0] - a[0], b[1] - a[1]) || 1
      return [(out * (b[1] - a[1])) / length, (-out * (b[0] - a[0])) / length] as const
    })
    const normal = (index: number) => normals[(index + count) % count] as readonly [number, number]
    const bend = (index: number) => {
      const [a, b] = [normal(index - 1), normal(index)]
      return a[0] * b[0] + a[1] * b[1] > SMOOTH
    }
    for (let index = 0; index < count; index++) {
      const first = this.#positions.length / 3
      for (const end of [0, 1]) {
        const [x, y] = corner(index + end)
        const [own, next] = [normal(index), normal(index + (end ? 1 : -1))]
        const [nx, ny] = bend(index + end) ? unit(own[0] + next[0], own[1] + next[1]) : own
        this.#point(x, y, low, nx, ny, 0, tint)
        this.#note(this.#marks, false)
        this.#point(x, y, high, nx, ny, 0, tint)
        this.#note(this.#marks, true)
      }
      const quad = out > 0 ? [0, 2, 3, 0, 3, 1] : [0, 3, 2, 0, 1, 3]
      this.#index.push(...quad.map((step) => first + step))
      const [a, b] = [corner(index), corner(index + 1)]
      this.#lines.push(a[0], a[1], low, b[0], b[1], low, a[0], a[1], high, b[0], b[1], high)
      if (!bend(index)) this.#lines.push(a[0], a[1], low, a[0], a[1], high)
      for (const front of [false, false, true, true, ...(bend(index) ? [] : [false, true])])
        this.#note(this.#lineMarks, front)
    }
  }

  /** Notes where a point at the rear or front end of a marked prism belongs. */
  #note(marks: number[], front: boolean): void {
    if (this.#mark) marks.push(front ? this.#mark.high : this.#mark.low, this.#mark.piece)
  }

  /**
   * A surface turned about the y-axis: `profile` are [radius, height, tint] seen with the axis at
   * the left, counter-clockwise, over the angles from the x-axis towards the viewer. An open
   * profile gives an open shell.
   */
  turned(
    profile: readonly (readonly [number, number, number])[],
    from = 0,
    to = 2 * Math.PI,
    steps = 32,
  ): this {
    const whole = to - from > 6.28
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
        this.#index.push(at, at + 1, at + 3, at, at + 3, at + 2)
        const next = from + ((to - from) * (step + 1)) / steps
        for (const [r, y] of [
          [r0, y0],
          [r1, y1],
        ] as const) {
          if (r > 0)
            this.#lines.push(r * cos, y, r * sin, r * Math.cos(next), y, r * Math.sin(next))
        }
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
    return this
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
