import { useMemo, useRef } from 'preact/hooks'
import type { Exhibit, Row } from '../../exhibit'
import { message, plural, t } from '../../language/messages'
import { typeset } from '../../language/typeset'
import { QUANTITIES } from '../../state'
import { BothOrders } from '../BothOrders'
import { useExhibit, useExhibits, useFollower } from '../context'
import { dotOf, moveDots, sharesOf } from '../dots'
import { Lettered } from '../Lettered'
import { quantityName, TERMS, unitOf } from '../names'
import { OrderChoice } from '../OrderChoice'
import { OrderRow } from '../OrderRow'
import { Path } from '../Path'
import type { Panel } from '../panel'
import { Scroller } from '../Scroller'
import { Term } from '../Term'

export const orders: Panel = {
  key: 'orders',
  label: message('Orders'),
  Content: Orders,
}

/** The orders of the engine, or of both beside each other. */
function Orders() {
  const [one, other] = useExhibits()
  return (
    <>
      <OrderChoice />
      {one && other ? <BothOrders one={one} other={other} /> : <Table />}
      <p class="soft small">
        {t(
          'All paths of a quantity have one scale and are seen from the front; what is below 1 % of the greatest is pale. The dot marks the present crank angle. a ∠ p stands for a cos(kθ + p). Click an order to show it alone; click it again to show all orders.',
        )}
      </p>
    </>
  )
}

/** The table of orders: size and path of each, with the present point on the path. */
function Table() {
  const exhibit = useExhibit()
  const body = useRef<HTMLTableElement>(null)
  const shares = useMemo(() => sharesOf(exhibit.table), [exhibit])
  const dots = useMemo(
    () => exhibit.table.filter(isShown).map((row) => dotOf(exhibit, row, shares.get(row) ?? 0)),
    [exhibit, shares],
  )
  useFollower((theta) => moveDots(body.current, dots, theta), [dots])
  return (
    <Scroller label={t('Orders')}>
      <table class="orders" ref={body}>
        <thead>
          <tr>
            <th scope="col">
              <Term word="order">{t('order')}</Term>
            </th>
            <th scope="col">
              <Term word="path">{t('path')}</Term>
            </th>
            <th scope="col" class="right">
              <Term word="greatest">{t('greatest')}</Term>
            </th>
            <th scope="col">
              <Term word="vertical">{t('vertical')}</Term>
            </th>
            <th scope="col">
              <Term word="horizontal">{t('horizontal')}</Term>
            </th>
          </tr>
        </thead>
        {QUANTITIES.map((quantity) => (
          <Group
            key={quantity}
            exhibit={exhibit}
            quantity={quantity}
            rows={exhibit.table.filter((row) => row.quantity === quantity)}
            shares={shares}
          />
        ))}
      </table>
    </Scroller>
  )
}

function Group({
  exhibit,
  quantity,
  rows,
  shares,
}: {
  exhibit: Exhibit
  quantity: Row['quantity']
  rows: readonly Row[]
  shares: ReadonlyMap<Row, number>
}) {
  if (!rows.length) return null
  const zero = rows
    .filter((row) => !isShown(row))
    .sort((one, other) => one.order - other.order)
    .map(({ label }) => label)
  return (
    <tbody>
      <tr class="group">
        <th colSpan={3} scope="rowgroup">
          <Term word={TERMS[quantity]}>{quantityName(quantity)}</Term>{' '}
          <span class="unit">
            <Term word={unitOf(exhibit, quantity)}>{unitOf(exhibit, quantity)}</Term>
          </span>
          {rows.some(({ estimated }) => estimated) && (
            <span class="badge">{t('estimated, with ranges')}</span>
          )}
        </th>
        <td class="soft">
          {quantity === 'couple' && (
            <Term word="pitch M_V">
              <Lettered text={t('pitch M_V')} />
            </Term>
          )}
        </td>
        <td class="soft">
          {quantity === 'couple' && (
            <Term word="yaw M_H">
              <Lettered text={t('yaw M_H')} />
            </Term>
          )}
        </td>
      </tr>
      {rows.filter(isShown).map((row) => (
        <Line key={row.order} row={row} share={shares.get(row) ?? 0} />
      ))}
      {zero.length > 0 && (
        <tr>
          <td colSpan={5} class="soft">
            {plural('None of order {orders}.', 'None of orders {orders}.', zero.length, {
              orders: zero.join(', '),
            })}
          </td>
        </tr>
      )}
    </tbody>
  )
}

/** Whether an order has a row: it remains, or would with other masses than the estimated ones. */
function isShown({ remains, estimated }: Row): boolean {
  return remains || estimated
}

/** Below this share of the greatest of its quantity a row is pale. */
const LITTLE = 0.01

function Line({ row, share }: { row: Row; share: number }) {
  return (
    <OrderRow {...row} little={share < LITTLE}>
      <td>
        <span class="drawn">
          <Path row={row} share={share} />
          <span class="path-words">{row.path}</span>
        </span>
      </td>
      <td class="right">{typeset(row.greatest)}</td>
      <td>{typeset(row.up)}</td>
      <td>{typeset(row.right)}</td>
    </OrderRow>
  )
}
