import { between, type Frame, frameOf, HOME, type Orbit, type Screen } from './cameras'
import type { Disc } from './extent'
import { type Pane, sheetOf } from './panes'
import type { Camera, Sight } from './stage'
import type { Vector } from './vector'

/** How long the way from one camera to another takes, ms. */
const WAY = 420

const ORBITED = ['azimuth', 'elevation', 'zoom', 'x', 'y'] as const

/** The stage in pixels, the share of its height kept for labels, and room about the engine. */
interface Stand {
  readonly width: number
  readonly height: number
  readonly foot: number
  readonly margin: number
}

/** Where one looks from at the moment: on a camera, or on the way from one to another. */
export class Viewpoint {
  readonly orbit: Orbit = { ...HOME }
  /** Azimuth of the isometric view, radians. */
  azimuth = Math.PI / 4
  #camera: Camera | null = null
  #from: Frame | null = null
  #since = 0
  #last: Frame | null = null
  /** Inputs of the last views, which are kept as long as they are. */
  #asked: readonly unknown[] = []
  #panes: readonly Pane[] = []

  /** Whether the picture will be another one in a moment by itself. */
  get moving(): boolean {
    return this.#from !== null
  }

  /** The views at time `now` (ms): what is seen, what fills the picture, the stage in pixels. */
  panes(
    sight: Sight,
    rooms: readonly (readonly Disc[])[],
    { width, height, foot, margin }: Stand,
    now: number,
  ): readonly Pane[] {
    const asked = [
      sight,
      ...rooms,
      width,
      height,
      foot,
      margin,
      this.azimuth,
      ...ORBITED.map((name) => this.orbit[name]),
    ]
    if (this.#panes.length && !this.#from && equal(asked, this.#asked)) return this.#panes
    this.#asked = asked
    if (sight === 'sheet') {
      this.#camera = this.#last = this.#from = null
      this.#panes = sheetOf(this, rooms, { width, height, foot: foot * height, margin })
    } else {
      const frame = this.#frame(sight, rooms, { aspect: width / height, foot, margin }, now)
      this.#panes = [{ camera: sight, x: 0, y: 0, width, height, frame }]
    }
    return this.#panes
  }

  #frame(camera: Camera, rooms: readonly (readonly Disc[])[], screen: Screen, now: number): Frame {
    const goal = this.#shifted(frameOf(camera, this, rooms, screen), camera)
    if (this.#camera !== null && this.#camera !== camera && this.#last !== null && !still()) {
      this.#from = this.#last
      this.#since = now
    }
    this.#camera = camera
    const share = this.#from ? (now - this.#since) / WAY : 1
    if (share >= 1) this.#from = null
    const eased = share < 0.5 ? 4 * share ** 3 : 1 - (2 - 2 * share) ** 3 / 2
    this.#last = this.#from ? between(this.#from, goal, eased) : goal
    return this.#last
  }

  /** A free look may be nearer, and beside the middle. */
  #shifted(frame: Frame, camera: Camera): Frame {
    if (camera !== 'orbit') return frame
    const half = frame.half / this.orbit.zoom
    const { right, up } = frame.look
    const [x, y] = [this.orbit.x * half, this.orbit.y * half]
    const centre = frame.centre.map(
      (at, i) => at + x * (right[i] as number) + y * (up[i] as number),
    )
    return { look: frame.look, half, centre: centre as unknown as Vector }
  }
}

/** Whether two lists hold the same values. */
export function equal(one: readonly unknown[], other: readonly unknown[]): boolean {
  if (one.length !== other.length) return false
  for (let index = 0; index < one.length; index++) if (one[index] !== other[index]) return false
  return true
}

/** Whether the system asks for less motion. */
function still(): boolean {
  return globalThis.matchMedia?.('(prefers-reduced-motion: reduce)').matches ?? false
}
