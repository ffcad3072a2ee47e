import type { Exhibit, StrokeColours } from '../exhibit'
import { type Places, turned } from '../motion'
import type { Plane } from '../phasor'
import { straight } from './arrow'
import { type Body, bodiesOf, coloursOf } from './bodies'
import { along, boreEnd } from './extent'
import { type Flattened, flattenedMounts, mountArrows, mountBodies } from './flatMounts'
import { hull } from './hull'
import { projected } from './lettering'
import { type Load, ROLL } from './load'
import { css } from './palette'
import type { Pane } from './panes'
import type { Pen } from './pen'
import type { Instant, Picture } from './picture'
import type { Reading } from './stage'
import { tint, windowsOf } from './strokes'
import { type Crank, crankOf, type Mark, type Twisted } from './twist'
import type { Vector } from './vector'

/** Where a body stands: its origin, and the direction [up, right] of its y-axis. */
interface Stand {
  x: number
  y: number
  z: number
  up: number
  right: number
}

/** The picture without WebGL: outlines of convex bodies, the farthest first. */
export class FlatPicture implements Picture {
  readonly means = 'flat'
  readonly canvas = document.createElement('canvas')
  #exhibit: Exhibit | null = null
  #crank: Crank | null = null
  #bodies: Body[] = []
  #mounts: Body[] = []
  #mounted: Float64Array = new Float64Array()
  #heat: Float32Array = new Float32Array()
  #windows: ReturnType<typeof windowsOf> = []
  readonly #hue = new Float32Array(4)
  #size = { width: 1, height: 1, density: 1 }
  /** Where the pistons and the pins of the shafts were drawn, [up, right, z]. */
  #pistons: Reading['pistons'] = {}
  #pins: Reading['pins'] = []

  show(exhibit: Exhibit, colours: StrokeColours): void {
    this.#exhibit = exhibit
    this.#crank = crankOf(exhibit)
    this.#bodies = bodiesOf(exhibit.scene, this.#crank)
    this.#mounts = mountBodies(exhibit)
    this.#windows = windowsOf(exhibit, colours)
  }

  draw(instant: Instant): void {
    const to = this.canvas.getContext('2d')
    if (!to) return
    const { width, height, density } = this.#size
    to.setTransform(density, 0, 0, density, 0, 0)
    to.clearRect(0, 0, width, height)
    this.sketch(to, instant)
  }

  /** Draws the same with any pen, in pixels of the page. */
  sketch(to: Pen, instant: Instant): void {
    const exhibit = this.#exhibit
    if (!exhibit) return
    to.lineJoin = 'round'
    this.#pistons = {}
    this.#pins = exhibit.scene.shafts.map(() => [])
    for (const pane of instant.panes) {
      to.save()
      to.beginPath()
      to.rect(pane.x, pane.y, pane.width, pane.height)
      to.clip()
      to.named?.(`view ${pane.camera}`)
      this.#view(to, exhibit, instant, pane)
      to.named?.(null)
      to.restore()
    }
    this.#note(exhibit, instant)
  }

