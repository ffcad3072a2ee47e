import type { Exhibit, StrokeColours } from '../exhibit'
import type { Places } from '../motion'
import type { Load } from './load'
import type { Mounted } from './mounts'
import type { Palette } from './palette'
import type { Pane } from './panes'
import type { Slice } from './section'
import type { Reading, Stage, View } from './stage'
import type { Twisted } from './twist'
import type { Displacement } from './whirl'

/** All that is known of an instant before it is drawn. */
export interface Instant {
  readonly view: View
  readonly panes: readonly Pane[]
  /** What the front view shows of the engine; null for all of it. */
  readonly slice: Slice | null
  /** Where the rods are. */
  readonly places: Places
  /** How the block has moved, not magnified, and how often that is drawn. */
  readonly moved: Displacement
  readonly magnification: number
  /** The mounts that it stands on; null without any. */
  readonly mounted: Mounted | null
  readonly load: Load
  /** How the crank is twisted; null where it is drawn as it is. */
  readonly twisted: Twisted | null
  /** Length of the longest arrow, in the scene's unit. */
  readonly arrow: number
  readonly palette: Palette
}

/** Draws the engine itself on a canvas: with WebGL, or flat. */
export interface Picture {
  readonly means: Stage['means']
  readonly canvas: HTMLCanvasElement
  show(exhibit: Exhibit, colours: StrokeColours): void
  draw(instant: Instant): void
  /** Where things stand in what was drawn last, the whirl taken away. */
  pistons(): Reading['pistons']
  pins(): Reading['pins']
  /** Colours of the pieces of the crank, as `Twisted` has them. */
  heat(): Float32Array
  /** The boxes of the mounts as they were drawn last, those that `Mounted` has. */
  mounted(): Float64Array
  /** Size in pixels, and whether it is drawn again and again (`live`), or for good. */
  size(width: number, height: number, density: number, live: boolean): void
  /** Lets go of what the graphics card has taken back; `show` builds it anew. */
  lose(): void
  dispose(): void
}
