import type { Slider, SliderCurve } from '../exhibit'

export const [WIDE, HIGH] = [200, 40]
const TOP = 3

/** The points of a curve in a box WIDE by HIGH, `most` at the top. */
export function pointsOf(slider: Slider, curve: SliderCurve, most: number): string {
  const [low, high] = [slider.values[0] ?? 0, slider.values.at(-1) ?? 1]
  return slider.values
    .map((value, place) => {
      const x = ((value - low) / (high - low)) * WIDE
      const y = HIGH - ((curve.results[place] ?? 0) / (most || 1)) * (HIGH - TOP)
      return `${round(x)},${round(y)}`
    })
    .join(' ')
}

const round = (number: number): number => Math.round(number * 10) / 10

/** The greatest value of each quantity, so that two forces are drawn to one scale. */
export function greatestOf(curves: readonly SliderCurve[]): Map<string, number> {
  const most = new Map<string, number>()
  for (const { what, results } of curves) most.set(what, Math.max(most.get(what) ?? 0, ...results))
  return most
}

/** What an engine leaves over the range of a slider, with the value where it is. */
export function Curves({ slider, share }: { slider: Slider; share: number }) {
  const most = greatestOf(slider.curves)
  return (
    <svg
      class="curves"
      viewBox={`0 0 ${WIDE} ${HIGH}`}
      preserveAspectRatio="none"
      aria-hidden="true"
      focusable="false"
    >
      {slider.curves.map((curve, place) => (
        <polyline
          key={`${curve.what} ${curve.order}`}
          class={`curve-${place}`}
          points={pointsOf(slider, curve, most.get(curve.what) ?? 1)}
        />
      ))}
      <line class="now" x1={share * WIDE} x2={share * WIDE} y1="0" y2={HIGH} />
    </svg>
  )
}
