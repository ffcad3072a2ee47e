import { message, t } from '../../language/messages'
import { QUANTITIES, set } from '../../state'
import { Choice } from '../Choice'
import { useApp, useExhibit } from '../context'
import { Figure } from '../Figure'
import { quantityName } from '../names'
import { orderText } from '../OrderChoice'
import type { Panel } from '../panel'

export const forces: Panel = {
  key: 'forces',
  label: message('Forces'),
  Content: Forces,
}

/** A quantity over the crank angle, and the path of its vector. */
function Forces() {
  const { store, quantity: chosen } = useApp()
  const exhibit = useExhibit()
  const quantity = chosen.value
  const single = store.orders.value?.length === 1 ? store.orders.value[0] : undefined
  const paths = exhibit.charts.filter(
    (chart) => chart.figure === 'hodograph' && chart.quantity === quantity,
  )
  const path =
    paths.find((chart) => chart.order === single) ?? paths.find((chart) => chart.order == null)
  const over = exhibit.charts.find(
    (chart) => chart.figure === 'over-turn' && chart.quantity === quantity,
  )
  const orders = paths.flatMap((chart) => (chart.order == null ? [] : [chart.order]))
  return (
    <>
      <div class="controls">
        <Choice
          label={t('Over the crank angle')}
          value={quantity}
          choices={QUANTITIES.map((each) => ({ value: each, label: quantityName(each) }))}
          chosen={(value) => set(store.quantity, value)}
        />
        {paths.length > 0 && (
          <Choice
            label={t('Path of order')}
            value={path?.order == null ? '' : String(path.order)}
            choices={[
              { value: '', label: t('all') },
              ...orders.map((each) => ({ value: String(each), label: orderText(exhibit, each) })),
            ]}
            chosen={(value) => set(store.orders, value === '' ? null : [Number(value)])}
          />
        )}
      </div>
      <div class="figures">
        {over && <Figure key={over.key} exhibit={exhibit} chart={over.key} label={over.label} />}
        {path && <Figure key={path.key} exhibit={exhibit} chart={path.key} label={path.label} />}
      </div>
    </>
  )
}
