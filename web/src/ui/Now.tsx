import { Fragment } from 'preact'
import { useMemo, useRef } from 'preact/hooks'
import type { Exhibit } from '../exhibit'
import { t } from '../language/messages'
import {
  type Coefficients,
  coefficientsOf,
  type Plane,
  phaseOf,
  signalAt,
  signalOf,
  turn,
  vectorAt,
} from '../phasor'
import { useApp, useFollower } from './context'
import { quantityName, TERMS } from './names'
import { Term } from './Term'

/** Force, couple and rolling moment at the present crank angle, of the chosen orders. */
export function Now() {
  const { shown } = useApp()
  return (
    <section class="now" aria-label={t('At this crank angle')}>
      {shown.value.map((exhibit, index) => (
        <Numbers key={index} exhibit={exhibit} named={shown.value.length > 1} />
      ))}
    </section>
  )
}

function Numbers({ exhibit, named }: { exhibit: Exhibit; named: boolean }) {
  const { store } = useApp()
  const cells = useRef<HTMLDListElement>(null)
  const orders = store.orders.value
  const now = useMemo(() => numbersOf(exhibit), [exhibit])
  useFollower(
    (theta) => {
      const fields = cells.current?.querySelectorAll('output')
      if (!fields) return
      now(theta, orders).forEach((text, index) => {
        const field = fields[index]
        if (field && field.textContent !== text) field.textContent = text
      })
    },
    [now, orders],
  )
  const lines = [
    ['force', ['↑', t('Vertical force, upward')], ['→', t('Horizontal force, to the right')]],
    [
      'couple',
      ['↑', t('Pitching couple, in the vertical plane')],
      ['→', t('Yawing couple, in the horizontal plane')],
    ],
    ['roll', ['', quantityName('roll')]],
  ] as const
  return (
    <div class="numbers">
      {named && <h2 class="whose">{exhibit.name}</h2>}
      <dl ref={cells}>
        {lines.map(([quantity, ...components]) => (
          <div key={quantity}>
            <dt>
              <Term word={TERMS[quantity]}>{quantityName(quantity)}</Term>
            </dt>
            <dd>
              {components.map(([sign, title]) => (
                <Fragment key={sign}>
                  {sign && (
                    <span class="way" title={title}>
                      {sign}
                    </span>
                  )}
                  <output aria-live="off" aria-label={title} />{' '}
                </Fragment>
              ))}
              <span class="unit">{exhibit.units[quantity]}</span>
              {exhibit.ends.length > 0 && (
                <output class="range" aria-live="off" aria-label={t('Range, estimated')} />
              )}
            </dd>
          </div>
        ))}
      </dl>
    </div>
  )
}

type Texts = (theta: number, orders: readonly number[] | null) => readonly string[]

/** The numbers of an engine as texts: of force and couple up and right, of the rolling moment one; after each quantity of an estimated engine the range. */
function numbersOf({ orders, sense, total, ends, units }: Exhibit): Texts {
  const phase = phaseOf(orders.length, sense)
  const factors = [units.force_factor, units.couple_factor, units.roll_factor]
  const sums = [total, ...ends].map(({ force, couple, roll }) => [
    coefficientsOf(force),
    coefficientsOf(couple),
    signalOf(roll),
  ])
  const [own = []] = sums
  const digits = own.map((numbers, kind) => decimals(bound(numbers) * (factors[kind] ?? 1)))
  const ofRanges = own.map((_, kind) =>
    decimals(
      Math.max(...sums.map((sum) => bound(sum[kind] as Coefficients))) * (factors[kind] ?? 1),
    ),
  )
  const place: Plane = [0, 0]
  const at = (numbers: Coefficients, kind: number): readonly number[] =>
    (kind < 2 ? [...vectorAt(numbers, phase, place)] : [signalAt(numbers, phase)]).map(
      (value) => value * (factors[kind] ?? 1),
    )
  return (theta, chosen) => {
    turn(phase, orders, theta, chosen)
    return own.flatMap((numbers, kind) => {
      const values = at(numbers, kind)
      const texts = values.map((value) => signed(value, digits[kind] ?? 0))
      if (!ends.length) return texts
      // at an angle a sum is linear in each estimated value: its range ends at corners
      const all = sums.map((sum) => at(sum[kind] as Coefficients, kind))
      const ranges = values.map((_, index) =>
        rangeText(
          all.map((each) => each[index] ?? 0),
          ofRanges[kind] ?? 0,
        ),
      )
      return [...texts, ranges.filter(Boolean).join(', ')]
    })
  }
}

/** The least and the greatest of values, as `(9 to 16)`. */
export function rangeText(values: readonly number[], digits: number): string {
  if (Math.min(...values) === Math.max(...values)) return ''
  const [low, high] = [Math.min(...values), Math.max(...values)].map((value) =>
    signed(value, digits).trim(),
  ) as [string, string]
  return t('({low} to {high})', { low, high })
}

/** Nothing with these coefficients becomes greater than this. */
function bound(coefficients: Coefficients): number {
  let sum = 0
  for (let index = 0; index + 1 < coefficients.length; index += 2)
    sum += Math.hypot(coefficients[index] as number, coefficients[index + 1] as number)
  return sum
}

/** Decimals that give the greatest value four figures, the same at every angle. */
function decimals(greatest: number): number {
  if (!(greatest > 1e-12)) return 0
  return Math.min(6, Math.max(0, 3 - Math.floor(Math.log10(greatest))))
}

function signed(value: number, digits: number): string {
  const text = Math.abs(value).toFixed(digits)
  const zero = Number(text) === 0
  return `${zero ? '\u2007' : value < 0 ? '−' : '+'}${text}`
}
