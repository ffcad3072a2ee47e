import { t } from '../language/messages'
import { noted, sizeAt, type Torques } from '../torque'
import { Bars, sizeText } from './Bars'
import { DataTable } from './DataTable'
import { Term } from './Term'

/** Amplitudes by order as bars to one scale, and as numbers. */
export function TorqueByOrder({ torques }: { torques: Torques }) {
  const { orders, gas, inertia, together, roll, factor, unit } = torques
  const places = noted([gas, inertia, together], orders)
  const parts = [
    ...(gas ? [{ key: 'gas', label: t('gas torque'), wave: gas }] : []),
    ...(inertia ? [{ key: 'inertia', label: t('inertia torque'), wave: inertia }] : []),
    ...(gas && inertia ? [{ key: 'both', label: t('together'), wave: together }] : []),
  ]
  const sizesOf = (wave: Torques['roll']) => places.map((place) => factor * sizeAt(wave, place))
  const series = parts.map(({ key, label, wave }) => ({ key, label, sizes: sizesOf(wave) }))
  const shownOrders = places.map((place) => orders[place] ?? 0)
  const columns = [...series, { key: 'roll', label: t('rolling moment'), sizes: sizesOf(roll) }]
  if (!parts.length) return null
  return (
    <>
      <Bars label={t('Torque by order')} {...{ unit, series, orders: shownOrders }} />
      {gas && orders.some((order) => !Number.isInteger(order)) && (
        <p>
          <Halves orders={orders} wave={gas} />{' '}
          {torques.chambers.some(({ burns }) => !burns) && (
            <Slow count={torques.chambers.length} turns={torques.turns} />
          )}
        </p>
      )}
      <details class="amplitudes">
        <summary>{t('Numbers by order')}</summary>
        <DataTable
          table={{
            title: '',
            heads: [t('order'), ...columns.map(({ label }) => `${label} [${unit}]`)],
            numeric: [true, ...columns.map(() => true)],
            rows: shownOrders.map((order, index) => [
              String(order),
              ...columns.map(({ sizes }) => sizeText(sizes[index] ?? 0)),
            ]),
          }}
        />
      </details>
    </>
  )
}

/** What a chamber without combustion brings. */
const Slow = ({ count, turns }: { count: number; turns: number }) => (
  <>
    {t(
      'A cylinder without combustion brings orders below {order}, the firings of a turn: slow ones, which are felt as shaking.',
      { order: count / turns },
    )}
  </>
)

/** Which half orders there are: the greatest of them. */
function Halves({ orders, wave }: { orders: readonly number[]; wave: Torques['roll'] }) {
  const halves = orders
    .map((order, index) => ({ order, size: sizeAt(wave, index) }))
    .filter(({ order, size }) => !Number.isInteger(order) && size > 0)
    .sort((one, other) => other.size - one.size)
  const greatest = halves[0]?.size ?? 0
  const noted = halves.filter(({ size }) => size > 0.3 * greatest).slice(0, 4)
  const list = noted
    .map(({ order }) => order)
    .sort((one, other) => one - other)
    .join(', ')
  return (
    <>
      <Term word="half order">{t('Half orders:')}</Term>{' '}
      {list ? t('the greatest are {orders}.', { orders: list }) : t('none, they cancel exactly.')}
    </>
  )
}
