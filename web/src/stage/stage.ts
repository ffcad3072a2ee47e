import type { Exhibit } from '../exhibit'

export type Camera = 'front' | 'plan' | 'side' | 'isometric' | 'orbit'
export const CAMERAS: readonly Camera[] = ['front', 'plan', 'side', 'isometric', 'orbit']

/** Everything that decides what is on the stage at an instant, but the engine itself. */
export interface View {
  /** Crank angle, radians, any turn. */
  readonly theta: number
  readonly camera: Camera
  /** What is drawn as arrows. */
  readonly arrows: {
    readonly force: boolean
    readonly couple: boolean
    readonly cylinders: boolean
    /** Orders that are added up; null for all. */
    readonly orders: readonly number[] | null
    /** 1 draws the greatest arrow as long as the stage is designed for. */
    readonly scale: number
  }
  /** The engine moves on its free response: how much it is magnified, 0 for not at all; orders as above. */
  readonly whirl: { readonly magnification: number; readonly orders: readonly number[] | null }
  /** Cylinder bores as glass, block box, gears: what may be hidden. */
  readonly glass: boolean
  readonly glow: boolean
  readonly dark: boolean
}

/** Where the things that are drawn stand, read back from what is drawn; [up, right, z] in the scene's unit, the whirl taken away. */
export interface Reading {
  /** Piston pin of each cylinder by number. */
  readonly pistons: Record<number, [number, number, number]>
  /** Middle of each crank pin, shaft by shaft. */
  readonly pins: [number, number, number][][]
  /** Paths of the crank axis at the front and the rear end over a cycle as they are drawn in the inset, unmagnified: [up, right]. */
  readonly paths: { readonly front: [number, number][]; readonly rear: [number, number][] }
}

/** One engine on a canvas of its own. Not a component: it is told what to draw, and draws it at once. */
export interface Stage {
  /** Puts another engine in the place of the one shown; keeps camera position where it can. `draw` follows. */
  show(exhibit: Exhibit): void
  /** Engines that are compared with this one: arrows of one length stand for the same force in all. `draw` follows. */
  beside(exhibits: readonly Exhibit[]): void
  draw(view: View): void
  read(): Reading
  /** After the element has changed its size; `draw` follows. */
  resize(): void
  /** Puts an orbit back to where it began. */
  home(): void
  dispose(): void
  /** How it draws: with WebGL, or flat where that is not to be had. */
  readonly means: 'webgl' | 'flat'
}

/** Makes a stage inside an element, which it fills. Falls back to flat drawings where WebGL is not to be had. */
export type CreateStage = (element: HTMLElement, exhibit: Exhibit, onOrbit: () => void) => Stage
