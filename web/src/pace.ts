import { t } from './language/messages'

/** How fast the page turns an engine: turns of the crankshaft in a second of the viewer's time. */
export const SLOWEST = 0.05
export const FASTEST = 5
/** Slow enough to follow a piston with the eye. */
export const USUAL = 0.4

const RANGE = Math.log(FASTEST / SLOWEST)

/** A slider from 0 to 1 as turns per second; equal steps are equal ratios. */
export function paceAt(place: number): number {
  return Number((SLOWEST * Math.exp(Math.min(1, Math.max(0, place)) * RANGE)).toPrecision(3))
}

/** Where the slider stands for so many turns per second. */
export function placeOf(pace: number): number {
  return Math.log(Math.min(FASTEST, Math.max(SLOWEST, pace)) / SLOWEST) / RANGE
}

/** A factor with two figures: 80, 1200, 2.5. */
function factorText(factor: number): string {
  const rounded = Number(factor.toPrecision(2))
  return rounded.toLocaleString('en', { maximumFractionDigits: 2, useGrouping: false })
}

/** The pace of the page beside the speed of the engine: "80 times slower than 6000 rpm". */
export function paceText(pace: number, speedRpm: number | null): string {
  if (speedRpm === null || speedRpm <= 0) return t('the file gives no speed')
  const ratio = speedRpm / (60 * pace)
  const speed = Number(speedRpm.toPrecision(6))
  if (Math.abs(ratio - 1) < 0.05) return t('as fast as the engine at {speed} rpm', { speed })
  return ratio > 1
    ? t('{factor} times slower than {speed} rpm', { factor: factorText(ratio), speed })
    : t('{factor} times faster than {speed} rpm', { factor: factorText(1 / ratio), speed })
}
