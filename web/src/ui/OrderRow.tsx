import type { ComponentChildren } from 'preact'
import { t } from '../language/messages'
import type { Quantity } from '../state'
import { useApp } from './context'
import { quantityName } from './names'
import { isChosen } from './OrderChoice'

interface Props {
  readonly order: number
  readonly label: string
  readonly quantity: Quantity
  /** Whether it is too small beside the greatest to be read first. */
  readonly little?: boolean
  readonly children: ComponentChildren
}

/** The row of an order: a click anywhere in it shows the order alone, another one all orders. */
export function OrderRow({ order, label, quantity, little, children }: Props) {
  const { store } = useApp()
  const chosen = isChosen(store.orders.value, order)
  const alone = chosen && store.orders.value?.length === 1
  function choose(): void {
    store.orders.value = alone ? null : [order]
    if (!alone) store.quantity.value = quantity
  }
  return (
    // a click anywhere in the row is the same as on its button
    <tr class={`${chosen ? 'chosen' : ''}${little ? ' little' : ''}`} onClick={choose}>
      <th scope="row">
        <button
          type="button"
          aria-pressed={chosen}
          aria-label={t('{quantity}, order {order}: show alone', {
            quantity: quantityName(quantity),
            order: label,
          })}
        >
          {label}
        </button>
      </th>
      {children}
    </tr>
  )
}
