import { useMemo, useRef } from 'preact/hooks'
import type { Exhibit, Row } from '../../exhibit'
import { plural, t } from '../../language/messages'
import { QUANTITIES } from '../../state'
import { useApp, useExhibit, useFollower } from '../context'
import { dotOf, moveDots } from '../dots'
import { quantityName, unitOf } from '../names'
import { isChosen, OrderChoice } from '../OrderChoice'
import { Path } from '../Path'

/** The table of orders: size and path of each, with the present point on the path. */
export function Orders() {
  const exhibit = useExhibit()
  const body = useRef<HTMLTableElement>(null)
  const dots = useMemo(
    () => exhibit.table.filter(isShown).map((row) => dotOf(exhibit, row)),
    [exhibit],
  )
  useFollower((theta) => moveDots(body.current, dots, theta), [dots])
  return (
    <>
      <OrderChoice />
      <section class="scroll" aria-label={t('Orders')}>
        <table class="orders" ref={body}>
          <thead>
            <tr>
              <th scope="col">{t('order')}</th>
              <th scope="col">{t('path')}</th>
              <th scope="col" class="right">
                {t('greatest')}
              </th>
              <th scope="col">{t('vertical')}</th>
              <th scope="col">{t('horizontal')}</th>
            </tr>
          </thead>
          {QUANTITIES.map((quantity) => (
            <Group
              key={quantity}
              exhibit={exhibit}
              quantity={quantity}
              rows={exhibit.table.filter((row) => row.quantity === quantity)}
            />
          ))}
        </table>
      </section>
      <p class="soft small">
        {t(
          'Each path has its own scale and is seen from the front; the dot marks the present crank angle. a ∠ p stands for a cos(kθ + p). Click an order to show it alone; click it again to show all orders.',
        )}
      </p>
    </>
  )
}

function Group({
  exhibit,
  quantity,
  rows,
}: {
  exhibit: Exhibit
  quantity: Row['quantity']
  rows: readonly Row[]
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
          {quantityName(quantity)} <span class="unit">{unitOf(exhibit, quantity)}</span>
          {rows.some(({ estimated }) => estimated) && (
            <span class="badge">{t('estimated, with ranges')}</span>
          )}
        </th>
        <td class="soft">{quantity === 'couple' && t('pitch M_V')}</td>
        <td class="soft">{quantity === 'couple' && t('yaw M_H')}</td>
      </tr>
      {rows.filter(isShown).map((row) => (
        <Line key={row.order} row={row} />
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

function Line({ row }: { row: Row }) {
  const { store } = useApp()
  const chosen = isChosen(store.orders.value, row.order)
  const alone = chosen && store.orders.value?.length === 1
  function choose(): void {
    store.orders.value = alone ? null : [row.order]
    if (!alone) store.quantity.value = row.quantity
  }
  return (
    // a click anywhere in the row is the same as on its button
    <tr class={chosen ? 'chosen' : ''} onClick={choose}>
      <th scope="row">
        <button
          type="button"
          aria-pressed={chosen}
          aria-label={t('{quantity}, order {order}: show alone', {
            quantity: quantityName(row.quantity),
            order: row.label,
          })}
        >
          {row.label}
        </button>
      </th>
      <td>
        <span class="drawn">
          <Path row={row} />
          <span>{row.path}</span>
        </span>
      </td>
      <td class="right">{row.greatest}</td>
      <td>{row.up}</td>
      <td>{row.right}</td>
    </tr>
  )
}
