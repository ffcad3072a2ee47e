import { useMemo, useRef } from 'preact/hooks'
import type { Exhibit, Row } from '../../exhibit'
import { QUANTITIES } from '../../state'
import { useApp, useExhibit, useFollower } from '../context'
import { dotOf, moveDots } from '../dots'
import { isChosen, OrderChoice } from '../OrderChoice'
import { isNothing, Path } from '../Path'

/** The table of orders: what each does, the path it runs through, and where on it the engine is now. */
export function Orders() {
  const exhibit = useExhibit()
  const body = useRef<HTMLTableElement>(null)
  const rows = useMemo(
    () => QUANTITIES.flatMap((one) => exhibit.table.filter((row) => row.quantity === one)),
    [exhibit],
  )
  const dots = useMemo(() => rows.map((row) => dotOf(exhibit, row)), [exhibit, rows])
  useFollower((theta) => moveDots(body.current, dots, theta), [dots])
  return (
    <>
      <OrderChoice />
      <section class="scroll" aria-label="Orders">
        <table class="orders" ref={body}>
          <thead>
            <tr>
              <th scope="col">order</th>
              <th scope="col">path</th>
              <th scope="col" class="right">
                greatest
              </th>
              <th scope="col">up</th>
              <th scope="col">right</th>
            </tr>
          </thead>
          {QUANTITIES.map((quantity) => (
            <Group
              key={quantity}
              exhibit={exhibit}
              quantity={quantity}
              rows={rows.filter((row) => row.quantity === quantity)}
            />
          ))}
        </table>
      </section>
      <p class="soft small">
        Each path is drawn to its own scale, seen from the front; the dot is at the crank angle of the stage. Amplitudes
        are written a ∠ p for a cos(kθ + p). A click on an order shows it alone, a second click all of them.
      </p>
    </>
  )
}

function Group({ exhibit, quantity, rows }: { exhibit: Exhibit; quantity: Row['quantity']; rows: readonly Row[] }) {
  if (!rows.length) return null
  const unit = quantity === 'torque' ? exhibit.units.roll : exhibit.units[quantity]
  return (
    <tbody>
      <tr class="group">
        <th colSpan={5} scope="rowgroup">
          {quantity === 'roll' ? 'roll of the block' : quantity} <span class="unit">{unit}</span>
        </th>
      </tr>
      {rows.map((row) => (
        <Line key={row.order} row={row} />
      ))}
    </tbody>
  )
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
    <tr class={`${isNothing(row) ? 'nothing' : ''} ${chosen ? 'chosen' : ''}`} onClick={choose}>
      <th scope="row">
        <button type="button" aria-pressed={chosen} aria-label={`Order ${row.label}, ${row.quantity}: show it alone`}>
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
