import type { Exhibit } from '../exhibit'
import { t } from '../language/messages'
import { among, sameOrder } from '../phasor'
import { set } from '../state'
import { useApp, useExhibit } from './context'

/** An order as it is printed in the tables. */
export function orderText(exhibit: Exhibit, order: number): string {
  return exhibit.table.find((row) => sameOrder(row.order, order))?.label ?? String(order)
}

/** Whether an order is among those that are shown. */
export function isChosen(orders: readonly number[] | null, order: number): boolean {
  return orders !== null && among(order, orders)
}

/** Orders for arrows, whirl and figures: all, or some of them. */
export function OrderChoice() {
  const { store } = useApp()
  const exhibit = useExhibit()
  const orders = store.orders.value
  function toggle(order: number): void {
    const kept = (orders ?? []).filter((other) => !sameOrder(other, order))
    const next = isChosen(orders, order) ? kept : [...kept, order].sort((one, other) => one - other)
    store.orders.value = next.length ? next : null
  }
  return (
    <fieldset class="choice orders">
      <legend>{t('Orders shown')}</legend>
      <div class="choices">
        <label class={orders === null ? 'chosen' : ''}>
          <input
            type="checkbox"
            checked={orders === null}
            onChange={() => set(store.orders, null)}
          />
          <span>{t('all')}</span>
        </label>
        {exhibit.orders.map((order) => (
          <label key={order} class={isChosen(orders, order) ? 'chosen' : ''}>
            <input
              type="checkbox"
              checked={isChosen(orders, order)}
              onChange={() => toggle(order)}
            />
            <span>{orderText(exhibit, order)}</span>
          </label>
        ))}
      </div>
    </fieldset>
  )
}
