import type { ChartKey, Exhibit } from '../../exhibit'
import { message, t } from '../../language/messages'
import { QUANTITIES, set } from '../../state'
import { Choice } from '../Choice'
import { useApp, useExhibits } from '../context'
import { Figures } from '../Figures'
import { quantityName } from '../names'
import { ordersOf, orderText } from '../OrderChoice'
import type { Panel } from '../panel'

export const forces: Panel = {
  key: 'forces',
  label: message('Forces'),
  Content: Forces,
}

/** A quantity over the crank angle, and the path of its vector. */
function Forces() {
  const { store, quantity: chosen } = useApp()
  const exhibits = useExhibits()
  const quantity = chosen.value
  const single = store.orders.value?.length === 1 ? store.orders.value[0] : undefined
  const isPath = (chart: ChartKey): boolean =>
    chart.figure === 'hodograph' && chart.quantity === quantity
  const orders = ordersOf(exhibits, ({ charts }) =>
    charts.flatMap((chart) => (isPath(chart) && chart.order != null ? [chart.order] : [])),
  )
  const path = orders.find((order) => order === single)
  const shownOf = ({ charts }: Exhibit): readonly ChartKey[] => [
    ...charts.filter((chart) => chart.figure === 'over-turn' && chart.quantity === quantity),
    ...charts.filter((chart) => isPath(chart) && (chart.order ?? undefined) === path),
  ]
  return (
    <>
      <div class="controls">
        <Choice
          label={t('Over the crank angle')}
          value={quantity}
          choices={QUANTITIES.map((each) => ({ value: each, label: quantityName(each) }))}
          chosen={(value) => set(store.quantity, value)}
        />
        {orders.length > 0 && (
          <Choice
            label={t('Path of order')}
            value={path === undefined ? '' : String(path)}
            choices={[
              { value: '', label: t('all') },
              ...orders.map((each) => ({ value: String(each), label: orderText(exhibits, each) })),
            ]}
            chosen={(value) => set(store.orders, value === '' ? null : [Number(value)])}
          />
        )}
      </div>
      <Figures charts={shownOf} of={exhibits} />
    </>
  )
}
