import { BufferGeometry } from 'three'
import { type Detail, Mould, type Shape } from './mould'
import type { Outline } from './outlines'
import type { Mark } from './twist'

/** The profile of a round bar of radius and height 1, to be turned. */
export const BAR = [
  [0, 0, 0],
  [1, 0, 0],
  [1, 1, 0],
  [0, 1, 0],
] as const

/** Solids that are kept: those of two long engines, as they are and with weights and shafts. */
const KEPT = 96
const KNOWN = new Map<string, Solid>()

/** The solid that is made from what the key says: an edited engine keeps most of its parts. */
export function solidOf(key: string, make: () => Solid): Solid {
  const solid = KNOWN.get(key) ?? make()
  KNOWN.delete(key)
  KNOWN.set(key, solid)
  for (const oldest of KNOWN.keys()) {
    if (KNOWN.size <= KEPT) break
    KNOWN.delete(oldest)
  }
  return solid
}

/**
 * A body that is put together from prisms along z and turned shapes about y; each has a `tint` from
 * 0 (the part's own colour) to 1 (its second colour). It is made when it is drawn.
 */
export class Solid {
  readonly #pieces: ((mould: Mould) => void)[] = []
  readonly #shapes = new Map<Detail, Shape>()
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
    const prism = { outline, from, to, tint, holes, mark: this.#mark }
    this.#pieces.push((mould) => mould.prism(prism))
    return this
  }

  /** A profile turned about the y-axis, all the way round or between two angles. */
  turned(
    profile: readonly (readonly [number, number, number])[],
    from = 0,
    to = 2 * Math.PI,
    steps = 32,
  ): this {
    this.#pieces.push((mould) => mould.turned({ profile, from, to, steps }))
    return this
  }

  /** The shape, worked out once; whoever draws it has geometries of his own. */
  shape(detail: Detail = 'fine'): Shape {
    const { faces, lines } = this.#shapes.get(detail) ?? this.#made(detail)
    return { faces: again(faces), lines: again(lines) }
  }

  #made(detail: Detail): Shape {
    const mould = new Mould(detail)
    for (const piece of this.#pieces) piece(mould)
    const shape = mould.shape()
    this.#shapes.set(detail, shape)
    return shape
  }
}

/** A geometry of the same numbers. */
function again(geometry: BufferGeometry): BufferGeometry {
  const other = new BufferGeometry().setIndex(geometry.getIndex())
  for (const [name, values] of Object.entries(geometry.attributes)) other.setAttribute(name, values)
  return other
}
