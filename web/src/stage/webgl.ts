import { Matrix4, OrthographicCamera, Scene, Vector3, WebGLRenderer } from 'three'
import { afterRest } from '../activity'
import type { Exhibit, StrokeColours } from '../exhibit'
import { type Batch, detail } from './batch'
import { materials } from './materials'
import type { Detail } from './mould'
import { BOX, BOXES } from './mounts'
import { LIGHT, type Palette } from './palette'
import { type Pane, pixelsOf } from './panes'
import { arrows } from './parts/arrows'
import { Block } from './parts/block'
import { bores } from './parts/bores'
import { glow } from './parts/glow'
import { mounts } from './parts/mounts'
import type { Part } from './parts/part'
import { pistons } from './parts/pistons'
import { rods } from './parts/rods'
import { shafts } from './parts/shafts'
import type { Instant, Picture } from './picture'
import type { Slice } from './section'
import type { Reading } from './stage'
import { type Crank, crankOf } from './twist'

/** The parts of one engine, as they hang on its block. */
interface Machine {
  readonly exhibit: Exhibit
  /** The first shaft, where it can twist. */
  readonly crank: Crank | null
  readonly block: Block
  readonly moving: readonly Part[]
  readonly pistons: ReturnType<typeof pistons>
  readonly shafts: ReturnType<typeof shafts>
  readonly glow: ReturnType<typeof glow>
  readonly glass: readonly Batch[]
  /** The mounts, which do not hang on the block; null without any. */
  readonly mounts: ReturnType<typeof mounts> | null
  arrows: ReturnType<typeof arrows> | null
}

/** Milliseconds of rest before a slow machine draws finely, and in how many more pixels. */
const REST_MS = 500
const FINER = 2
/** Pixels across a bore below which a rough piston looks round: its sides are less than a pixel off. */
const SMALL = 48

/** The columns of a matrix as a box has them. */
const ORIGIN_FIRST = [3, 0, 1, 2] as const

/** How programs that draw in place of a graphics card call themselves. */
const BY_PROCESSOR = /swiftshader|llvmpipe|softpipe|software|basic render/i

/** A picture by WebGL, or null where that is not to be had. */
export function webglPicture(): Picture | null {
  const [canvas, context] = asked({ antialias: true, failIfMajorPerformanceCaveat: true })
  if (context && hasCard(context)) return new WebglPicture(canvas, context, true)
  context?.getExtension('WEBGL_lose_context')?.loseContext()
  const [plain, jagged] = asked({ antialias: false })
  return jagged ? new WebglPicture(plain, jagged, false) : null
}

/** A canvas to draw on, asked for here because three complains on the console where there is none. */
function asked(how: WebGLContextAttributes): [HTMLCanvasElement, WebGL2RenderingContext | null] {
  const canvas = document.createElement('canvas')
  const wish: WebGLContextAttributes = { alpha: true, powerPreference: 'default', stencil: false }
  return [canvas, canvas.getContext('webgl2', { ...wish, ...how })]
}

/** Whether a graphics card draws, as far as the browser says. */
function hasCard(context: WebGL2RenderingContext): boolean {
  const masked = String(context.getParameter(context.RENDERER))
  const named = masked === 'WebKit WebGL' ? context.getExtension('WEBGL_debug_renderer_info') : null
  const name = named ? String(context.getParameter(named.UNMASKED_RENDERER_WEBGL)) : masked
  return !BY_PROCESSOR.test(name)
}

class WebglPicture implements Picture {
  readonly means = 'webgl'
  readonly canvas: HTMLCanvasElement
  readonly #renderer: WebGLRenderer
  readonly #scene = new Scene()
  readonly #camera = new OrthographicCamera()
  readonly #paint = materials()
  readonly #basis = [new Vector3(), new Vector3(), new Vector3()] as const
  #machine: Machine | null = null
  #palette: Palette | null = null
  #reach = 1
  #panes: readonly Pane[] = []
  #slice: Slice | null = null
  #size = { width: 1, height: 1 }
  #density = 1
  #live = true
  #finer = 1
  #callOff = (): void => {}

