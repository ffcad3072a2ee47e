import { message, t } from '../../language/messages'
import { useExhibit } from '../context'
import { DataTable } from '../DataTable'
import { Figure } from '../Figure'
import type { Panel } from '../panel'

export const marine: Panel = {
  key: 'marine',
  label: message('Ship'),
  Content: MarinePanel,
  when: ({ shown }) => shown.value.some(({ marine: tables }) => tables.length > 0),
  of: 'each',
}

/** What a large two-stroke engine does to its ship: external moments, guide-force moments. */
function MarinePanel() {
  const exhibit = useExhibit()
  const { marine: tables, charts } = exhibit
  if (!tables.length)
    return (
      <p class="needs">
        {t(
          'This is of large two-stroke engines in line, with masses, sizes, speed and gas in their file.',
        )}
      </p>
    )
  return (
    <div class="stacked">
      {tables.map((table, place) => (
        <DataTable key={place} table={table} />
      ))}
      <div class="figures">
        {charts
          .filter(({ figure }) => figure === 'guide-moments')
          .map(({ key, label }) => (
            <Figure key={key} exhibit={exhibit} chart={key} label={label} />
          ))}
      </div>
    </div>
  )
}
