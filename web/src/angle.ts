import { t } from './language/messages'

/** An angle that was typed: in degrees, or a sentence that shows how to type one. */
export type Typed =
  | { readonly ok: true; readonly degrees: number }
  | { readonly ok: false; readonly sentence: string }

const ANGLE = /^([+\-−]?(?:\d+(?:[.,]\d*)?|[.,]\d+)(?:e[+-]?\d+)?)\s*([\p{L}°]*)\.?$/iu
const DEGREES: Readonly<Record<string, number>> = {
  '': 1,
  '°': 1,
  d: 1,
  deg: 1,
  degs: 1,
  degree: 1,
  degrees: 1,
  rad: 180 / Math.PI,
  radian: 180 / Math.PI,
  radians: 180 / Math.PI,
  turn: 360,
  turns: 360,
  rev: 360,
  revs: 360,
  revolution: 360,
  度: 1,
  град: 1,
  градус: 1,
  градуса: 1,
  градусов: 1,
  ラジアン: 180 / Math.PI,
  弧度: 180 / Math.PI,
  рад: 180 / Math.PI,
  радиан: 180 / Math.PI,
  радиана: 180 / Math.PI,
  радианов: 180 / Math.PI,
  回転: 360,
  об: 360,
  оборот: 360,
  оборота: 360,
  оборотов: 360,
}
/** The largest angle in degrees; a float still resolves a millionth of a degree there. */
const LARGEST = 1e7

/** How many degrees one of a unit of angles is; undefined for what is none. */
export function degreesOf(unit: string): number | undefined {
  const key = unit.toLowerCase().replace(/\.$/, '')
  return Object.hasOwn(DEGREES, key) ? DEGREES[key] : undefined
}

/** Text with the full-width letters and digits of East Asia as a keyboard of the West has them. */
export function halfWidth(text: string): string {
  return text
    .replace(/[\uff01-\uff5e]/g, (letter) => String.fromCharCode(letter.charCodeAt(0) - 0xfee0))
    .replaceAll('\u3000', ' ')
}

/** Reads `450`, `-30`, `90 deg`, `1.5 rad`, `2 turns`; a comma may stand for the decimal point. `90度`, `120 град` too. */
export function typedAngle(text: string): Typed {
  const parts = ANGLE.exec(halfWidth(text).trim())
  const unit = degreesOf(parts?.[2] ?? '')
  const typed = text.trim().slice(0, 40)
  if (!parts?.[1] || typeof unit !== 'number')
    return {
      ok: false,
      sentence: t(
        '“{typed}” is not an angle. Type degrees, as in 450 or -30, or a number with its unit: 90 deg, 1.5 rad, 2 turns.',
        { typed },
      ),
    }
  const degrees = Number(parts[1].replace(',', '.').replace('−', '-')) * unit
  if (!(Math.abs(degrees) <= LARGEST))
    return {
      ok: false,
      sentence: t('“{typed}” is too large; the largest angle is {largest} degrees.', {
        typed,
        largest: LARGEST,
      }),
    }
  return { ok: true, degrees }
}

/** An angle within a cycle of `turns` turns: 0 up to, but not, 360 `turns`. */
export function withinCycle(degrees: number, turns: number): number {
  const cycle = 360 * turns
  const rest = ((degrees % cycle) + cycle) % cycle
  return rest === cycle ? 0 : rest
}

/** Degrees as text without noise: 450, 22.5, 0.125. */
export function degreesText(degrees: number): string {
  const text = degrees.toFixed(3)
  return text.replace(/\.?0+$/, '').replace(/^-0$/, '0')
}

/** The least number of turns that is a whole number of cycles of both. */
export function commonTurns(one: number, other: number): number {
  let [a, b] = [Math.max(1, Math.round(one)), Math.max(1, Math.round(other))]
  const product = a * b
  while (b) [a, b] = [b, a % b]
  return product / a
}