  #view(to: Pen, exhibit: Exhibit, instant: Instant, pane: Pane): void {
    const project = (point: Vector) => projected(instant, pane, exhibit, point)
    const slice = pane.camera === 'front' ? instant.slice : null
    const drawn = this.#bodies
      .filter(({ fill }) =>
        fill === 'glass' ? instant.view.glass : fill !== 'charge' || instant.view.glow,
      )
      .map((body): Flattened => this.#flattened(body, exhibit, instant, project))
    const { mounted } = instant
    if (mounted) drawn.push(...flattenedMounts(this.#mounts, mounted, pane))
    for (const shape of drawn.sort((a, b) => a.depth - b.depth)) {
      const { z } = shape
      if (slice && z > slice.to) continue
      const behind = slice !== null && z < slice.from
      if (behind && shape.body.fill === 'charge') continue
      to.globalAlpha = behind ? FAINT : 1
      to.named?.(nameOf(shape.body, exhibit))
      this.#paint(to, shape, instant)
      to.named?.(null)
    }
    to.globalAlpha = 1
    to.named?.('arrows')
    this.#arrows(to, instant, project)
    mountArrows(to, instant, pane)
    to.named?.(null)
  }

  #flattened(
    body: Body,
    exhibit: Exhibit,
    { places, view, twisted }: Instant,
    project: (point: Vector) => Vector,
  ) {
    const ahead = exhibit.sense * aheadOf(body.mark, twisted)
    const stand = standOf(body, exhibit, places, view.theta, ahead)
    if (body.carrier === 'piston')
      this.#pistons[exhibit.scene.cylinders[body.index]?.number ?? 0] = [stand.y, stand.x, stand.z]
    const count = body.points.length / 3
    const stretch = body.carrier === 'charge' ? chargeHeight(body, exhibit, places) : 1
    const flat = new Float64Array(2 * count)
    const depths: [number, number] = [0, 0]
    let along = 0
    for (let index = 0; index < count; index++) {
      const [x, y, z] = body.points.subarray(3 * index, 3 * index + 3) as unknown as Vector
      const place: Vector = [
        stand.x + x * stand.up + y * stretch * stand.right,
        stand.y - x * stand.right + y * stretch * stand.up,
        stand.z + z,
      ]
      along += place[2] / count
      const [right, down, near] = project(place)
      flat[2 * index] = right
      flat[2 * index + 1] = down
      depths[index < count / 2 ? 0 : 1] += (2 * near) / count
    }
    // Glass stands behind everything at its place, so that pistons are painted over their bores.
    const depth = (depths[0] + depths[1]) / 2 - (body.fill === 'glass' ? 1e-3 : 0)
    return { body, flat, depth, z: along, nearer: depths[1] > depths[0] ? count / 2 : 0 }
  }

  #paint(to: Pen, shape: Flattened, { palette, view, twisted }: Instant): void {
    const { body, flat, nearer } = shape
    const [side, cap] = heated(body.mark, twisted) ?? coloursOf(body.fill, palette)
    const glass = body.fill === 'glass'
    trace(to, flat, hull(flat))
    if (body.fill === 'charge') {
      this.#glow(to, body, view.theta)
      return
    }
    to.fillStyle = css(side, glass ? 0.13 : 1)
    to.fill()
    to.strokeStyle = glass ? css(palette.glass, 0.6) : css(palette.edge, palette.edgeOpacity)
    to.lineWidth = 1
    to.stroke()
    const count = flat.length / 4
    const corners = Array.from({ length: count }, (_, index) => nearer + index)
    trace(to, flat, corners)
    to.fillStyle = css(cap, glass ? 0.08 : 1)
    to.fill()
    to.stroke()
  }

  /** Tints the charge of a bore by its stroke. */
  #glow(to: Pen, body: Body, theta: number): void {
    const cycle = this.#exhibit?.cycle_deg ?? 720
    tint(this.#windows[body.index] ?? [], (theta * 180) / Math.PI, cycle, this.#hue, 0)
    const [red, green, blue, opacity] = this.#hue as unknown as [number, number, number, number]
    if (opacity <= 0) return
    to.fillStyle = `rgb(${255 * red} ${255 * green} ${255 * blue} / ${opacity})`
    to.fill()
  }

  #arrows(to: Pen, { load, arrow, palette }: Instant, project: (point: Vector) => Vector): void {
    to.lineCap = 'round'
    curved(to, load, arrow, css(palette.roll), project)
    for (const { kind, x, y, z, up, right } of load.pulls) {
      const tip = project([x + right * arrow, y + up * arrow, z])
      straight(to, project([x, y, z]), tip, css(palette[kind]), kind === 'part' ? 2 : 3.5)
    }
  }

  /** Keeps where the crank pins were drawn. */
  #note(exhibit: Exhibit, { view, twisted, mounted }: Instant): void {
    const { scene, sense } = exhibit
    this.#mounted = mounted?.boxes.slice() ?? new Float64Array()
    this.#heat = twisted?.heat ?? new Float32Array()
    this.#pins = scene.shafts.map((shaft, index) =>
      shaft.throws.map(({ angle, radius, z }, at): [number, number, number] => {
        const place = index === 0 ? this.#crank?.places[at] : undefined
        const ahead = sense * (twisted?.ahead[place ?? -1] ?? 0)
        const bearing = angle + turned(shaft, sense, view.theta) + ahead
        return [shaft.up + radius * Math.cos(bearing), shaft.right + radius * Math.sin(bearing), z]
      }),
    )
  }

  pistons(): Reading['pistons'] {
    return this.#pistons
  }

  pins(): Reading['pins'] {
    return this.#pins
  }

  heat(): Float32Array {
    return this.#heat
  }

  mounted(): Float64Array {
    return this.#mounted
  }

  size(width: number, height: number, density: number): void {
    this.#size = { width, height, density }
    this.canvas.width = Math.round(width * density)
    this.canvas.height = Math.round(height * density)
  }

  lose(): void {}

  dispose(): void {
    this.#exhibit = null
    this.#bodies = []
    this.#mounts = []
  }
}

/** How much is seen of what stands behind a section. */
const FAINT = 0.22

/** What a body is a part of, such as `piston 3`. */
function nameOf({ carrier, index }: Body, { scene, mounts }: Exhibit): string {
  if (carrier === 'mount') return `mount ${mounts?.mounts[index]?.name ?? ''}`.trim()
  const name = carrier === 'shaft' ? scene.shafts[index]?.name : scene.cylinders[index]?.number
  return `${carrier} ${name ?? ''}`.trim()
}