  /** Without a graphics card (`quick`) motion is drawn coarsely, and finely at rest. */
  constructor(
    canvas: HTMLCanvasElement,
    context: WebGL2RenderingContext,
    readonly quick: boolean,
  ) {
    this.canvas = canvas
    this.#renderer = new WebGLRenderer({ canvas, context, alpha: true, antialias: quick })
    this.#renderer.setClearColor(0, 0)
    this.#camera.matrixAutoUpdate = false
    this.#scene.matrixAutoUpdate = false
  }

  show(exhibit: Exhibit, colours: StrokeColours): void {
    this.#clear()
    const { scene, sense } = exhibit
    const block = new Block(exhibit.whirl)
    const heads = pistons(block.group, scene, this.#paint)
    const crank = crankOf(exhibit)
    const turning = shafts(block.group, scene, sense, this.#paint, crank)
    const shine = glow(block.group, exhibit, colours, this.#paint)
    this.#scene.add(block.group)
    this.#machine = {
      exhibit,
      crank,
      block,
      moving: [heads, rods(block.group, scene, this.#paint), turning, shine],
      pistons: heads,
      shafts: turning,
      glow: shine,
      glass: bores(block.group, scene, this.#paint),
      mounts: exhibit.mounts && mounts(this.#scene, exhibit.mounts.mounts.length, this.#paint),
      arrows: null,
    }
    this.#reach = 4 * Math.hypot(...scene.high.map((high, i) => high - (scene.low[i] as number)))
  }

  draw(instant: Instant): void {
    const { view, panes, slice, places, moved, magnification, load, arrow, palette } = instant
    const { twisted, mounted } = instant
    const machine = this.#machine
    if (!machine) return
    if (palette !== this.#palette) {
      this.#paint.dress(palette, palette !== LIGHT)
      this.#palette = palette
    }
    this.#paint.twist(twisted, machine.exhibit.sense)
    machine.glow.visible = view.glow
    for (const part of machine.moving) part.move(places, view.theta)
    for (const batch of machine.glass) batch.visible = view.glass
    machine.block.move(moved, magnification)
    if (mounted) machine.mounts?.move(mounted, mounted.shake && view.arrows.force ? arrow : 0)
    machine.arrows ??= arrows(machine.block.group, load, this.#paint)
    machine.arrows.move(arrow)
    this.#panes = panes
    this.#slice = slice
    this.#render(1)
    if (this.quick) return
    this.#callOff()
    this.#callOff = afterRest(this.#rested, REST_MS)
  }

  readonly #rested = (): void => this.#render(FINER)

  #render(finer: number): void {
    if (finer !== this.#finer) {
      this.#finer = finer
      this.#renderer.setPixelRatio(this.#density * finer)
    }
    detail(this.#scene, this.quick || !this.#live || finer > 1 ? 'fine' : this.#hasty())
    this.#renderer.autoClear = true
    for (const pane of this.#panes) {
      const { x, y, width, height } = pane
      const below = this.#size.height - y - height
      this.#renderer.setViewport(x, below, width, height)
      this.#look(pane)
      this.#paint.cut(pane.camera === 'front' ? this.#slice : null)
      this.#renderer.render(this.#scene, this.#camera)
      this.#renderer.autoClear = false
    }
  }

  /** What is to be drawn again at once: roughly where pistons are small, so that none has corners. */
  #hasty(): Detail {
    const bores = this.#machine?.exhibit.scene.cylinders.map(({ bore }) => bore) ?? []
    const across = Math.max(...bores) * Math.max(...this.#panes.map(pixelsOf))
    return across < SMALL ? 'rough' : 'coarse'
  }

  #look({ frame: { look, centre, half }, width, height }: Pane): void {
    const camera = this.#camera
    const [right, up, back] = this.#basis
    right.set(...look.right)
    up.set(...look.up)
    back.set(...look.back)
    camera.matrix.makeBasis(right, up, back)
    const away = this.#reach
    camera.matrix.setPosition(
      centre[0] + away * look.back[0],
      centre[1] + away * look.back[1],
      centre[2] + away * look.back[2],
    )
    camera.matrixWorldNeedsUpdate = true
    camera.top = half
    camera.bottom = -half
    camera.right = (half * width) / height
    camera.left = -camera.right
    camera.near = 0
    camera.far = 2 * away
    camera.updateProjectionMatrix()
  }

  pistons(): Reading['pistons'] {
    const machine = this.#machine
    if (!machine) return {}
    const { cylinders } = machine.exhibit.scene
    return Object.fromEntries(
      machine.pistons.places.map(({ batch, index }, place) => {
        return [cylinders[place]?.number ?? 0, this.#read(batch, index, 0, 0, 0)]
      }),
    )
  }

  pins(): Reading['pins'] {
    const machine = this.#machine
    if (!machine) return []
    return machine.exhibit.scene.shafts.map((shaft, index) => {
      const batch = machine.shafts.drawn[index] as Batch
      return shaft.throws.map((pin, at) => {
        const place = index === 0 ? machine.crank?.places[at] : undefined
        const angle = pin.angle + (this.#paint.twisted.ahead[place ?? -1] ?? 0)
        return this.#read(
          batch,
          0,
          pin.radius * Math.sin(angle),
          pin.radius * Math.cos(angle),
          pin.z,
        )
      })
    })
  }

  heat(): Float32Array {
    return this.#paint.twisted.heat
  }

  mounted(): Float64Array {
    const machine = this.#machine
    const count = machine?.exhibit.mounts?.mounts.length ?? 0
    const out = new Float64Array(count * BOXES * BOX)
    if (!machine?.mounts) return out
    const { rubber, metal } = machine.mounts.drawn
    const place = new Matrix4()
    for (let index = 0; index < count; index++)
      for (let part = 0; part < BOXES; part++) {
        if (part === 0) rubber.mesh.getMatrixAt(index, place)
        else metal.mesh.getMatrixAt(3 * index + part - 1, place)
        ORIGIN_FIRST.forEach((column, at) => {
          const own = place.elements.slice(4 * column, 4 * column + 3)
          out.set(own, (index * BOXES + part) * BOX + 3 * at)
        })
      }
    return out
  }

  /** A point of a drawn thing, [up, right, z], from the matrices it was drawn with. */
  #read(batch: Batch, index: number, x: number, y: number, z: number): [number, number, number] {
    const point = new Vector3(x, y, z)
    const place = new Matrix4()
    batch.mesh.getMatrixAt(index, place)
    point.applyMatrix4(place).applyMatrix4(batch.mesh.matrixWorld)
    this.#machine?.block.unmoved(point)
    return [point.y, point.x, point.z]
  }

  size(width: number, height: number, density: number, live: boolean): void {
    this.#size = { width, height }
    this.#density = density
    this.#live = live
    this.#renderer.setDrawingBufferSize(width, height, density * this.#finer)
  }

  #clear(): void {
    const machine = this.#machine
    if (!machine) return
    for (const part of machine.moving) part.dispose()
    for (const batch of machine.glass) batch.dispose()
    machine.arrows?.dispose()
    machine.mounts?.dispose()
    this.#scene.remove(machine.block.group)
    this.#machine = null
  }

  lose(): void {
    this.#callOff()
    this.#clear()
    this.#paint.dispose()
  }

  dispose(): void {
    this.lose()
    this.#renderer.dispose()
    // Browsers keep only a few contexts: this one is given back at once.
    this.#renderer.getContext().getExtension('WEBGL_lose_context')?.loseContext()
  }
}
