import { Group, Matrix4, Quaternion, Vector3 } from 'three'
import type { Whirl } from '../../exhibit'
import { type Displacement, rotation } from '../whirl'

/** The block with everything on it, at the magnified displacement of the rigid engine. */
export class Block {
  readonly group = new Group()
  readonly #centre: Vector3
  readonly #axis = new Vector3()
  readonly #turn = new Quaternion()
  readonly #moved = new Vector3()
  readonly #inverse = new Matrix4()
  static readonly #SIZE = new Vector3(1, 1, 1)

  constructor(whirl: Whirl) {
    this.group.matrixAutoUpdate = false
    const [up, right, z] = whirl.centre
    this.#centre = new Vector3(right, up, z)
  }

  /** A true rotation about the centre of mass by the small angles times the magnification. */
  move(displacement: Displacement, magnification: number): void {
    this.#axis.set(...rotation(displacement, magnification))
    const angle = this.#axis.length()
    this.#turn.setFromAxisAngle(angle > 0 ? this.#axis.divideScalar(angle) : this.#axis, angle)
    this.#moved.copy(this.#centre).applyQuaternion(this.#turn).negate().add(this.#centre)
    this.#moved.x += displacement.right * magnification
    this.#moved.y += displacement.up * magnification
    this.#moved.z += displacement.along * magnification
    this.group.matrix.compose(this.#moved, this.#turn, Block.#SIZE)
    this.group.matrixWorldNeedsUpdate = true
  }

  /** Takes the block's motion away from a point of what was drawn. */
  unmoved(point: Vector3): Vector3 {
    return point.applyMatrix4(this.#inverse.copy(this.group.matrixWorld).invert())
  }
}
