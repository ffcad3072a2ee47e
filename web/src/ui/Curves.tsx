import { useMemo, useRef } from 'preact/hooks'
import { type Coefficients, phaseOf, signalAt, turn } from '../phasor'
import { curvesOf } from '../torque'
import { useFollower } from './context'
import { decimalsOf, signedText } from './figures'

/** A signal over a working cycle: how it is drawn, what it is called, its value. */
export interface Series {
  readonly key: string
  readonly label: string
  readonly wave: Coefficients
  readonly mean: number
  /** Drawn faintly, without a line in the legend. */
  readonly faint?: boolean
}

/** The least and the greatest value of curves, nought among them. */
export function extentOf(curves: readonly Float64Array[]): readonly [number, number] {
  let [low, high] = [0, 0]
  for (const curve of curves)
    for (const value of curve) {
      low = Math.min(low, value)
      high = Math.max(high, value)
    }
  return [low, high]
}

/** Width and height of a drawing in its own units; both are stretched to their room. */
export const [WIDE, HIGH] = [1000, 1000]

/** A curve as a path; `low` is at the lower edge of the drawing, `high` at the upper one. */
export function pathOf(curve: Float64Array, low: number, high: number): string {
  const span = high - low || 1
  const points = Array.from(curve, (value, index) => {
    const x = ((WIDE * index) / (curve.length - 1)).toFixed(1)
    const y = (HIGH * (1 - (value - low) / span)).toFixed(1)
    return `${x} ${y}`
  })
  return `M${points.join('L')}`
}

const FEWEST = 3

/** Round values between two, about `count` of them, and three at least. */
export function ticksOf(low: number, high: number, count: number): number[] {
  const rough = (high - low) / count
  if (!(rough > 0)) return [0]
  const power = 10 ** Math.floor(Math.log10(rough))
  const steps = [10, 5, 2, 1, 0.5].map((each) => each * power)
  const least = steps.findLastIndex((step) => step >= rough)
  const [wide, finer] = [least, least + 1].map((index) =>
    multiples(low, high, steps[index] ?? rough),
  )
  return (wide as number[]).length < FEWEST ? (finer as number[]) : (wide as number[])
}

/** The multiples of a step from one value to another. */
function multiples(low: number, high: number, step: number): number[] {
  const first = Math.ceil(low / step - 1e-9)
  const last = Math.floor(high / step + 1e-9)
  return Array.from({ length: last - first + 1 }, (_, index) => (first + index) * step)
}

/** A tick as text: without the last digits of its sum. */
export const tickText = (value: number): string =>
  String(Number(value.toPrecision(6))).replace('-', '−')

interface Props {
  readonly label: string
  readonly unit: string
  readonly factor: number
  readonly turns: number
  readonly orders: readonly number[]
  readonly series: readonly Series[]
  /** Least and greatest value that are to be seen, as sent; those of the series without. */
  readonly extent?: readonly [number, number]
}

/** Curves over a working cycle with a line at the present crank angle, and their values there. */
export function Curves({ label, unit, factor, turns, orders, series, extent }: Props) {
  const line = useRef<SVGLineElement>(null)
  const legend = useRef<HTMLUListElement>(null)
  const drawn = useMemo(() => curvesOf(series, orders, turns), [series, orders, turns])
  const [low, high] = extent ?? extentOf(drawn)
  const room = 0.04 * (high - low || 1)
  const [bottom, top] = [low - room, high + room]
  const paths = useMemo(
    () => drawn.map((curve) => pathOf(curve, bottom, top)),
    [drawn, bottom, top],
  )
  const phase = useMemo(() => phaseOf(orders.length, 1), [orders])
  const named = series.filter(({ faint }) => !faint)
  const digits = decimalsOf(factor * Math.max(Math.abs(low), Math.abs(high)))
  useFollower(
    (theta) => {
      const x = String((WIDE * ((theta / (2 * Math.PI)) % turns)) / turns)
      line.current?.setAttribute('x1', x)
      line.current?.setAttribute('x2', x)
      turn(phase, orders, theta, null)
      legend.current?.querySelectorAll('output').forEach((output, index) => {
        const own = named[index]
        if (!own) return
        const text = signedText(factor * (own.mean + signalAt(own.wave, phase)), digits)
        if (output.textContent !== text) output.textContent = text
      })
    },
    [series, orders, turns, factor, digits],
  )
  const up = ticksOf(bottom * factor, top * factor, 4)
  const height = (value: number) => 100 * (1 - (value / factor - bottom) / (top - bottom))
  return (
    <figure class="cycle-curves">
      <figcaption>
        {label} <span class="soft">{unit}</span>
      </figcaption>
      <div class="cycle-plot">
        <div class="plot-up" aria-hidden="true">
          {up.map((value) => (
            <span key={value} style={{ top: `${height(value)}%` }}>
              {tickText(value)}
            </span>
          ))}
        </div>
        <svg
          viewBox={`0 0 ${WIDE} ${HIGH}`}
          preserveAspectRatio="none"
          role="img"
          aria-label={`${label}: ${named.map((each) => each.label).join(', ')}`}
        >
          {up.map((value) => (
            <path
              key={value}
              class={value === 0 ? 'plot-axis' : 'plot-grid'}
              d={`M0 ${(height(value) * HIGH) / 100}H${WIDE}`}
            />
          ))}
          {quartersOf(turns).map((angle) => (
            <path
              key={angle}
              class="plot-grid"
              d={`M${(angle / (360 * turns)) * WIDE} 0V${HIGH}`}
            />
          ))}
          {series.map(({ key, faint }, index) => (
            <path
              key={key}
              class={`plot-curve ${faint ? 'plot-faint' : `of-${key}`}`}
              data-series={key}
              d={paths[index] ?? ''}
            />
          ))}
          <line ref={line} class="plot-cursor" y1="0" y2={HIGH} />
        </svg>
        <Angles turns={turns} />
      </div>
      <ul class="legend" ref={legend}>
        {named.map(({ key, label: name }) => (
          <li key={key}>
            <i class={`swatch of-${key}`} aria-hidden="true" /> {name}{' '}
            <output aria-live="off" aria-label={name} />
          </li>
        ))}
      </ul>
    </figure>
  )
}

/** The angles that are written below, degrees: every half turn, of many turns every one. */
function quartersOf(turns: number): number[] {
  const step = turns > 2 ? 360 : 180
  return Array.from({ length: (360 * turns) / step + 1 }, (_, index) => step * index)
}

/** Crank angles below a drawing. */
export function Angles({ turns }: { turns: number }) {
  return (
    <div class="plot-along" aria-hidden="true">
      {quartersOf(turns).map((angle) => (
        <span key={angle} style={{ left: `${(100 * angle) / (360 * turns)}%` }}>
          {angle}°
        </span>
      ))}
    </div>
  )
}
