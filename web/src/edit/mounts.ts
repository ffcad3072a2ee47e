import type { Scene, Whirl } from '../exhibit'
import type { Tree } from '../host/host'
import { message, t } from '../language/messages'
import type { Place } from '../ui/layoutView'
import { parsed, rewritten } from './quantity'
import { at, type Path, put } from './tree'

/** What a metre is in the units of lengths that files have; bare numbers are metres. */
const METRE: Readonly<Record<string, number>> = {
  ...{ '': 1, m: 1, mm: 1000, cm: 100 },
  ...{ in: 1 / 0.0254, inch: 1 / 0.0254, inches: 1 / 0.0254, ft: 1 / 0.3048 },
}
const USUAL = 'mm'
export const KEYS = ['up', 'right', 'z'] as const

/** A length of a file in metres; null where it is none that is known here. */
export function metres(value: unknown): number | null {
  if (value === undefined) return 0
  const given = parsed(value)
  const metre = given && METRE[given.unit]
  return given && metre ? given.number / metre : null
}

/** A length in the unit of the value that it replaces, in whole steps, such as thousandths of a metre. */
export function lengthLike(length: number, was: unknown, step: number): unknown {
  const unit = parsed(was)?.unit ?? USUAL
  const metre = METRE[unit] ?? 1
  const number = Math.round(length / step) * step * metre
  return rewritten(Number(number.toPrecision(9)) + 0, was, USUAL)
}

/** A mount of a file, as the layout has it. */
export interface Placed {
  readonly index: number
  readonly name: string
  /** Null where a length is not known here, and cannot be dragged. */
  readonly place: Place | null
}

/** The place that a table of a file gives with these three keys; `otherwise` where it does not. */
export function placeIn(tree: Tree, path: Path, otherwise: Place = [0, 0, 0]): Place | null {
  const found = KEYS.map((key, axis) => {
    const value = at(tree, [...path, key])
    return value === undefined ? (otherwise[axis] ?? 0) : metres(value)
  })
  const [up, right, z] = found
  return up == null || right == null || z == null ? null : [up, right, z]
}

/** The mounts of a file. */
export function mountsIn(tree: Tree): Placed[] {
  const list = at(tree, ['mounts'])
  return (Array.isArray(list) ? list : []).map((_, index) => ({
    index,
    name: String(at(tree, ['mounts', index, 'name']) ?? index + 1),
    place: placeIn(tree, ['mounts', index]),
  }))
}

/** The file with something at another place; what does not change stays as it was written. */
export function placedAt(tree: Tree, path: Path, was: Place, to: Place, step: number): Tree {
  return KEYS.reduce((now, key, axis) => {
    const [before, after] = [was[axis] ?? 0, to[axis] ?? 0]
    if (Math.abs(after - before) < step / 2) return now
    const own = [...path, key]
    return put(now, own, lengthLike(after, at(tree, own), step))
  }, tree)
}

/** Hertz at which a block bounces on the mounts that are offered. */
const BOUNCE = 9
/** How stiff they are across, as a share of that upward. */
const ACROSS = 0.5
const MOUNTS = [
  [message('front left'), -1, 1],
  [message('front right'), 1, 1],
  [message('rear left'), -1, -1],
  [message('rear right'), 1, -1],
] as const

const round = (value: number, step: number): number => Math.round(value / step) * step
const millimetres = (length: number): string => `${round(1000 * length, 5) + 0} mm`

/** Four mounts about the centre of mass, as far apart as the engine, on which it bounces slowly. */
export function fourMounts(
  { low, high }: Scene,
  { centre: [up, right, z], mass }: Pick<Whirl, 'centre' | 'mass'>,
): Record<string, unknown>[] {
  const wide = Math.max(0.6 * (high[1] - low[1]), 0.6 * (high[0] - low[0]))
  const long = 0.4 * (high[2] - low[2])
  const each = (mass * (2 * Math.PI * BOUNCE) ** 2) / 4 / 1000
  const digits = 10 ** Math.floor(Math.log10(each))
  const stiff = Number((round(each / digits, 0.5) * digits).toPrecision(3))
  const across = Number((ACROSS * stiff).toPrecision(3))
  return MOUNTS.map(([name, side, end]) => ({
    name: t(name),
    up: millimetres(up),
    right: millimetres(right + side * wide),
    z: millimetres(z + end * long),
    stiffness: [`${stiff} N/mm`, `${across} N/mm`, `${across} N/mm`],
  }))
}

/** Metres beside the middle where a mount more stands, and between mounts at one place. */
const [ASIDE, APART] = [0.2, 0.1]

/** One mount more: like the last, at the other side where none stands, under a name of its own. */
export function oneMore(mounts: readonly unknown[]): Record<string, unknown> {
  const last = (mounts.at(-1) ?? { stiffness: '100 N/mm' }) as Record<string, unknown>
  const names = new Set(mounts.map((mount) => at(mount, ['name'])))
  let number = mounts.length + 1
  while (names.has(t('mount {number}', { number }))) number++
  const places = mountsIn({ mounts }).flatMap(({ place }) => (place ? [place] : []))
  const was: Place = placeIn(last, []) ?? [0, 0, 0]
  let to: Place = [was[0], -was[1] || ASIDE, was[2]]
  while (
    places.some((place) => place.every((each, axis) => Math.abs(each - (to[axis] ?? 0)) < 1e-3))
  )
    to = [to[0], to[1], to[2] + APART]
  const leaning = parsed(last.bearing)
  const leant = leaning?.number ? { bearing: rewritten(-leaning.number, last.bearing, 'deg') } : {}
  return { ...placedAt(last, [], was, to, 1e-3), ...leant, name: t('mount {number}', { number }) }
}

/** The file with the estimated mass of the block, marked as a guess. */
export function withEstimate(tree: Tree, mass: number, source: string): Tree {
  const kilograms = Number(mass.toPrecision(3))
  const heavy = put(tree, ['block', 'mass'], `${kilograms} kg`)
  return put(heavy, ['provenance', 'block.mass'], { status: 'placeholder', source })
}
