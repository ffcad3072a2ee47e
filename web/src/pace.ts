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

/** A factor as one says it: 80, 1200, 2.5. */
function factorText(factor: number): string {
  const rounded = Number(factor.toPrecision(2))
  return rounded.toLocaleString('en', { maximumFractionDigits: 2, useGrouping: false })
}

/** "as at 6000 rpm, slowed 80 times": what the pace is to the speed of the engine file. */
export function paceWords(pace: number, speedRpm: number | null): string {
  if (speedRpm === null || speedRpm <= 0) return 'the engine file names no speed'
  const factor = speedRpm / (60 * pace)
  const speed = `as at ${Number(speedRpm.toPrecision(6))} rpm`
  if (Math.abs(factor - 1) < 0.05) return `${speed}, as fast as the engine`
  return factor > 1
    ? `${speed}, slowed ${factorText(factor)} times`
    : `${speed}, ${factorText(1 / factor)} times as fast`
}
