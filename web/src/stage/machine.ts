import type { Exhibit } from '../exhibit'
import { type Chain, chainOf, type Places, placesOf } from '../motion'
import { type MountChoice, shakeOf } from '../mounts'
import { type TwistChoice, twistOf } from '../torsion'
import { Mounting, Shaking } from './mounts'
import { Room } from './room'
import { type Slice, slicesOf } from './section'
import type { View } from './stage'
import { type Crank, crankOf, Twisting } from './twist'
import { Whirling } from './whirl'

/** An engine ready to be moved, and what twists its crank or moves its block as was last chosen. */
export class Machine {
  readonly exhibit: Exhibit
  readonly room: Room
  readonly chain: Chain
  readonly places: Places
  readonly whirling: Whirling
  readonly slices: readonly Slice[]
  readonly crank: Crank | null
  readonly mounting: Mounting | null
  #twisting: { twisting: Twisting | null; choice: TwistChoice } | null = null
  #shaking: { shaking: Shaking | null; choice: MountChoice } | null = null

  constructor(exhibit: Exhibit) {
    this.exhibit = exhibit
    this.room = new Room(exhibit)
    this.chain = chainOf(exhibit.scene, exhibit.sense)
    this.places = placesOf(this.chain)
    this.whirling = new Whirling(exhibit)
    this.slices = slicesOf(exhibit.scene)
    this.crank = crankOf(exhibit)
    this.mounting = exhibit.mounts && new Mounting(exhibit, exhibit.mounts)
  }

  /** What twists the crank, made where the choice has changed. */
  twisting(choice: TwistChoice): Twisting | null {
    const { crank, exhibit } = this
    if (!crank || choice.show === 'still') return null
    if (this.#twisting?.choice !== choice) {
      const twist = twistOf(exhibit, choice)
      this.#twisting = { twisting: twist && new Twisting(exhibit, crank, twist), choice }
    }
    return this.#twisting.twisting
  }

  /** What moves the block on its mounts, made where the choice has changed. */
  shaking(choice: MountChoice): Shaking | null {
    if (!this.mounting || choice.show === 'still') return null
    if (this.#shaking?.choice !== choice) {
      const shake = shakeOf(this.exhibit, choice)
      this.#shaking = { shaking: shake && new Shaking(this.exhibit, shake), choice }
    }
    return this.#shaking.shaking
  }

  /** What carries the block, free or on its mounts. */
  carrier({ mounts }: View): Whirling {
    return this.shaking(mounts) ?? this.whirling
  }

  /** How much more than it is the motion of the block is shown; nought where it stands still. */
  magnification({ mounts, whirl }: View): number {
    return this.shaking(mounts)?.shake.times ?? whirl.magnification
  }
}