/** How far a part of the crank is ahead, radians; of a journal the middle. */
function aheadOf(mark: Mark | null, twisted: Twisted | null): number {
  if (!mark || !twisted) return 0
  return ((twisted.ahead[mark.low] ?? 0) + (twisted.ahead[mark.high] ?? 0)) / 2
}

/** The colours of a part of the crank by the load of its piece; null where it has none. */
function heated(mark: Mark | null, twisted: Twisted | null): readonly [number, number] | null {
  if (!mark || !twisted?.heat[4 * mark.piece + 3]) return null
  const [red = 0, green = 0, blue = 0] = twisted.heat.subarray(4 * mark.piece)
  const colour = [red, green, blue].reduce((all, each) => 256 * all + Math.round(255 * each), 0)
  return [colour, colour]
}

/** Where a body stands; one of a crank that twists is turned by `ahead` more. */
function standOf(
  body: Body,
  exhibit: Exhibit,
  places: Places,
  theta: number,
  ahead: number,
): Stand {
  const { scene, sense } = exhibit
  const { index } = body
  if (body.carrier === 'shaft') {
    const shaft = scene.shafts[index]
    const bearing = body.bearing + ahead + (shaft ? turned(shaft, sense, theta) : 0)
    const [up, right] = [Math.cos(bearing), Math.sin(bearing)]
    return { x: shaft?.right ?? 0, y: shaft?.up ?? 0, z: 0, up, right }
  }
  const c = scene.cylinders[index]
  const bearing = c?.bearing ?? 0
  const [up, right] = [Math.cos(bearing), Math.sin(bearing)]
  const at = 2 * index
  if (body.carrier === 'piston' || body.carrier === 'charge') {
    const above = body.carrier === 'charge' ? (c?.pin_height ?? 0) : 0
    const [x, y] = [places.piston[at + 1] as number, places.piston[at] as number]
    return { x: x + above * right, y: y + above * up, z: c?.z ?? 0, up, right }
  }
  if (body.carrier === 'rod') {
    const [y, x] = places.bigEnd.subarray(at) as unknown as Plane
    const [rodUp, rodRight] = places.direction.subarray(at) as unknown as Plane
    return { x, y, z: c?.rod_z ?? 0, up: rodUp, right: rodRight }
  }
  const [x, y, z] = c ? along(scene, c, 0) : [0, 0, 0]
  return { x, y, z, up, right }
}

/** How far it is from the crown of a piston to the end of its bore. */
function chargeHeight({ index }: Body, { scene }: Exhibit, { piston }: Places): number {
  const c = scene.cylinders[index]
  const shaft = scene.shafts[c?.shaft ?? 0]
  if (!c || !shaft) return 0
  const up = (piston[2 * index] as number) - shaft.up
  const right = (piston[2 * index + 1] as number) - shaft.right
  return boreEnd(scene, c) - c.pin_height - up * Math.cos(c.bearing) - right * Math.sin(c.bearing)
}

function trace(to: Pen, flat: Float64Array, corners: readonly number[]): void {
  to.beginPath()
  for (const corner of corners)
    to.lineTo(flat[2 * corner] as number, flat[2 * corner + 1] as number)
  to.closePath()
}

/** A curved arrow about the crank axis for the roll, clockwise from the top. */
function curved(
  to: Pen,
  { turning, about: [x, y, z] }: Load,
  arrow: number,
  colour: string,
  project: (point: Vector) => Vector,
): void {
  const sweep = ROLL.angle * turning
  const radius = ROLL.radius * arrow
  const steps = Math.ceil(Math.abs(sweep) / 0.1)
  if (steps < 1) return
  to.strokeStyle = to.fillStyle = colour
  to.lineWidth = 3
  to.beginPath()
  let before: Vector = [0, 0, 0]
  let last: Vector = [0, 0, 0]
  for (let step = 0; step <= steps; step++) {
    const way = (sweep * step) / steps
    before = last
    last = project([x + radius * Math.sin(way), y + radius * Math.cos(way), z])
    to.lineTo(last[0], last[1])
  }
  to.stroke()
  const long = Math.hypot(last[0] - before[0], last[1] - before[1])
  if (long < 1) return
  const [dx, dy] = [(last[0] - before[0]) / long, (last[1] - before[1]) / long]
  to.beginPath()
  to.moveTo(last[0] + 9 * dx, last[1] + 9 * dy)
  to.lineTo(last[0] + 5 * dy, last[1] - 5 * dx)
  to.lineTo(last[0] - 5 * dy, last[1] + 5 * dx)
  to.fill()
}
