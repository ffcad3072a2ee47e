import type { Exhibit } from '../exhibit'
import { shakeOf } from '../mounts'
import { type Disc, discsOf } from './extent'
import { Loads } from './load'
import { FORCES, forceDiscs, mountDiscs } from './mounts'
import type { View } from './stage'

/** What the picture of an engine must have room for: its parts, and its arrows at their longest. */
export class Room {
  readonly exhibit: Exhibit
  readonly loads: Loads
  /** The greater of breadth and height; lengths are in the unit of the engine looked at. */
  readonly size: number
  readonly #parts: readonly Disc[]
  readonly #factor: number
  #arrows: readonly Disc[] | null = null
  /** What moves the block, and the room that forces of mounts need then. */
  #moving: View['mounts'] | null = null
  #mounts: readonly Disc[] = []
  #discs: readonly Disc[] = []

  /** `main` is the engine looked at; in another unit, lengths are compared in crank radii. */
  constructor(exhibit: Exhibit, main: Exhibit = exhibit) {
    const { length_unit, low, high } = exhibit.scene
    const alike = length_unit === main.scene.length_unit
    this.exhibit = exhibit
    this.loads = new Loads(exhibit)
    this.#factor = alike ? 1 : main.scale.length / exhibit.scale.length
    this.size = this.#factor * Math.max(high[0] - low[0], high[1] - low[1])
    this.#parts = this.#scaled([...discsOf(exhibit.scene), ...mountDiscs(exhibit)])
  }

  /** The same list as long as nothing changes; the longest arrow is `arrow` long. */
  discs(view: View, arrow: number): readonly Disc[] {
    const arrows = this.loads.room(view, arrow / this.#factor)
    if (arrows !== this.#arrows || view.mounts !== this.#moving) {
      this.#arrows = arrows
      this.#moving = view.mounts
      const shake = view.arrows.force ? shakeOf(this.exhibit, view.mounts) : null
      this.#mounts = forceDiscs(this.exhibit, shake, (FORCES * arrow) / this.#factor)
      this.#discs = [...this.#parts, ...this.#scaled([...arrows, ...this.#mounts])]
    }
    return this.#discs
  }

  #scaled(discs: readonly Disc[]): readonly Disc[] {
    const factor = this.#factor
    return discs.map(({ centre: [x, y, z], facing, radius }) => ({
      centre: [factor * x, factor * y, factor * z],
      facing,
      radius: factor * radius,
    }))
  }
}
