import type { Exhibit, StrokeColours } from '../exhibit'
import { t } from '../language/messages'
import { moved } from '../motion'
import type { Plane } from '../phasor'
import { clearestAzimuth } from './clearest'
import { FlatPicture } from './flat'
import { Inset } from './inset'
import { footOf, write } from './lettering'
import { LOOK } from './looks'
import { Machine } from './machine'
import { BOX, BOXES, Shaking } from './mounts'
import { listened } from './orbit'
import { DARK, LIGHT } from './palette'
import { type Pane, pixelsOf, placed } from './panes'
import { composed, printable } from './paper'
import type { Pen } from './pen'
import type { Instant, Picture } from './picture'
import { Room } from './room'
import type { CreateStage, Reading, Shots, Stage, View } from './stage'
import { equal, Viewpoint } from './viewpoint'
import { webglPicture } from './webgl'
import { Whirling } from './whirl'

/** The longest arrow at scale 1, as a share of the greater of breadth and height. */
const ARROW = 0.28
const DENSEST = 2
/** Pixels across that every graphics card can draw. */
const FINEST = 8192
/** Arrows longer than this may leave the picture, so that the engine stays large. */
const WITHIN = 2
/** From this width on, pixels, the inset has a place of its own. */
const ASIDE = 340
/** Room round the engine and its arrows. */
const MARGIN = 1.06

export const createStage: CreateStage = (element, exhibit, colours, refresh) =>
  new EngineStage(element, exhibit, colours, refresh, webglPicture() ?? new FlatPicture())

type Triple = [number, number, number]

/** The engine, the labels beside it, and the viewpoint. */
class EngineStage implements Stage {
  readonly #element: HTMLElement
  readonly #root = document.createElement('div')
  readonly #sheet = document.createElement('canvas')
  readonly #picture: Picture
  readonly #colours: StrokeColours
  readonly #inset: Inset
  readonly #viewpoint = new Viewpoint()
  #panes: readonly Pane[] = []
  readonly #unlisten: () => void
  readonly #unprint: () => void
  #machine: Machine
  /** What the picture must have room for: this engine, then those beside it. */
  #rooms: readonly Room[]
  #view: View | null = null
  #size = { width: 1, height: 1, density: 1 }
  /** What the picture was last drawn for, the sheet and the inset last written for. */
  #drawn: readonly unknown[] = []
  #written: readonly unknown[] = []
  #traced: readonly unknown[] = []
  readonly #front: Plane = [0, 0]
  readonly #rear: Plane = [0, 0]
  readonly #refresh: () => void

