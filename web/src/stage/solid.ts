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

/**
 * A body that is put together from prisms along z and turned shapes about y; each has a `tint` from
 * 0 (the part's own colour) to 1 (its second colour). It is made when it is drawn.
 */
export class Solid {
  readonly #pieces: ((mould: Mould) => void)[] = []
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

  shape(detail: Detail = 'fine'): Shape {
    const mould = new Mould(detail)
    for (const piece of this.#pieces) piece(mould)
    return mould.shape()
  }
}
