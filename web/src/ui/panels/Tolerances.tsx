import { message, t } from '../../language/messages'
import { useExhibit } from '../context'
import { DataTable } from '../DataTable'
import { Figure } from '../Figure'
import type { Panel } from '../panel'

export const tolerances: Panel = {
  key: 'tolerances',
  label: message('Tolerances'),
  Content: TolerancesPanel,
  when: ({ shown }) => shown.value.some(({ tolerances: tables }) => tables.length > 0),
  of: 'each',
}

/** How engines built to the tolerances of the file scatter, and which tolerance matters most. */
function TolerancesPanel() {
  const exhibit = useExhibit()
  const { tolerances: tables, charts } = exhibit
  if (!tables.length)
    return (
      <p class="needs">
        {t(
          'The file of this engine has no tolerances; write them behind the values, as in 650 g +- 2 g.',
        )}
      </p>
    )
  return (
    <div class="stacked">
      <div class="figures">
        {charts
          .filter(({ figure }) => figure === 'scatter')
          .map(({ key, label }) => (
            <Figure key={key} exhibit={exhibit} chart={key} label={label} />
          ))}
      </div>
      {tables.map((table, place) => (
        <DataTable key={place} table={table} />
      ))}
    </div>
  )
}
