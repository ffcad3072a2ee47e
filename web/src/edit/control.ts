import type { Control, Pin } from '../exhibit'
import type { Tree } from '../host/host'
import { degrees, parsed, turn, wrapped } from './quantity'
import { at, put, read, same } from './tree'

const plain = (number: number): number => Number(number.toPrecision(12))

/** What a file holds for a number in a unit. */
const withUnit = (number: number, unit: string): unknown =>
  unit ? `${plain(number)} ${unit}` : plain(number)

/** The engine file with a control at a value. */
export function moved(tree: Tree, control: Control, value: number): Tree {
  return control.sets.reduce(
    (now, { path, factor, added }) =>
      put(now, read(path), withUnit(factor * value + added, control.unit)),
    tree,
  )
}

/** The value of a control in an engine file; that of the control where the file says nothing. */
export function valueIn(tree: Tree, control: Control): number {
  const [first, second] = control.sets.map(({ path, factor, added }) => {
    const given = at(tree, read(path))
    const number = control.unit === 'deg' ? degrees(given) : (parsed(given)?.number ?? null)
    return number === null ? null : { number, factor, added }
  })
  if (!first) return control.value
  // both banks of a V: what stands between them, wherever the middle is
  const value = second
    ? Math.abs(wrapped((first.number - second.number) / (first.factor - second.factor), 1e-9))
    : (first.number - first.added) / first.factor
  const round = control.unit === 'deg' && control.high === 360 && value < 0 ? value + 360 : value
  return plain(round)
}

/** The value, or the nearest of those that make sense, if it is no farther than a share of the range. */
export function snapped(value: number, snaps: readonly number[], reach: number): number {
  let best = value
  let least = reach
  for (const snap of snaps) {
    const away = Math.abs(snap - value)
    if (away > least) continue
    least = away
    best = snap
  }
  return best
}

/** Angles that a throw comes to rest at: fifteenths of a right angle and even shares of a turn. */
export function throwSnaps(count: number): number[] {
  const shares = [24, 5, 7, count, 2 * count].filter((parts) => parts > 1)
  const angles = shares.flatMap((parts) =>
    Array.from({ length: parts + 1 }, (_, place) => wrapped((place * 360) / parts, 1e-9)),
  )
  return [...new Set(angles), -180]
}

/** An angle, degrees from above -180 to 180, at rest within `reach` of one that makes sense. */
export function snappedAngle(angle: number, snaps: readonly number[], reach: number): number {
  return wrapped(snapped(wrapped(angle, 1e-9), snaps, reach), 1e-9)
}

/** The engine file with a throw turned; a list that follows from the firing order is written out. */
export function turnedPin(tree: Tree, pins: readonly Pin[], pin: Pin, angle: number): Tree {
  const path = read(pin.path)
  const was = at(tree, path)
  const unit = parsed(was)?.unit ?? 'deg'
  const written = (deg: number): unknown => withUnit((deg / 360) * turn(unit), unit)
  const list = path.slice(0, -1)
  const whole =
    typeof path.at(-1) === 'number' && at(tree, list) === undefined
      ? put(
          tree,
          list,
          pins.map(({ angle_deg }) => `${plain(angle_deg)} deg`),
        )
      : tree
  return put(whole, path, written(angle))
}

/** The present angle of a throw in an engine file, degrees. */
export function angleIn(tree: Tree, pin: Pin): number {
  return degrees(at(tree, read(pin.path))) ?? pin.angle_deg
}

/** The engine file without its firing order, where it has one. */
export function withoutOrder(tree: Tree): Tree {
  const { firing_order: _order, firing_angles: _angles, ...rest } = tree
  return same(rest, tree) ? tree : rest
}
