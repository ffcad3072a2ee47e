import type { App } from '../app'
import type { Exhibit, Vectors } from '../exhibit'
import { roundFactor } from '../magnification'
import { Whirling } from '../stage/whirl'

/** Share of the engine's size that the default magnification gives the greatest movement. */
const SHARE = 0.05

/** A magnification: 1, 2 or 5 times a power of ten; 0 where nothing moves. */
export function suggestedMagnification(exhibit: Exhibit): number {
  const { low, high } = exhibit.scene
  const size = Math.hypot(high[0] - low[0], high[1] - low[1], high[2] - low[2])
  const reach = Math.max(
    Math.abs(high[2] - exhibit.whirl.centre[2]),
    Math.abs(exhibit.whirl.centre[2] - low[2]),
  )
  const { centre, shift, tilt, turn } = exhibit.whirl
  const most = greatest(shift) + reach * greatest(tilt) + rim(exhibit, centre) * total(turn)
  if (!(most > 1e-9 * size)) return 0
  return roundFactor((SHARE * size) / most)
}

/** How far from the centre of mass the farthest corner of the engine is, seen from the front. */
function rim(
  { scene: { low, high } }: Exhibit,
  [up, right]: readonly [number, number, number],
): number {
  return Math.hypot(Math.max(high[0] - up, up - low[0]), Math.max(high[1] - right, right - low[1]))
}

function total(signals: readonly (readonly [number, number])[]): number {
  return signals.reduce((sum, [real, imaginary]) => sum + Math.hypot(real, imaginary), 0)
}

/** At most so far does a sum of turning vectors reach. */
function greatest({ forward, backward }: Vectors): number {
  return [...forward, ...backward].reduce((sum, [up, right]) => sum + Math.hypot(up, right), 0)
}

/** Whirl on, as it is seen well, or off. */
export function toggledWhirl({ store, shown }: App): void {
  const on = !(store.whirl.peek() > 0)
  store.whirl.value = on ? usualMagnification(shown.peek()) || 1 : 0
  const { 'mounts.show': moving, ...rest } = store.choices.peek()
  if (on && moving) store.choices.value = rest
}

/** The magnification at which the one of these engines that moves most is seen well; 0 at rest. */
export function usualMagnification(exhibits: readonly Exhibit[]): number {
  const moving = exhibits.map(suggestedMagnification).filter((factor) => factor > 0)
  return moving.length ? Math.min(...moving) : 0
}

/** How far the crank axis gets from its rest at front and rear, of some orders or (null) of all. */
export function reachOf(exhibit: Exhibit, orders: readonly number[] | null): readonly number[] {
  const whirling = new Whirling(exhibit)
  return whirling.ends.map((z) =>
    Math.max(...whirling.path(z, orders).map(([up, right]) => Math.hypot(up, right))),
  )
}

/** How far the block rolls to either side, radians, of some orders or (null) of all. */
export function rollOf(exhibit: Exhibit, orders: readonly number[] | null): number {
  const whirling = new Whirling(exhibit)
  const steps = 180 * Math.max(1, exhibit.turns)
  const rolls = Array.from({ length: steps }, (_, step) =>
    Math.abs(whirling.at((step / 90) * Math.PI, orders).turn),
  )
  return Math.max(...rolls)
}
