import { message, t } from '../../language/messages'
import { useExhibit } from '../context'
import { DataTable } from '../DataTable'
import { Figure } from '../Figure'
import type { Panel } from '../panel'

const DRAWN = ['stroke-chart', 'firing-ring']

export const strokes: Panel = {
  key: 'strokes',
  label: message('Strokes'),
  Content: Strokes,
  of: 'each',
}

/** Firing, valve events and exhaust neighbours of each cylinder. */
function Strokes() {
  const exhibit = useExhibit()
  const charts = exhibit.charts.filter((chart) => DRAWN.includes(chart.figure))
  if (!charts.length && !exhibit.strokes.length)
    return <p>{t('The engine file gives no firing order, so the strokes are unknown.')}</p>
  return (
    <>
      <div class="figures">
        {charts.map((chart) => (
          <Figure key={chart.key} exhibit={exhibit} chart={chart.key} label={chart.label} />
        ))}
      </div>
      {exhibit.strokes
        .filter((table) => table.rows.length > 0 || (table.notes?.length ?? 0) > 0)
        .map((table) => (
          <DataTable
            key={table.title}
            table={table.title === exhibit.name ? { ...table, title: '' } : table}
          />
        ))}
    </>
  )
}
