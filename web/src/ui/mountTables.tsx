import type { Exhibit, MountNumbers, Mounts, MountVibration, Table, Unit } from '../exhibit'
import { t } from '../language/messages'
import { type Answer, rateOf, rmsOf } from '../mountResponse'
import { groundWaves, PER_RPM, pointWaves } from '../mounts'
import type { Coefficients } from '../phasor'
import { curvesOf } from '../torque'
import { sizeText } from './Bars'
import { DataTable } from './DataTable'

interface Props {
  readonly exhibit: Exhibit
  readonly own: Mounts
  readonly numbers: MountNumbers
  /** The speed that is shown. */
  readonly shown: MountVibration
  readonly answer: Answer
}

/** Share of the greatest of a column below which a number is rounding. */
const ROUNDING = 1e-9
/** Share of the greatest motion from which an order has its row. */
const NOTED = 1e-3

interface Column {
  readonly head: string
  readonly unit?: Unit
  readonly values: readonly (number | null)[]
}

/** A table of numbers; what is only rounding beside the greatest of its column is nought. */
function tableOf(title: string, first: string, names: readonly string[], columns: Column[]): Table {
  const texts = columns.map(({ unit, values }) => {
    const least = ROUNDING * Math.max(...values.map((value) => Math.abs(value ?? 0)))
    return values.map((value) => {
      if (value === null) return ''
      return sizeText(Math.abs(value) <= least ? 0 : value * (unit?.factor ?? 1))
    })
  })
  return {
    title,
    heads: [first, ...columns.map(({ head, unit }) => (unit ? `${head} [${unit.label}]` : head))],
    rows: names.map((name, row) => [name, ...texts.map((each) => each[row] ?? '')]),
    numeric: [false, ...columns.map(() => true)],
    notes: [],
  }
}

const rpmOf = ({ speed_rpm }: MountVibration): number => Number(speed_rpm.toFixed(1))

/** How each point shakes at the speed. */
export function PointTable({ own, numbers, shown, answer }: Props) {
  const { orders, points } = own
  const speed = shown.speed_rpm * PER_RPM
  const rates = (waves: readonly Coefficients[]) => waves.map((wave) => rateOf(wave, orders, speed))
  const displacement = points.map((point) => pointWaves(own, answer.motion, point))
  const velocity = displacement.map(rates)
  const table = tableOf(
    t('Points at {rpm} rpm', { rpm: rpmOf(shown) }),
    t('point'),
    points.map(({ name }) => name),
    [
      {
        head: t('displacement, rms'),
        unit: numbers.displacement_unit,
        values: displacement.map(rmsOf),
      },
      { head: t('velocity, rms'), unit: numbers.velocity_unit, values: velocity.map(rmsOf) },
      {
        head: t('acceleration, rms'),
        unit: numbers.acceleration_unit,
        values: velocity.map(rates).map(rmsOf),
      },
    ],
  )
  return <DataTable table={table} />
}

/** The force in each mount of the block at the speed. */
export function ForceTable({ exhibit, own, numbers, shown, answer }: Props) {
  const based = own.centres.length > 1
  const upper = own.mounts.flatMap(({ below }, place) => (below && based ? [] : [place]))
  const forces = upper.map((place) => answer.forces[place] ?? [])
  const table = tableOf(
    t('Force in the mounts at {rpm} rpm', { rpm: rpmOf(shown) }),
    t('mount'),
    upper.map((place) => own.mounts[place]?.name ?? ''),
    [
      { head: t('rms'), unit: numbers.force_unit, values: forces.map(rmsOf) },
      {
        head: t('peak'),
        unit: numbers.force_unit,
        values: forces.map((force) => peakOf(force, own.orders, exhibit.turns)),
      },
      { head: t('transmissibility'), values: upper.map((place) => answer.through[place] ?? null) },
      {
        head: t('heat'),
        unit: numbers.heat_unit,
        values: upper.map((place) => answer.heat[place] ?? 0),
      },
    ],
  )
  return <DataTable table={table} />
}

/** The greatest length of a vector over a cycle. */
function peakOf(waves: readonly Coefficients[], orders: readonly number[], turns: number): number {
  const [up = new Float64Array(), right, along] = curvesOf(
    waves.map((wave) => ({ wave, mean: 0 })),
    orders,
    turns,
  )
  return up.reduce(
    (most, each, step) => Math.max(most, Math.hypot(each, right?.[step] ?? 0, along?.[step] ?? 0)),
    0,
  )
}

/** Amplitudes of a point, and the force on the foundation, order by order. */
export function orderTable(
  { own, numbers, shown, answer }: Omit<Props, 'exhibit'>,
  point: Mounts['points'][0],
): Table {
  const motion = pointWaves(own, answer.motion, point)
  const ground = groundWaves(own, answer.forces)
  const sizes = (wave: Coefficients) =>
    own.orders.map((_, place) => Math.hypot(wave[2 * place] ?? 0, wave[2 * place + 1] ?? 0))
  const [up = [], right = [], along = []] = motion.map(sizes)
  const total = own.orders.map((_, place) =>
    Math.sqrt(ground.reduce((sum, wave) => sum + (sizes(wave)[place] ?? 0) ** 2, 0) / 2),
  )
  const most = Math.max(...up, ...right, ...along)
  const noted = own.orders.flatMap((_, place) =>
    Math.max(up[place] ?? 0, right[place] ?? 0, along[place] ?? 0) > NOTED * most ? [place] : [],
  )
  const of = (values: readonly number[]) => noted.map((place) => values[place] ?? 0)
  const unit = numbers.displacement_unit
  return tableOf(
    t('Amplitudes of the point by order at {rpm} rpm', { rpm: rpmOf(shown) }),
    t('order'),
    noted.map((place) => String(own.orders[place])),
    [
      { head: t('up'), unit, values: of(up) },
      { head: t('right'), unit, values: of(right) },
      { head: t('along'), unit, values: of(along) },
      { head: t('force on the foundation, rms'), unit: numbers.force_unit, values: of(total) },
    ],
  )
}
