import { useMemo } from 'preact/hooks'
import type { ChartKey, Exhibit } from '../../exhibit'
import { message, t } from '../../language/messages'
import { Switch } from '../../Switch'
import { QUANTITIES, set } from '../../state'
import { type Torques, takesGas, torquesOf } from '../../torque'
import { Choice } from '../Choice'
import { Curves, type Series } from '../Curves'
import { useApp, useChoice, useExhibit, useExhibits } from '../context'
import { Each } from '../Each'
import { Figures } from '../Figures'
import { quantityName } from '../names'
import { ordersOf, orderText } from '../OrderChoice'
import type { Panel } from '../panel'
import { commonExtent, useSetting } from '../torques'

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
  const [gas, chooseGas] = useChoice<'off' | 'on'>('forces.gas', ['off', 'on'])
  const setting = useSetting()
  const gasIsKnown = exhibits.some((exhibit) => takesGas(exhibit, setting))
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
      {gasIsKnown && (
        <div>
          <Switch
            label={t('Gas in the rolling moment, also on the stage')}
            on={gas === 'on'}
            change={(on) => chooseGas(on ? 'on' : 'off')}
          />
          <p class="soft small">{t('Gas makes no force and no couple; see Torque.')}</p>
        </div>
      )}
      <Figures charts={shownOf} of={exhibits} />
      {gas === 'on' && quantity === 'roll' && <Each Part={RollWithGas} />}
    </>
  )
}

/** The rolling moment with the gas and without it, over a working cycle. */
function RollWithGas() {
  const exhibit = useExhibit()
  const exhibits = useExhibits()
  const chosen = useSetting()
  const setting = { ...chosen, gas: chosen.gas === 'none' ? ('burning' as const) : chosen.gas }
  const key = JSON.stringify(setting)
  const shown = useMemo(() => {
    const without = (each: Exhibit) => torquesOf(each, { ...setting, gas: 'none' })
    const own = torquesOf(exhibit, setting)
    const rolls = (each: Torques): Series[] => [
      { key: 'roll', label: t('with gas'), wave: each.roll, mean: 0 },
    ]
    const series: Series[] = [
      { key: 'inertia', label: t('without gas'), wave: without(exhibit).roll, mean: 0 },
      ...rolls(own),
    ]
    return { own, series, extent: commonExtent(exhibits, setting, own, rolls) }
  }, [exhibit, exhibits.length, key])
  if (!takesGas(exhibit, setting)) return null
  const { own, series, extent } = shown
  return (
    <Curves
      label={t('Rolling moment on the block, clockwise')}
      unit={own.unit}
      factor={own.factor}
      turns={own.turns}
      orders={own.orders}
      series={series}
      extent={extent}
    />
  )
}
