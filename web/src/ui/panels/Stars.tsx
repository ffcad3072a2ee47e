import type { ChartKey, Exhibit } from '../../exhibit'
import { Choice } from '../Choice'
import { useApp, useExhibit } from '../context'
import { Figure } from '../Figure'
import { orderText } from '../OrderChoice'
import { isNothing } from '../Path'

const DRAWN = ['vector-star', 'polygon']

/** Orders of which there are stars, and the one to show: the chosen one, else the lowest of which something is left. */
export function ordersWith(exhibit: Exhibit, figure: string, quantity: string): number[] {
  const of = (chart: ChartKey): boolean => chart.figure === figure && chart.quantity === quantity
  return exhibit.charts.filter(of).flatMap((chart) => (chart.order == null ? [] : [chart.order]))
}

export function orderShown(exhibit: Exhibit, orders: readonly number[], chosen: readonly number[] | null, of: string) {
  const wanted = chosen?.find((order) => orders.includes(order))
  const left = exhibit.table.find((row) => row.quantity === of && !isNothing(row) && orders.includes(row.order))
  return wanted ?? left?.order ?? orders[0]
}

/** The crank star, and the vectors of one order as star and as polygon. */
export function Stars() {
  const { store, quantity: told } = useApp()
  const exhibit = useExhibit()
  const quantity = told.value === 'couple' ? 'couple' : 'force'
  const orders = ordersWith(exhibit, 'vector-star', quantity)
  const order = orderShown(exhibit, orders, store.orders.value, quantity)
  const charts = exhibit.charts.filter(
    (chart) =>
      chart.figure === 'crank-star' ||
      (DRAWN.includes(chart.figure) && chart.quantity === quantity && chart.order === order),
  )
  return (
    <>
      <div class="controls">
        <Choice
          label="Vectors of"
          value={quantity}
          choices={[
            { value: 'force', label: 'force' },
            { value: 'couple', label: 'couple' },
          ]}
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
      <div class="figures">
        {charts.map((chart) => (
          <Figure key={chart.key} exhibit={exhibit} chart={chart.key} label={chart.label} />
        ))}
      </div>
    </>
  )
}
