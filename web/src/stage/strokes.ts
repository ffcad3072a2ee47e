import type { Exhibit, StrokeColours } from '../exhibit'
import { channels, TINTS } from './palette'

/** What the chamber of a cylinder does over the cycle; angles in degrees of theta. */
interface Window {
  readonly from: number
  readonly length: number
  readonly hue: readonly [number, number, number]
  readonly begin: number
  readonly end: number
}

/** Windows by cylinder; of two that overlap, power and compression come first. */
export function windowsOf(exhibit: Exhibit, colours: StrokeColours): Window[][] {
  const rank = ['power', 'compression', 'exhaust', 'intake']
  const sorted = [...exhibit.stroke_windows].sort(
    (a, b) => rank.indexOf(a.stroke) - rank.indexOf(b.stroke),
  )
  return exhibit.scene.cylinders.map((cylinder) =>
    sorted
      .filter((window) => window.chamber === cylinder.chamber)
      .map(({ stroke, from_deg, to_deg }) => {
        const colour = Number.parseInt(colours[stroke].slice(1), 16)
        const { begin, end } = TINTS[stroke]
        return { from: from_deg, length: to_deg - from_deg, hue: channels(colour), begin, end }
      }),
  )
}

/** Writes red, green, blue and opacity of a cylinder's tint at `degrees` into `out`. */
export function tint(
  windows: readonly Window[],
  degrees: number,
  cycle: number,
  out: Float32Array,
  at: number,
): void {
  out[at + 3] = 0
  for (const { from, length, hue, begin, end } of windows) {
    const since = (((degrees - from) % cycle) + cycle) % cycle
    if (since >= length) continue
    const share = since / length
    // Combustion dies away; intake and compression grow evenly.
    const left = begin > end ? Math.exp(-3.2 * share) : 1 - share
    out[at] = hue[0]
    out[at + 1] = hue[1]
    out[at + 2] = hue[2]
    out[at + 3] = end + (begin - end) * left
    return
  }
}
