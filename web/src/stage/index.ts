import type { Exhibit } from '../exhibit'
import { type Chain, chainOf, moved, type Places, placesOf } from '../motion'
import { type Disc, discsOf } from './extent'
import { flatPicture } from './flat'
import { Inset } from './inset'
import { Loads } from './load'
import { listened, wentHome } from './orbit'
import { DARK, LIGHT } from './palette'
import type { Instant, Picture } from './picture'
import { NARROW, write } from './sheet'
import type { CreateStage, Reading, Stage, View } from './stage'
import { Viewpoint } from './viewpoint'
import { webglPicture } from './webgl'
import { Whirling } from './whirl'

/** How long the longest arrow is at scale 1, as a share of the engine's greatest breadth or height. */
const ARROW = 0.28
const DENSEST = 2
/** Kept at the lower edge for axes and scales, pixels. */
const FOOT = 58
/** Arrows drawn longer than that on purpose may leave the picture: the engine is not to become small beside them. */
const WITHIN = 2
/** Room round the engine and its arrows. */
const MARGIN = 1.06

export const createStage: CreateStage = (element, exhibit, onOrbit) =>
  new EngineStage(element, exhibit, onOrbit, webglPicture() ?? flatPicture())

/** The engine, what is written beside it, and where one looks from. */
class EngineStage implements Stage {
  readonly #element: HTMLElement
  readonly #root = document.createElement('div')
  readonly #sheet = document.createElement('canvas')
  readonly #picture: Picture
  readonly #inset: Inset
  readonly #viewpoint = new Viewpoint()
  readonly #unlisten: () => void
  #exhibit: Exhibit
  #discs: readonly Disc[]
  /** The tips of arrows, and all that must be seen with them. */
  #tips: readonly Disc[] | null = null
  #seen: readonly Disc[] = []
  #chain: Chain
  #places: Places
  #loads: Loads
  #beside: readonly Exhibit[] = []
  #whirling: Whirling
  #instant: Instant | null = null
  #view: View | null = null
  #size = { width: 1, height: 1, density: 1 }
  /** What the picture was last drawn for, the sheet and the inset last written for. */
  #drawn: readonly unknown[] = []
  #written: readonly unknown[] = []
  #traced: readonly unknown[] = []
  #ends: readonly [[number, number], [number, number]] = [
    [0, 0],
    [0, 0],
  ]
  #awaited = 0

  constructor(element: HTMLElement, exhibit: Exhibit, onOrbit: () => void, picture: Picture) {
    this.#element = element
    this.#picture = picture
    Object.assign(this.#root.style, { position: 'relative', width: '100%', height: '100%', overflow: 'hidden' })
    for (const canvas of [picture.canvas, this.#sheet]) {
      Object.assign(canvas.style, { position: 'absolute', left: '0', top: '0', width: '100%', height: '100%' })
      this.#root.append(canvas)
    }
    this.#sheet.style.pointerEvents = 'none'
    this.#sheet.setAttribute('aria-hidden', 'true')
    picture.canvas.setAttribute('role', 'img')
    this.#inset = new Inset(this.#root)
    element.append(this.#root)
    this.#exhibit = exhibit
    this.#discs = discsOf(exhibit.scene)
    this.#chain = chainOf(exhibit.scene, exhibit.sense)
    this.#places = placesOf(this.#chain)
    this.#loads = new Loads(exhibit)
    this.#whirling = new Whirling(exhibit)
    this.#unlisten = listened(
      picture.canvas,
      this.#viewpoint.orbit,
      () => this.#view?.camera === 'orbit',
      () => {
        onOrbit()
        this.#again()
      },
    )
    picture.canvas.addEventListener('webglcontextlost', this.#lost)
    picture.canvas.addEventListener('webglcontextrestored', this.#found)
    picture.show(exhibit, this.#chain)
    this.resize()
  }

  get means(): Stage['means'] {
    return this.#picture.means
  }

  show(exhibit: Exhibit): void {
    this.#exhibit = exhibit
    this.#discs = discsOf(exhibit.scene)
    this.#chain = chainOf(exhibit.scene, exhibit.sense)
    this.#places = placesOf(this.#chain)
    this.#loads = new Loads(exhibit)
    this.#loads.beside = this.#beside
    this.#tips = null
    this.#whirling = new Whirling(exhibit)
    this.#written = []
    this.#traced = []
    this.#instant = null
    this.#drawn = []
    this.#picture.show(exhibit, this.#chain)
  }

  beside(exhibits: readonly Exhibit[]): void {
    this.#beside = exhibits
    this.#loads.beside = exhibits
  }

  draw(view: View): void {
    this.#say(view)
    this.#view = view
    const { scene } = this.#exhibit
    const { low, high } = scene
    const { width, height } = this.#size
    const palette = view.dark ? DARK : LIGHT
    const screen = {
      aspect: width / height,
      foot: width < NARROW ? Math.min(0.4, (FOOT + 26) / height) : Math.min(0.25, FOOT / height),
      margin: MARGIN,
    }
    const instant = this.#now(view)
    instant.load = this.#loads.at(view)
    instant.arrow = ARROW * Math.max(high[0] - low[0], high[1] - low[1]) * view.arrows.scale
    const longest = instant.arrow * Math.min(1, WITHIN / view.arrows.scale)
    const discs = this.#with(this.#loads.room(view, longest))
    const frame = this.#viewpoint.frame(view.camera, discs, screen, performance.now())
    moved(this.#chain, view.theta, this.#places)
    instant.view = view
    instant.frame = frame
    instant.palette = palette
    instant.moved = this.#whirling.at(view.theta, view.whirl.orders)
    if (this.#anew(instant)) this.#picture.draw(instant)
    this.#write(instant)
    this.#trace(instant)
    if (this.#viewpoint.moving && this.#awaited === 0) this.#awaited = requestAnimationFrame(this.#again)
  }

  /** What must be seen: the engine, and its arrows at their longest, so that none is cut off. The same list as long as it holds. */
  #with(arrows: readonly Disc[]): readonly Disc[] {
    if (arrows !== this.#tips) {
      this.#tips = arrows
      this.#seen = [...this.#discs, ...arrows]
    }
    return this.#seen
  }

  /** Whether an instant looks different from the one that was drawn last: without a graphics card drawing takes long. */
  #anew({ view, frame, palette, load, arrow }: Instant): boolean {
    const { right, up, back } = frame.look
    const { arrows, whirl } = view
    const what = [view.theta, view.glass, view.glow, palette, whirl.magnification, whirl.orders?.join()]
    const pushed = [
      load.force,
      load.couple,
      arrow,
      arrows.force,
      arrows.couple,
      arrows.cylinders,
      arrows.orders?.join(),
    ]
    const state = [...what, ...pushed, ...right, ...up, ...back, ...frame.centre, frame.half]
    if (same(state, this.#drawn)) return false
    this.#drawn = state
    return true
  }

  /** The record of an instant, which is used again and again. */
  #now(view: View): Instant {
    this.#instant ??= {
      view,
      frame: { look: { right: [1, 0, 0], up: [0, 1, 0], back: [0, 0, 1] }, centre: [0, 0, 0], half: 1 },
      places: this.#places,
      moved: this.#whirling.at(view.theta, null),
      load: this.#loads.at(view),
      arrow: 0,
      palette: LIGHT,
    }
    return this.#instant
  }

  readonly #again = (): void => {
    cancelAnimationFrame(this.#awaited)
    this.#awaited = 0
    if (this.#view) this.draw(this.#view)
  }

  /** The graphics card was taken away, which a sleeping laptop may do; at once, while nothing can be deleted twice. */
  readonly #lost = (): void => this.#picture.lose()

  readonly #found = (): void => {
    this.#picture.show(this.#exhibit, this.#chain)
    this.#drawn = []
    this.#again()
  }

  /** Tells those who do not see it what is shown, and whether keys turn it. */
  #say(view: View): void {
    if (this.#view?.camera === view.camera && this.#written.length > 0) return
    const { canvas } = this.#picture
    const free = view.camera === 'orbit'
    const how = free ? 'free view; arrow keys turn it, plus and minus zoom, Home puts it back' : `${view.camera} view`
    canvas.setAttribute('aria-label', `${this.#exhibit.name}: ${how}`)
    canvas.tabIndex = free ? 0 : -1
    canvas.style.touchAction = free ? 'none' : ''
    canvas.style.cursor = free ? 'grab' : ''
  }

  /** Unless the engine moves, the sheet changes only with the camera, the size, the colours and the scale of arrows. */
  #write({ view, frame, palette, load, arrow, moved: displacement }: Instant): void {
    const { width, height, density } = this.#size
    const { look, centre, half } = frame
    const { force, couple } = load
    const { magnification } = view.whirl
    const still = [...look.right, ...look.up, ...centre, half, width, height, density, palette, force, couple, arrow]
    const state = magnification > 0 ? [...still, magnification, view.theta, view.whirl.orders] : still
    if (same(state, this.#written)) return
    this.#written = state
    const to = this.#sheet.getContext('2d')
    if (!to) return
    to.setTransform(density, 0, 0, density, 0, 0)
    write(to, this.#exhibit, { frame, width, height, palette, load, arrow, moved: displacement, magnification })
  }

  #trace({ view, moved: displacement, palette }: Instant): void {
    const shown = view.whirl.magnification > 0
    this.#inset.visible = shown
    if (!shown) return
    const [front, rear] = this.#whirling.ends
    this.#whirling.axis(displacement, front, this.#ends[0])
    this.#whirling.axis(displacement, rear, this.#ends[1])
    this.#paths(view)
    this.#inset.draw(this.#ends[0], this.#ends[1], palette, this.#size.density)
  }

  /** Works the paths out where the orders have changed. */
  #paths(view: View): void {
    const state = [view.whirl.orders?.join() ?? 'all', this.#exhibit]
    if (same(state, this.#traced)) return
    this.#traced = state
    const [front, rear] = this.#whirling.ends
    const { orders } = view.whirl
    const whirling = new Whirling(this.#exhibit)
    const { length_unit, low, high } = this.#exhibit.scene
    const paths = { front: whirling.path(front, orders), rear: whirling.path(rear, orders) }
    this.#inset.trace(paths, length_unit, Math.max(high[0] - low[0], high[1] - low[1]))
  }

  read(): Reading {
    if (this.#view) this.#paths(this.#view)
    return { pistons: this.#picture.pistons(), pins: this.#picture.pins(), paths: this.#inset.paths }
  }

  resize(): void {
    const width = Math.max(1, this.#element.clientWidth)
    const height = Math.max(1, this.#element.clientHeight)
    const density = Math.min(DENSEST, globalThis.devicePixelRatio || 1)
    this.#size = { width, height, density }
    this.#picture.size(width, height, density)
    this.#drawn = []
    this.#inset.fit(width, height)
    this.#traced = []
    this.#sheet.width = Math.round(width * density)
    this.#sheet.height = Math.round(height * density)
    this.#written = []
  }

  home(): void {
    wentHome(this.#viewpoint.orbit)
    this.#again()
  }

  dispose(): void {
    cancelAnimationFrame(this.#awaited)
    this.#unlisten()
    this.#picture.canvas.removeEventListener('webglcontextlost', this.#lost)
    this.#picture.canvas.removeEventListener('webglcontextrestored', this.#found)
    this.#picture.dispose()
    this.#root.remove()
    this.#view = null
  }
}

function same(a: readonly unknown[], b: readonly unknown[]): boolean {
  if (a.length !== b.length) return false
  for (let index = 0; index < a.length; index++) if (a[index] !== b[index]) return false
  return true
}
