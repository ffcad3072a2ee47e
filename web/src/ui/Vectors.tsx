import type { Exhibit, Row } from '../exhibit'
import { t } from '../language/messages'
import { set } from '../state'
import { Choice } from './Choice'
import { useApp, useExhibits } from './context'
import { quantityName } from './names'
import { ordersOf, orderText } from './OrderChoice'

const QUANTITIES = ['force', 'couple'] as const

/** Quantity, orders, and the shown order: the chosen one, else the greatest that remains. */
export function useVectors(
  of: (exhibit: Exhibit, quantity: 'force' | 'couple') => readonly number[],
) {
  const { store, quantity: chosen } = useApp()
  const exhibits = useExhibits()
  const quantity: 'force' | 'couple' = chosen.value === 'couple' ? 'couple' : 'force'
  const orders = ordersOf(exhibits, (exhibit) => of(exhibit, quantity))
  const wanted = store.orders.value?.find((order) => orders.includes(order))
  const is = (row: Row): boolean => row.quantity === quantity && orders.includes(row.order)
  const left = exhibits.flatMap(({ table }) => table.filter((row) => is(row) && row.remains))
  const most = Math.max(...left.map(({ size }) => size))
  return {
    exhibits,
    quantity,
    orders,
    order: wanted ?? left.find(({ size }) => size === most)?.order ?? orders[0],
  }
}

/** Chooses the quantity, and one of the orders that there are of it. */
export function VectorChoice({
  label,
  vectors,
}: {
  label: string
  vectors: ReturnType<typeof useVectors>
}) {
  const { store } = useApp()
  const { exhibits, quantity, orders, order } = vectors
  return (
    <div class="controls">
      <Choice
        label={label}
        value={quantity}
        choices={QUANTITIES.map((value) => ({ value, label: quantityName(value) }))}
        chosen={(value) => set(store.quantity, value)}
      />
      <Choice
        label={t('Order')}
        value={String(order)}
        choices={orders.map((each) => ({ value: String(each), label: orderText(exhibits, each) }))}
        chosen={(value) => set(store.orders, [Number(value)])}
      />
    </div>
  )
}
