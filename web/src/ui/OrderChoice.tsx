import type { Exhibit } from '../exhibit'
import { t } from '../language/messages'
import { among, sameOrder } from '../phasor'
import { set } from '../state'
import { useApp, useExhibits } from './context'

/** An order as it is printed in the tables. */
export function orderText(exhibits: readonly Exhibit[], order: number): string {
  const rows = exhibits.flatMap(({ table }) => table)
  return rows.find((row) => sameOrder(row.order, order))?.label ?? String(order)
}

/** The orders of any of these engines, ascending. */
export function ordersOf(
  exhibits: readonly Exhibit[],
  of: (exhibit: Exhibit) => readonly number[],
): number[] {
  const all = exhibits.flatMap((exhibit) => of(exhibit)).sort((one, other) => one - other)
  return all.filter((order, index) => !index || !sameOrder(order, all[index - 1] ?? 0))
}

/** Whether an order is among those that are shown. */
export function isChosen(orders: readonly number[] | null, order: number): boolean {
  return orders !== null && among(order, orders)
}

/** Orders for arrows, whirl and figures: all, or some of them. */
export function OrderChoice() {
  const { store } = useApp()
  const exhibits = useExhibits()
  const offered = ordersOf(exhibits, (exhibit) => exhibit.orders)
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
        {offered.map((order) => (
          <label key={order} class={isChosen(orders, order) ? 'chosen' : ''}>
            <input
              type="checkbox"
              checked={isChosen(orders, order)}
              onChange={() => toggle(order)}
            />
            <span>{orderText(exhibits, order)}</span>
          </label>
        ))}
      </div>
    </fieldset>
  )
}