  constructor(
    element: HTMLElement,
    exhibit: Exhibit,
    colours: StrokeColours,
    refresh: () => void,
    picture: Picture,
  ) {
    this.#element = element
    this.#colours = colours
    this.#refresh = refresh
    this.#picture = picture
    Object.assign(this.#root.style, {
      position: 'relative',
      width: '100%',
      height: '100%',
      overflow: 'hidden',
    })
    for (const canvas of [picture.canvas, this.#sheet]) {
      const place = { position: 'absolute', inset: '0', width: '100%', height: '100%' }
      Object.assign(canvas.style, place)
      this.#root.append(canvas)
    }
    this.#sheet.style.pointerEvents = 'none'
    this.#sheet.setAttribute('aria-hidden', 'true')
    picture.canvas.setAttribute('role', 'img')
    this.#inset = new Inset(this.#root)
    element.append(this.#root)
    this.#machine = new Machine(exhibit)
    this.#rooms = [this.#machine.room]
    this.#viewpoint.azimuth = clearestAzimuth(exhibit.scene)
    this.#unlisten = listened(
      picture.canvas,
      this.#viewpoint.orbit,
      () => this.#view?.camera === 'orbit',
      refresh,
    )
    picture.canvas.addEventListener('webglcontextlost', this.#lost)
    picture.canvas.addEventListener('webglcontextrestored', this.#restored)
    picture.show(exhibit, colours)
    this.#unprint = printable(this.#root, this.#printing)
    this.resize()
  }

  get #exhibit(): Exhibit {
    return this.#machine.exhibit
  }

  get means(): Stage['means'] {
    return this.#picture.means
  }

  show(exhibit: Exhibit): void {
    this.#machine = new Machine(exhibit)
    this.#rooms = [this.#machine.room]
    this.#viewpoint.azimuth = clearestAzimuth(exhibit.scene)
    this.#written = []
    this.#traced = []
    this.#drawn = []
    this.#picture.show(exhibit, this.#colours)
  }

  beside(exhibits: readonly Exhibit[]): void {
    const { room } = this.#machine
    this.#rooms = [room, ...exhibits.map((exhibit) => new Room(exhibit, room.exhibit))]
    for (const each of this.#rooms)
      each.loads.beside = [room.exhibit, ...exhibits].filter((other) => other !== each.exhibit)
  }

  draw(view: View): void {
    this.#describe(view)
    this.#view = view
    this.#draw(view)
  }

  #draw(view: View): void {
    const instant = this.#instant(view)
    if (this.#anew(instant)) this.#picture.draw(instant)
    this.#write(instant)
    this.#trace(instant)
    if (this.#viewpoint.moving) this.#refresh()
  }

  #instant(view: View): Instant {
    const { chain, places, whirling, room, slices, mounting } = this.#machine
    const { width, height } = this.#size
    const palette = view.dark ? DARK : LIGHT
    // where there is room, the paths of the whirl stand beside the engine, not before it
    const shaking = this.#machine.shaking(view.mounts)
    const magnification = this.#machine.magnification(view)
    const beside = magnification > 0 && width >= ASIDE ? this.#inset.breadth : 0
    const screen = {
      ...{ width: width - beside, height },
      ...{ foot: footOf(width, height, !!shaking && view.arrows.force), margin: MARGIN },
    }
    const load = room.loads.at(view)
    const arrow = ARROW * Math.max(...this.#rooms.map(({ size }) => size)) * view.arrows.scale
    const longest = arrow * Math.min(1, WITHIN / view.arrows.scale)
    const discs = this.#rooms.map((each) => each.discs(view, longest))
    const panes = this.#viewpoint.panes(view.camera, discs, screen, performance.now())
    this.#panes = panes
    const slice = slices[view.section - 1] ?? null
    const twisted = this.#machine.twisting(view.twist)?.at(view.theta) ?? null
    moved(chain, view.theta, places, twisted?.cylinders)
    const displacement = (shaking ?? whirling).at(view.theta, view.whirl.orders)
    const mounted = mounting?.at(displacement, magnification, shaking) ?? null
    const block = { moved: displacement, magnification, mounted }
    return { view, panes, slice, places, ...block, load, arrow, palette, twisted }
  }

  /** Whether an instant differs from the last drawn one; drawing without a card is slow. */
  #anew({ view, panes, palette, load, arrow }: Instant): boolean {
    const { arrows, whirl, section } = view
    const shown = [
      ...[view.theta, view.glass, view.glow, palette, arrow],
      ...[load.force, load.couple, load.roll],
    ]
    const pushed = [arrows.force, arrows.couple, arrows.axes, arrows.each, arrows.orders?.join()]
    const whirled = [whirl.magnification, whirl.orders?.join()]
    const state = [...shown, ...pushed, panes, section, ...whirled, view.twist, view.mounts]
    if (equal(state, this.#drawn)) return false
    this.#drawn = state
    return true
  }

  /** The graphics card is gone, as after sleep; at once, so that nothing is freed twice. */
  readonly #lost = (): void => this.#picture.lose()

  readonly #restored = (): void => {
    this.#picture.show(this.#exhibit, this.#colours)
    this.#drawn = []
    this.#refresh()
  }

  /** Light and finely drawn, until it is on paper. */
  readonly #printing = (density: number | null): void => {
    if (!this.#view) return
    if (density === null) this.resize()
    else this.#resize(density, false)
    this.#draw(density === null ? this.#view : { ...this.#view, dark: false })
  }

  /** Describes the picture, and whether keys turn it. */
  #describe(view: View): void {
    if (this.#view?.camera === view.camera && this.#written.length > 0) return
    const { canvas } = this.#picture
    const free = view.camera === 'orbit'
    canvas.setAttribute('aria-label', t(LOOK[view.camera], { engine: this.#exhibit.name }))
    canvas.tabIndex = free ? 0 : -1
    canvas.style.touchAction = free ? 'none' : ''
    canvas.style.cursor = free ? 'grab' : ''
  }

  /** Writes the labels where camera, size, colours or the scale of arrows changed. */
  #write(instant: Instant): void {
    const { view, panes, slice, palette, load, arrow } = instant
    const { width, height, density } = this.#size
    const { magnification, mounted } = instant
    const { orders } = view.whirl
    const { force, couple, roll } = load
    const forces = mounted?.shake && view.arrows.force ? mounted.shake : null
    const sizes = [panes, slice, width, height, density, palette, arrow, view.twist, forces]
    const still = [...sizes, force, couple, roll]
    const state = magnification > 0 ? [...still, magnification, view.theta, orders] : still
    if (equal(state, this.#written)) return
    this.#written = state
    const to = this.#sheet.getContext('2d')
    if (!to) return
    to.setTransform(density, 0, 0, density, 0, 0)
    write(to, this.#exhibit, { ...instant, width, height })
  }

  #trace({ view, moved: displacement, magnification, palette }: Instant): void {
    const shown = magnification > 0
    this.#inset.visible = shown
    if (!shown) return
    this.#place({ moved: displacement })
    this.#paths(view)
    const { density } = this.#size
    this.#inset.draw(this.#front, this.#rear, palette, { density, magnification })
  }

  /** Where the two ends of the crank axis are. */
  #place({ moved: displacement }: Pick<Instant, 'moved'>): void {
    const [front, rear] = this.#machine.whirling.ends
    this.#machine.whirling.axis(displacement, front, this.#front)
    this.#machine.whirling.axis(displacement, rear, this.#rear)
  }

  /** Works the paths out where the orders have changed. */
  #paths(view: View): void {
    const carrier = this.#machine.carrier(view)
    const state = [view.whirl.orders?.join() ?? 'all', this.#exhibit, carrier]
    if (equal(state, this.#traced)) return
    this.#traced = state
    const [front, rear] = carrier.ends
    const { orders } = view.whirl
    // one of its own: that of the stage keeps the angle that is shown
    const whirling =
      carrier instanceof Shaking
        ? new Shaking(this.#exhibit, carrier.shake)
        : new Whirling(this.#exhibit)
    const { low, high } = this.#exhibit.scene
    const paths = { front: whirling.path(front, orders), rear: whirling.path(rear, orders) }
    this.#inset.trace(
      paths,
      this.#exhibit.units.lengths,
      Math.max(high[0] - low[0], high[1] - low[1]),
    )
  }

  get size(): Stage['size'] {
    return this.#size
  }

  shots(density: number, finer: number): Shots {
    const canvas = document.createElement('canvas')
    const { width, height } = this.#size
    this.#resize(Math.min(density * finer, FINEST / width, FINEST / height), false)
    return {
      take: (view) => {
        this.#draw(view)
        composed(this.#root, density, canvas)
        return canvas
      },
      end: () => {
        this.resize()
        if (this.#view) this.#draw(this.#view)
      },
    }
  }

  sketch(view: View, pen: Pen): void {
    const instant = this.#instant(view)
    const { width, height } = this.#size
    const flat = new FlatPicture()
    flat.show(this.#exhibit, this.#colours)
    flat.sketch(pen, instant)
    pen.named?.('labels')
    write(pen, this.#exhibit, { ...instant, width, height })
    const { magnification } = instant
    if (magnification > 0) {
      this.#place(instant)
      const { offsetLeft, offsetTop } = this.#inset.canvas
      pen.save()
      pen.translate(offsetLeft, offsetTop)
      this.#inset.sketch(pen, this.#front, this.#rear, instant.palette, magnification)
      pen.restore()
    }
    pen.named?.(null)
  }

  read(): Reading {
    if (this.#view) this.#paths(this.#view)
    return {
      pistons: this.#picture.pistons(),
      pins: this.#picture.pins(),
      heat: this.#heat(),
      magnification: this.#view ? this.#machine.magnification(this.#view) : 0,
      mounts: this.#mounts(),
      paths: this.#inset.paths,
      panes: this.#panes.map((pane) => {
        const { camera, x, y, width, height } = pane
        const [across, down] = placed(pane, [0, 0, 0])
        return { camera, x, y, width, height, scale: pixelsOf(pane), origin: [across, down] }
      }),
    }
  }

  #mounts(): Reading['mounts'] {
    const view = this.#view
    const { mounts } = this.#exhibit
    if (!view || !mounts) return []
    const boxes = this.#picture.mounted()
    const shaking = this.#machine.shaking(view.mounts)
    const forces = new Float64Array(3 * mounts.mounts.length)
    shaking?.forces(forces)
    const most = shaking?.shake.most ?? 0
    return mounts.mounts.map(({ name }, index) => {
      const first = index * BOXES * BOX
      const [x, y, z] = boxes.subarray(first, first + 3) as unknown as Triple
      const [dx, dy, dz] = boxes.subarray(first + 6, first + 9) as unknown as Triple
      const [fx, fy, fz] = forces.subarray(3 * index, 3 * index + 3) as unknown as Triple
      return {
        name,
        upper: [y + dy, x + dx, z + dz],
        lower: [y, x, z],
        force: [most * fy, most * fx, most * fz],
      }
    })
  }

  #heat(): Reading['heat'] {
    const heat = this.#picture.heat()
    const { torsion } = this.#exhibit
    return (torsion?.pieces ?? []).map((_, piece) => {
      const [red = 0, green = 0, blue = 0, much = 0] = heat.subarray(4 * piece)
      return much > 0 ? [red, green, blue] : null
    })
  }

  resize(): void {
    // a presentation enlarges the stage with its letters
    const enlarged = (this.#element as { currentCSSZoom?: number }).currentCSSZoom ?? 1
    this.#resize(Math.min(DENSEST, globalThis.devicePixelRatio || 1) * enlarged, true)
  }

  #resize(density: number, live: boolean): void {
    const width = Math.max(1, this.#element.clientWidth)
    const height = Math.max(1, this.#element.clientHeight)
    this.#size = { width, height, density }
    this.#picture.size(width, height, density, live)
    this.#drawn = []
    this.#inset.fit(width, height)
    this.#traced = []
    this.#sheet.width = Math.round(width * density)
    this.#sheet.height = Math.round(height * density)
    this.#written = []
  }

  dispose(): void {
    this.#unprint()
    this.#unlisten()
    this.#picture.canvas.removeEventListener('webglcontextlost', this.#lost)
    this.#picture.canvas.removeEventListener('webglcontextrestored', this.#restored)
    this.#picture.dispose()
    this.#root.remove()
    this.#view = null
  }
}
