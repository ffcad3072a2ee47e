import type { Exhibit, StrokeColours } from '../exhibit'
import type { MountChoice } from '../mounts'
import type { TwistChoice } from '../torsion'
import type { Pen } from './pen'

export type Camera = 'front' | 'plan' | 'side' | 'isometric' | 'orbit'
export const CAMERAS: readonly Camera[] = ['front', 'plan', 'side', 'isometric', 'orbit']
/** What is on the stage: one view, or all of a drawing sheet. */
export type Sight = Camera | 'sheet'
export const SIGHTS: readonly Sight[] = ['sheet', ...CAMERAS]

/** Of what there are arrows besides those of the whole engine. */
export const EACH = ['engine', 'banks', 'cylinders'] as const
export type Each = (typeof EACH)[number]

/** The view of an engine at an instant. */
export interface View {
  /** Crank angle, radians, any turn. */
  readonly theta: number
  readonly camera: Sight
  /** The arrows to draw. */
  readonly arrows: {
    readonly force: boolean
    readonly couple: boolean
    /** The rolling moment, as a curved arrow about the crank axis. */
    readonly roll: boolean
    /** The couple as two pairs of forces, upright (pitch) and level (yaw), not as one in its plane. */
    readonly axes: boolean
    /** Forces of each cylinder, or their sums by banks, besides those of the engine. */
    readonly each: Each
    /** Orders that are added up; null for all. */
    readonly orders: readonly number[] | null
    /** 1 draws the greatest arrow as long as the stage is designed for. */
    readonly scale: number
  }
  /** Magnification of the free response, 0 for none; orders as above. */
  readonly whirl: { readonly magnification: number; readonly orders: readonly number[] | null }
  /** What twists the crank of an engine whose torsion is known. */
  readonly twist: TwistChoice
  /** What moves the block of an engine on mounts; while it does, nothing whirls. */
  readonly mounts: MountChoice
  /** Cylinder bores as glass, block box, gears: what may be hidden. */
  readonly glass: boolean
  readonly glow: boolean
  /** Place of the slice that the front view shows, from the front; 0 for the whole engine. */
  readonly section: number
  readonly dark: boolean
}

/** Places read back from the drawing, [up, right, z] in the scene's unit, without whirl. */
export interface Reading {
  /** Piston pin of each cylinder by number. */
  readonly pistons: Record<number, [number, number, number]>
  /** Middle of each crank pin, shaft by shaft. */
  readonly pins: [number, number, number][][]
  /** Colours of the pieces of a crank that twists, front first: red, green, blue; else null. */
  readonly heat: ([number, number, number] | null)[]
  /** How often the motion of the block is drawn; 0 where it stands. */
  readonly magnification: number
  /** Mounts as they are drawn: the ends of the rubber at the block and below, and the force, N. */
  readonly mounts: readonly MountRead[]
  /** Paths of the crank axis at the ends over a cycle, unmagnified: [up, right]. */
  readonly paths: { readonly front: [number, number][]; readonly rear: [number, number][] }
  /** The views on the stage: where each stands, and pixels to one unit of length. */
  readonly panes: readonly PaneRead[]
}

/** A mount on the stage: places and force on what is below it, [up, right, z]. */
export interface MountRead {
  readonly name: string
  readonly upper: readonly [number, number, number]
  readonly lower: readonly [number, number, number]
  readonly force: readonly [number, number, number]
}

/** A view on the stage, pixels from its upper left corner. */
export interface PaneRead {
  readonly camera: Camera
  readonly x: number
  readonly y: number
  readonly width: number
  readonly height: number
  readonly scale: number
  /** Where the axis of the first shaft stands at z = 0. */
  readonly origin: readonly [number, number]
}

/** One engine on a canvas of its own; `draw` draws at once. */
export interface Stage {
  /** Replaces the engine, keeps the camera. `draw` follows. */
  show(exhibit: Exhibit): void
  /** Engines beside this one: all are drawn to one scale, and so are their arrows. `draw` follows. */
  beside(exhibits: readonly Exhibit[]): void
  draw(view: View): void
  read(): Reading
  /** After the element has changed its size; `draw` follows. */
  resize(): void
  /** Breadth and height, pixels of the page. */
  readonly size: { readonly width: number; readonly height: number }
  /**
   * Pictures of views as the stage would show them, `density` pixels to one of the page; they are
   * drawn `finer` times as finely, for not every machine draws smooth edges.
   */
  shots(density: number, finer: number): Shots
  /** Draws a view with a pen, flat, in pixels of the page. */
  sketch(view: View, pen: Pen): void
  dispose(): void
  /** How it draws: with WebGL, or flat where that is not to be had. */
  readonly means: 'webgl' | 'flat'
}

/** A stage that is drawn for pictures; `end` gives it back to the page. */
export interface Shots {
  /** The view on a canvas without a ground; the next one takes its place. */
  take(view: View): HTMLCanvasElement
  end(): void
}

/** Makes a stage that fills an element, flat where there is no WebGL; `refresh` asks for a frame. */
export type CreateStage = (
  element: HTMLElement,
  exhibit: Exhibit,
  colours: StrokeColours,
  refresh: () => void,
) => Stage
