import type { ChartKey } from '../../exhibit'
import { message, t } from '../../language/messages'
import { Figures } from '../Figures'
import type { Panel } from '../panel'
import { useVectors, VectorChoice } from '../Vectors'

const STAR = 'vector-star'
const DRAWN = [STAR, 'polygon']

export const stars: Panel = {
  key: 'stars',
  label: message('Stars'),
  Content: Stars,
}

/** The crank star, and the vectors of one order as star and as polygon. */
function Stars() {
  const vectors = useVectors(({ charts }, quantity) => {
    const of = (chart: ChartKey): boolean => chart.figure === STAR && chart.quantity === quantity
    return charts.filter(of).flatMap((chart) => (chart.order == null ? [] : [chart.order]))
  })
  const { exhibits, quantity, order } = vectors
  const isShown = (chart: ChartKey): boolean =>
    chart.figure === 'crank-star' ||
    (DRAWN.includes(chart.figure) && chart.quantity === quantity && chart.order === order)
  return (
    <>
      <VectorChoice label={t('Vectors of')} vectors={vectors} />
      <Figures charts={(exhibit) => exhibit.charts.filter(isShown)} of={exhibits} />
    </>
  )
}
