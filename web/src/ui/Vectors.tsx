import type { Exhibit, Row } from '../exhibit'
import { Choice } from './Choice'
import { useApp, useExhibit } from './context'
import { orderText } from './OrderChoice'
import { isNothing } from './Path'

type Quantity = 'force' | 'couple'

const QUANTITIES = [
  { value: 'force', label: 'force' },
  { value: 'couple', label: 'couple' },
] as const

/** The quantity and the order of which one is shown, and which orders there are: the chosen one, else the lowest that is left. */
export function useVectors(of: (exhibit: Exhibit, quantity: Quantity) => readonly number[]) {
  const { store, quantity: told } = useApp()
  const exhibit = useExhibit()
  const quantity: Quantity = told.value === 'couple' ? 'couple' : 'force'
  const orders = of(exhibit, quantity)
  const wanted = store.orders.value?.find((order) => orders.includes(order))
  const is = (row: Row): boolean => row.quantity === quantity && orders.includes(row.order)
  const left = exhibit.table.find((row) => is(row) && !isNothing(row))
  return { exhibit, quantity, orders, order: wanted ?? left?.order ?? orders[0] }
}

/** Chooses the quantity, and one of the orders that there are of it. */
export function VectorChoice({ label, vectors }: { label: string; vectors: ReturnType<typeof useVectors> }) {
  const { store } = useApp()
  const { exhibit, quantity, orders, order } = vectors
  return (
    <div class="controls">
      <Choice
        label={label}
        value={quantity}
        choices={QUANTITIES}
        chosen={(value) => {
          store.quantity.value = value
        }}
      />
      <Choice
        label="Order"
        value={String(order)}
        choices={orders.map((one) => ({ value: String(one), label: orderText(exhibit, one) }))}
        chosen={(value) => {
          store.orders.value = [Number(value)]
        }}
      />
    </div>
  )
}
