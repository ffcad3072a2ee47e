import {
  type BufferGeometry,
  DynamicDrawUsage,
  type Group,
  type InstancedBufferAttribute,
  InstancedBufferGeometry,
  InstancedMesh,
  LineSegments,
  type Object3D,
  type ShaderMaterial,
} from 'three'
import type { Detail } from './mould'
import type { Solid } from './solid'

/** What a batch is drawn with in one detail. */
interface Made {
  readonly faces: BufferGeometry
  readonly lines: InstancedBufferGeometry | null
}

/** Which batch a mesh is of. */
const BATCHES = new WeakMap<Object3D, Batch>()

/** Draws all batches below a thing finely or coarsely. */
export function detail(root: Object3D, wanted: Detail): void {
  root.traverse((object) => BATCHES.get(object)?.detail(wanted))
}

/** Equal parts that are drawn at once, each at a place of its own, with lines along their edges. */
export class Batch {
  readonly mesh: InstancedMesh
  readonly #lines: LineSegments | null = null
  readonly #array: Float32Array
  readonly #solid: Solid
  readonly #count: number
  readonly #own: [string, InstancedBufferAttribute][] = []
  readonly #made = new Map<Detail, Made>()

  constructor(
    parent: Group,
    solid: Solid,
    count: number,
    paint: ShaderMaterial,
    ink: ShaderMaterial | null,
    rank = 0,
  ) {
    this.#solid = solid
    this.#count = count
    this.mesh = new InstancedMesh(undefined, paint, count)
    this.mesh.instanceMatrix.setUsage(DynamicDrawUsage)
    this.#array = this.mesh.instanceMatrix.array as Float32Array
    still(this.mesh, rank)
    parent.add(this.mesh)
    BATCHES.set(this.mesh, this)
    if (ink === null) return
    this.#lines = new LineSegments(undefined, ink)
    still(this.#lines, rank + 1)
    parent.add(this.#lines)
  }

  /** Something else that each item has one of. */
  attribute(name: string, values: InstancedBufferAttribute): void {
    this.#own.push([name, values])
  }

  /** Has it drawn finely or coarsely; to be said before it is drawn at all. */
  detail(wanted: Detail): void {
    const { faces, lines } = this.#made.get(wanted) ?? this.#make(wanted)
    this.mesh.geometry = faces
    if (this.#lines && lines) this.#lines.geometry = lines
  }

  #make(wanted: Detail): Made {
    const { faces, lines: edges } = this.#solid.shape(wanted)
    for (const [name, values] of this.#own) faces.setAttribute(name, values)
    const lines = this.#lines && new InstancedBufferGeometry()
    if (lines) {
      for (const [name, values] of Object.entries(edges.attributes))
        lines.setAttribute(name, values)
      // The same buffer of places as the faces have, so that it is written and sent only once.
      lines.setAttribute('instanceMatrix', this.mesh.instanceMatrix)
      lines.instanceCount = this.#count
    }
    const made = { faces, lines }
    this.#made.set(wanted, made)
    return made
  }

  /** Puts an item at x, y, z, its y-axis along [up, right], stretched along its axes. */
  put(
    index: number,
    x: number,
    y: number,
    z: number,
    up: number,
    right: number,
    across = 1,
    along = 1,
    deep = across,
  ): void {
    const to = this.#array
    const at = 16 * index
    to[at] = up * across
    to[at + 1] = -right * across
    to[at + 2] = 0
    to[at + 4] = right * along
    to[at + 5] = up * along
    to[at + 6] = 0
    to[at + 10] = deep
    to[at + 12] = x
    to[at + 13] = y
    to[at + 14] = z
  }

  /** Puts an item by where it begins and its three axes, twelve numbers of a list. */
  set(index: number, from: ArrayLike<number>, first: number): void {
    const to = this.#array
    const at = 16 * index
    for (let axis = 0; axis < 3; axis++) {
      to[at + 12 + axis] = from[first + axis] as number
      to[at + axis] = from[first + 3 + axis] as number
      to[at + 4 + axis] = from[first + 6 + axis] as number
      to[at + 8 + axis] = from[first + 9 + axis] as number
    }
  }

  /** To be called once all are put. */
  placed(): void {
    this.mesh.instanceMatrix.needsUpdate = true
  }

  set visible(shown: boolean) {
    this.mesh.visible = shown
    if (this.#lines) this.#lines.visible = shown
  }

  dispose(): void {
    this.mesh.removeFromParent()
    this.#lines?.removeFromParent()
    this.mesh.dispose()
    for (const { faces, lines } of this.#made.values()) {
      faces.dispose()
      lines?.dispose()
    }
  }
}

/** Nothing here is looked after by three: it all moves with its group, and is always drawn. */
function still(object: InstancedMesh | LineSegments, rank: number): void {
  object.frustumCulled = false
  object.matrixAutoUpdate = false
  object.renderOrder = rank
}

/** Items grouped by a key. */
export function alike<T>(things: readonly T[], key: (thing: T) => string): T[][] {
  const groups = new Map<string, T[]>()
  for (const thing of things) {
    const name = key(thing)
    const group = groups.get(name)
    if (group) group.push(thing)
    else groups.set(name, [thing])
  }
  return [...groups.values()]
}
