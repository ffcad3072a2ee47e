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
import { alike } from './BothOrders'
import { useApp, useFollower } from './context'
import { decimalsOf, signedText } from './figures'
import { Icon } from './icons'
import { quantityName, TERMS } from './names'
import { Term } from './Term'

/** Force, couple and rolling moment at the present crank angle, of the chosen orders. */
export function Now() {
  const { shown, staged } = useApp()
  const [one, other] = staged.value
  return (
    <section class="now" aria-label={t('At this crank angle')}>
      {staged.value.map((exhibit, index) => (
        <Numbers
          key={index}
          exhibit={exhibit}
          name={other ? exhibit.name : ''}
          gas={exhibit.orders !== shown.value[index]?.orders}
        />
      ))}
      {one && other && alike(one, other) && (
        <Numbers exhibit={other} from={one} name={t('Difference, second − first')} />
      )}
    </section>
  )
}

interface Props {
  readonly exhibit: Exhibit
  /** Whose numbers are taken from those of the exhibit. */
  readonly from?: Exhibit
  readonly name: string
  /** Whether its rolling moment has the gas in it. */
  readonly gas?: boolean
}

function Numbers({ exhibit, from, name, gas }: Props) {
  const { store } = useApp()
  const cells = useRef<HTMLDListElement>(null)
  const orders = store.orders.value
  const now = useMemo(
    () => (from ? differencesOf(from, exhibit) : numbersOf(exhibit)),
    [exhibit, from],
  )
  const ranges = !from && exhibit.ends.length > 0
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
      {name && <h2 class="whose">{name}</h2>}
      <dl ref={cells}>
        {lines.map(([quantity, ...components]) => (
          <div key={quantity}>
            <dt>
              {!from && store[quantity].value && (
                // the arrow on the stage that has this colour
                <span class={`mark ${quantity}`}>
                  <Icon name={quantity} />
                </span>
              )}
              <Term word={TERMS[quantity]}>{quantityName(quantity)}</Term>
              {quantity === 'roll' && <> {gasText(exhibit, gas)}</>}
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
              {ranges && (
                <output class="range" aria-live="off" aria-label={t('Range, estimated')} />
              )}
            </dd>
          </div>
        ))}
      </dl>
    </div>
  )
}

/** Whether gas is in a rolling moment, where the file says what the gas does. */
function gasText({ torque, speed_rpm: rpm }: Exhibit, gas = false): string {
  if (gas) return t('(with gas)')
  if (!torque || torque.loads.every(({ assumed }) => assumed)) return ''
  if (!rpm) return t('(without gas)')
  return t('(without gas, {rpm} rpm)', { rpm: Number(rpm.toPrecision(6)) })
}

/** By how much the numbers of the second engine are greater, in its units. */
function differencesOf(one: Exhibit, other: Exhibit): Texts {
  const [first, second] = [valuesOf(one), valuesOf(other)]
  const factors = factorsOf(other)
  const digits = first.bounds.map((most, kind) =>
    decimalsOf((most + (second.bounds[kind] ?? 0)) * (factors[kind] ?? 1)),
  )
  return (theta, chosen) => {
    const [before, after] = [first.at(theta, chosen), second.at(theta, chosen)]
    return after.map((value, index) => {
      const kind = KINDS[index] ?? 0
      const change = (value - (before[index] ?? 0)) * (factors[kind] ?? 1)
      return signedText(change, digits[kind] ?? 0)
    })
  }
}

/** The quantity of each number: force up and right, couple up and right, rolling moment. */
const KINDS = [0, 0, 1, 1, 2]

const factorsOf = ({ units }: Exhibit): readonly number[] => [
  units.force_factor,
  units.couple_factor,
  units.roll_factor,
]

/** The numbers of an engine as they are sent, and what those of each quantity never exceed. */
function valuesOf({ orders, sense, total }: Exhibit) {
  const phase = phaseOf(orders.length, sense)
  const sums = [
    coefficientsOf(total.force),
    coefficientsOf(total.couple),
    signalOf(total.roll),
  ] as const
  const place: Plane = [0, 0]
  const out = [0, 0, 0, 0, 0]
  return {
    bounds: sums.map(bound),
    at(theta: number, chosen: readonly number[] | null): readonly number[] {
      turn(phase, orders, theta, chosen)
      ;[out[0], out[1]] = vectorAt(sums[0], phase, place)
      ;[out[2], out[3]] = vectorAt(sums[1], phase, place)
      out[4] = signalAt(sums[2], phase)
      return out
    },
  }
}

type Texts = (theta: number, orders: readonly number[] | null) => readonly string[]

/** The numbers of an engine as texts: of force and couple up and right, of the rolling moment one; after each quantity of an estimated engine the range. */
function numbersOf(exhibit: Exhibit): Texts {
  const { orders, sense, total, ends } = exhibit
  const phase = phaseOf(orders.length, sense)
  const factors = factorsOf(exhibit)
  const sums = [total, ...ends].map(({ force, couple, roll }) => [
    coefficientsOf(force),
    coefficientsOf(couple),
    signalOf(roll),
  ])
  const [own = []] = sums
  const digits = own.map((numbers, kind) => decimalsOf(bound(numbers) * (factors[kind] ?? 1)))
  const ofRanges = own.map((_, kind) =>
    decimalsOf(
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
      const texts = values.map((value) => signedText(value, digits[kind] ?? 0))
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
    signedText(value, digits).trim(),
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
