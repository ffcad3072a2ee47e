import {
  DynamicDrawUsage,
  type Group,
  InstancedBufferGeometry,
  InstancedMesh,
  LineSegments,
  type ShaderMaterial,
} from 'three'
import type { Shape } from './solid'

/** Equal parts that are drawn at once, each at a place of its own, with lines along their edges. */
export class Batch {
  readonly mesh: InstancedMesh
  readonly #lines: LineSegments | null = null
  readonly #array: Float32Array
  readonly #shape: Shape
  readonly #lineGeometry: InstancedBufferGeometry | null = null

  constructor(
    parent: Group,
    shape: Shape,
    count: number,
    paint: ShaderMaterial,
    ink: ShaderMaterial | null,
    rank = 0,
  ) {
    this.#shape = shape
    this.mesh = new InstancedMesh(shape.faces, paint, count)
    this.mesh.instanceMatrix.setUsage(DynamicDrawUsage)
    this.#array = this.mesh.instanceMatrix.array as Float32Array
    still(this.mesh, rank)
    parent.add(this.mesh)
    if (ink === null) return
    const geometry = new InstancedBufferGeometry()
    geometry.setAttribute('position', shape.lines.getAttribute('position'))
    const mark = shape.lines.getAttribute('mark')
    if (mark) geometry.setAttribute('mark', mark)
    // The same buffer of places as the faces have, so that it is written and sent only once.
    geometry.setAttribute('instanceMatrix', this.mesh.instanceMatrix)
    geometry.instanceCount = count
    this.#lineGeometry = geometry
    this.#lines = new LineSegments(geometry, ink)
    still(this.#lines, rank + 1)
    parent.add(this.#lines)
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
    this.#shape.faces.dispose()
    this.#shape.lines.dispose()
    this.#lineGeometry?.dispose()
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
